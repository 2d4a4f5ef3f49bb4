#include "sim2d/scenario/Defaults.h"

#include <array>

#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

double massOf(PersonKind kind) {
  // adult: mass of HuNavSim's pedestrians; child: about 10 years, elderly: a little lighter than an
  // adult (body mass statistics of WHO growth charts and NHANES); wheelchair: adult and a 20 kg
  // chair; luggage: adult and a 20 kg case
  static constexpr std::array<double, 5> kMasses = {80.0, 32.0, 72.0, 100.0, 100.0};
  return kMasses.at(static_cast<std::size_t>(kind));
}

const char* personKindName(PersonKind kind) {
  return kindWords()[static_cast<std::size_t>(kind)].c_str();
}

}  // namespace sim2d
