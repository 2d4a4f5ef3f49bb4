#include "metrics/Counterfactual.h"
#include "metrics/MetricRegistry.h"
#include "metrics/PlanningTime.h"
#include "sim2d/base/Text.h"

namespace metrics {

namespace {

/// Text of a table cell: bars would end it.
std::string cellOf(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    cell += c == '|' ? std::string("\\|") : std::string(1, c);
  }
  return cell.empty() ? "-" : cell;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += " " + cell + " |";
  }
  return text + "\n";
}

std::string categoryTable(const MetricRegistry& registry, Category category) {
  std::string text = "\n## " + std::string(categoryName(category)) + "\n\n";
  text +=
      row({"#", "key", "meaning", "unit", "formula", "range", "better", "rate", "needs", "source"});
  text += "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const MetricEntry& entry : registry.entries()) {
    const MetricInfo& info = entry.info;
    if (info.category != category) {
      continue;
    }
    text += row({info.hunav > 0 ? std::to_string(info.hunav) : "", "`" + info.key + "`",
                 cellOf(info.name), cellOf(info.unit), cellOf(info.formula), cellOf(info.range),
                 betterName(info.better), base::formatDouble(100.0 * info.rateBound) + " %",
                 needsText(info.needs), cellOf(info.source)});
  }
  return text;
}

std::string parameterTable() {
  std::string text = "\n## Parameters\n\n" + row({"name", "default", "unit", "meaning"});
  text += "|---|---|---|---|\n";
  for (const ParameterInfo& info : parameterInfos()) {
    const base::ParameterSpec& spec = info.spec;
    text += row({"`" + spec.key + "`", base::formatDouble(std::get<double>(spec.fallback)),
                 cellOf(spec.unit), cellOf(spec.help)});
  }
  return text;
}

constexpr char kIntroduction[] = R"(# Metrics

Written by `hunavsim list metrics --format markdown`; do not edit by hand.

Numbers in the first column are those of HuNavSim's evaluator; the others are ours. SI units,
radians, world frame. A record has N samples at times t_i, dt_i = t_(i+1) - t_i, T = the whole time.
Robot: position p, heading psi, velocity v, speed s = |v|, turning speed w, radius r_r. Person a:
position q, velocity u, radius r_a. d = |p - q|, gap = d - r_r - r_a, c_i = smallest gap at sample i,
not below 0. F = social force, O = mean obstacle force. Closing velocity V = v - u, R = r_r + r_a.
D = gap, at least surprise_minimum_distance. ttc = time to collision on straight courses.

Profile `corrected` (default) uses the formulas below. Profile `hunav2` gives the same numbers as
the public HuNavSim 2.0 evaluator, with its peculiarities. A value that a record does not define is
empty in CSV and `null` in JSON, with the reason; so is an infinite one, which only the evaluator's own
files (`--layout`) have as `inf`.

Of several robots each is measured for itself, as if the others were not there. The values of the
first stand where those of a single one do; those of the others in `metrics.json` below `robots`, in
`metrics_<robot>.csv` and `steps_<robot>.csv`, and in columns `<robot>.<key>` of a batch
(`evaluate --robot` measures one alone). A `--reference` is beside the first.

Metrics that need a robot are those of its way (`corrected`): N and T count from when it sets off to
when it arrives, between two samples to the second; parked it neither stands still nor runs into
anybody. It arrives by the event `arrived`; where there is none, where it came to stand
(`stop_linear_speed`, `stop_angular_speed`) in the region of `completed`, if it does to the end. A
robot with a goal that does not arrive has failed after `time_limit`: its way ends there, or with the
record. While a run goes on this is said of it so far. `from` and `until` of the scenario's metrics,
where one of them says something else than the whole record, are heeded instead of both. Metrics of
people alone look at the whole record. A recorded reference is that part of its run, of the same
robot, or of its first.

Shortest ways are those of a disc of the robot's radius round walls, map and obstacles, doors open:
pulled tight, of all ways over cells the shortest, unknown ground only where nothing else leads
there. Cells know 16 directions: another side of some obstacle may be shorter by 3.1 % of the way and
about a cell at each corner, hence `path_efficiency`, `spl` and `stl` too high by so much, at most. A
passage less than a cell wider than the robot may count as closed.

Obstacle points of O are worked out from the walls, obstacles and closed doors of a run. A recording of
another program that carries points (`closest_obs` of hunav_msgs) is measured with those: for people
where anybody has some, for the robot where it has some; then its clearance is the smaller one of the
distances to the points and to the walls of the map. Without points, map and obstacles O is undefined,
in `hunav2` 0. The factor of F on a person is that of the recording (`social_force_factor`), else
`social_factor`.

The sums 25-34 grow with the recording rate; each is given a second time divided by N, with `_mean`
at its key. Column rate: largest change when a record of smooth motion is sampled twice
as often, from 20 Hz on, as a share of the larger value, which counts as at least 0.1.
)";

std::string listOf(const std::vector<MetricInfo>& infos) {
  std::string text;
  for (const MetricInfo& info : infos) {
    text += "- `" + info.key + "`: " + info.name + " [" + info.unit + "], " + info.formula + "; " +
            info.range + ", " + betterName(info.better) + " is better, source: " + info.source +
            "\n";
  }
  return text;
}

constexpr char kEffects[] =
    "\n## What the robot did to people\n\nOnly of `run --counterfactual`: the run beside one of "
    "the same seed without robots. Lengths and\ntimes up to the last goal that both have in "
    "common; `counterfactual.csv` has them per person.\n\n";

constexpr char kPlanning[] =
    "\n## Measured by the clock\n\nDiffers from run to run, so it is in the table that `run` "
    "prints "
    "and in `manifest.json` (`null`\nwithout robot) and not among the metrics, which are those of "
    "the record.\n\n";

}  // namespace

std::string metricsMarkdown(const MetricRegistry& registry) {
  std::string text = kIntroduction;
  for (int category = 0; category < kCategories; ++category) {
    text += categoryTable(registry, static_cast<Category>(category));
  }
  return text + kEffects + listOf(effectInfos()) + kPlanning + listOf(planningInfos()) +
         parameterTable();
}

}  // namespace metrics
