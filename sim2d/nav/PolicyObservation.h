#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "sim2d/nav/Observation.h"

/// Observations of a learned policy as arrays of float: the same in the environment for
/// reinforcement learning (hunavsim.env) and in the planner `onnx`. Robot frame: x ahead, y left.
namespace sim2d {

/// Goal x, y [m]; velocity vx, vy [m/s]; turn rate omega [rad/s].
constexpr std::size_t kPolicyStateColumns = 5;
/// Position x, y [m]; velocity vx, vy [m/s]; radius [m]. One row per person.
constexpr std::size_t kPolicyPersonColumns = 5;
constexpr double kPolicyPeopleRange = 15.0;  // [m], people beyond are not observed
constexpr double kPolicyLidarRange = 10.0;   // [m], the distance of beams without a hit

/// Sizes of the arrays; an array of size 0 does not exist.
struct PolicySizes {
  std::size_t people = 16;      // rows of people
  std::size_t beams = 180;      // of the lidar
  std::size_t gridCells = 0;    // side length of the occupancy grid in cells
  double gridResolution = 0.1;  // [m], side length of a cell
};

/// People within kPolicyPeopleRange with the distance of their centres [m], nearest first; equal
/// distances by id. The pointers refer to `bodies`.
std::vector<std::pair<double, const TrackedBody*>> nearestPeople(
    const Vec2& from, const std::vector<TrackedBody>& bodies);

/// Writes kPolicyStateColumns values. `motion`: the robot's velocity in its own frame.
void writePolicyState(const Pose2& pose, const BodyTwist& motion, const Vec2& goal, float* to);

/// Writes `rows` rows of kPolicyPersonColumns values: the first people of `near`, then zeros.
void writePolicyPeople(const Pose2& pose,
                       const std::vector<std::pair<double, const TrackedBody*>>& near,
                       std::size_t rows, float* to);

/// Writes `beams` distances [m], counter-clockwise from behind the robot (-pi in its frame). Each
/// is that of the beam of the scan whose direction is nearest, at most kPolicyLidarRange; beams
/// without a hit, and directions outside the field of view, have kPolicyLidarRange. `scan` may be
/// null (no scan yet).
void writePolicyLidar(const Pose2& pose, const LaserScan* scan, std::size_t beams, float* to);

/// Writes gridCells x gridCells values: 1 for a cell whose centre lies in a wall or in one of
/// `others`, otherwise 0. Row i from behind to ahead, column j from right to left; the robot is in
/// the middle.
void writePolicyGrid(const Pose2& pose, const std::vector<TrackedBody>& others,
                     const Obstacles& obstacles, const PolicySizes& sizes, float* to);

/// The arrays of one robot.
struct PolicyObservation {
  std::vector<float> state, people, lidar, grid;

  explicit PolicyObservation(const PolicySizes& sizes);
  /// Fills the arrays from what a robot perceives.
  void fill(const Observation& observation);

 private:
  PolicySizes sizes_;
};

}  // namespace sim2d
