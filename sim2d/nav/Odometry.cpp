#include "sim2d/nav/Odometry.h"

#include <cassert>
#include <cmath>

#include "sim2d/base/Rng.h"

namespace sim2d {

Odometry::Odometry(const OdometryParameters& parameters, std::uint64_t seed, int robotId,
                   const Pose2& start)
    : parameters_(parameters), seed_(seed), robotId_(robotId), truth_(start), pose_(start) {}

void Odometry::reset(const Pose2& truth) {
  truth_ = truth;
  pose_ = truth;
  motion_ = {};
}

/// `turn` [rad] of the step, `way` [m] in the frame that has turned by half of it, where an arc
/// leads straight ahead. So rot1 and rot2 are half of the turn each: unlike the book's, who take
/// the direction of the way for the robot's heading, this holds backwards and sideways as well.
Odometry::Error Odometry::errorOf(double turn, const Vec2& way, std::uint64_t step) const {
  const double rot = 0.5 * std::fabs(turn);
  const double trans = way.norm();
  const double rotDeviation = std::sqrt(parameters_.alpha1 * rot + parameters_.alpha2 * trans);
  const double transDeviation =
      std::sqrt(parameters_.alpha3 * trans + parameters_.alpha4 * 2.0 * rot);
  const double drift = 0.5 * parameters_.headingDrift * way.x();
  const base::AgentRng random(seed_, robotId_, step);
  Error error;
  error.rot1 = random.normal(drift, rotDeviation, base::Draw::Odometry, 0);
  error.trans = random.normal(0.0, transDeviation, base::Draw::Odometry, 1);
  error.rot2 = random.normal(drift, rotDeviation, base::Draw::Odometry, 2);
  return error;
}

void Odometry::advance(const Pose2& truth, const BodyTwist& motion, double dt, std::uint64_t step) {
  assert(dt > 0.0);
  const Pose2 before = truth_;
  truth_ = truth;
  if (parameters_.isExact()) {
    pose_ = truth;
    motion_ = motion;
    return;
  }
  const double turn = base::angleDiff(truth.heading, before.heading);
  const Pose2 middle{before.position, before.heading + 0.5 * turn};
  const Vec2 way = middle.toLocal(truth.position);
  const Error error = errorOf(turn, way, step);
  const double length = way.norm();
  const Vec2 along = length > 0.0 ? Vec2(way / length) : Vec2(1.0, 0.0);
  const Vec2 wayError = error.trans * along;
  const double rot1 = 0.5 * turn + error.rot1;
  const double rot2 = 0.5 * turn + error.rot2;
  pose_.position = Pose2{pose_.position, pose_.heading + rot1}.toWorld(way + wayError);
  pose_.heading = base::wrapToPi(pose_.heading + rot1 + rot2);
  motion_.linear = motion.linear + wayError.x() / dt;
  motion_.lateral = motion.lateral + wayError.y() / dt;
  motion_.angular = motion.angular + (error.rot1 + error.rot2) / dt;
}

}  // namespace sim2d
