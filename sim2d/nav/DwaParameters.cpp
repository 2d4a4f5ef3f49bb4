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
                "Speeds that are tried; omnidirectional: the samples in all are shared out evenly.")
      .addCount(&P::angularSamples, "angular_samples", kCount,
                "Turn rates that are tried with each speed.")
      .add(&P::window, "window", "s", {0.01, 2.0},
           "Time within which a velocity must be reached to be tried.", std::string(fox) + ", 0.25")
      .add(&P::horizon, "horizon", "s", {0.2, 10.0},
           "How far ahead arcs are driven in thought; more where braking takes longer.")
      .add(&P::step, "step", "s", {0.02, 0.5}, "Time between two looks along an arc.")
      .add(&P::margin, "margin", "m", base::kDistance,
           "Room that the robot leaves to walls and people.")
      .add(&P::clearance, "clearance", "m", {0.01, 5.0},
           "Room beyond which more of it makes an arc no better.")
      .add(&P::goalWeight, "goal_weight", "", base::kWeight,
           "Weight of the way that is left at the end of an arc.")
      .add(&P::headingWeight, "heading_weight", "", base::kWeight,
           "Weight of the turn that is left where the robot would stand if it braked.", fox)
      .add(&P::clearanceWeight, "clearance_weight", "", base::kWeight,
           "Weight of missing room along an arc.", fox)
      .add(&P::velocityWeight, "velocity_weight", "", base::kWeight,
           "Weight of what is missing to the full speed.", fox)
      .add(&P::smoothnessWeight, "smoothness_weight", "", base::kWeight,
           "Weight of the difference to the last command.")
      .add(&P::slowDistance, "slow_distance", "m", base::kDistance,
           "Gap to a person ahead below which the robot is slower.")
      .add(&P::slowShare, "slow_share", "", kShare,
           "Share of the full speed that is left close to a person.")
      .add(&P::standingSpeed, "standing_speed", "m/s", base::kSpeed,
           "Who is slower is taken to stand: the way leads round them.")
      .add(&P::patience, "patience", "s", base::kTimeSpan,
           "After this time without progress the robot moves off a little and tries anew.")
      .add(&P::reverseDistance, "reverse_distance", "m", base::kDistance, "How far it moves off.");
  return table;
}

}  // namespace sim2d
