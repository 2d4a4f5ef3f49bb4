#include <string>

#include "sim2d/base/Ranges.h"
#include "sim2d/nav/mppi/MppiPlanner.h"

namespace sim2d {
namespace {

using MppiTable = base::ParameterTable<MppiParameters>;

void addSampling(MppiTable& table) {
  using P = MppiParameters;
  const std::string nav2 = "Nav2 MPPI";
  table
      .addCount(&P::samples, "samples", {64.0, 20000.0},
                "Trajectories sampled in each cycle, rounded up to a multiple of 16.", nav2)
      .addCount(&P::steps, "time_steps", {10.0, 200.0}, "Time steps of each trajectory.", nav2)
      .add(&P::modelDt, "model_dt", "s", {0.01, 0.2},
           "Duration of a time step of the trajectories.", nav2)
      .add(&P::temperature, "temperature", "", base::kPositiveWeight,
           "lambda: cost difference that changes the weight of a trajectory by the factor e.",
           "Williams et al. 2017")
      .add(&P::gamma, "gamma", "", base::kWeight, "Weight of the control cost: lambda (1 - alpha).",
           "Williams et al. 2017")
      .add(&P::linearNoise, "linear_noise", "m/s", base::kPositiveSpeed,
           "Standard deviation of the noise on the forward speed.", nav2)
      .add(&P::angularNoise, "angular_noise", "rad/s", base::kPositiveSpeed,
           "Standard deviation of the noise on the turn rate.", nav2)
      .add(&P::lateralNoise, "lateral_noise", "m/s", base::kPositiveSpeed,
           "Standard deviation of the noise on the lateral speed (omnidirectional).", nav2)
      .add(&P::noiseTime, "noise_time", "s", base::kTime,
           "Time in which the autocorrelation of the noise decays to 1/e; 0: white noise, as in "
           "Nav2.");
}

void addCosts(MppiTable& table) {
  using P = MppiParameters;
  table
      .add(&P::goal, "goal_weight", "1/m", base::kWeight,
           "Cost of the mean remaining distance, around walls.")
      .add(&P::end, "end_weight", "1/m", base::kWeight,
           "Cost of the remaining distance at the end of a trajectory.")
      .add(&P::heading, "heading_weight", "", base::kWeight,
           "Cost of a heading away from the path to the goal (not for omnidirectional robots).")
      .add(&P::reverse, "reverse_weight", "s/m", base::kWeight,
           "Cost of the mean reverse speed (not for omnidirectional robots).")
      .add(&P::stop, "stop_weight", "s²/m²", base::kWeight,
           "Cost of the squared speed inside the goal region.")
      .add(&P::wall, "wall_weight", "", base::kWeight,
           "Cost of contact with a wall, decreasing quadratically to 0 at wall_range.")
      .add(&P::wallRange, "wall_range", "m", base::kLength,
           "Gap to walls beyond which the cost is 0.")
      .add(&P::person, "person_weight", "", base::kWeight,
           "Cost of contact with a person, decreasing to 0 at person_range.")
      .add(&P::personRange, "person_range", "m", base::kLength,
           "Gap to a person beyond which the cost is 0.")
      .add(&P::personMargin, "person_margin", "m", base::kDistance,
           "A smaller gap to a person counts as a contact.")
      .add(&P::hit, "contact_weight", "", base::kPositiveWeight,
           "Cost of contact with a person or an obstacle along the whole trajectory.")
      .add(&P::smoothness, "smoothness_weight", "", base::kWeight,
           "Cost of accelerating at the limits of the drive along the whole trajectory.");
}

void addNearness(base::ParameterTable<SocialMppiParameters>& table) {
  using P = SocialMppiParameters;
  table
      .add(&P::prediction, "prediction", "", {0.0, 1.0},
           "Prediction of people: 0: constant velocity, 1: social force model with walls and the "
           "robot's plan.",
           "Helbing & Molnár 1995; Moussaïd et al. 2009")
      .add(&P::intimate, "intimate_weight", "", base::kWeight,
           "Cost of contact with a person, decreasing linearly to 0 at a gap of 0.45 m.",
           "Hall 1966")
      .add(&P::personal, "personal_weight", "", base::kWeight,
           "Cost of contact with a person, decreasing quadratically to 0 at a gap of 1.2 m.",
           "Hall 1966")
      .add(&P::space, "space_weight", "", base::kWeight,
           "Cost at the centre of the personal space: a Gaussian that is longer in front of "
           "walking people.",
           "Kirby 2010; Truong & Ngo 2017")
      .add(&P::group, "group_weight", "", base::kWeight,
           "Cost at the centre of the space shared by two people who stand face to face.",
           "Kendon 1990; Truong & Ngo 2017");
}

void addMotion(base::ParameterTable<SocialMppiParameters>& table) {
  using P = SocialMppiParameters;
  table
      .add(&P::touchTime, "ttc_weight", "", base::kWeight,
           "Cost of approaching a person nearby, with the square of ttc_limit / time - 1.",
           "van der Horst & Hogema 1993")
      .add(&P::fromTouchTime, "ttc_limit", "s", base::kTimeSpan,
           "Time to collision at the current closing speed above which the cost is 0.",
           "van der Horst & Hogema 1993")
      .add(&P::relativeSpeed, "relative_speed_weight", "s²/m²", base::kWeight,
           "Cost of the squared relative speed beside a person, decreasing to 0 at a gap of 1.2 m.",
           "Butler & Agah 2001")
      .add(&P::strip, "front_weight", "", base::kWeight,
           "Cost of a position where a person is about to walk; the robot passes behind people.",
           "Kirby 2010")
      .add(&P::stripTime, "front_time", "s", base::kTimeSpan,
           "Walking time that this area extends in front of a person.")
      .add(&P::legibility, "legibility_weight", "", base::kWeight,
           "Cost of not showing early on which side the robot will pass an oncoming person; the "
           "beginning of a trajectory has the largest weight.",
           "Dragan, Lee & Srinivasa 2013")
      .add(&P::patience, "patience_weight", "", base::kWeight,
           "Cost of standing in a narrow passage that a person is about to use.")
      .add(&P::waitDistance, "wait_distance", "m", base::kLength,
           "Distance from the narrow passage at which the robot waits.")
      .add(&P::patienceTime, "patience_time", "s", base::kTime,
           "Waiting time after which the robot enters the passage anyway.");
}

}  // namespace

base::ParameterTable<MppiParameters> mppiTable() {
  MppiTable table;
  addSampling(table);
  addCosts(table);
  return table;
}

base::ParameterTable<SocialMppiParameters> socialMppiTable() {
  base::ParameterTable<SocialMppiParameters> table;
  table.include(&SocialMppiParameters::mppi, mppiTable());
  addNearness(table);
  addMotion(table);
  return table;
}

}  // namespace sim2d
