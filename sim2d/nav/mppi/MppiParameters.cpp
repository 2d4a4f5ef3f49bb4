#include "sim2d/nav/mppi/MppiParameters.h"

#include <string>

#include "sim2d/base/Ranges.h"

namespace sim2d {
namespace {

using MppiTable = base::ParameterTable<MppiParameters>;

void addSampling(MppiTable& table) {
  using P = MppiParameters;
  const std::string nav2 = "Nav2 MPPI";
  table
      .addCount(&P::samples, "samples", {64.0, 20000.0},
                "Ways that are weighed in each step, rounded up to a multiple of 16.", nav2)
      .addCount(&P::steps, "time_steps", {10.0, 200.0}, "Steps of each way.", nav2)
      .add(&P::modelDt, "model_dt", "s", {0.01, 0.2}, "Time of a step of the ways.", nav2)
      .add(&P::temperature, "temperature", "", base::kWeightAboveZero,
           "lambda: how much cheaper a way must be to count e times as much.",
           "Williams et al. 2017")
      .add(&P::gamma, "gamma", "", base::kWeight, "Weight of the control cost: lambda (1 - alpha).",
           "Williams et al. 2017")
      .add(&P::linearNoise, "linear_noise", "m/s", base::kSpeedOfMotion,
           "Standard deviation of the noise on the speed ahead.", nav2)
      .add(&P::angularNoise, "angular_noise", "rad/s", base::kSpeedOfMotion,
           "Standard deviation of the noise on the turn rate.", nav2)
      .add(&P::lateralNoise, "lateral_noise", "m/s", base::kSpeedOfMotion,
           "Standard deviation of the noise on the sideways speed (omnidirectional).", nav2)
      .add(&P::noiseTime, "noise_time", "s", base::kTime,
           "Time in which the noise forgets itself to 1/e; 0: white, as in Nav2.");
}

void addCosts(MppiTable& table) {
  using P = MppiParameters;
  table
      .add(&P::goal, "goal_weight", "1/m", base::kWeight,
           "Cost of the mean distance to go, round the walls.")
      .add(&P::end, "end_weight", "1/m", base::kWeight,
           "Cost of the distance to go at the end of a way.")
      .add(&P::heading, "heading_weight", "", base::kWeight,
           "Cost of facing away from the way to the goal (not for omnidirectional robots).")
      .add(&P::reverse, "reverse_weight", "s/m", base::kWeight,
           "Cost of the mean speed backwards (not for omnidirectional robots).")
      .add(&P::stop, "stop_weight", "s²/m²", base::kWeight,
           "Cost of the squared speed inside the goal.")
      .add(&P::wall, "wall_weight", "", base::kWeight,
           "Cost of touching a wall, falling with the square to 0 at wall_range.")
      .add(&P::wallRange, "wall_range", "m", base::kLength, "Gap to walls that costs nothing.")
      .add(&P::person, "person_weight", "", base::kWeight,
           "Cost of touching a person, falling to 0 at person_range.")
      .add(&P::personRange, "person_range", "m", base::kLength,
           "Gap to a person that costs nothing.")
      .add(&P::personMargin, "person_margin", "m", base::kDistance,
           "A smaller gap to a person counts as a contact.")
      .add(&P::hit, "contact_weight", "", base::kWeightAboveZero,
           "Cost of being in contact with a person or an obstacle along the whole path.")
      .add(&P::smoothness, "smoothness_weight", "", base::kWeight,
           "Cost of changing the speed as fast as the drive can all the time.");
}

void addNearness(base::ParameterTable<SocialMppiParameters>& table) {
  using P = SocialMppiParameters;
  table
      .add(&P::prediction, "prediction", "", {0.0, 1.0},
           "How people are expected to walk on: 0 at constant velocity, 1 by the social force "
           "model, which knows walls and the robot's plan.",
           "Helbing & Molnár 1995; Moussaïd et al. 2009")
      .add(&P::intimate, "intimate_weight", "", base::kWeight,
           "Cost of touching a person, falling linearly to 0 at a gap of 0.45 m.", "Hall 1966")
      .add(&P::personal, "personal_weight", "", base::kWeight,
           "Idem, falling with the square to 0 at a gap of 1.2 m.", "Hall 1966")
      .add(&P::space, "space_weight", "", base::kWeight,
           "Cost at the middle of the personal space: a Gaussian, longer in front of who walks.",
           "Kirby 2010; Truong & Ngo 2017")
      .add(&P::group, "group_weight", "", base::kWeight,
           "Cost in the middle of the space that two share who stand face to face.",
           "Kendon 1990; Truong & Ngo 2017");
}

void addMotion(base::ParameterTable<SocialMppiParameters>& table) {
  using P = SocialMppiParameters;
  table
      .add(&P::touchTime, "ttc_weight", "", base::kWeight,
           "Cost of closing in on a person nearby, with the square of ttc_limit / time - 1.",
           "van der Horst & Hogema 1993")
      .add(&P::fromTouchTime, "ttc_limit", "s", base::kTimeSpan,
           "Time to touch at the present closing speed above which nobody minds.",
           "van der Horst & Hogema 1993")
      .add(&P::relativeSpeed, "relative_speed_weight", "s²/m²", base::kWeight,
           "Cost of the squared relative speed beside a person, falling to 0 at a gap of 1.2 m.",
           "Butler & Agah 2001")
      .add(&P::strip, "front_weight", "", base::kWeight,
           "Cost of being where somebody is about to walk: makes the robot pass behind.",
           "Kirby 2010")
      .add(&P::stripTime, "front_time", "s", base::kTimeSpan,
           "How far ahead of somebody that is, as a time of walking.")
      .add(&P::legibility, "legibility_weight", "", base::kWeight,
           "Cost of not showing early on which side of somebody oncoming the robot will pass; "
           "what is seen first counts most.",
           "Dragan, Lee & Srinivasa 2013")
      .add(&P::patience, "patience_weight", "", base::kWeight,
           "Cost of standing in a narrow place through which somebody comes.")
      .add(&P::waitDistance, "wait_distance", "m", base::kLength,
           "How far from the narrow place the robot waits.")
      .add(&P::patienceTime, "patience_time", "s", base::kTime,
           "After waiting so long it goes in all the same.");
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
