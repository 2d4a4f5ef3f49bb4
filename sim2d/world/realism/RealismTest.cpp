#include "sim2d/world/realism/RealismTest.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

namespace fs = std::filesystem;

void addAllRealismTests(
    std::vector<RealismTest>& to);  // written by CMake, from the …Tests.cpp here

double Quantity::summaryOf(const std::vector<double>& values) const {
  const bool isMissing =
      values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return v != v; });
  if (isMissing) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  switch (summary) {
    case Summary::Smallest:
      return *std::min_element(values.begin(), values.end());
    case Summary::Largest:
      return *std::max_element(values.begin(), values.end());
    case Summary::Mean:
      break;
  }
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

base::Result<std::vector<double>> RealismTest::measure(const RealismRun& run) const {
  try {
    return play(run);
  } catch (const NotPlayed& problem) {
    return problem.why;
  }
}

const std::vector<RealismTest>& realismTests() {
  static const std::vector<RealismTest> kTests = [] {
    std::vector<RealismTest> tests;
    addAllRealismTests(tests);
    return tests;
  }();
  return kTests;
}

std::string sceneName(const RealismTest& test) {
  std::string name = "realism_" + test.name + "_agents";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

Scenario sceneOf(const RealismTest& test) {
  return test.scene({"das", 1, {}}).scenario(sceneName(test), test.duration);
}

base::Diagnostics writeScenes(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  base::Diagnostics problems;
  std::set<fs::path> written;
  for (const RealismTest& test : realismTests()) {
    const fs::path path = fs::path(folder) / (sceneName(test) + ".yaml");
    base::append(problems, base::writeFileAtomically(path.string(), writeScenario(sceneOf(test))));
    written.insert(path);
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (written.count(entry.path()) == 0) {
      fs::remove(entry.path(), error);
    }
  }
  return problems;
}

}  // namespace sim2d
