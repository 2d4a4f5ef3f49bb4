#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/bridge/messages/BasicMessages.h"

/// Messages of geometry_msgs and tf2_msgs. Units: m, rad, m/s, rad/s; right-handed, z up.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::geometry_msgs {

struct Vector3 {
  static constexpr const char* kType = "geometry_msgs/msg/Vector3";
  using PackedElement = double;

  double x = 0;
  double y = 0;
  double z = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
};

struct Point {
  static constexpr const char* kType = "geometry_msgs/msg/Point";
  using PackedElement = double;

  double x = 0;
  double y = 0;
  double z = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
};

struct Point32 {
  static constexpr const char* kType = "geometry_msgs/msg/Point32";
  using PackedElement = float;

  float x = 0;
  float y = 0;
  float z = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
  }
};

/// w is last. The default is the identity rotation.
struct Quaternion {
  static constexpr const char* kType = "geometry_msgs/msg/Quaternion";
  using PackedElement = double;

  double x = 0;
  double y = 0;
  double z = 0;
  double w = 1.0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("x", self.x);
    field("y", self.y);
    field("z", self.z);
    field("w", self.w);
  }
};

struct Pose {
  static constexpr const char* kType = "geometry_msgs/msg/Pose";
  using PackedElement = double;

  Point position;
  Quaternion orientation;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("position", self.position);
    field("orientation", self.orientation);
  }
};

struct PoseStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseStamped";

  std_msgs::Header header;
  Pose pose;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("pose", self.pose);
  }
};

struct Twist {
  static constexpr const char* kType = "geometry_msgs/msg/Twist";
  using PackedElement = double;

  Vector3 linear;
  Vector3 angular;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("linear", self.linear);
    field("angular", self.angular);
  }
};

struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TwistStamped";

  std_msgs::Header header;
  Twist twist;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("twist", self.twist);
  }
};

struct Transform {
  static constexpr const char* kType = "geometry_msgs/msg/Transform";
  using PackedElement = double;

  Vector3 translation;
  Quaternion rotation;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("translation", self.translation);
    field("rotation", self.rotation);
  }
};

/// The pose of the child frame in the frame of the header.
struct TransformStamped {
  static constexpr const char* kType = "geometry_msgs/msg/TransformStamped";

  std_msgs::Header header;
  std::string childFrameId;
  Transform transform;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("child_frame_id", self.childFrameId);
    field("transform", self.transform);
  }
};

struct PoseWithCovariance {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovariance";

  Pose pose;
  std::array<double, 36> covariance{};

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("pose", self.pose);
    field("covariance", self.covariance);
  }
};

struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs/msg/PoseWithCovarianceStamped";

  std_msgs::Header header;
  PoseWithCovariance pose;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("pose", self.pose);
  }
};

struct TwistWithCovariance {
  static constexpr const char* kType = "geometry_msgs/msg/TwistWithCovariance";

  Twist twist;
  std::array<double, 36> covariance{};

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("twist", self.twist);
    field("covariance", self.covariance);
  }
};

struct Polygon {
  static constexpr const char* kType = "geometry_msgs/msg/Polygon";

  std::vector<Point32> points;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("points", self.points);
  }
};

}  // namespace bridge::geometry_msgs

namespace bridge::tf2_msgs {

struct TFMessage {
  static constexpr const char* kType = "tf2_msgs/msg/TFMessage";

  std::vector<geometry_msgs::TransformStamped> transforms;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("transforms", self.transforms);
  }
};

}  // namespace bridge::tf2_msgs
