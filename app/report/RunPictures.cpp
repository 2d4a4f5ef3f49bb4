#include "app/report/RunPictures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/report/Comparison.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"

namespace report {

namespace {

constexpr std::size_t kMostRead = 160;   // folders of runs
constexpr std::size_t kMostPerCell = 8;  // ways per case and option
constexpr std::size_t kMostPlayers = 24;
constexpr std::size_t kFewPlayers = 4;           // shown when nothing failed
constexpr std::size_t kPlayerBytes = 5'000'000;  // of all players
constexpr double kPlayerStep = 0.2;              // [s]
constexpr double kWayStep = 0.1;                 // [m]
constexpr std::size_t kMostPanels = 24;

/// Which run folders to read.
std::vector<std::size_t> chosenRuns(const Study& study, const std::vector<std::size_t>& failures,
                                    std::size_t& kept) {
  std::vector<bool> isKept(study.runCount());
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    isKept[run] = study.runFolder(run).has_value();
    kept += isKept[run] ? 1 : 0;
  }
  std::set<std::size_t> chosen;
  const auto take = [&](std::size_t run) {
    if (isKept[run] && chosen.size() < kMostRead) {
      chosen.insert(run);
    }
  };
  std::for_each(failures.begin(), failures.end(), take);
  for (const char* key :
       {"robot_on_person_collision", "person_on_robot_collision", "obstacle_collisions"}) {
    const std::size_t place = study.results.keyAt(key);
    for (std::size_t run = 0; place < study.results.keys.size() && run < study.runCount(); ++run) {
      if (study.valuesOf(place)[run] > 0.0) {
        take(run);
      }
    }
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> perCell;
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    if (isKept[run] && ++perCell[{study.caseOf[run], study.optionOf[run]}] <= kMostPerCell) {
      take(run);
    }
  }
  return {chosen.begin(), chosen.end()};
}

/// The first robot of an instant; null: there is none.
std::optional<base::Vec2> robotIn(const sim2d::Frame& frame) {
  for (std::size_t k = 0; k < frame.robots.size(); ++k) {
    if (frame.robots.id[k] == -1) {
      return base::Vec2(frame.robots.x[k], frame.robots.y[k]);
    }
  }
  return std::nullopt;
}

/// `problems`: of the metrics' settings that its record holds.
RunPicture pictureOf(const sim2d::Trace& trace, std::size_t run, base::Diagnostics& problems) {
  RunPicture picture;
  picture.run = run;
  for (const sim2d::Frame& frame : trace.frames) {
    const std::optional<base::Vec2> place = robotIn(frame);
    if (place && (picture.way.empty() || (*place - picture.way.back()).norm() >= kWayStep)) {
      picture.way.push_back(*place);
    }
  }
  app::MetricsSetup setup;
  problems = app::readMetricsSetup(trace.header, setup);
  picture.contacts = metrics::contactsOf(trace, setup.selection, setup.parameters);
  return picture;
}

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

/// Walls and shapes of a ground, drawn once and used in each of its panels.
class Grounds {
 public:
  Grounds(Figure& figure, double width, double height)
      : figure_(figure), width_(width), height_(height) {}

  MapPanel draw(const std::string& name, const Ground& ground, double left, double top) {
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

 private:
  Figure& figure_;
  double width_, height_;
  std::map<std::string, std::size_t> known_;
};

std::vector<base::Vec2> inPanel(const std::vector<base::Vec2>& way, const MapPanel& panel) {
  std::vector<base::Vec2> points;
  points.reserve(way.size());
  for (const base::Vec2& point : way) {
    points.push_back(panel.at(point));
  }
  return points;
}

constexpr double kPanelHead = 20.0;  // title [px]

/// With the title; a map is at least 60 px tall, at most `most`.
double panelHeightOf(const Ground& ground, double width, double most) {
  const base::Vec2 size = ground.high - ground.low;
  return kPanelHead + std::clamp(width * size.y() / size.x(), 60.0, most);
}

using CasePlace = std::pair<std::size_t, std::size_t>;  // case, option

std::map<CasePlace, std::vector<const RunPicture*>> waysByCell(const Study& study,
                                                               const RunPictures& pictures) {
  std::map<CasePlace, std::vector<const RunPicture*>> cells;
  for (const RunPicture& picture : pictures.runs) {
    auto& cell = cells[{study.caseOf[picture.run], study.optionOf[picture.run]}];
    if (picture.way.size() > 1 && cell.size() < 2 * kMostPerCell) {
      cell.push_back(&picture);
    }
  }
  return cells;
}

/// Squares of half a metre, the darker the more contacts.
void heatSquares(Figure& figure, const MapPanel& panel, const std::vector<base::Vec2>& contacts) {
  constexpr double kSquare = 0.5;  // [m]
  std::map<std::pair<int, int>, int> counts;
  int most = 1;
  for (const base::Vec2& place : contacts) {
    int& count = counts[{static_cast<int>(std::floor(place.x() / kSquare)),
                         static_cast<int>(std::floor(place.y() / kSquare))}];
    most = std::max(most, ++count);
  }
  for (const auto& [square, count] : counts) {
    const base::Vec2 corner = panel.at({square.first * kSquare, (square.second + 1) * kSquare});
    figure.rect(corner.x(), corner.y(), kSquare * panel.scale, kSquare * panel.scale, "hot",
                0.25 + 0.65 * count / most);
  }
}

}  // namespace

Ground groundOf(const sim2d::Trace& trace) {
  Ground ground;
  bool isFirst = true;
  const auto include = [&](const base::Vec2& point, double room) {
    const base::Vec2 around(room, room);
    ground.low = isFirst ? base::Vec2(point - around) : ground.low.cwiseMin(point - around).eval();
    ground.high =
        isFirst ? base::Vec2(point + around) : ground.high.cwiseMax(point + around).eval();
    isFirst = false;
  };
  for (const sim2d::TraceObstacle& obstacle : trace.header.obstacles) {
    for (const sim2d::Outline& outline : obstacle.outlines) {
      (obstacle.name == "map" ? ground.walls : ground.shapes).push_back(outline);
      for (const base::Vec2& point : outline.points) {
        include(point, 0.0);
      }
    }
  }
  for (const sim2d::Frame& frame : trace.frames) {
    const auto includeAll = [&include](const sim2d::BodyColumns& bodies) {
      for (std::size_t k = 0; k < bodies.size(); ++k) {
        include({bodies.x[k], bodies.y[k]}, 0.5);
      }
    };
    includeAll(frame.humans);
    includeAll(frame.robots);
  }
  if (isFirst) {
    include(base::Vec2::Zero(), 5.0);
  }
  return ground;
}

const RunPicture* RunPictures::of(std::size_t run) const {
  for (const RunPicture& picture : runs) {
    if (picture.run == run) {
      return &picture;
    }
  }
  return nullptr;
}

RunPictures readRunPictures(const Study& study, const std::vector<std::size_t>& failures) {
  RunPictures pictures;
  const std::vector<std::size_t> chosen = chosenRuns(study, failures, pictures.kept);
  const std::set<std::size_t> failed(failures.begin(), failures.end());
  std::size_t players = 0;
  std::size_t bytes = 0;
  const auto warn = [&pictures](const base::Diagnostics& problems) {
    for (base::Diagnostic problem : problems) {
      problem.severity = base::Severity::Warning;  // the report goes on
      pictures.problems.push_back(std::move(problem));
    }
  };
  for (const std::size_t run : chosen) {
    const base::Result<sim2d::Trace> trace = app::readRun(*study.runFolder(run));
    if (!trace) {
      warn(trace.diagnostics());
      continue;
    }
    base::Diagnostics problems;
    pictures.runs.push_back(pictureOf(*trace, run, problems));
    warn(problems);
    pictures.grounds.try_emplace(study.results.runs[run].scenario, groundOf(*trace));
    const std::size_t most = failed.count(run) != 0 ? kMostPlayers : kFewPlayers;
    if (players < most && bytes < kPlayerBytes) {
      pictures.runs.back().player =
          playerJson(*trace, pictures.runs.back().contacts,
                     "Run " + std::to_string(study.results.runs[run].number), kPlayerStep);
      bytes += pictures.runs.back().player.size();
      ++players;
    }
  }
  return pictures;
}

std::optional<Figure> waysFigure(const Study& study, const RunPictures& pictures) {
  const auto cells = waysByCell(study, pictures);
  if (cells.empty()) {
    return std::nullopt;
  }
  PanelGrid grid;
  grid.count = std::min(kMostPanels, cells.size());
  grid.columns = study.options.size() > 1 && study.options.size() <= 4
                     ? static_cast<int>(study.options.size())
                     : 3;
  grid.gap = 14.0;
  constexpr double kMostHeight = 260.0;
  std::vector<double> heights;
  heights.reserve(cells.size());
  for (const auto& [place, ways] : cells) {
    heights.push_back(
        ways.empty()
            ? kPanelHead
            : panelHeightOf(pictures.grounds.at(study.results.runs[ways.front()->run].scenario),
                            grid.panelWidth(), kMostHeight));
  }
  grid.fitRows(heights);
  Figure figure("trajectories", grid.width, grid.height());
  Grounds grounds(figure, grid.panelWidth(), kMostHeight);
  auto cell = cells.begin();
  grid.forEach([&](std::size_t /*index*/, double left, double top) {
    const auto& [place, ways] = *cell++;
    const auto& [ofCase, option] = place;
    const std::string title = study.cases.size() > 1
                                  ? study.options[option] + ", " + study.cases[ofCase]
                                  : study.options[option];
    figure.text(left, top + 12.0,
                shortened(title, static_cast<std::size_t>(grid.panelWidth() / 6.4)));
    if (ways.empty()) {
      return;
    }
    const std::string& scenario = study.results.runs[ways.front()->run].scenario;
    const MapPanel panel =
        grounds.draw(scenario, pictures.grounds.at(scenario), left, top + kPanelHead);
    for (const RunPicture* way : ways) {
      figure.polyline(inPanel(way->way, panel), strokeOf(option), 1.4, 0.6);
    }
    for (const RunPicture* way : ways) {
      const base::Vec2 end = panel.at(way->way.back());
      figure.disc(end.x(), end.y(), 2.2, fillOf(option));
    }
  });
  figure.caption =
      "Ways of the robot on the map, up to " + std::to_string(2 * kMostPerCell) +
      " runs a panel; the dot is where a run ends" +
      (cells.size() > kMostPanels ? " (the first " + std::to_string(kMostPanels) + " panels)."
                                  : ".") +
      (pictures.kept < study.runCount()
           ? " Drawn are runs whose folders were kept: " + std::to_string(pictures.kept) + " of " +
                 std::to_string(study.runCount()) + "."
           : "");
  return figure;
}

std::optional<Figure> contactsFigure(const Study& study, const RunPictures& pictures) {
  std::map<std::string, std::vector<base::Vec2>> contacts;
  for (const RunPicture& picture : pictures.runs) {
    for (const metrics::RobotContact& contact : picture.contacts) {
      contacts[study.results.runs[picture.run].scenario].push_back(contact.place);
    }
  }
  if (contacts.empty()) {
    return std::nullopt;
  }
  PanelGrid grid;
  grid.count = std::min(kMostPanels, contacts.size());
  grid.columns = contacts.size() > 1 ? 2 : 1;
  grid.gap = 20.0;
  constexpr double kMostHeight = 420.0;
  std::vector<double> heights;
  heights.reserve(contacts.size());
  for (const auto& [name, places] : contacts) {
    heights.push_back(panelHeightOf(pictures.grounds.at(name), grid.panelWidth(), kMostHeight));
  }
  grid.fitRows(heights);
  Figure figure("contacts", grid.width, grid.height());
  Grounds grounds(figure, grid.panelWidth(), kMostHeight);
  auto scenario = contacts.begin();
  grid.forEach([&](std::size_t /*index*/, double left, double top) {
    const auto& [name, places] = *scenario++;
    figure.text(left, top + 12.0,
                shortened(name.substr(study.sharedFolder), 60) + ": " +
                    std::to_string(places.size()) +
                    (places.size() == 1 ? " contact" : " contacts"));
    const MapPanel panel = grounds.draw(name, pictures.grounds.at(name), left, top + kPanelHead);
    heatSquares(figure, panel, places);
  });
  const std::size_t others = pictures.grounds.size() - contacts.size();
  figure.caption =
      "Where the robot was when contacts with people or obstacles began, per square of 0.5 m, in " +
      std::to_string(pictures.runs.size()) +
      (pictures.runs.size() == 1 ? " recorded run." : " recorded runs.") +
      (others == 0 ? ""
                   : " None in the " + std::to_string(others) +
                         (others == 1 ? " other scenario." : " other scenarios."));
  return figure;
}

}  // namespace report
