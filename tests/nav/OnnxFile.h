#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/nav/onnx/PolicyNetwork.h"

/// Skips a test if the module that runs networks was not built. A module that does not work fails.
#define NEED_OPENCV()                                                                  \
  if (sim2d::policyModuleFile().empty()) {                                             \
    QSKIP("the module for networks is not built: libopencv-dnn-dev is not installed"); \
  }                                                                                    \
  QVERIFY2(sim2d::policyModuleVersion(), "the module for networks cannot be loaded")

/// Small ONNX files, byte by byte as onnx.proto defines them: inputs, flattened and concatenated,
/// then one matrix product (Gemm).
namespace onnxfile {

inline std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80U; value >>= 7U) {
    bytes += static_cast<char>(static_cast<unsigned char>((value & 0x7FU) | 0x80U));
  }
  return bytes + static_cast<char>(static_cast<unsigned char>(value));
}

inline std::string number(unsigned field, std::uint64_t value) {
  return varint(field << 3U) + varint(value);
}

inline std::string bytes(unsigned field, const std::string& content) {
  return varint((field << 3U) | 2U) + varint(content.size()) + content;
}

struct Tensor {
  std::string name;
  std::vector<std::uint64_t> shape;  // 0: a named size
};

/// ValueInfoProto of floats.
inline std::string declared(const Tensor& tensor) {
  std::string shape;
  for (const std::uint64_t size : tensor.shape) {
    shape += bytes(1, size > 0 ? number(1, size) : bytes(2, "batch"));
  }
  return bytes(1, tensor.name) + bytes(2, bytes(1, number(1, 1) + bytes(2, shape)));
}

/// TensorProto of floats.
inline std::string weights(const Tensor& tensor, const std::vector<float>& values) {
  std::string raw(values.size() * sizeof(float), '\0');
  std::memcpy(raw.data(), values.data(), raw.size());
  std::string text;
  for (const std::uint64_t size : tensor.shape) {
    text += number(1, size);
  }
  return text + number(2, 1) + bytes(8, tensor.name) + bytes(9, raw);
}

inline std::string intAttribute(const std::string& name, std::uint64_t value) {
  return bytes(5, bytes(1, name) + number(3, value) + number(20, 2));
}

inline std::string node(const std::string& type, const std::vector<std::string>& inputs,
                        const std::string& output, const std::string& attributes = {}) {
  std::string text;
  for (const std::string& input : inputs) {
    text += bytes(1, input);
  }
  return text + bytes(2, output) + bytes(3, "the_" + output) + bytes(4, type) + attributes;
}

/// ModelProto; an empty key: no metadata.
inline std::string model(const std::string& graph, const std::string& metadata,
                         const std::string& key = "hunavsim_policy") {
  std::string text = number(1, 7) + bytes(2, "tests") + bytes(7, graph) + bytes(8, number(2, 13));
  text += bytes(14, bytes(1, "author") + bytes(2, "A. Author"));
  return key.empty() ? text : text + bytes(14, bytes(1, key) + bytes(2, metadata));
}

/// A policy whose actions are linear in all its inputs.
struct LinearPolicy {
  std::vector<Tensor> inputs = {{"state", {1, 5}}};
  std::vector<std::vector<float>> rows;  // per action: one weight for each value of the inputs
  std::vector<float> offsets;            // per action
  std::string output = "action";
  std::vector<std::uint64_t> outputShape = {1, 2};

  std::string graph() const {
    std::string nodes;
    std::string declarations;
    std::vector<std::string> flat;
    for (const Tensor& input : inputs) {
      declarations += bytes(11, declared(input));
      flat.push_back(input.name);
      if (input.shape.size() > 2) {
        flat.back() += "_flat";
        nodes += bytes(1, node("Flatten", {input.name}, flat.back(), intAttribute("axis", 1)));
      }
    }
    if (flat.size() > 1) {
      nodes += bytes(1, node("Concat", flat, "all", intAttribute("axis", 1)));
    }
    nodes += bytes(1, node("Gemm", {flat.size() > 1 ? "all" : flat.front(), "rows", "offsets"},
                           output, intAttribute("transB", 1)));
    std::vector<float> flatRows;
    for (const std::vector<float>& row : rows) {
      flatRows.insert(flatRows.end(), row.begin(), row.end());
    }
    return nodes + bytes(2, "policy") +
           bytes(5, weights({"rows", {rows.size(), rows.front().size()}}, flatRows)) +
           bytes(5, weights({"offsets", {offsets.size()}}, offsets)) + declarations +
           bytes(12, declared({output, outputShape}));
  }
};

/// The JSON of the metadata.
inline std::string metadataOf(std::size_t people, std::size_t beams, std::size_t cells, int repeat,
                              int actions = 2) {
  return R"({"format": 1, "people": )" + std::to_string(people) + R"(, "beams": )" +
         std::to_string(beams) + R"(, "grid_cells": )" + std::to_string(cells) +
         R"(, "grid_resolution": 0.5, "repeat": )" + std::to_string(repeat) +
         R"(, "dt": 0.05, "actions": )" + std::to_string(actions) + "}";
}

/// v = goal x / 8 + 1/16 and omega = goal y / 2 - 1/4, with the goal in the robot's frame.
inline LinearPolicy towardsGoal() {
  LinearPolicy policy;
  policy.rows = {{0.125F, 0.0F, 0.0F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F, 0.0F, 0.0F}};
  policy.offsets = {0.0625F, -0.25F};
  return policy;
}

}  // namespace onnxfile
