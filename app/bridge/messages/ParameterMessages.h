#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/bridge/messages/BasicMessages.h"
#include "app/bridge/messages/FieldTraits.h"

/// Messages of rcl_interfaces: node parameters and log entries.
/// Field names, types and order match the ROS 2 Humble .msg and .srv files.
namespace bridge::rcl_interfaces {

struct Log {
  static constexpr const char* kType = "rcl_interfaces/msg/Log";
  static constexpr std::uint8_t kDebug = 10;
  static constexpr std::uint8_t kInfo = 20;
  static constexpr std::uint8_t kWarn = 30;
  static constexpr std::uint8_t kError = 40;
  static constexpr std::uint8_t kFatal = 50;

  builtin_interfaces::Time stamp;
  std::uint8_t level = 0;
  std::string name;
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("stamp", self.stamp);
    field("level", self.level);
    field("name", self.name);
    field("msg", self.msg);
    field("file", self.file);
    field("function", self.function);
    field("line", self.line);
  }
  template <class F>
  static void constants(F&& constant) {
    constant("DEBUG", kDebug);
    constant("INFO", kInfo);
    constant("WARN", kWarn);
    constant("ERROR", kError);
    constant("FATAL", kFatal);
  }
};

struct ParameterType {
  static constexpr const char* kType = "rcl_interfaces/msg/ParameterType";
  static constexpr std::uint8_t kParameterNotSet = 0;
  static constexpr std::uint8_t kParameterBool = 1;
  static constexpr std::uint8_t kParameterInteger = 2;
  static constexpr std::uint8_t kParameterDouble = 3;
  static constexpr std::uint8_t kParameterString = 4;
  static constexpr std::uint8_t kParameterByteArray = 5;
  static constexpr std::uint8_t kParameterBoolArray = 6;
  static constexpr std::uint8_t kParameterIntegerArray = 7;
  static constexpr std::uint8_t kParameterDoubleArray = 8;
  static constexpr std::uint8_t kParameterStringArray = 9;

  template <class Self, class F>
  static void fields(Self& /*self*/, F&& /*field*/) {}
  template <class F>
  static void constants(F&& constant) {
    constant("PARAMETER_NOT_SET", kParameterNotSet);
    constant("PARAMETER_BOOL", kParameterBool);
    constant("PARAMETER_INTEGER", kParameterInteger);
    constant("PARAMETER_DOUBLE", kParameterDouble);
    constant("PARAMETER_STRING", kParameterString);
    constant("PARAMETER_BYTE_ARRAY", kParameterByteArray);
    constant("PARAMETER_BOOL_ARRAY", kParameterBoolArray);
    constant("PARAMETER_INTEGER_ARRAY", kParameterIntegerArray);
    constant("PARAMETER_DOUBLE_ARRAY", kParameterDoubleArray);
    constant("PARAMETER_STRING_ARRAY", kParameterStringArray);
  }
};

/// type is a constant of ParameterType and selects the valid field.
struct ParameterValue {
  static constexpr const char* kType = "rcl_interfaces/msg/ParameterValue";

  std::uint8_t type = 0;
  bool boolValue = false;
  std::int64_t integerValue = 0;
  double doubleValue = 0;
  std::string stringValue;
  std::vector<std::byte> byteArrayValue;
  std::vector<bool> boolArrayValue;
  std::vector<std::int64_t> integerArrayValue;
  std::vector<double> doubleArrayValue;
  std::vector<std::string> stringArrayValue;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("type", self.type);
    field("bool_value", self.boolValue);
    field("integer_value", self.integerValue);
    field("double_value", self.doubleValue);
    field("string_value", self.stringValue);
    field("byte_array_value", self.byteArrayValue);
    field("bool_array_value", self.boolArrayValue);
    field("integer_array_value", self.integerArrayValue);
    field("double_array_value", self.doubleArrayValue);
    field("string_array_value", self.stringArrayValue);
  }
};

struct Parameter {
  static constexpr const char* kType = "rcl_interfaces/msg/Parameter";

  std::string name;
  ParameterValue value;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("name", self.name);
    field("value", self.value);
  }
};

struct SetParametersResult {
  static constexpr const char* kType = "rcl_interfaces/msg/SetParametersResult";

  bool successful = false;
  std::string reason;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("successful", self.successful);
    field("reason", self.reason);
  }
};

struct ListParametersResult {
  static constexpr const char* kType = "rcl_interfaces/msg/ListParametersResult";

  std::vector<std::string> names;
  std::vector<std::string> prefixes;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("names", self.names);
    field("prefixes", self.prefixes);
  }
};

struct ParameterEvent {
  static constexpr const char* kType = "rcl_interfaces/msg/ParameterEvent";

  builtin_interfaces::Time stamp;
  std::string node;
  std::vector<Parameter> newParameters;
  std::vector<Parameter> changedParameters;
  std::vector<Parameter> deletedParameters;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("stamp", self.stamp);
    field("node", self.node);
    field("new_parameters", self.newParameters);
    field("changed_parameters", self.changedParameters);
    field("deleted_parameters", self.deletedParameters);
  }
};

struct FloatingPointRange {
  static constexpr const char* kType = "rcl_interfaces/msg/FloatingPointRange";

  double fromValue = 0;
  double toValue = 0;
  double step = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("from_value", self.fromValue);
    field("to_value", self.toValue);
    field("step", self.step);
  }
};

struct IntegerRange {
  static constexpr const char* kType = "rcl_interfaces/msg/IntegerRange";

  std::int64_t fromValue = 0;
  std::int64_t toValue = 0;
  std::uint64_t step = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("from_value", self.fromValue);
    field("to_value", self.toValue);
    field("step", self.step);
  }
};

struct ParameterDescriptor {
  static constexpr const char* kType = "rcl_interfaces/msg/ParameterDescriptor";

  std::string name;
  std::uint8_t type = 0;
  std::string description;
  std::string additionalConstraints;
  bool readOnly = false;
  bool dynamicTyping = false;
  BoundedSequence<FloatingPointRange, 1> floatingPointRange;
  BoundedSequence<IntegerRange, 1> integerRange;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("name", self.name);
    field("type", self.type);
    field("description", self.description);
    field("additional_constraints", self.additionalConstraints);
    field("read_only", self.readOnly);
    field("dynamic_typing", self.dynamicTyping);
    field("floating_point_range", self.floatingPointRange);
    field("integer_range", self.integerRange);
  }
};

}  // namespace bridge::rcl_interfaces
