#include <cstddef>
#include <cstdint>
#include <string_view>

#include "sim2d/nav/onnx/PolicyFile.h"
#include "tests/fuzz/Require.h"

/// Any bytes as an ONNX file: what is read of it is within its ranges.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const base::Result<sim2d::PolicyMetadata> read = sim2d::readPolicyMetadata(bytes, "fuzz.onnx");
  if (!read) {
    require(base::hasErrors(read.diagnostics()), "what is not read has an error");
    return 0;
  }
  const sim2d::PolicySizes& sizes = read->sizes;
  require(read->repeat >= 1 && (read->actions == 2 || read->actions == 3), "commands exist");
  require(sizes.people <= 10000 && sizes.beams <= 10000 && sizes.gridCells <= 1000 &&
              sizes.gridResolution > 0.0,
          "the sizes are small");
  return 0;
}
