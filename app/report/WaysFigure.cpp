#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "app/report/MapPanels.h"

namespace report {

namespace {

constexpr std::size_t kMostWays = 16;  // in a panel

std::vector<base::Vec2> inPanel(const std::vector<base::Vec2>& way, const MapPanel& panel) {
  std::vector<base::Vec2> points;
  points.reserve(way.size());
  for (const base::Vec2& point : way) {
    points.push_back(panel.at(point));
  }
  return points;
}

using CasePlace = std::pair<std::size_t, std::size_t>;  // case, option

std::map<CasePlace, std::vector<const RunPicture*>> waysByCell(const Study& study,
                                                               const RunPictures& pictures) {
  std::map<CasePlace, std::vector<const RunPicture*>> cells;
  for (const RunPicture& picture : pictures.runs) {
    if (picture.way.empty()) {
      continue;  // there is no robot
    }
    auto& cell = cells[{study.caseOf[picture.run], study.optionOf[picture.run]}];
    if (cell.size() < kMostWays) {
      cell.push_back(&picture);
    }
  }
  return cells;
}

/// The panels of ways: titles and what is in each.
struct WayPanel {
  std::size_t ofCase = 0, option = 0;
  std::vector<const RunPicture*> ways;  // none: no run to draw
};

class WaysMaker {
 public:
  WaysMaker(const Study& study, const RunPictures& pictures) : study_(study), pictures_(pictures) {}

  std::optional<Figure> make() {
    cells_ = waysByCell(study_, pictures_);
    if (cells_.empty()) {
      return std::nullopt;
    }
    // Few options: a column each, and a row for each case that has a way at all.
    isTable_ = study_.options.size() > 1 && study_.options.size() <= 4;
    grid_.columns = isTable_ ? static_cast<int>(study_.options.size()) : 3;
    grid_.gap = 14.0;
    const std::string cut = isTable_ ? chooseRows() : chooseCells();
    grid_.count = panels_.size();
    std::vector<double> heights;
    heights.reserve(panels_.size());
    for (const WayPanel& panel : panels_) {
      heights.push_back(heightOf(panel));
    }
    grid_.fitRows(heights);
    Figure figure("trajectories", grid_.width, grid_.height());
    Grounds grounds(figure, grid_.panelWidth(), kMostHeight);
    grid_.forEach([&](std::size_t index, double left, double top) {
      draw(figure, grounds, index, {left, top});
    });
    figure.caption = "Ways of the robot on the map, up to " + std::to_string(kMostWays) +
                     " runs a panel; the dot is where a run ends" + cut + "." + keptText();
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
      const CasePlace place = {*row, k % options};
      const auto cell = cells_.find(place);
      panels_.push_back({place.first, place.second,
                         cell == cells_.end() ? std::vector<const RunPicture*>() : cell->second});
      row = k % options + 1 == options ? std::next(row) : row;
    }
    return cutText(shown, rows.size(), "cases");
  }

  std::string chooseCells() {
    for (const auto& [place, ways] : cells_) {
      if (panels_.size() < kMostPanels) {
        panels_.push_back({place.first, place.second, ways});
      }
    }
    return cutText(panels_.size(), cells_.size(), "panels");
  }

  double caseHead() const { return isTable_ && study_.cases.size() > 1 ? kCaseHead : 0.0; }
  const std::string& scenarioOf(const WayPanel& panel) const {
    return study_.results.runs[panel.ways.front()->run].scenario;
  }
  double heightOf(const WayPanel& panel) const {
    const double more = kLine * static_cast<double>(titleOf(panel).size() - 1);
    return caseHead() + more +
           (panel.ways.empty() ? 2.0 * kPanelHead
                               : panelHeightOf(pictures_.grounds.at(scenarioOf(panel)),
                                               grid_.panelWidth(), kMostHeight));
  }
  /// Draws the title in as many lines as it needs.
  std::vector<std::string> titleOf(const WayPanel& panel) const {
    const std::string title =
        isTable_ || study_.cases.size() == 1
            ? study_.options[panel.option]
            : (study_.options.size() == 1 ? std::string() : study_.options[panel.option] + ", ") +
                  study_.cases[panel.ofCase];
    return wrapped(title, static_cast<std::size_t>(grid_.panelWidth() / kLetter));
  }

  void draw(Figure& figure, Grounds& grounds, std::size_t index, base::Vec2 corner) const {
    const WayPanel& panel = panels_[index];
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
    const MapPanel map =
        grounds.draw(scenario, pictures_.grounds.at(scenario), corner.x(), corner.y() + kPanelHead);
    for (const RunPicture* way : panel.ways) {
      figure.polyline(inPanel(way->way, map), strokeOf(panel.option), 1.4, 0.6);
    }
    for (const RunPicture* way : panel.ways) {
      const base::Vec2 end = map.at(way->way.back());
      figure.disc(end.x(), end.y(), 2.2, fillOf(panel.option));
    }
  }

  /// Which runs are missing.
  std::string keptText() const {
    const std::string read =
        pictures_.runs.size() < pictures_.kept
            ? " " + std::to_string(pictures_.runs.size()) + " of these folders were read."
            : "";
    return pictures_.kept < study_.runCount() || !read.empty()
               ? " Drawn are runs whose folders were kept: " + std::to_string(pictures_.kept) +
                     " of " + std::to_string(study_.runCount()) + "." + read
               : "";
  }

  const Study& study_;
  const RunPictures& pictures_;
  std::map<CasePlace, std::vector<const RunPicture*>> cells_;
  std::vector<WayPanel> panels_;
  PanelGrid grid_;
  bool isTable_ = false;
};

}  // namespace

std::optional<Figure> waysFigure(const Study& study, const RunPictures& pictures) {
  return WaysMaker(study, pictures).make();
}

}  // namespace report
