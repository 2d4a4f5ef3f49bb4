#include "sim2d/nav/nav2/costmap/ObservationBuffer.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {
namespace {

constexpr double kInfiniteMargin = 1e-4;  // [m], as laser_geometry's user has it
constexpr double kBufferClock = 1e-9;     // [s], rounding of times

}  // namespace

void ObservationBuffer::observe(const LaserScan& scan) {
  if (!(scan.time > lastScan_)) {
    return;
  }
  lastScan_ = scan.time;
  lastTime_ = scan.time;
  PointCloud cloud;
  if (source_.observationPersistence == 0.0 && !clouds_.empty()) {
    cloud = std::move(clouds_.front());  // its memory
    clouds_.clear();
    cloud.points.clear();
  }
  cloud.origin = scan.sensor.position;
  cloud.time = scan.time;
  if (lidarHeight_ >= source_.minObstacleHeight && lidarHeight_ <= source_.maxObstacleHeight) {
    cloud.points.reserve(scan.distances.size());
    for (std::size_t i = 0; i < scan.distances.size(); ++i) {
      double distance = scan.distances[i];
      if (!(distance >= 0.0)) {
        continue;
      }
      if (distance >= scan.range) {
        if (!source_.infIsValid) {
          continue;
        }
        distance = scan.range - kInfiniteMargin;
      }
      const double angle =
          scan.sensor.heading + scan.angleMin + static_cast<double>(i) * scan.perBeam;
      cloud.points.push_back(cloud.origin + distance * base::directionOf(angle));
    }
  }
  clouds_.push_front(std::move(cloud));
}

const std::deque<PointCloud>& ObservationBuffer::clouds(double time) {
  const double kept = source_.observationPersistence;
  while (clouds_.size() > 1 && (kept == 0.0 || time - clouds_.back().time > kept + kBufferClock)) {
    clouds_.pop_back();
  }
  if (clouds_.size() == 1 && kept > 0.0 && time - clouds_.front().time > kept + kBufferClock) {
    clouds_.clear();
  }
  return clouds_;
}

bool ObservationBuffer::isCurrent(double time) const {
  return source_.expectedUpdateRate == 0.0 ||
         time - lastTime_ <= source_.expectedUpdateRate + kBufferClock;
}

}  // namespace sim2d::nav2
