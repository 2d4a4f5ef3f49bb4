#pragma once

#include <string>
#include <vector>

#include "app/report/Figure.h"

/// Placement of point labels without overlaps.
namespace report {

struct Box {
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();  // [px]
};
struct Segment {
  base::Vec2 from = base::Vec2::Zero(), to = base::Vec2::Zero();  // [px]
};

struct Label {
  std::string words;
  base::Vec2 point = base::Vec2::Zero();  // [px], centre of its mark
};

/// The position of a label.
struct PlacedLabel {
  Box box;
  bool hasLeader = false;  // far from its point: drawn with a leader line
  Segment leader;          // from the mark to the label
};

/// Places each label within the bounds without covering labels or marks; lines are covered only if
/// no other position is near. Greedy, repeated a few times.
std::vector<PlacedLabel> placeLabels(const std::vector<Label>& labels,
                                     const std::vector<Segment>& lines, const Box& bounds);

void drawLabels(Figure& figure, const std::vector<Label>& labels,
                const std::vector<PlacedLabel>& places);

}  // namespace report
