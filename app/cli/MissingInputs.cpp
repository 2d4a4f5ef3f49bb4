#include "app/cli/MissingInputs.h"

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Text.h"

namespace app {
namespace {

using metrics::MetricInfo;

constexpr char kRecorded[] = "recorded";  // model of people, type of the robot

bool isForeign(const sim2d::TraceHeader& header) {
  const bool hasPeople =
      std::any_of(header.humans.begin(), header.humans.end(),
                  [](const sim2d::TraceHuman& human) { return human.model == kRecorded; });
  return hasPeople || (!header.robots.empty() && header.robots.front().type == kRecorded);
}

bool hasOutlines(const sim2d::TraceHeader& header) {
  return !header.map.isEmpty() ||
         std::any_of(header.obstacles.begin(), header.obstacles.end(),
                     [](const sim2d::TraceObstacle& each) { return !each.outlines.empty(); });
}

/// Whether any person has a factor of the social force.
bool hasFactors(const std::vector<sim2d::TraceHuman>& humans) {
  return std::any_of(humans.begin(), humans.end(), [](const sim2d::TraceHuman& human) {
    return std::any_of(human.parameters.begin(), human.parameters.end(),
                       [](const auto& each) { return each.first == "social_force_factor"; });
  });
}

bool isKey(const MetricInfo& info, std::string_view key) {
  return info.key == key || info.partOf == key;
}

class MissingInputs {
 public:
  MissingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                const MetricsSetup& setup, const std::string& source)
      : header_(trace.header),
        points_(points),
        source_(source),
        profile_(setup.parameters.profile),
        entries_(setup.selection.entries(metrics::standardRegistry())) {}

  base::Diagnostics find() {
    const bool hasRobot = !header_.robots.empty();
    findPoints();
    if (header_.map.isEmpty() && hasRobot) {
      add("bag.no-map", [](const MetricInfo& info) { return info.needs.map; });
    }
    if (hasRobot && header_.robots.front().goals.empty()) {
      add("bag.no-goal", [](const MetricInfo& info) { return info.needs.goal; });
    }
    const bool usesFactors = profile_ == metrics::Profile::Corrected;
    if (usesFactors && hasRobot && !header_.humans.empty() && !hasFactors(header_.humans)) {
      add("bag.no-factors", [](const MetricInfo& info) {
        return isKey(info, "social_force_on_agents") || isKey(info, "social_work");
      });
    }
    if (hasRobot) {
      add("bag.no-replans", [](const MetricInfo& info) { return isKey(info, "replanning_count"); });
    }
    return std::move(missing_);
  }

 private:
  /// Where obstacle points are computed from walls, only the forces lack the recorded ones.
  void findPoints() {
    const bool hasWalls = hasOutlines(header_);
    if (!header_.humans.empty() && !points_.hasPeople()) {
      add(hasWalls ? "bag.points-of-walls" : "bag.no-obstacles-of-people",
          [](const MetricInfo& info) { return info.needs.obstacles && !info.needs.robot; });
    }
    if (!header_.robots.empty() && !points_.hasRobot()) {
      add(hasWalls ? "bag.points-of-walls" : "bag.no-obstacles-of-robot",
          [hasWalls](const MetricInfo& info) {
            const bool isForce =
                isKey(info, "obstacle_force_on_robot") || isKey(info, "social_work");
            return info.needs.obstacles && info.needs.robot && (!hasWalls || isForce);
          });
    }
  }

  void add(const char* code, const std::function<bool(const MetricInfo&)>& lacks) {
    std::vector<std::string> keys;
    for (const metrics::MetricEntry& entry : entries_) {
      if (lacks(entry.info)) {
        keys.push_back(entry.info.key);
      }
    }
    if (!keys.empty()) {
      missing_.push_back(base::warning(code, {base::join(keys, ", ")}, source_));
    }
  }

  const sim2d::TraceHeader& header_;
  const sim2d::RecordedPoints& points_;
  const std::string& source_;
  metrics::Profile profile_;
  std::vector<metrics::MetricEntry> entries_;
  base::Diagnostics missing_;
};

}  // namespace

base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source) {
  return isForeign(trace.header) ? MissingInputs(trace, points, setup, source).find()
                                 : base::Diagnostics();
}

}  // namespace app
