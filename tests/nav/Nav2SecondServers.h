#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/control/GoalCheckers.h"
#include "sim2d/nav/nav2/servers/CollisionMonitor.h"
#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

/// Servers and checkers of Nav2 a second time, from their descriptions alone and without the
/// program's code: what the program's are compared with.
namespace nav2second {

using namespace sim2d::nav2;
using Twist = std::array<double, 3>;  // v_x, v_y, omega

/// velocity_smoother's tick by tick output; commands come at every tick but where a row is silent.
class Smoother {
 public:
  explicit Smoother(const VelocitySmootherParameters& parameters) : p_(parameters) {}

  void command(const Twist& twist, double time) {
    wanted_ = twist;
    wantedAt_ = time;
  }
  /// False: nothing is sent. `measured` is the mean of the odometry.
  bool tick(double time, const Twist& measured, Twist& sent) {
    if (time - wantedAt_ > p_.velocityTimeout + 1e-9) {
      wanted_ = {};
      if (isSilent_ || (now_[0] == 0.0 && now_[1] == 0.0 && now_[2] == 0.0)) {
        isSilent_ = true;
        return false;
      }
    }
    isSilent_ = false;
    const Twist from = p_.feedback == "CLOSED_LOOP" ? measured : now_;
    Twist to{}, most{};
    double eta = 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
      to[i] = std::max(p_.minVelocity[i], std::min(p_.maxVelocity[i], wanted_[i]));
      const bool isGaining = std::fabs(to[i]) >= std::fabs(from[i]) && to[i] * from[i] >= 0.0;
      most[i] = (isGaining ? p_.maxAccel[i] : -p_.maxDecel[i]) / p_.smoothingFrequency;
      const double wanted = std::fabs(to[i] - from[i]);
      if (p_.scaleVelocities && wanted > most[i] && most[i] > 0.0 &&
          std::fabs(1.0 - most[i] / wanted) > std::fabs(1.0 - eta)) {
        eta = most[i] / wanted;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double step = eta * (to[i] - from[i]);
      now_[i] = from[i] + (std::fabs(step) > most[i] ? std::copysign(most[i], step) : step);
      sent[i] = std::fabs(now_[i]) < p_.deadbandVelocity[i] ? 0.0 : now_[i];
    }
    return true;
  }

 private:
  VelocitySmootherParameters p_;
  Twist wanted_{}, now_{};
  double wantedAt_ = 0.0;
  bool isSilent_ = false;
};

/// Whether a polygon winds round a point.
inline bool winds(const std::vector<Vec2>& polygon, const Vec2& point) {
  double turned = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - point, b = polygon[(i + 1) % polygon.size()] - point;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y());
  }
  return std::fabs(turned) > 3.0;  // 2 pi or 0
}

/// A shape of collision_monitor in plain numbers; no corners: a circle.
struct Shape {
  MonitorPolygon keys;
  std::vector<Vec2> corners;
  int needed = 1;  // points inside that trigger it
};

class Monitor {
 public:
  explicit Monitor(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {}

  /// What is sent on; `by` is the name of the shape that decided, empty: none.
  Twist filtered(const Twist& command, const std::vector<Vec2>& points, std::string& by) const {
    Twist best = command;
    for (const Shape& shape : shapes_) {
      double factor = 1.0;
      if (!factorOf(shape, command, points, factor)) {
        continue;
      }
      const bool isStop = shape.keys.actionType == "stop";
      const Twist slower = {factor * command[0], factor * command[1], factor * command[2]};
      if (isStop || size(slower) < size(best)) {
        best = slower;
        by = shape.keys.name;
      }
      if (isStop) {
        break;
      }
    }
    return best;
  }

 private:
  using Plane = std::complex<double>;

  static double size(const Twist& twist) {
    return twist[0] * twist[0] + twist[1] * twist[1] + twist[2] * twist[2];
  }
  static bool isInside(const Shape& shape, const Vec2& point) {
    return shape.corners.empty() ? std::hypot(point.x(), point.y()) < shape.keys.radius
                                 : winds(shape.corners, point);
  }
  /// Points inside, the robot being moved for so many steps: a geometric series of turned steps.
  static int countAfter(const Shape& shape, const Twist& command, const std::vector<Vec2>& points,
                        int steps) {
    const double dt = shape.keys.simulationTimeStep, turn = command[2] * dt;
    const Plane once(command[0] * dt, command[1] * dt);
    const Plane moved = std::fabs(turn) < 1e-9 ? once * static_cast<double>(steps)
                                               : once * (1.0 - std::polar(1.0, turn * steps)) /
                                                     (1.0 - std::polar(1.0, turn));
    int inside = 0;
    for (const Vec2& point : points) {
      const Plane seen = (Plane(point.x(), point.y()) - moved) * std::polar(1.0, -turn * steps);
      inside += isInside(shape, {seen.real(), seen.imag()}) ? 1 : 0;
    }
    return inside;
  }
  /// False: the shape does not act.
  static bool factorOf(const Shape& shape, const Twist& command, const std::vector<Vec2>& points,
                       double& factor) {
    const MonitorPolygon& keys = shape.keys;
    const bool isTriggered = countAfter(shape, command, points, 0) >= shape.needed;
    if (keys.actionType == "approach") {
      double time = 0.0;
      if (!isTriggered) {
        int steps = 1;
        while (time <= keys.timeBeforeCollision &&
               countAfter(shape, command, points, steps) < shape.needed) {
          time += keys.simulationTimeStep;
          ++steps;
        }
        if (time > keys.timeBeforeCollision) {
          return false;
        }
      }
      factor = time / keys.timeBeforeCollision;
      return true;
    }
    const double speed = std::hypot(command[0], command[1]), turning = std::fabs(command[2]);
    if (keys.actionType == "stop") {
      factor = 0.0;
    } else if (keys.actionType == "slowdown") {
      factor = keys.slowdownRatio;
    } else {
      factor = std::min({1.0, speed > 0.0 ? keys.linearLimit / speed : 1.0,
                         turning > 0.0 ? keys.angularLimit / turning : 1.0});
    }
    return isTriggered;
  }

  std::vector<Shape> shapes_;
};

/// The goal checkers, by the last word of their names.
class Arrival {
 public:
  Arrival(std::string kind, Distro distro, const GoalCheckerParameters& parameters)
      : kind_(std::move(kind)), isNew_(distro >= Distro::Lyrical), p_(parameters) {}

  void reset() { wasThere_ = false; }
  bool isReached(const GoalQuery& query) {
    if (isNew_ && query.pathLength > p_.pathLengthTolerance) {
      return false;
    }
    const double away = std::hypot(query.robot.position.x() - query.goal.position.x(),
                                   query.robot.position.y() - query.goal.position.y());
    const bool isThere = wasThere_ || away <= p_.xyTolerance;
    wasThere_ = isThere && p_.isStateful;
    double turn = std::remainder(query.goal.heading - query.robot.heading, 2.0 * M_PI);
    if (p_.isSymmetric && std::fabs(turn) > 0.5 * M_PI) {
      turn = M_PI - std::fabs(turn);
    }
    const bool isStanding =
        std::fabs(query.speed.angular) <= p_.rotStoppedVelocity &&
        std::hypot(query.speed.linear, query.speed.lateral) <= p_.transStoppedVelocity;
    return isThere && (kind_ == "Position" || std::fabs(turn) <= p_.yawTolerance) &&
           (kind_ != "Stopped" || isStanding);
  }

 private:
  std::string kind_;
  bool isNew_;
  GoalCheckerParameters p_;
  bool wasThere_ = false;
};

/// The progress checkers, from the whole history.
inline bool progresses(const std::vector<std::pair<double, Pose2>>& history, bool countsTurns,
                       const ProgressCheckerParameters& parameters) {
  std::size_t base = 0;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const Pose2& from = history[base].second;
    const Pose2& to = history[i].second;
    const double turn = std::remainder(to.heading - from.heading, 2.0 * M_PI);
    if (std::hypot(to.position.x() - from.position.x(), to.position.y() - from.position.y()) >
            parameters.movementRadius ||
        (countsTurns && std::fabs(turn) > parameters.movementAngle)) {
      base = i;
    }
  }
  return history.back().first - history[base].first <= parameters.movementTimeAllowance;
}

}  // namespace nav2second
