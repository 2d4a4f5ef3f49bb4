#include "app/report/MapPanels.h"

#include <algorithm>

namespace report {

namespace {

MapPanel panelFor(const Ground& ground, double left, double top, double width, double height) {
  const base::Vec2 size = ground.high - ground.low;
  MapPanel panel;
  panel.scale = std::min(width / size.x(), height / size.y());
  panel.low = ground.low;
  panel.high = ground.high;
  panel.left = left + 0.5 * (width - panel.width());
  panel.top = top;
  return panel;
}

std::string outlinePath(const std::vector<sim2d::Outline>& outlines, const MapPanel& panel) {
  std::string path;
  for (const sim2d::Outline& outline : outlines) {
    const char* move = "M";
    for (const base::Vec2& point : outline.points) {
      const base::Vec2 at = panel.at(point);
      path += move + pixel(at.x()) + " " + pixel(at.y());
      move = "L";
    }
    path += "Z";
  }
  return path;
}

}  // namespace

MapPanel Grounds::draw(const std::string& name, const Ground& ground, double left, double top) {
  const MapPanel origin = panelFor(ground, 0.0, 0.0, width_, height_);
  const auto [place, isNew] = known_.try_emplace(name, known_.size());
  const std::string id = std::to_string(place->second);
  if (isNew) {
    figure_.define("walls" + id, outlinePath(ground.walls, origin) + "M0 0", "wall");
    figure_.define("shapes" + id, outlinePath(ground.shapes, origin) + "M0 0", "solid");
  }
  MapPanel panel = panelFor(ground, left, top, width_, height_);
  figure_.rect(panel.left, panel.top, panel.width(), panel.height(), "ground");
  figure_.beginClip(panel.left, panel.top, panel.width(), panel.height());
  figure_.use("shapes" + id, left, top);
  figure_.use("walls" + id, left, top);
  figure_.endClip();
  return panel;
}

double panelHeightOf(const Ground& ground, double width, double most) {
  const base::Vec2 size = ground.high - ground.low;
  return kPanelHead + std::clamp(width * size.y() / size.x(), 60.0, most);
}

std::string cutText(std::size_t shown, std::size_t all, const char* what) {
  return shown < all ? " (the first " + std::to_string(shown) + " of " + std::to_string(all) + " " +
                           what + ")"
                     : std::string();
}

}  // namespace report
