#include <algorithm>
#include <optional>
#include <utility>

#include "app/bridge/topics/RunMessages.h"
#include "app/bridge/topics/Telling.h"

namespace bridge {
namespace {

constexpr double kUsualRate = 10.0;  // [Hz] of a lidar

}  // namespace

/// The last turn of its lidar in this frame: seen, or else recorded.
const sim2d::RobotSenses::Scan* RunTopics::scanIn(const sim2d::Frame& frame, std::size_t robot) {
  if (frame.senses != nullptr && robot < frame.senses->size() && (*frame.senses)[robot].scan) {
    return &*(*frame.senses)[robot].scan;
  }
  const auto found = std::find_if(
      frame.scans.rbegin(), frame.scans.rend(),
      [&](const sim2d::RecordedScan& each) { return each.robot == frame.robots.id[robot]; });
  return found == frame.scans.rend() ? nullptr : &found->scan;
}

void RunTopics::repeatScans() {
  for (Robot& robot : robots_) {
    robot.scanned.reset();
  }
}

void RunTopics::tellNewScan(const Telling& telling, std::size_t robot) {
  const sim2d::Frame& frame = telling.frame;
  const bool hasSenses = frame.senses != nullptr && robot < frame.senses->size();
  std::optional<double>& told = robots_[robot].scanned;
  if (hasSenses && (*frame.senses)[robot].laterScan != nullptr) {
    const sim2d::RobotSenses::LaterScan& later = *(*frame.senses)[robot].laterScan;
    const bool isWanted =
        telling.isWanted(topicOf(robot, Scan)) || (telling.isWanted(Tf) && !mountOf(robot));
    if (std::exchange(told, later.time) != later.time && isWanted) {
      tellScan(telling, robot, later.make());
    }
  } else if (const sim2d::RobotSenses::Scan* const scan = scanIn(frame, robot)) {
    if (std::exchange(told, scan->time) != scan->time) {
      tellScan(telling, robot, *scan);
    }
  }
}

void RunTopics::tellScan(const Telling& telling, std::size_t robot,
                         const sim2d::RobotSenses::Scan& scan) const {
  const std::string& frames = robots_[robot].frames;
  if (!mountOf(robot)) {
    telling.tellShort(Tf, [&] {
      return tf2_msgs::TFMessage{
          {transformTo(scan.time, frames + kOdometry, frames + kSensor, scan.sensor)}};
    });
  }
  const double rate = robot < options_.lidarRates.size() ? options_.lidarRates[robot] : kUsualRate;
  telling.tell(topicOf(robot, Scan), [&] { return scanOf(scan, 1.0 / rate, frames + kSensor); });
}

}  // namespace bridge
