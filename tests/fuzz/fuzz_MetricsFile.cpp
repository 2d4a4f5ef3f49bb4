#include <cstddef>
#include <cstdint>
#include <string>

#include "metrics/Report.h"
#include "tests/fuzz/Require.h"

/// Any bytes as a selection of metrics with formulas: read, written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const base::Result<metrics::MetricsFile> file = metrics::parseMetricsFile(text, "fuzz.yaml");
  if (!file) {
    require(base::hasErrors(file.diagnostics()), "what is not read has an error");
    return 0;
  }
  const std::string written = metrics::writeMetricsFile(*file);
  const base::Result<metrics::MetricsFile> again = metrics::parseMetricsFile(written, "fuzz.yaml");
  require(static_cast<bool>(again), "what is written can be read");
  require(metrics::writeMetricsFile(*again) == written, "writing twice gives one text");
  return 0;
}
