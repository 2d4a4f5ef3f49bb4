#include "sim2d/nav/nav2/params/FrameNames.h"

#include <algorithm>
#include <array>
#include <optional>

namespace sim2d::nav2 {
namespace {

constexpr std::array<std::string_view, 4> kOnRobot = {"robot_base_frame", "base_frame_id",
                                                      "base_frame", "sensor_frame"};

std::string_view withoutSlash(std::string_view name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

/// The frame that a parameter of a node names; nullopt when it is absent or empty.
std::optional<std::string> frameIn(const NodeParameters& node, std::string_view key) {
  const GivenParameter* const given = node.find(key);
  if (given == nullptr || !given->value->isScalar()) {
    return std::nullopt;
  }
  const std::string name(withoutSlash(given->value->text));
  return name.empty() ? std::nullopt : std::optional(name);
}

/// Whether the last part of a name is a key for a frame on the robot.
bool namesRobotFrame(std::string_view name) {
  const std::string_view last = name.substr(name.rfind('.') + 1);
  return std::find(kOnRobot.begin(), kOnRobot.end(), last) != kOnRobot.end();
}

void addRobotFrames(const ParameterFile& file, std::vector<std::string>& to) {
  for (const NodeParameters& node : file.nodes()) {
    for (const GivenParameter& given : node.given) {
      if (namesRobotFrame(given.name) && given.value->isScalar()) {
        to.emplace_back(withoutSlash(given.value->text));
      }
    }
  }
}

}  // namespace

bool FrameNames::canTransform(std::string_view parent, std::string_view child,
                              bool isLocalized) const {
  int inMap = 0;
  for (const std::string_view frame : {withoutSlash(parent), withoutSlash(child)}) {
    if (frame == map) {
      ++inMap;
    } else if (frame != odom && !std::binary_search(onRobot.begin(), onRobot.end(), frame)) {
      return false;
    }
  }
  return inMap != 1 || isLocalized;
}

FrameNames frameNamesOf(const ParameterFile& file, const std::string& robot) {
  FrameNames names;
  const NodeParameters local = file.parametersOf("local_costmap", robot);
  const NodeParameters behaviors = file.parametersOf("behavior_server", robot);
  names.map = frameIn(file.parametersOf("global_costmap", robot), "global_frame").value_or("map");
  const std::string localFrame = frameIn(local, "global_frame").value_or("map");
  names.isLocalInOdom = localFrame != names.map;
  if (names.isLocalInOdom) {
    names.odom = localFrame;
  } else {
    // Jazzy introduced `local_frame`; earlier, `global_frame` was the frame of the local costmap.
    const auto own = frameIn(behaviors, "local_frame");
    const auto humble = frameIn(behaviors, "global_frame");
    names.odom = own ? *own : humble && *humble != names.map ? *humble : "odom";
  }
  names.onRobot = {"base_footprint", "base_link"};
  addRobotFrames(file, names.onRobot);
  std::sort(names.onRobot.begin(), names.onRobot.end());
  names.onRobot.erase(std::unique(names.onRobot.begin(), names.onRobot.end()), names.onRobot.end());
  return names;
}

}  // namespace sim2d::nav2
