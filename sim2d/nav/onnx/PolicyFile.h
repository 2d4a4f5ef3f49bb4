#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/PolicyObservation.h"

/// Metadata of an ONNX file with a learned policy, read without OpenCV.
namespace sim2d {

/// Metadata of the key `hunavsim_policy` in ModelProto.metadata_props: a JSON object of the options
/// of the environment in which the policy was trained. All keys are required, others are errors:
///   {"format": 1, "people": 16, "beams": 180, "grid_cells": 0, "grid_resolution": 0.1,
///    "repeat": 2, "dt": 0.05, "actions": 2}
struct PolicyMetadata {
  PolicySizes sizes;
  int repeat = 1;    // steps of the world per decision
  double dt = 0.05;  // of these steps [s]
  int actions = 2;   // v [m/s] and omega [rad/s]; 3: also the lateral v of omnidirectional robots
};

constexpr const char* kPolicyMetadataKey = "hunavsim_policy";
constexpr const char* kPolicyOutput = "action";

/// `text`: the JSON; `file`: for messages. Errors: onnx.not-json, onnx.no-key, onnx.unknown-key,
/// onnx.wrong-format, onnx.wrong-type, onnx.out-of-range; all that apply.
base::Result<PolicyMetadata> parsePolicyMetadata(const std::string& text, const std::string& file);

/// An input of the network and its shape, starting with the batch.
struct PolicyInput {
  const char* name = "";
  std::vector<int> shape;
};
/// Inputs of a policy of these sizes: `state` [1, 5], `people` [1, people, 5], `lidar` [1, beams],
/// `grid` [1, 1, cells, cells]; those of size 0 are left out.
std::vector<PolicyInput> policyInputsOf(const PolicySizes& sizes);

/// Reads the metadata of a model and checks its inputs and outputs. `model`: the bytes of the file.
/// Errors: onnx.no-onnx, onnx.no-metadata, those of parsePolicyMetadata, onnx.no-input,
/// onnx.unknown-input, onnx.wrong-element-type, onnx.wrong-shape, onnx.wrong-output.
base::Result<PolicyMetadata> readPolicyMetadata(std::string_view model, const std::string& file);

}  // namespace sim2d
