#pragma once

#include <functional>
#include <optional>

#include "editor/canvas/MapScene.h"
#include "sim2d/trace/Frame.h"

class QPainter;

namespace editor {

/// Draws in the scene what robots of a frame perceive and weigh (`Frame::senses`).
class SensePainter {
 public:
  explicit SensePainter(const Theme& theme) : theme_(theme) {}

  /// The last turn of a lidar: what it sees through, and a dot where a beam ends at something.
  void scan(QPainter& painter, const sim2d::RobotSenses::Scan& scan) const;
  /// Ways that a planner weighed: the chosen one strong, others the paler the dearer, those that
  /// would hit something in the colour of errors.
  void ways(QPainter& painter, const std::vector<sim2d::RobotSenses::Way>& ways) const;
  /// Rings where the detector takes bodies to be; a line to the true place of those who stand
  /// elsewhere. `place` gives it, none: nobody of that number is there.
  using Place = std::function<std::optional<Vec2>(const sim2d::RobotSenses::Body&)>;
  void tracks(QPainter& painter, const std::vector<sim2d::RobotSenses::Body>& bodies,
              const Place& place) const;
  /// A line from where a robot is to where it takes itself to be.
  void slip(QPainter& painter, const Vec2& from, const Vec2& believed) const;

 private:
  const Theme& theme_;
};

/// How far a scan reached into something; beams that hit nothing end at its range.
bool isHit(const sim2d::RobotSenses::Scan& scan, std::size_t beam);
/// Where a beam ended, world frame.
Vec2 endOf(const sim2d::RobotSenses::Scan& scan, std::size_t beam);
/// Where the robot takes itself to be, when that is elsewhere: the state is one step older than the
/// frame. None also when it perceives nothing (it stands, or is driven from outside).
std::optional<Pose2> believedElsewhere(const sim2d::Frame& frame, std::size_t robot);
/// Of each way, how dear it is: 0 the best, 1 the worst of those that hit nothing.
std::vector<double> dearnessOf(const std::vector<sim2d::RobotSenses::Way>& ways);

constexpr double kTrackGap = 0.08;        // of a ring round a body [m]
constexpr double kFarTrack = 0.25;        // [m]; nearer than that a track is at its body
constexpr std::size_t kMostBeams = 1200;  // painted; of more only every second, third …

}  // namespace editor
