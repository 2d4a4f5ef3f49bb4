#pragma once

#include <string>
#include <vector>

#include "app/report/Figure.h"

/// Names of points in a plane, beside them and not on each other.
namespace report {

struct Box {
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();  // [px]
};
struct Segment {
  base::Vec2 from = base::Vec2::Zero(), to = base::Vec2::Zero();  // [px]
};

struct Label {
  std::string words;
  base::Vec2 point = base::Vec2::Zero();  // [px], in the middle of its mark
};

/// Where words stand.
struct PlacedLabel {
  Box box;
  bool hasLeader = false;  // too far from its point to be told without a line
  Segment leader;          // from its mark to its words
};

/// Finds a place for each, within the bounds, on no label and no mark, on lines only where there is
/// nowhere else nearby. Greedy, and some times over.
std::vector<PlacedLabel> placeLabels(const std::vector<Label>& labels,
                                     const std::vector<Segment>& lines, const Box& bounds);

void drawLabels(Figure& figure, const std::vector<Label>& labels,
                const std::vector<PlacedLabel>& places);

}  // namespace report
