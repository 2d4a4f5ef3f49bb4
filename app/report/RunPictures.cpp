#include "app/report/RunPictures.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/report/Comparison.h"
#include "app/report/Plots.h"
#include "app/run/MetricsSetup.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr std::size_t kMostRead = 160;     // run folders
constexpr std::size_t kMostPerCell = 8;    // paths per case and option
constexpr std::size_t kMostFailures = 24;  // failures in the player
constexpr std::size_t kMostOthers = 4;     // other runs in the player, from several options
constexpr std::size_t kFailureBytes = 5'000'000, kOtherBytes = 2'000'000;
constexpr double kPlayerStep = 0.2;  // [s]
constexpr double kWayStep = 0.1;     // [m]

/// The kept runs in the order: the first of each case and option, then the second of each, and so
/// on.
std::vector<std::size_t> roundRobin(const Study& study, const std::vector<bool>& isKept) {
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

/// Selects the run folders to read and counts the kept ones.
std::vector<std::size_t> chosenRuns(const Study& study, const std::vector<std::size_t>& failures,
                                    RunPictures& pictures) {
  std::vector<bool> isKept(study.runCount());
  for (std::size_t run = 0; run < study.runCount(); ++run) {
    isKept[run] = study.runFolder(run).has_value();
    pictures.kept += isKept[run] ? 1 : 0;
  }
  std::set<std::size_t> chosen;
  const auto take = [&](std::size_t run) {
    if (isKept[run] && chosen.size() < kMostRead) {
      chosen.insert(run);
    }
  };
  for (const std::size_t run : failures) {
    pictures.keptFailures += isKept[run] ? 1 : 0;
    take(run);
  }
  for (const char* key :
       {"robot_on_person_collision", "person_on_robot_collision", "obstacle_collisions"}) {
    const std::size_t place = study.results.keyAt(key);
    for (std::size_t run = 0; place < study.results.keys.size() && run < study.runCount(); ++run) {
      if (study.valuesOf(place)[run] > 0.0) {
        take(run);
      }
    }
  }
  const std::vector<std::size_t> others = roundRobin(study, isKept);
  std::for_each(others.begin(), others.end(), take);
  return {chosen.begin(), chosen.end()};
}

/// The position of the first robot in a frame. Nothing: no robot.
std::optional<base::Vec2> robotIn(const sim2d::Frame& frame) {
  for (std::size_t k = 0; k < frame.robots.size(); ++k) {
    if (frame.robots.id[k] == -1) {
      return base::Vec2(frame.robots.x[k], frame.robots.y[k]);
    }
  }
  return std::nullopt;
}

/// `problems`: errors in the trace's metrics settings.
RunPicture pictureOf(const sim2d::Trace& trace, std::size_t run, base::Diagnostics& problems) {
  RunPicture picture;
  picture.run = run;
  for (const sim2d::Frame& frame : trace.frames) {
    const std::optional<base::Vec2> place = robotIn(frame);
    if (place && (picture.path.empty() || (*place - picture.path.back()).norm() >= kWayStep)) {
      picture.path.push_back(*place);
    }
  }
  app::MetricsSetup setup;
  problems = app::readMetricsSetup(trace.header, setup);
  picture.contacts = metrics::robotContacts(trace, setup.selection, setup.parameters);
  return picture;
}

/// Selects the runs for the player, in run order: the first failures, and a few other runs of each
/// option.
class PlayerSelection {
 public:
  PlayerSelection(const Study& study, const std::vector<std::size_t>& failures)
      : study_(study), failures_(failures.begin(), failures.end()) {}

  bool accepts(std::size_t run) const {
    if (failures_.count(run) != 0) {
      return failed_.count < kMostFailures && failed_.bytes < kFailureBytes;
    }
    const std::size_t share = std::max<std::size_t>(1, kMostOthers / study_.options.size());
    const auto ofOption = perOption_.find(study_.optionOf[run]);
    return others_.count < kMostOthers && others_.bytes < kOtherBytes &&
           (ofOption == perOption_.end() || ofOption->second < share);
  }
  void take(std::size_t run, std::size_t bytes) {
    Total& total = failures_.count(run) != 0 ? failed_ : others_;
    ++total.count;
    total.bytes += bytes;
    if (failures_.count(run) == 0) {
      ++perOption_[study_.optionOf[run]];
    }
  }

  /// The description of a run: "dwa, corridor, seed 13", "robot1.max_vel 0.5, corridor, seed 13".
  PlayerLabels labelsOf(std::size_t run) const {
    const Results::Run& row = study_.results.runs[run];
    std::string about;
    if (study_.options.size() > 1) {
      const std::string& option = study_.options[study_.optionOf[run]];
      about = (base::parseDouble(option) ? study_.compared + " " : "") + option + ", ";
    }
    if (study_.cases.size() > 1 || study_.compared != "scenario") {
      about += study_.cases[study_.caseOf[run]] + ", ";
    }
    return {"Run " + std::to_string(row.number), about + "seed " + std::to_string(row.seed),
            failures_.count(run) != 0 ? study_.outcomeText(run) : std::string()};
  }

 private:
  struct Total {
    std::size_t count = 0, bytes = 0;
  };

  const Study& study_;
  std::set<std::size_t> failures_;
  Total failed_, others_;
  std::map<std::size_t, std::size_t> perOption_;
};

/// The number of runs in the player, of failures or of other runs.
std::size_t playersOf(const RunPictures& pictures, const std::vector<std::size_t>& failures,
                      bool ofFailures) {
  const std::set<std::size_t> failed(failures.begin(), failures.end());
  return static_cast<std::size_t>(
      std::count_if(pictures.runs.begin(), pictures.runs.end(), [&](const RunPicture& picture) {
        return !picture.player.empty() && (failed.count(picture.run) != 0) == ofFailures;
      }));
}

}  // namespace

FloorPlan floorPlanOf(const sim2d::Trace& trace) {
  FloorPlan floorPlan;
  bool isFirst = true;
  const auto include = [&](const base::Vec2& point, double room) {
    const base::Vec2 around(room, room);
    floorPlan.low =
        isFirst ? base::Vec2(point - around) : floorPlan.low.cwiseMin(point - around).eval();
    floorPlan.high =
        isFirst ? base::Vec2(point + around) : floorPlan.high.cwiseMax(point + around).eval();
    isFirst = false;
  };
  for (const sim2d::TraceObstacle& obstacle : trace.header.obstacles) {
    for (const sim2d::Outline& outline : obstacle.outlines) {
      (obstacle.name == "map" ? floorPlan.walls : floorPlan.shapes).push_back(outline);
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
  return floorPlan;
}

RunPictures readRunPictures(const Study& study, const std::vector<std::size_t>& failures) {
  RunPictures pictures;
  const std::vector<std::size_t> chosen = chosenRuns(study, failures, pictures);
  PlayerSelection choice(study, failures);
  const auto warn = [&pictures](const base::Diagnostics& problems) {
    for (base::Diagnostic problem : problems) {
      problem.severity = base::Severity::Warning;  // the report continues
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
    pictures.floorPlans.try_emplace(study.results.runs[run].scenario, floorPlanOf(*trace));
    if (choice.accepts(run)) {
      RunPicture& picture = pictures.runs.back();
      picture.player = playerJson(*trace, picture.contacts, choice.labelsOf(run), kPlayerStep);
      choice.take(run, picture.player.size());
    }
  }
  return pictures;
}

std::string playedFailuresText(const RunPictures& pictures,
                               const std::vector<std::size_t>& failures) {
  const std::size_t played = playersOf(pictures, failures, true);
  if (pictures.keptFailures == 0 || played == failures.size()) {
    return {};
  }
  const std::string kept = std::to_string(pictures.keptFailures);
  return " " + std::to_string(played) + " of the " + std::to_string(failures.size()) +
         " can be played here" +
         (pictures.keptFailures == failures.size() ? "; the page size is limited."
          : played == pictures.keptFailures
              ? "; the folders of the others were not kept."
              : "; the folders of " + kept + " were kept, and the page size is limited.");
}

std::string playedOthersText(const RunPictures& pictures,
                             const std::vector<std::size_t>& failures) {
  const std::size_t played = playersOf(pictures, failures, false);
  const std::size_t kept = pictures.kept - pictures.keptFailures;
  return played == kept ? std::string()
                        : "The player contains " + std::to_string(played) + " of the " +
                              std::to_string(kept) + " runs with success that were kept.";
}

namespace {

constexpr double kTimes = 40.0;    // [px], time axis below the last panel
constexpr double kCaption = 18.0;  // [px]
constexpr double kDigit = 6.4;     // [px], width of a digit at 10 px

/// The vertical axis of a panel.
struct ValueAxis {
  Scale scale;
  std::vector<double> at;  // ticks
};

Extent finiteExtent(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) {
    if (std::isfinite(value)) {
      extent.add(value);
    }
  }
  return extent;
}

/// Starts at 0 if the values are near it; extends to whole steps.
ValueAxis axisOf(const std::vector<double>& values, double height) {
  constexpr double kWidest = 1e300;
  auto [low, high] = finiteExtent(values);
  if (!(low <= high) || high - low > kWidest) {
    low = 0.0;
    high = 1.0;
  }
  if (low > 0.0 && low < 0.6 * high) {
    low = 0.0;
  }
  if (high - low < 1e-9) {
    low = std::min(low, 0.0);
    high = high > low ? high : low + 1.0;
  }
  const double step = tickStep(high - low, 4);
  low = step * std::floor(low / step + 1e-9);
  high = step * std::ceil(high / step - 1e-9);
  return {{low, high, height, 0.0},
          ticks(low, high, static_cast<int>(std::lround((high - low) / step)))};
}

/// The curve of a panel and those over it.
std::vector<const TimeCurve*> curvesOf(const TimeCurve& panel) {
  std::vector<const TimeCurve*> all = {&panel};
  for (const TimeCurve& curve : panel.overlaid) {
    all.push_back(&curve);
  }
  return all;
}

std::vector<double> panelValues(const TimeCurve& panel) {
  std::vector<double> values;
  for (const TimeCurve* curve : curvesOf(panel)) {
    values.insert(values.end(), curve->values.begin(), curve->values.end());
  }
  return values;
}

/// The times of all curves; at least 1 s if they have no duration.
Extent timesOf(const std::vector<TimeCurve>& panels) {
  Extent times;
  for (const TimeCurve& panel : panels) {
    for (const TimeCurve* curve : curvesOf(panel)) {
      if (!curve->times.empty()) {
        times.add(curve->times.front());
        times.add(curve->times.back());
      }
    }
  }
  if (!(times.high > times.low)) {
    times.low = std::isfinite(times.low) ? times.low : 0.0;
    times.high = times.low + 1.0;
  }
  return times;
}

/// Undefined values are gaps; a value between two gaps is a dot.
void drawCurve(Figure& figure, const TimeCurve& curve, std::size_t option, const Scale& across,
               const Scale& up) {
  std::vector<base::Vec2> line;
  const std::size_t end = std::min(curve.times.size(), curve.values.size());
  for (std::size_t k = 0; k <= end; ++k) {
    if (k < end && std::isfinite(curve.values[k])) {
      line.emplace_back(across.at(curve.times[k]), up.at(curve.values[k]));
      continue;
    }
    if (line.size() == 1) {
      figure.disc(line.front().x(), line.front().y(), 1.0, fillOf(option));
    }
    figure.polyline(line, strokeOf(option), 1.4);
    line.clear();
  }
}

/// Draws the curves of a panel; several have a mark at their ends and a legend that ends at the
/// right edge.
void drawCurves(Figure& figure, const TimeCurve& panel, const Scale& across, const Scale& up,
                double legendY) {
  const std::vector<const TimeCurve*> curves = curvesOf(panel);
  for (std::size_t k = curves.size(); k-- > 0;) {
    drawCurve(figure, *curves[k], k, across, up);
  }
  if (curves.size() < 2) {
    return;
  }
  double right = across.to;
  for (std::size_t k = curves.size(); k-- > 0;) {
    const TimeCurve& curve = *curves[k];
    const std::size_t points = std::min(curve.times.size(), curve.values.size());
    if (points > 0 && std::isfinite(curve.values[points - 1])) {
      figure.mark(across.at(curve.times[points - 1]), up.at(curve.values[points - 1]), k, 3.5);
    }
    figure.text(right, legendY, curve.label, "ink", Figure::Anchor::End, 10.0);
    right -= kLetter * static_cast<double>(characterCount(curve.label)) + 10.0;
    figure.mark(right, legendY - 3.5, k, 3.5);
    right -= 14.0;
  }
}

}  // namespace

Figure timePlot(const std::vector<TimeCurve>& curves, double width, const std::string& caption,
                std::optional<double> at) {
  const bool isNarrow = width < 900.0;
  const double margin = isNarrow ? 10.0 : 32.0;
  const double height = isNarrow ? 84.0 : 120.0;
  std::vector<ValueAxis> axes;
  std::size_t digits = 0;
  for (const TimeCurve& curve : curves) {
    axes.push_back(axisOf(panelValues(curve), height));
    for (const std::string& text : tickTexts(axes.back().scale, axes.back().at)) {
      digits = std::max(digits, characterCount(text));
    }
  }
  PanelGrid grid;
  grid.count = curves.size();
  grid.columns = 1;
  grid.panelHeight = kTitle + height;
  grid.gap = 6.0;
  const double left = margin + kDigit * static_cast<double>(digits) + 8.0;
  const double bottom = margin + grid.height();
  const Extent times = timesOf(curves);
  const Scale across{times.low, times.high, left, width - margin - 8.0};
  Figure figure("plot", width, bottom + kTimes + (caption.empty() ? 0.0 : kCaption) + margin);
  grid.forEach([&](std::size_t k, double /*left*/, double above) {
    const TimeCurve& curve = curves[k];
    panelTitle(figure, titleOf({{}, curve.name, curve.unit}), left, margin + above);
    ValueAxis& axis = axes[k];
    const double top = margin + above + kTitle;
    axis.scale.from += top;
    axis.scale.to += top;
    verticalAxis(figure, axis.scale, axis.at, across.from, across.to);
    if (at && *at >= times.low && *at <= times.high) {
      figure.line(across.at(*at), top, across.at(*at), top + height, "accent");
    }
    drawCurves(figure, curve, across, axis.scale, margin + above + kTitle - 8.0);
  });
  horizontalAxis(figure, across, bottom);
  figure.text(across.to, bottom + 30.0, "time [s]", "dim", Figure::Anchor::End, 10.0);
  if (!caption.empty()) {
    figure.text(left, bottom + kTimes + kCaption - 4.0, caption, "dim", Figure::Anchor::Start,
                10.0);
  }
  return figure;
}

}  // namespace report
