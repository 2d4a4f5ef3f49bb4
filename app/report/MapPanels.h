#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "app/report/RunPictures.h"

/// What figures on maps share.
namespace report {

constexpr std::size_t kMostPanels = 24;
constexpr double kPanelHead = 20.0;  // title [px]

/// A map in a panel: world to pixels.
struct MapPanel {
  double left = 0.0, top = 0.0, scale = 1.0;  // px, px, px/m
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();

  base::Vec2 at(const base::Vec2& world) const {
    return {left + (world.x() - low.x()) * scale, top + (high.y() - world.y()) * scale};
  }
  double width() const { return (high.x() - low.x()) * scale; }
  double height() const { return (high.y() - low.y()) * scale; }
};

/// Walls and shapes of a ground, drawn once and used in each of its panels.
class Grounds {
 public:
  Grounds(Figure& figure, double width, double height)
      : figure_(figure), width_(width), height_(height) {}

  MapPanel draw(const std::string& name, const Ground& ground, double left, double top);

 private:
  Figure& figure_;
  double width_, height_;
  std::map<std::string, std::size_t> known_;
};

/// With the title; a map is at least 60 px tall, at most `most`.
double panelHeightOf(const Ground& ground, double width, double most);

/// " (the first 24 of 30 scenarios)"; all are there: nothing.
std::string cutText(std::size_t shown, std::size_t all, const char* what);

}  // namespace report
