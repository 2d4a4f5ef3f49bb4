#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "app/report/Study.h"
#include "metrics/RobotPlaces.h"
#include "sim2d/trace/Trace.h"

namespace report {

/// What pages show of one recorded run.
struct RunPicture {
  std::size_t run = 0;          // of the study
  std::vector<base::Vec2> way;  // of the robot [m], a point each 10 cm
  std::vector<metrics::RobotContact> contacts;
  std::string player;  // JSON for the page's player; empty = not asked for
};

/// Where runs take place.
struct Ground {
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();  // [m]
  std::vector<sim2d::Outline> walls, shapes;                       // of the map; drawn obstacles
};

Ground groundOf(const sim2d::Trace& trace);

/// What the player's head and its list say of a run.
struct PlayerWords {
  std::string title;         // "Run 42"
  std::string about = {};    // option, case and seed; empty = scenario and seed
  std::string outcome = {};  // of a run without success: what happened
};

/// JSON of a run for the page's player: places in cm, headings in 1/100 rad, as differences from
/// one sample to the next. `every` [s] between samples, at least the record's own. `contacts`:
/// those that metrics count are told even where the bodies did not touch.
std::string playerJson(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts, const PlayerWords& words,
                       double every);

struct RunPictures {
  std::vector<RunPicture> runs;           // in the order of the study's runs
  std::map<std::string, Ground> grounds;  // per scenario
  std::size_t kept = 0;                   // run folders that there are
  std::size_t keptFailures = 0;           // those of them without success
  base::Diagnostics problems;             // warnings: folders that cannot be read

  const RunPicture* of(std::size_t run) const;
};

/// Reads run folders that were kept: those of `failures` and of runs with contacts first, then some
/// per case and option; of the first failures and of a few others also the player's data.
RunPictures readRunPictures(const Study& study, const std::vector<std::size_t>& failures);

/// What the page says of runs that it cannot play: " 24 of the 32 can be played here …" for the
/// caption of the failures, and a sentence on the others; empty: all that were kept can be.
std::string playedFailuresText(const RunPictures& pictures,
                               const std::vector<std::size_t>& failures);
std::string playedOthersText(const RunPictures& pictures, const std::vector<std::size_t>& failures);

/// Ways of the robot on the map, a panel per case and option; null: there are none.
std::optional<Figure> waysFigure(const Study& study, const RunPictures& pictures);
/// Where contacts happen, a panel per scenario that has some; null: none has.
std::optional<Figure> contactsFigure(const Study& study, const RunPictures& pictures);

}  // namespace report
