#include "metrics/MetricParameters.h"

#include <utility>

namespace metrics {

const char* profileName(Profile profile) {
  return profile == Profile::Corrected ? "corrected" : "hunav2";
}

std::optional<Profile> profileOf(std::string_view name) {
  for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
    if (name == profileName(profile)) {
      return profile;
    }
  }
  return std::nullopt;
}

namespace {

using P = MetricParameters;
using base::kAnyNumber;
using base::kNotNegative;

ParameterInfo number(const char* key, double P::*member, const char* unit, const char* help,
                     base::Range range = kNotNegative) {
  base::ParameterSpec spec;
  spec.key = key;
  spec.unit = unit;
  spec.range = range;
  spec.help = help;
  spec.fallback = P{}.*member;
  return {std::move(spec), member};
}

/// 0 or 1, as files have it.
ParameterInfo onOff(const char* key, double P::*member, const char* help) {
  return number(key, member, "", help, {0.0, 1.0});
}

}  // namespace

const std::vector<ParameterInfo>& parameterInfos() {
  static const std::vector<ParameterInfo> kInfos = {
      number("goal_tolerance", &P::goalTolerance, "m", "added to the radius of the goal"),
      number("time_limit", &P::timeLimit, "s", "a run of this length is a timeout"),
      number("contact_distance", &P::contactDistance, "m",
             "gap below which robot and person touch"),
      number("stop_linear_speed", &P::stopLinearSpeed, "m/s", "slower counts as standing"),
      number("stop_angular_speed", &P::stopAngularSpeed, "rad/s", "slower counts as not turning"),
      number("intimate_distance", &P::intimateDistance, "m", "outer edge of the intimate space"),
      number("personal_distance", &P::personalDistance, "m", "outer edge of the personal space"),
      number("social_distance", &P::socialDistance, "m", "outer edge of the social space"),
      number("group_interaction_distance", &P::groupInteractionDistance, "m",
             "from a member to the centre of the group, along the heading"),
      number("group_minimum_members", &P::groupMinimumMembers, "", "smaller groups are none"),
      number("social_factor", &P::socialFactor, "m/s²", "strength of the social force", kAnyNumber),
      number("social_lambda", &P::socialLambda, "", "weight of the relative velocity", kAnyNumber),
      number("social_gamma", &P::socialGamma, "m", "reach of the social force"),
      number("social_n", &P::socialN, "", "width of the sideways term", kAnyNumber),
      number("social_n_prime", &P::socialNPrime, "", "width of the slowing term", kAnyNumber),
      number("obstacle_factor", &P::obstacleFactor, "m/s²", "strength of the obstacle force",
             kAnyNumber),
      number("obstacle_sigma", &P::obstacleSigma, "m", "reach of the obstacle force"),
      onOff("person_force_parameters", &P::personForceParameters,
            "1: the force of the robot on a person uses the person's own factor"),
      number("fear_cap", &P::fearCap, "1/s", "largest fear of one pair"),
      number("panic_epsilon", &P::panicEpsilon, "m²/s",
             "near misses closer than this give no panic"),
      number("field_of_view", &P::fieldOfView, "rad", "full angle a person sees"),
      number("recognition_time", &P::recognitionTime, "s", "a shock lasts as long"),
      number("reaction_time", &P::reactionTime, "s", "a reaction lasts as long"),
      number("surprise_distance", &P::surpriseDistance, "m",
             "proxemic distance of the surprise costs"),
      number("surprise_minimum_distance", &P::surpriseMinimumDistance, "m",
             "smaller gaps count as this one"),
      onOff("surprise_requires_motion", &P::surpriseRequiresMotion,
            "1: a standing robot surprises nobody"),
      onOff("surprise_visibility_only_unrecognised", &P::surpriseVisibilityOnlyUnrecognised,
            "1: no visibility cost after the reaction"),
      number("compliance_distance", &P::complianceDistance, "m",
             "gap that space_compliance asks for"),
      number("progress_tolerance", &P::progressTolerance, "m",
             "smaller steps away from the goal are none"),
      number("stall_speed", &P::stallSpeed, "m/s", "slower counts as stalled"),
      number("personal_radius", &P::personalRadius, "m",
             "centre distance of time_in_personal_space"),
      number("facing_half_angle", &P::facingHalfAngle, "rad", "half cone of facing and seeing"),
      number("gaussian_threshold", &P::gaussianThreshold, "",
             "personal space value that counts as intruded"),
      number("discomfort_distance", &P::discomfortDistance, "m", "smaller gaps are uncomfortable"),
      number("oscillation_speed", &P::oscillationSpeed, "m/s", "slower counts as oscillating"),
      number("oscillation_angular_speed", &P::oscillationAngularSpeed, "rad/s",
             "and turning slower"),
      number("backward_speed", &P::backwardSpeed, "m/s", "faster backwards counts"),
      number("inplace_speed", &P::inplaceSpeed, "m/s", "slower counts as in place"),
      number("inplace_angular_speed", &P::inplaceAngularSpeed, "rad/s",
             "and turning at least this fast"),
      number("safety_distance", &P::safetyDistance, "m", "clearance that obstacle_safety asks for"),
      number("collision_horizon", &P::collisionHorizon, "s",
             "collisions sooner than this are a threat"),
      number("stopped_distance", &P::stoppedDistance, "m", "who moved less is stopped"),
      number("stopped_window", &P::stoppedWindow, "s", "in the time up to now of this length"),
      number("disturbance_radius", &P::disturbanceRadius, "m", "space that a person takes"),
      number("disturbance_field_of_view", &P::disturbanceFieldOfView, "rad",
             "full angle in which a person notices"),
      number("disturbance_speed", &P::disturbanceSpeed, "m/s", "speed that disturbs in full"),
      number("crowd_radius", &P::crowdRadius, "m", "neighbourhood of the crowd measures"),
      number("crowd_interval", &P::crowdInterval, "s", "least time between two looks at the crowd"),
      number("lane_width", &P::laneWidth, "m", "to each side of a person: the same lane"),
      number("conflict_horizon", &P::conflictHorizon, "s",
             "closest approaches sooner than this count"),
      number("conflict_margin", &P::conflictMargin, "m", "gap with which passing is no conflict"),
      number("flow_line_x1", &P::flowLineX1, "m", "line whose crossings are counted, first end",
             kAnyNumber),
      number("flow_line_y1", &P::flowLineY1, "m", "", kAnyNumber),
      number("flow_line_x2", &P::flowLineX2, "m", "second end; both ends equal: no line",
             kAnyNumber),
      number("flow_line_y2", &P::flowLineY2, "m", "", kAnyNumber),
  };
  return kInfos;
}

const ParameterInfo* findParameter(std::string_view name) {
  for (const ParameterInfo& info : parameterInfos()) {
    if (info.spec.key == name) {
      return &info;
    }
  }
  return nullptr;
}

}  // namespace metrics
