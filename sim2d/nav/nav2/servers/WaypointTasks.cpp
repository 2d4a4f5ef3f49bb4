#include "sim2d/nav/nav2/servers/WaypointTasks.h"

namespace sim2d::nav2 {

const std::vector<Nav2Key<WaypointFollowerParameters>>& waypointFollowerKeys() {
  using P = WaypointFollowerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"waypoint_task_executor_plugin", &P::taskPlugin, "", "Name of the task at each goal."}};
  return kKeys;
}

const std::vector<IdleKey>& idleWaypointFollowerKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"global_frame_id", "frames coincide here", kSinceJazzy},
      {"loop_rate", "each step looks whether a goal is reached"},
      {"stop_on_failure", "a robot whose tree has failed stands"}};
  return kKeys;
}

const std::vector<Nav2Key<WaypointTaskParameters>>& waypointTaskKeys(WaypointTask task) {
  using P = WaypointTaskParameters;
  static const Nav2Key<P> kEnabled = {"enabled", &P::enabled, "", "Whether the task is done."};
  static const std::vector<Nav2Key<P>> kWait = {
      kEnabled,
      {"waypoint_pause_duration", &P::pauseDuration, "ms", "How long the robot stands there."}};
  static const std::vector<Nav2Key<P>> kPhoto = {kEnabled};
  static const std::vector<Nav2Key<P>> kInput = {
      kEnabled, {"timeout", &P::inputTimeout, "s", "How long an input is waited for."}};
  return task == WaypointTask::Wait ? kWait : task == WaypointTask::Photo ? kPhoto : kInput;
}

const std::vector<IdleKey>& idleWaypointTaskKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"image_topic", "a photo is an event of the run"},
      {"save_dir", "a photo is an event of the run"},
      {"image_format", "a photo is an event of the run"},
      {"input_topic", "no topics here: an input never comes"}};
  return kKeys;
}

double durationOf(const WaypointTaskParameters& task) {
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
