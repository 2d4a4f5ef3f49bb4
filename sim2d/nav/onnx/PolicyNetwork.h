#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/onnx/PolicyFile.h"

namespace sim2d {

/// The network of a learned policy. Equal inputs give bit-identical actions. Not thread-safe;
/// different networks may be used at the same time.
class PolicyNetwork {
 public:
  virtual ~PolicyNetwork() = default;
  PolicyNetwork() = default;
  PolicyNetwork(const PolicyNetwork&) = delete;
  PolicyNetwork& operator=(const PolicyNetwork&) = delete;
  PolicyNetwork(PolicyNetwork&&) = delete;
  PolicyNetwork& operator=(PolicyNetwork&&) = delete;

  virtual const PolicyMetadata& metadata() const = 0;
  /// The action: `metadata().actions` finite values, not clipped. Errors: onnx.not-run,
  /// onnx.not-finite.
  virtual base::Result<std::vector<float>> action(const PolicyObservation& observation) = 0;
};

/// Reads an ONNX file and runs it once with zeros. Errors: those of readPolicyMetadata and of
/// reading a file, onnx.no-module, onnx.not-loaded, and those of `action`.
base::Result<std::unique_ptr<PolicyNetwork>> readPolicyNetwork(const std::string& file);

/// The file of the shared module that runs networks; empty: it is neither beside the program nor in
/// lib/hunavsim of a folder above it.
std::string policyModuleFile();

/// What runs networks: "OpenCV 4.6.0". Error: onnx.no-module.
base::Result<std::string> policyModuleVersion();

}  // namespace sim2d
