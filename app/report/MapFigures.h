#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "app/report/RunPictures.h"

/// Shared parts of figures that show maps.
namespace report {

constexpr std::size_t kMostPanels = 24;
constexpr double kPanelHead = 20.0;  // [px], height of the title

/// The transform from world to pixels of a map panel.
struct MapPanel {
  double left = 0.0, top = 0.0, scale = 1.0;  // px, px, px/m
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();

  base::Vec2 at(const base::Vec2& world) const {
    return {left + (world.x() - low.x()) * scale, top + (high.y() - world.y()) * scale};
  }
  double width() const { return (high.x() - low.x()) * scale; }
  double height() const { return (high.y() - low.y()) * scale; }
};

/// Draws the walls and shapes of a map. They are defined once and reused in each panel.
class FloorPlans {
 public:
  FloorPlans(Figure& figure, double width, double height)
      : figure_(figure), width_(width), height_(height) {}

  MapPanel draw(const std::string& name, const FloorPlan& floorPlan, double left, double top);

 private:
  Figure& figure_;
  double width_, height_;
  std::map<std::string, std::size_t> known_;
};

/// The height including the title; the map is at least 60 px and at most `most` tall.
double panelHeightOf(const FloorPlan& floorPlan, double width, double most);

/// " (the first 24 of 30 scenarios)"; empty if all are shown.
std::string truncationNote(std::size_t shown, std::size_t all, const char* what);

}  // namespace report
