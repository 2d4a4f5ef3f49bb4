#include "sim2d/world/realism/RealismTest.h"

#include <algorithm>
#include <numeric>

namespace sim2d {

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

const std::vector<RealismTest>& realismTests() {
  static const std::vector<RealismTest> kTests = [] {
    std::vector<RealismTest> tests;
    addAllRealismTests(tests);
    return tests;
  }();
  return kTests;
}

}  // namespace sim2d
