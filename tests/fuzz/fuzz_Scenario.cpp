#include <cstddef>
#include <cstdint>
#include <string>

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/fuzz/Require.h"

/// Any bytes as a scenario: read, written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const sim2d::ScenarioReading reading = sim2d::readScenarioText(text, "fuzz.yaml");
  const std::string written = sim2d::writeScenario(reading.scenario);
  if (!reading.ok()) {
    return 0;
  }
  const sim2d::ScenarioReading again = sim2d::readScenarioText(written, "fuzz.yaml");
  require(again.ok(), "what is written can be read");
  require(again.scenario == sim2d::withoutDefaults(reading.scenario),
          "reading what is written gives the same scenario");
  require(sim2d::writeScenario(again.scenario) == written, "writing twice gives one text");
  base::Diagnostics losses;
  sim2d::writeScenarioB(reading.scenario, losses);
  return 0;
}
