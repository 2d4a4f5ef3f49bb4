#include "app/report/RunPictures.h"

#include <algorithm>
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

/// Runs that were kept: the first of each case and option, then the second of each, and so on.
std::vector<std::size_t> inRounds(const Study& study, const std::vector<bool>& isKept) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> perCell;
  std::vector<std::vector<std::size_t>> rounds(kMostPerCell);
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    std::size_t& before = perCell[{study.caseOf[run], study.optionOf[run]}];
    if (isKept[run] && before < kMostPerCell) {
      rounds[before++].push_back(run);
    }
  }
  std::vector<std::size_t> runs;
  for (const std::vector<std::size_t>& round : rounds) {
    runs.insert(runs.end(), round.begin(), round.end());
  }
  return runs;
}

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
  const std::vector<std::size_t> others = inRounds(study, isKept);
  std::for_each(others.begin(), others.end(), take);
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

}  // namespace report
