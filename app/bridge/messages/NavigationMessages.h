#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/GeometryMessages.h"

/// Messages of nav_msgs and sensor_msgs.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::nav_msgs {

/// The pose is in the frame of the header, the twist in the child frame.
struct Odometry {
  static constexpr const char* kType = "nav_msgs/msg/Odometry";

  std_msgs::Header header;
  std::string childFrameId;
  geometry_msgs::PoseWithCovariance pose;
  geometry_msgs::TwistWithCovariance twist;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("child_frame_id", self.childFrameId);
    field("pose", self.pose);
    field("twist", self.twist);
  }
};

/// resolution [m/cell]. origin: pose of the outer corner of cell (0, 0).
struct MapMetaData {
  static constexpr const char* kType = "nav_msgs/msg/MapMetaData";

  builtin_interfaces::Time mapLoadTime;
  float resolution = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  geometry_msgs::Pose origin;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("map_load_time", self.mapLoadTime);
    field("resolution", self.resolution);
    field("width", self.width);
    field("height", self.height);
    field("origin", self.origin);
  }
};

/// Row 0 has the lowest y. Cells: 0 free to 100 occupied, -1 unknown.
struct OccupancyGrid {
  static constexpr const char* kType = "nav_msgs/msg/OccupancyGrid";

  std_msgs::Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("info", self.info);
    field("data", self.data);
  }
};

struct Path {
  static constexpr const char* kType = "nav_msgs/msg/Path";

  std_msgs::Header header;
  std::vector<geometry_msgs::PoseStamped> poses;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("poses", self.poses);
  }
};

struct GetMap {
  static constexpr const char* kType = "nav_msgs/srv/GetMap";
  struct Request {
    static constexpr const char* kType = "nav_msgs/srv/GetMap_Request";

    template <class Self, class F>
    static void fields(Self& /*self*/, F&& /*field*/) {}
  };
  struct Response {
    static constexpr const char* kType = "nav_msgs/srv/GetMap_Response";

    OccupancyGrid map;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("map", self.map);
    }
  };
};

}  // namespace bridge::nav_msgs

namespace bridge::sensor_msgs {

/// Units: angles [rad], ranges [m], times [s].
struct LaserScan {
  static constexpr const char* kType = "sensor_msgs/msg/LaserScan";

  std_msgs::Header header;
  float angleMin = 0;
  float angleMax = 0;
  float angleIncrement = 0;
  float timeIncrement = 0;
  float scanTime = 0;
  float rangeMin = 0;
  float rangeMax = 0;
  std::vector<float> ranges;
  std::vector<float> intensities;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("angle_min", self.angleMin);
    field("angle_max", self.angleMax);
    field("angle_increment", self.angleIncrement);
    field("time_increment", self.timeIncrement);
    field("scan_time", self.scanTime);
    field("range_min", self.rangeMin);
    field("range_max", self.rangeMax);
    field("ranges", self.ranges);
    field("intensities", self.intensities);
  }
};

struct CompressedImage {
  static constexpr const char* kType = "sensor_msgs/msg/CompressedImage";

  std_msgs::Header header;
  std::string format;
  std::vector<std::uint8_t> data;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("header", self.header);
    field("format", self.format);
    field("data", self.data);
  }
};

}  // namespace bridge::sensor_msgs
