#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bt/robot/Nav2Files.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/params/Nav2Parameters.h"
#include "tests/fuzz/Require.h"

/// Any bytes as a nav2_params.yaml: read for each branch, explained, its servers made and driven
/// for some steps on a small costmap.
namespace {

using sim2d::nav2::Distro;

constexpr int kMaxCells = 200;  // along a side: larger costmaps cost time

sim2d::OccupancyGrid room() {
  constexpr int kSide = 40;
  std::vector<std::int8_t> cells(std::size_t{kSide} * kSide, 0);
  for (std::size_t k = 0; k < std::size_t{kSide}; ++k) {
    cells[k] = cells[cells.size() - 1 - k] = 100;
  }
  return {kSide, kSide, 0.1, {}, cells};
}

bool isSmall(const sim2d::nav2::CostmapParameters& costmap) {
  return costmap.width / costmap.resolution <= kMaxCells &&
         costmap.height / costmap.resolution <= kMaxCells;
}

void drive(const sim2d::nav2::Nav2Parameters& parameters) {
  if (!isSmall(parameters.localCostmap.parameters) ||
      !isSmall(parameters.globalCostmap.parameters)) {
    return;
  }
  auto made = bt::Nav2Servers::make({parameters, {}, room(), {}, 1, -1});
  if (!made) {
    require(base::hasErrors(made.diagnostics()), "servers that are not made tell why");
    return;
  }
  bt::Nav2Servers& servers = **made;
  bt::RobotRequest plan;
  sim2d::Observation seen;
  seen.pose = {{1.0, 1.0}, 0.0};
  seen.goal = {3.0, 3.0};
  seen.dt = 0.05;
  for (int step = 0; step < 3; ++step) {
    seen.time = step * seen.dt;
    servers.sense(seen);
    if (step == 0) {
      plan.path = servers.paths().add({{seen.goal, 0.0}});
      servers.begin(bt::RobotAction::ComputePath, plan);
    }
    const sim2d::BodyTwist twist = servers.act();
    require(twist.linear == twist.linear && twist.angular == twist.angular, "commands are numbers");
    const bt::RobotOutcome planned = servers.outcome(bt::RobotAction::ComputePath);
    if (step == 1 && planned.path != 0) {
      plan.path = planned.path;
      servers.begin(bt::RobotAction::FollowPath, plan);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto file = sim2d::nav2::ParameterFile::parse(text, "fuzz.yaml");
  if (!file) {
    require(base::hasErrors(file.diagnostics()), "what is not read has an error");
    return 0;
  }
  for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
    const sim2d::nav2::Nav2ReadResult reading = readNav2Parameters(*file, {distro, "robot1"});
    bt::nav2Inconsistencies(reading.parameters, nullptr);
    bt::nav2Hints(reading.parameters);
    if (reading.ok()) {
      drive(reading.parameters);
    }
  }
  return 0;
}
