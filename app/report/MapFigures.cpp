#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "app/report/Markup.h"
#include "app/report/RunPictures.h"

namespace report {

namespace {

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

MapPanel panelFor(const FloorPlan& floorPlan, double left, double top, double width,
                  double height) {
  const base::Vec2 size = floorPlan.high - floorPlan.low;
  MapPanel panel;
  panel.scale = std::min(width / size.x(), height / size.y());
  panel.low = floorPlan.low;
  panel.high = floorPlan.high;
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

MapPanel FloorPlans::draw(const std::string& name, const FloorPlan& floorPlan, double left,
                          double top) {
  const MapPanel origin = panelFor(floorPlan, 0.0, 0.0, width_, height_);
  const auto [place, isNew] = known_.try_emplace(name, known_.size());
  const std::string id = std::to_string(place->second);
  if (isNew) {
    figure_.define("walls" + id, outlinePath(floorPlan.walls, origin) + "M0 0", "wall");
    figure_.define("shapes" + id, outlinePath(floorPlan.shapes, origin) + "M0 0", "solid");
  }
  MapPanel panel = panelFor(floorPlan, left, top, width_, height_);
  figure_.rect(panel.left, panel.top, panel.width(), panel.height(), "ground");
  figure_.beginClip(panel.left, panel.top, panel.width(), panel.height());
  figure_.use("shapes" + id, left, top);
  figure_.use("walls" + id, left, top);
  figure_.endClip();
  return panel;
}

/// The height including the title; the map is at least 60 px and at most `most` tall.
double panelHeightOf(const FloorPlan& floorPlan, double width, double most) {
  const base::Vec2 size = floorPlan.high - floorPlan.low;
  return kPanelHead + std::clamp(width * size.y() / size.x(), 60.0, most);
}

/// " (the first 24 of 30 scenarios)"; empty if all are shown.
std::string truncationNote(std::size_t shown, std::size_t all, const char* what) {
  return shown < all ? " (the first " + std::to_string(shown) + " of " + std::to_string(all) + " " +
                           what + ")"
                     : std::string();
}

using Squares = std::map<std::pair<int, int>, int>;  // contacts per square

constexpr double kSquare = 0.5;  // [m]

Squares squaresOf(const std::vector<base::Vec2>& contacts) {
  Squares counts;
  for (const base::Vec2& place : contacts) {
    ++counts[{static_cast<int>(std::floor(place.x() / kSquare)),
              static_cast<int>(std::floor(place.y() / kSquare))}];
  }
  return counts;
}

/// The opacity for a number of contacts, on the same scale in all panels.
double strengthOf(int count, int most) {
  return 0.25 + 0.65 * count / most;
}

void heatSquares(Figure& figure, const MapPanel& panel, const Squares& squares, int most) {
  for (const auto& [square, count] : squares) {
    const base::Vec2 corner = panel.at({square.first * kSquare, (square.second + 1) * kSquare});
    figure.rect(corner.x(), corner.y(), kSquare * panel.scale, kSquare * panel.scale, "hot",
                strengthOf(count, most));
  }
}

constexpr double kKeyHeight = 30.0;  // [px]

/// The legend: the lowest, a middle and the highest number of contacts.
void heatLegend(Figure& figure, double top, int most) {
  constexpr double kSide = 12.0;
  const std::string words = "Contacts per square:";
  figure.text(0.0, top + 10.0, words, "dim");
  double left = 6.4 * static_cast<double>(words.size());
  for (const int count : std::set<int>{1, (1 + most) / 2, most}) {
    figure.rect(left, top, kSide, kSide, "ground");
    figure.rect(left, top, kSide, kSide, "hot", strengthOf(count, most));
    const std::string number = std::to_string(count);
    figure.text(left + kSide + 6.0, top + 10.0, number);
    left += kSide + 24.0 + 6.4 * static_cast<double>(number.size());
  }
}

/// The contacts of all runs in one scenario.
struct ContactMap {
  std::string scenario;
  std::size_t count = 0;
  Squares squares;
  int most() const {
    int found = 0;
    for (const auto& [square, contacts] : squares) {
      found = std::max(found, contacts);
    }
    return found;
  }
};

/// The contact maps of scenarios with contacts, by name.
std::vector<ContactMap> contactMaps(const Study& study, const RunPictures& pictures) {
  std::map<std::string, std::vector<base::Vec2>> places;
  for (const RunPicture& picture : pictures.runs) {
    for (const metrics::RobotContact& contact : picture.contacts) {
      places[study.results.runs[picture.run].scenario].push_back(contact.place);
    }
  }
  std::vector<ContactMap> maps;
  maps.reserve(places.size());
  for (const auto& [scenario, contacts] : places) {
    maps.push_back({scenario, contacts.size(), squaresOf(contacts)});
  }
  return maps;
}

std::string contactsCaption(const RunPictures& pictures, std::size_t shown, std::size_t all) {
  const std::size_t others = pictures.floorPlans.size() - all;
  return "Positions of the robot at the start of contacts with people (gap below contact_distance "
         "of the metrics) or obstacles, in " +
         counted(pictures.runs.size(), "recorded run") +
         "; more intense colour of a 0.5 m square means more contacts, on the same scale in all "
         "maps" +
         truncationNote(shown, all, "scenarios with contacts") + "." +
         (others == 0 ? "" : " No contacts in " + counted(others, "other scenario") + ".");
}

constexpr double kMapHeight = 420.0;  // [px], maximum height of a map

PanelGrid gridOf(const std::vector<ContactMap>& maps, const RunPictures& pictures) {
  PanelGrid grid;
  grid.count = maps.size();
  grid.columns = maps.size() > 1 ? 2 : 1;
  grid.gap = 20.0;
  std::vector<double> heights;
  heights.reserve(maps.size());
  for (const ContactMap& map : maps) {
    heights.push_back(
        panelHeightOf(pictures.floorPlans.at(map.scenario), grid.panelWidth(), kMapHeight));
  }
  grid.fitRows(heights);
  return grid;
}

}  // namespace

std::optional<Figure> contactsFigure(const Study& study, const RunPictures& pictures) {
  std::vector<ContactMap> maps = contactMaps(study, pictures);
  const std::size_t all = maps.size();
  if (maps.empty()) {
    return std::nullopt;
  }
  maps.resize(std::min(kMostPanels, all));
  const PanelGrid grid = gridOf(maps, pictures);
  int most = 1;
  for (const ContactMap& map : maps) {
    most = std::max(most, map.most());
  }
  Figure figure("contacts", grid.width, grid.height() + kKeyHeight);
  FloorPlans floorPlans(figure, grid.panelWidth(), kMapHeight);
  grid.forEach([&](std::size_t index, double left, double top) {
    const ContactMap& map = maps[index];
    const std::string name = shortened(map.scenario.substr(study.commonPrefixLength), 60);
    figure.text(left, top + 12.0, name + ": " + counted(map.count, "contact"));
    const FloorPlan& floorPlan = pictures.floorPlans.at(map.scenario);
    heatSquares(figure, floorPlans.draw(map.scenario, floorPlan, left, top + kPanelHead),
                map.squares, most);
  });
  heatLegend(figure, grid.height() + kKeyHeight - 16.0, most);
  figure.caption = contactsCaption(pictures, maps.size(), all);
  return figure;
}

namespace {

constexpr std::size_t kMostWays = 16;  // per panel

std::vector<base::Vec2> inPanel(const std::vector<base::Vec2>& way, const MapPanel& panel) {
  std::vector<base::Vec2> points;
  points.reserve(way.size());
  for (const base::Vec2& point : way) {
    points.push_back(panel.at(point));
  }
  return points;
}

using CaseOption = std::pair<std::size_t, std::size_t>;  // case, option

std::map<CaseOption, std::vector<const RunPicture*>> pathsByCell(const Study& study,
                                                                 const RunPictures& pictures) {
  std::map<CaseOption, std::vector<const RunPicture*>> cells;
  for (const RunPicture& picture : pictures.runs) {
    if (picture.path.empty()) {
      continue;  // no robot
    }
    cells[{study.caseOf[picture.run], study.optionOf[picture.run]}].push_back(&picture);
  }
  return cells;
}

/// A panel with robot paths.
struct PathPanel {
  std::size_t ofCase = 0, option = 0;
  std::vector<const RunPicture*> ways;  // empty: no run to draw
};

class PathsFigureBuilder {
 public:
  PathsFigureBuilder(const Study& study, const RunPictures& pictures)
      : study_(study), pictures_(pictures) {}

  std::optional<Figure> make() {
    cells_ = pathsByCell(study_, pictures_);
    for (auto& [place, ways] : cells_) {
      isThinned_ = isThinned_ || ways.size() > kMostWays;
      ways.resize(std::min(ways.size(), kMostWays));
    }
    if (cells_.empty()) {
      return std::nullopt;
    }
    // With few options: one column per option and one row per case with paths.
    isTable_ = study_.options.size() > 1 && study_.options.size() <= 4;
    grid_.columns = isTable_ ? static_cast<int>(study_.options.size()) : 3;
    grid_.gap = 14.0;
    const std::string cut = isTable_ ? chooseRows() : chooseCells();
    grid_.count = panels_.size();
    std::vector<double> heights;
    heights.reserve(panels_.size());
    for (const PathPanel& panel : panels_) {
      heights.push_back(heightOf(panel));
    }
    grid_.fitRows(heights);
    Figure figure("trajectories", grid_.width, grid_.height());
    FloorPlans floorPlans(figure, grid_.panelWidth(), kMostHeight);
    grid_.forEach([&](std::size_t index, double left, double top) {
      draw(figure, floorPlans, index, {left, top});
    });
    figure.caption =
        "Paths of the robot on the map" +
        (isThinned_ ? ", at most " + std::to_string(kMostWays) + " runs per panel" : "") +
        "; a dot marks the end of a run" + cut + "." + omittedText();
    return figure;
  }

 private:
  static constexpr double kMostHeight = 260.0;  // of a map [px]
  static constexpr double kCaseHead = 20.0;     // [px]
  static constexpr double kLine = 13.0;         // of a title [px]

  std::string chooseRows() {
    std::set<std::size_t> rows;
    for (const auto& [place, ways] : cells_) {
      rows.insert(place.first);
    }
    const std::size_t options = study_.options.size();
    const std::size_t shown = std::min(rows.size(), kMostPanels / options);
    auto row = rows.begin();
    for (std::size_t k = 0; k < shown * options; ++k) {
      const CaseOption place = {*row, k % options};
      const auto cell = cells_.find(place);
      panels_.push_back({place.first, place.second,
                         cell == cells_.end() ? std::vector<const RunPicture*>() : cell->second});
      row = k % options + 1 == options ? std::next(row) : row;
    }
    return truncationNote(shown, rows.size(), "cases");
  }

  std::string chooseCells() {
    for (const auto& [place, ways] : cells_) {
      if (panels_.size() < kMostPanels) {
        panels_.push_back({place.first, place.second, ways});
      }
    }
    return truncationNote(panels_.size(), cells_.size(), "panels");
  }

  double caseHead() const { return isTable_ && study_.cases.size() > 1 ? kCaseHead : 0.0; }
  const std::string& scenarioOf(const PathPanel& panel) const {
    return study_.results.runs[panel.ways.front()->run].scenario;
  }
  double heightOf(const PathPanel& panel) const {
    const double more = kLine * static_cast<double>(titleOf(panel).size() - 1);
    return caseHead() + more +
           (panel.ways.empty() ? 2.0 * kPanelHead
                               : panelHeightOf(pictures_.floorPlans.at(scenarioOf(panel)),
                                               grid_.panelWidth(), kMostHeight));
  }
  /// The lines of the title.
  std::vector<std::string> titleOf(const PathPanel& panel) const {
    const std::string title =
        isTable_ || study_.cases.size() == 1
            ? study_.options[panel.option]
            : (study_.options.size() == 1 ? std::string() : study_.options[panel.option] + ", ") +
                  study_.cases[panel.ofCase];
    return wrapped(title, static_cast<std::size_t>(grid_.panelWidth() / kLetter));
  }

  void draw(Figure& figure, FloorPlans& floorPlans, std::size_t index, base::Vec2 corner) const {
    const PathPanel& panel = panels_[index];
    if (isTable_ && panel.option == 0 && caseHead() > 0.0) {
      constexpr double kSize = 11.5;
      figure.text(0.0, corner.y() + 12.0, shortened(study_.cases[panel.ofCase], 100), "ink",
                  Figure::Anchor::Start, kSize);
    }
    corner.y() += caseHead();
    const std::vector<std::string> title = titleOf(panel);
    for (std::size_t line = 0; line < title.size(); ++line) {
      figure.text(corner.x(), corner.y() + 12.0 + kLine * static_cast<double>(line), title[line],
                  isTable_ && caseHead() > 0.0 ? "dim" : "ink");
    }
    corner.y() += kLine * static_cast<double>(title.size() - 1);
    if (panel.ways.empty()) {
      figure.text(corner.x(), corner.y() + kPanelHead + 12.0, "no run drawn", "dim");
      return;
    }
    const std::string& scenario = scenarioOf(panel);
    const MapPanel map = floorPlans.draw(scenario, pictures_.floorPlans.at(scenario), corner.x(),
                                         corner.y() + kPanelHead);
    for (const RunPicture* way : panel.ways) {
      figure.polyline(inPanel(way->path, map), strokeOf(panel.option), 1.4, 0.6);
    }
    for (const RunPicture* way : panel.ways) {
      const base::Vec2 end = map.at(way->path.back());
      figure.disc(end.x(), end.y(), 2.2, fillOf(panel.option));
    }
  }

  /// Text about runs that are not drawn.
  std::string omittedText() const {
    const std::string read =
        pictures_.runs.size() < pictures_.kept
            ? " " + std::to_string(pictures_.runs.size()) + " of these folders were read."
            : "";
    return pictures_.kept < study_.runCount() || !read.empty()
               ? " Only runs with kept folders are drawn: " + std::to_string(pictures_.kept) +
                     " of " + std::to_string(study_.runCount()) + "." + read
               : "";
  }

  const Study& study_;
  const RunPictures& pictures_;
  std::map<CaseOption, std::vector<const RunPicture*>> cells_;
  std::vector<PathPanel> panels_;
  PanelGrid grid_;
  bool isTable_ = false;
  bool isThinned_ = false;  // some panel does not show all its runs
};

}  // namespace

std::optional<Figure> pathsFigure(const Study& study, const RunPictures& pictures) {
  return PathsFigureBuilder(study, pictures).make();
}

}  // namespace report
