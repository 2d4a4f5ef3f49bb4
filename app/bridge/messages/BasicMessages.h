#pragma once

#include <cstdint>
#include <string>

/// Messages of builtin_interfaces, std_msgs, rosgraph_msgs and std_srvs.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::builtin_interfaces {

/// Time since the epoch of the clock: sec [s] + nanosec [ns].
struct Time {
  static constexpr const char* kType = "builtin_interfaces/msg/Time";
  using PackedElement = std::int32_t;

  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("sec", self.sec);
    field("nanosec", self.nanosec);
  }
};

struct Duration {
  static constexpr const char* kType = "builtin_interfaces/msg/Duration";
  using PackedElement = std::int32_t;

  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("sec", self.sec);
    field("nanosec", self.nanosec);
  }
};

}  // namespace bridge::builtin_interfaces

namespace bridge::std_msgs {

struct Header {
  static constexpr const char* kType = "std_msgs/msg/Header";

  builtin_interfaces::Time stamp;
  std::string frameId;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("stamp", self.stamp);
    field("frame_id", self.frameId);
  }
};

struct String {
  static constexpr const char* kType = "std_msgs/msg/String";

  std::string data;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("data", self.data);
  }
};

struct Empty {
  static constexpr const char* kType = "std_msgs/msg/Empty";

  template <class Self, class F>
  static void fields(Self& /*self*/, F&& /*field*/) {}
};

/// Each component is in [0, 1].
struct ColorRGBA {
  static constexpr const char* kType = "std_msgs/msg/ColorRGBA";
  using PackedElement = float;

  float r = 0;
  float g = 0;
  float b = 0;
  float a = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("r", self.r);
    field("g", self.g);
    field("b", self.b);
    field("a", self.a);
  }
};

}  // namespace bridge::std_msgs

namespace bridge::rosgraph_msgs {

struct Clock {
  static constexpr const char* kType = "rosgraph_msgs/msg/Clock";

  builtin_interfaces::Time clock;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("clock", self.clock);
  }
};

}  // namespace bridge::rosgraph_msgs

namespace bridge::std_srvs {

struct Empty {
  static constexpr const char* kType = "std_srvs/srv/Empty";
  struct Request {
    static constexpr const char* kType = "std_srvs/srv/Empty_Request";

    template <class Self, class F>
    static void fields(Self& /*self*/, F&& /*field*/) {}
  };
  struct Response {
    static constexpr const char* kType = "std_srvs/srv/Empty_Response";

    template <class Self, class F>
    static void fields(Self& /*self*/, F&& /*field*/) {}
  };
};

struct Trigger {
  static constexpr const char* kType = "std_srvs/srv/Trigger";
  struct Request {
    static constexpr const char* kType = "std_srvs/srv/Trigger_Request";

    template <class Self, class F>
    static void fields(Self& /*self*/, F&& /*field*/) {}
  };
  struct Response {
    static constexpr const char* kType = "std_srvs/srv/Trigger_Response";

    bool success = false;
    std::string message;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("success", self.success);
      field("message", self.message);
    }
  };
};

struct SetBool {
  static constexpr const char* kType = "std_srvs/srv/SetBool";
  struct Request {
    static constexpr const char* kType = "std_srvs/srv/SetBool_Request";

    bool data = false;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("data", self.data);
    }
  };
  struct Response {
    static constexpr const char* kType = "std_srvs/srv/SetBool_Response";

    bool success = false;
    std::string message;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("success", self.success);
      field("message", self.message);
    }
  };
};

}  // namespace bridge::std_srvs
