#include "sim2d/nav/nav2/servers/WaypointTasks.h"

namespace sim2d::nav2 {

const std::vector<Nav2Key<WaypointFollowerParameters>>& waypointFollowerKeys() {
  using P = WaypointFollowerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"waypoint_task_executor_plugin", &P::taskPlugin, "", "Name of the task at each goal."}};
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredWaypointFollowerKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"global_frame_id", "the frames are identical", kSinceJazzy},
      {"loop_rate", "goals are checked in every time step"},
      {"stop_on_failure", "a robot stops when its tree has failed"}};
  return kKeys;
}

const std::vector<Nav2Key<WaypointTaskParameters>>& waypointTaskKeys(WaypointTask task) {
  using P = WaypointTaskParameters;
  static const Nav2Key<P> kEnabled = {"enabled", &P::enabled, "", "Whether the task is executed."};
  static const std::vector<Nav2Key<P>> kWait = {kEnabled,
                                                {"waypoint_pause_duration", &P::pauseDuration, "ms",
                                                 "Time for which the robot stands at the goal."}};
  static const std::vector<Nav2Key<P>> kPhoto = {kEnabled};
  static const std::vector<Nav2Key<P>> kInput = {
      kEnabled, {"timeout", &P::inputTimeout, "s", "Maximum wait for an input."}};
  return task == WaypointTask::Wait ? kWait : task == WaypointTask::Photo ? kPhoto : kInput;
}

const std::vector<IgnoredKey>& ignoredWaypointTaskKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"image_topic", "a photo is an event of the run"},
      {"save_dir", "a photo is an event of the run"},
      {"image_format", "a photo is an event of the run"},
      {"input_topic", "ROS topics are not used: no input is received"}};
  return kKeys;
}

double waypointTaskDuration(const WaypointTaskParameters& task) {
  constexpr double kMillisecond = 1e-3;  // [s]
  if (!task.enabled) {
    return 0.0;
  }
  switch (task.kind) {
    case WaypointTask::Wait:
      return kMillisecond * task.pauseDuration;
    case WaypointTask::Input:
      return task.inputTimeout;
    default:
      return 0.0;
  }
}

}  // namespace sim2d::nav2
