#include "sim2d/nav/nav2/costmap/InflationLaw.h"

#include <cmath>

#include "sim2d/base/Math.h"

namespace sim2d::nav2 {

std::uint8_t InflationLaw::cost(double distance) const {
  if (distance <= 0.0) {
    return kLethal;
  }
  if (distance <= inscribed) {
    return kInscribed;
  }
  constexpr double kMost = kInscribed - 1;
  const double cost = kMost * base::exp(-scaling * (distance - inscribed));
  return static_cast<std::uint8_t>(std::fmin(cost, kMost));  // a scaling below 0 rises
}

double InflationLaw::distance(std::uint8_t cost) const {
  return inscribed - base::log(static_cast<double>(cost) / kInscribed) / scaling;
}

}  // namespace sim2d::nav2
