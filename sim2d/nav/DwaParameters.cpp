#include "sim2d/nav/DwaParameters.h"

#include <string>

#include "sim2d/base/Ranges.h"

namespace sim2d {

base::ParameterTable<DwaParameters> dwaTable() {
  using P = DwaParameters;
  constexpr base::Range kCount{1.0, 200.0};
  constexpr base::Range kShare{0.0, 1.0};
  const char* const fox = "Fox, Burgard & Thrun 1997";
  base::ParameterTable<P> table;
  table
      .addCount(&P::linearSamples, "linear_samples", kCount,
                "Sampled speeds; omnidirectional: the total number of samples is distributed "
                "evenly.")
      .addCount(&P::angularSamples, "angular_samples", kCount, "Sampled turn rates for each speed.")
      .add(&P::window, "window", "s", {0.01, 2.0},
           "Time within which a sampled velocity must be reachable.", std::string(fox) + ", 0.25")
      .add(&P::horizon, "horizon", "s", {0.2, 10.0},
           "Time for which arcs are simulated; longer if braking takes longer.")
      .add(&P::step, "step", "s", {0.02, 0.5}, "Time between two checks along an arc.")
      .add(&P::margin, "margin", "m", base::kDistance, "Minimum distance to walls and people.")
      .add(&P::clearance, "clearance", "m", {0.01, 5.0},
           "Clearance above which more clearance does not improve the score of an arc.")
      .add(&P::goalWeight, "goal_weight", "", base::kWeight,
           "Weight of the remaining path length at the end of an arc.")
      .add(&P::headingWeight, "heading_weight", "", base::kWeight,
           "Weight of the remaining rotation at the position where the robot would stop if it "
           "braked.",
           fox)
      .add(&P::clearanceWeight, "clearance_weight", "", base::kWeight,
           "Weight of missing clearance along an arc.", fox)
      .add(&P::velocityWeight, "velocity_weight", "", base::kWeight,
           "Weight of the difference to the maximum speed.", fox)
      .add(&P::smoothnessWeight, "smoothness_weight", "", base::kWeight,
           "Weight of the difference from the last command.")
      .add(&P::slowDistance, "slow_distance", "m", base::kDistance,
           "Gap to a person ahead below which the robot slows down.")
      .add(&P::slowShare, "slow_share", "", kShare, "Share of the maximum speed close to a person.")
      .add(&P::standingSpeed, "standing_speed", "m/s", base::kSpeed,
           "People below this speed count as standing: the path leads around them.")
      .add(&P::patience, "patience", "s", base::kTimeSpan,
           "Time without progress after which the robot backs off and tries again.")
      .add(&P::reverseDistance, "reverse_distance", "m", base::kDistance,
           "Distance that it backs off.");
  return table;
}

}  // namespace sim2d
