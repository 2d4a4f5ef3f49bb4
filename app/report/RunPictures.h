#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "app/report/Study.h"
#include "metrics/RunResults.h"
#include "sim2d/trace/Trace.h"

namespace report {

/// The displayed data of one recorded run.
struct RunPicture {
  std::size_t run = 0;           // index in the study
  std::vector<base::Vec2> path;  // [m], path of the robot, a point every 10 cm
  std::vector<metrics::RobotContact> contacts;
  std::string player;  // JSON for the player; empty: not in the player
};

/// The map of a scenario.
struct FloorPlan {
  base::Vec2 low = base::Vec2::Zero(), high = base::Vec2::Zero();  // [m]
  std::vector<sim2d::Outline> walls, shapes;                       // map walls; other obstacles
};

FloorPlan floorPlanOf(const sim2d::Trace& trace);

/// The texts of a run in the player.
struct PlayerLabels {
  std::string title;         // "Run 42"
  std::string about = {};    // option, case, seed; empty: scenario, seed
  std::string outcome = {};  // outcome of a run without success
};

/// The JSON of a run for the player: positions in cm, headings in 1/100 rad, as differences between
/// samples. `every`: sample interval [s], at least that of the trace. `contacts`: contacts counted
/// by metrics are listed even without a contact event.
std::string playerJson(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const PlayerLabels& words, double every);

struct RunPictures {
  std::vector<RunPicture> runs;                 // in run order
  std::map<std::string, FloorPlan> floorPlans;  // per scenario
  std::size_t kept = 0;                         // number of kept run folders
  std::size_t keptFailures = 0;                 // kept run folders without success
  base::Diagnostics problems;                   // warnings: unreadable folders
};

/// Reads kept run folders: first those of `failures` and of runs with contacts, then some per case
/// and option. The first failures and a few other runs also get player data.
RunPictures readRunPictures(const Study& study, const std::vector<std::size_t>& failures);

/// Text about runs that the player does not contain: " 24 of the 32 can be played here …" for the
/// caption of the failures, and a sentence about the other runs. Empty: all kept runs can be
/// played.
std::string playedFailuresText(const RunPictures& pictures,
                               const std::vector<std::size_t>& failures);
std::string playedOthersText(const RunPictures& pictures, const std::vector<std::size_t>& failures);

/// The robot's paths on the map, one panel per case and option. Nothing: no paths.
std::optional<Figure> pathsFigure(const Study& study, const RunPictures& pictures);
/// The positions of contacts, one panel per scenario with contacts. Nothing: no contacts.
std::optional<Figure> contactsFigure(const Study& study, const RunPictures& pictures);

/// A metric over the time of a run.
struct TimeCurve {
  std::string name, unit;             // unit: empty = none
  std::vector<double> times;          // [s], ascending
  std::vector<double> values;         // NaN: undefined, a gap
  std::string label{};                // in the legend, if there are several curves in a panel
  std::vector<TimeCurve> overlaid{};  // further curves of the panel, with the same unit
};

/// Metrics over time for a paper, one panel above the other with a common time axis; at least one
/// curve. Overlaid curves have the colours and marks of options, with a legend above the panel.
/// `width` [px]: below 900 the figure is for a column or page. `caption`: a line below; `at` [s]:
/// the time of a vertical line, if it is within the run.
Figure timePlot(const std::vector<TimeCurve>& curves, double width, const std::string& caption = {},
                std::optional<double> at = {});

}  // namespace report
