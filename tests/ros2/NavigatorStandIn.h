#pragma once

#include <cmath>
#include <deque>
#include <limits>

#include "app/bridge/messages/action_msgs.h"
#include "app/bridge/messages/nav2_msgs.h"
#include "app/bridge/messages/nav_msgs.h"
#include "app/bridge/messages/sensor_msgs.h"
#include "app/bridge/messages/tf2_msgs.h"
#include "tests/ros2/Ros2Test.h"

namespace ros2test {

/// What Nav2 is to a robot, as small as can be: the action `navigate_to_pose`, a plan on /map
/// (steps to the goal, counted from it), /cmd_vel (stamped) for each state on /tf, and a stop
/// before what /scan sees close ahead. It answers a state by that state and what was told before
/// alone.
class NavigatorStandIn {
 public:
  explicit NavigatorStandIn(int domain) : participant_(participant(inDomain(domain))) {
    node_ = participant_->addNode("/", "bt_navigator");
    commands_ = *participant_->publisher(node_, "/cmd_vel", geometry_msgs::TwistStamped::kType,
                                         Qos::keepLast(10));
    Qos latched = Qos::latched();
    hear<nav_msgs::OccupancyGrid>("/map", latched, [this](const auto& map) { map_ = map; });
    hear<sensor_msgs::LaserScan>("/scan", Qos::keepLast(50),
                                 [this](const auto& scan) { scans_.push_back(scan); });
    hear<tf2_msgs::TFMessage>("/tf", Qos::keepLast(1000), [this](const auto& tf) { take(tf); });
    using Action = nav2_msgs::NavigateToPose;
    serve<Action::SendGoal>("navigate_to_pose/_action/send_goal", [this](const auto& request) {
      goal_ = request.goal.pose.pose.position;
      planFrom_.clear();
      ++goals_;
      Action::SendGoal::Response response;
      response.accepted = true;
      return response;
    });
    using Result = Action::GetResult;
    serve<Result>("navigate_to_pose/_action/get_result", [this](const auto& /*request*/) {
      const int mine = goals_;
      participant_->spinUntil([&] { return hasArrived_ || goals_ != mine || isOver_; },
                              Milliseconds(120000));
      typename Result::Response response;
      response.status = hasArrived_ ? action_msgs::GoalStatus::kStatusSucceeded
                                    : action_msgs::GoalStatus::kStatusAborted;
      return response;
    });
    participant_->publishGraph();
  }

  template <class Done>
  bool spinUntil(Done done) {
    const bool isDone = participant_->spinUntil(
        [&] {
          isOver_ = done();
          return isOver_;
        },
        Milliseconds(120000));
    return isDone;
  }
  bool hasArrived() const { return hasArrived_; }
  int goals() const { return goals_; }
  int stops() const { return stops_; }  // before what the scan showed

 private:
  struct Pose {
    double x = 0, y = 0, yaw = 0;
    Pose operator*(const Pose& b) const {
      return {x + std::cos(yaw) * b.x - std::sin(yaw) * b.y,
              y + std::sin(yaw) * b.x + std::cos(yaw) * b.y, yaw + b.yaw};
    }
  };

  template <class M, class Take>
  void hear(const char* topic, const Qos& qos, Take take) {
    subscriptions_.push_back(ros2test::hear<M>(*participant_, node_, topic, qos, take));
  }
  template <class S, class Answer>
  void serve(const char* name, Answer answer) {
    servers_.push_back(*participant_->server(
        node_, name, S::kType, Qos::keepLast(10), [answer](const ServiceRequest& asked) {
          const auto request = decode<typename S::Request>(asked.bytes);
          return encode(request ? answer(*request) : typename S::Response());
        }));
  }

  static Pose poseOf(const geometry_msgs::Transform& t) {
    return {t.translation.x, t.translation.y, 2.0 * std::atan2(t.rotation.z, t.rotation.w)};
  }
  static double seconds(const builtin_interfaces::Time& t) { return t.sec + 1e-9 * t.nanosec; }

  void take(const tf2_msgs::TFMessage& tf) {
    Pose odom, base;
    bool isWhole = false;
    for (const geometry_msgs::TransformStamped& each : tf.transforms) {
      if (each.childFrameId == "odom") {
        odom = poseOf(each.transform);
      } else if (each.header.frameId == "odom") {
        base = poseOf(each.transform);
        isWhole = true;
      }
    }
    if (isWhole && goal_ && !map_.data.empty()) {
      const builtin_interfaces::Time stamp = tf.transforms.front().header.stamp;
      geometry_msgs::TwistStamped command;
      command.header.stamp = stamp;
      command.twist = commandAt(odom * base, seconds(stamp));
      commands_->publish(encode(command));
    }
  }

  geometry_msgs::Twist commandAt(const Pose& at, double time) {
    geometry_msgs::Twist twist;
    if (std::hypot(goal_->x - at.x, goal_->y - at.y) < 0.15) {
      hasArrived_ = true;
    }
    if (hasArrived_) {
      return twist;
    }
    const Pose ahead = lookAhead(at);
    const double turn =
        std::remainder(std::atan2(ahead.y - at.y, ahead.x - at.x) - at.yaw, 2.0 * M_PI);
    twist.angular.z = std::min(1.0, std::max(-1.0, 2.0 * turn));
    twist.linear.x = std::fabs(turn) > 0.8 ? 0.0 : 0.5;
    if (nearestAhead(time) < 0.35 && twist.linear.x > 0.0) {
      twist.linear.x = 0.0;
      ++stops_;
    }
    return twist;
  }

  /// Of the newest scan that is older than this state: it has come for certain.
  double nearestAhead(double time) {
    while (scans_.size() > 1 && seconds(scans_[1].header.stamp) < time - 1e-6) {
      scans_.pop_front();
    }
    double nearest = std::numeric_limits<double>::infinity();
    if (scans_.empty() || seconds(scans_.front().header.stamp) > time - 1e-6) {
      return nearest;
    }
    const sensor_msgs::LaserScan& scan = scans_.front();
    for (std::size_t k = 0; k < scan.ranges.size(); ++k) {
      const double angle = scan.angleMin + static_cast<double>(k) * scan.angleIncrement;
      if (std::fabs(std::remainder(angle, 2.0 * M_PI)) < 0.3 && scan.ranges[k] > 0.0F) {
        nearest = std::min(nearest, static_cast<double>(scan.ranges[k]));
      }
    }
    return nearest;
  }

  int width() const { return static_cast<int>(map_.info.width); }
  int height() const { return static_cast<int>(map_.info.height); }
  bool isFree(int column, int row) const {
    const int clear = static_cast<int>(std::ceil(0.4 / map_.info.resolution));
    for (int y = row - clear; y <= row + clear; ++y) {
      for (int x = column - clear; x <= column + clear; ++x) {
        const bool isInside = x >= 0 && y >= 0 && x < width() && y < height();
        if (!isInside || map_.data[static_cast<std::size_t>(y * width() + x)] != 0) {
          return false;
        }
      }
    }
    return true;
  }
  int columnOf(double x) const {
    return static_cast<int>((x - map_.info.origin.position.x) / map_.info.resolution);
  }
  int rowOf(double y) const {
    return static_cast<int>((y - map_.info.origin.position.y) / map_.info.resolution);
  }

  /// Steps to the goal from each cell, -1: no way.
  void plan() {
    planFrom_.assign(map_.data.size(), -1);
    std::deque<int> open = {rowOf(goal_->y) * width() + columnOf(goal_->x)};
    planFrom_[static_cast<std::size_t>(open.front())] = 0;
    while (!open.empty()) {
      const int cell = open.front();
      open.pop_front();
      for (const int next : {cell - 1, cell + 1, cell - width(), cell + width()}) {
        const bool isInside = next >= 0 && next < width() * height();
        if (isInside && planFrom_[static_cast<std::size_t>(next)] < 0 &&
            isFree(next % width(), next / width())) {
          planFrom_[static_cast<std::size_t>(next)] = planFrom_[static_cast<std::size_t>(cell)] + 1;
          open.push_back(next);
        }
      }
    }
  }

  /// Half a metre down the plan.
  Pose lookAhead(const Pose& at) {
    if (planFrom_.empty()) {
      plan();
    }
    int cell = rowOf(at.y) * width() + columnOf(at.x);
    const int steps = static_cast<int>(0.5 / map_.info.resolution);
    for (int k = 0; k < steps; ++k) {
      for (const int next : {cell - 1, cell + 1, cell - width(), cell + width()}) {
        const bool isInside = next >= 0 && next < width() * height();
        const int there = isInside ? planFrom_[static_cast<std::size_t>(next)] : -1;
        const int here = planFrom_[static_cast<std::size_t>(cell)];
        if (there >= 0 && (here < 0 || there < here)) {
          cell = next;
          break;
        }
      }
    }
    const double resolution = map_.info.resolution;
    return {map_.info.origin.position.x + (cell % width() + 0.5) * resolution,
            map_.info.origin.position.y + (cell / width() + 0.5) * resolution, 0.0};
  }

  std::unique_ptr<Participant> participant_;
  int node_ = 0;
  nav_msgs::OccupancyGrid map_;
  std::deque<sensor_msgs::LaserScan> scans_;
  std::optional<geometry_msgs::Point> goal_;
  std::vector<int> planFrom_;
  bool hasArrived_ = false, isOver_ = false;
  int goals_ = 0, stops_ = 0;
  std::unique_ptr<Publisher> commands_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::vector<std::unique_ptr<Server>> servers_;
};

}  // namespace ros2test
