#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/ParameterMessages.h"

/// Services of rcl_interfaces: node parameters.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::rcl_interfaces {

struct GetParameters {
  static constexpr const char* kType = "rcl_interfaces/srv/GetParameters";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/GetParameters_Request";

    std::vector<std::string> names;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("names", self.names);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/GetParameters_Response";

    std::vector<ParameterValue> values;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("values", self.values);
    }
  };
};

struct GetParameterTypes {
  static constexpr const char* kType = "rcl_interfaces/srv/GetParameterTypes";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/GetParameterTypes_Request";

    std::vector<std::string> names;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("names", self.names);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/GetParameterTypes_Response";

    std::vector<std::uint8_t> types;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("types", self.types);
    }
  };
};

struct SetParameters {
  static constexpr const char* kType = "rcl_interfaces/srv/SetParameters";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/SetParameters_Request";

    std::vector<Parameter> parameters;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("parameters", self.parameters);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/SetParameters_Response";

    std::vector<SetParametersResult> results;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("results", self.results);
    }
  };
};

struct SetParametersAtomically {
  static constexpr const char* kType = "rcl_interfaces/srv/SetParametersAtomically";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/SetParametersAtomically_Request";

    std::vector<Parameter> parameters;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("parameters", self.parameters);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/SetParametersAtomically_Response";

    SetParametersResult result;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("result", self.result);
    }
  };
};

struct DescribeParameters {
  static constexpr const char* kType = "rcl_interfaces/srv/DescribeParameters";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/DescribeParameters_Request";

    std::vector<std::string> names;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("names", self.names);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/DescribeParameters_Response";

    std::vector<ParameterDescriptor> descriptors;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("descriptors", self.descriptors);
    }
  };
};

/// depth 0: unlimited.
struct ListParameters {
  static constexpr const char* kType = "rcl_interfaces/srv/ListParameters";
  struct Request {
    static constexpr const char* kType = "rcl_interfaces/srv/ListParameters_Request";
    static constexpr std::uint64_t kDepthRecursive = 0;

    std::vector<std::string> prefixes;
    std::uint64_t depth = 0;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("prefixes", self.prefixes);
      field("depth", self.depth);
    }
    template <class F>
    static void constants(F&& constant) {
      constant("DEPTH_RECURSIVE", kDepthRecursive);
    }
  };
  struct Response {
    static constexpr const char* kType = "rcl_interfaces/srv/ListParameters_Response";

    ListParametersResult result;

    template <class Self, class F>
    static void fields(Self& self, F&& field) {
      field("result", self.result);
    }
  };
};

}  // namespace bridge::rcl_interfaces
