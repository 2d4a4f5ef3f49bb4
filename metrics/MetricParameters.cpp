#include "metrics/MetricParameters.h"

#include "sim2d/base/Find.h"

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
using base::kFactor;
constexpr base::Range kOnOff{0.0, 1.0};  // range of a switch

constexpr char kSocialForces[] = "social_force_ social_work";
constexpr char kObstacleForces[] = "obstacle_force_ social_work";

}  // namespace

ParameterInfo::ParameterInfo(const char* key, double P::*itsMember, const char* unit,
                             const char* help, const char* users, base::Range range)
    : spec{key, base::ParameterType::Number, unit, range, P{}.*itsMember, {}, help, {}, {}},
      member(itsMember),
      usedBy(users) {}

namespace {

const std::vector<ParameterInfo> kInfos = {
    {"goal_tolerance", &P::goalTolerance, "m", "added to the radius of the goal",
     "completed time_to_reach_goal aggregated_time success spl stl"},
    {"time_limit", &P::timeLimit, "s",
     "an evaluation interval of this length is a timeout; a robot that arrives later has "
     "completed its path, but without success",
     "success"},
    {"contact_distance", &P::contactDistance, "m",
     "gap below which robot and person are in contact", "success"},
    {"stop_linear_speed", &P::stopLinearSpeed, "m/s", "lower speeds count as standing",
     "surprise_"},
    {"stop_angular_speed", &P::stopAngularSpeed, "rad/s", "lower turn rates count as not turning"},
    {"jerk_window", &P::jerkWindow, "s", "time window of the jerk; faster changes are smoothed",
     "max_jerk"},
    {"intimate_distance", &P::intimateDistance, "m", "outer edge of the intimate space",
     "intimate_space_ group_intimate_ personal_space_intrusions group_personal_"},
    {"personal_distance", &P::personalDistance, "m", "outer edge of the personal space",
     "personal_space_intrusions group_personal_ social_space_ group_social_"},
    {"social_distance", &P::socialDistance, "m", "outer edge of the social space",
     "social_space_ group_social_"},
    {"group_interaction_distance", &P::groupInteractionDistance, "m",
     "distance from a member to the centre of the group, along the heading",
     "group_intimate_ group_personal_ group_social_"},
    {"group_minimum_members", &P::groupMinimumMembers, "", "smaller groups are ignored",
     "group_ formation_space_"},
    {"social_factor", &P::socialFactor, "m/s²", "strength of the social force", kSocialForces,
     kFactor},
    {"social_lambda", &P::socialLambda, "", "weight of the relative velocity", kSocialForces,
     kFactor},
    {"social_gamma", &P::socialGamma, "m", "range of the social force", kSocialForces},
    {"social_n", &P::socialN, "", "width of the sideways term", kSocialForces, kFactor},
    {"social_n_prime", &P::socialNPrime, "", "width of the deceleration term", kSocialForces,
     kFactor},
    {"obstacle_factor", &P::obstacleFactor, "m/s²", "strength of the obstacle force",
     kObstacleForces, kFactor},
    {"obstacle_sigma", &P::obstacleSigma, "m", "range of the obstacle force", kObstacleForces},
    {"person_force_parameters", &P::personForceParameters, "",
     "1: the force of the robot on a person uses the person's own factor",
     "social_force_on_agents social_work", kOnOff},
    {"fear_cap", &P::fearCap, "1/s", "maximum fear of a pair"},
    {"panic_epsilon", &P::panicEpsilon, "m²/s", "near misses closer than this cause no panic",
     "danger_panic_cost"},
    {"field_of_view", &P::fieldOfView, "rad", "full angle of a person's field of view",
     "surprise_"},
    {"recognition_time", &P::recognitionTime, "s", "duration of a shock", "surprise_"},
    {"reaction_time", &P::reactionTime, "s", "duration of a reaction", "surprise_"},
    {"surprise_distance", &P::surpriseDistance, "m", "proxemic distance of the surprise costs",
     "surprise_"},
    {"surprise_minimum_distance", &P::surpriseMinimumDistance, "m",
     "smaller gaps count as this value", "surprise_"},
    {"surprise_requires_motion", &P::surpriseRequiresMotion, "",
     "1: a standing robot causes no surprise", "surprise_", kOnOff},
    {"surprise_visibility_only_unrecognised", &P::surpriseVisibilityOnlyUnrecognised, "",
     "1: no visibility cost after the reaction", "surprise_visibility_", kOnOff},
    {"compliance_distance", &P::complianceDistance, "m", "gap required by space_compliance"},
    {"progress_tolerance", &P::progressTolerance, "m",
     "smaller steps away from the goal are ignored"},
    {"stall_speed", &P::stallSpeed, "m/s", "lower speeds count as stalled"},
    {"personal_radius", &P::personalRadius, "m", "centre distance of time_in_personal_space",
     "avg_speed_in_personal_space"},
    {"facing_half_angle", &P::facingHalfAngle, "rad",
     "half angle of the cone of facing and seeing"},
    {"gaussian_threshold", &P::gaussianThreshold, "",
     "value of the personal space that counts as an intrusion"},
    {"discomfort_distance", &P::discomfortDistance, "m", "smaller gaps count as discomfort"},
    {"oscillation_speed", &P::oscillationSpeed, "m/s", "lower speeds count as hardly moving"},
    {"oscillation_angular_speed", &P::oscillationAngularSpeed, "rad/s",
     "lower turn rates count as hardly moving"},
    {"backward_speed", &P::backwardSpeed, "m/s",
     "faster backward motion counts as driving backwards"},
    {"inplace_speed", &P::inplaceSpeed, "m/s", "lower speeds count as rotating in place"},
    {"inplace_angular_speed", &P::inplaceAngularSpeed, "rad/s",
     "minimum turn rate of a rotation in place"},
    {"safety_distance", &P::safetyDistance, "m", "clearance required by obstacle_safety"},
    {"collision_horizon", &P::collisionHorizon, "s", "earlier collisions count as a threat"},
    {"collision_cap", &P::collisionCap, "s", "later collisions count as happening at this time"},
    {"stopped_distance", &P::stoppedDistance, "m",
     "a robot that moves less within stopped_window counts as stopped"},
    {"stopped_window", &P::stoppedWindow, "s",
     "preceding time in which the motion is measured for stopped_distance"},
    {"disturbance_radius", &P::disturbanceRadius, "m", "radius of the space that a person occupies",
     "heading_direction_"},
    {"disturbance_field_of_view", &P::disturbanceFieldOfView, "rad",
     "full angle in which a person notices the robot", "heading_direction_"},
    {"disturbance_speed", &P::disturbanceSpeed, "m/s", "speed above which the disturbance is full",
     "heading_direction_"},
    {"crowd_radius", &P::crowdRadius, "m", "radius of the neighbourhood in crowd metrics",
     "crowd_voronoi_ crowd_specific_flow"},
    {"crowd_interval", &P::crowdInterval, "s", "minimum time between two crowd samples", "crowd_"},
    {"lane_width", &P::laneWidth, "m",
     "distance to each side of a person that counts as the same lane"},
    {"conflict_horizon", &P::conflictHorizon, "s", "closest approaches within this time count",
     "engagement"},
    {"conflict_margin", &P::conflictMargin, "m", "passing with at least this gap is not a conflict",
     "engagement"},
    {"flow_line_x1", &P::flowLineX1, "m", "first end of the line whose crossings are counted",
     "line_", kFactor},
    {"flow_line_y1", &P::flowLineY1, "m", "", "line_", kFactor},
    {"flow_line_x2", &P::flowLineX2, "m", "second end of the line; both ends equal: no line",
     "line_", kFactor},
    {"flow_line_y2", &P::flowLineY2, "m", "", "line_", kFactor},
};

}  // namespace

const std::vector<ParameterInfo>& parameterInfos() {
  return kInfos;
}

const ParameterInfo* findParameter(std::string_view name) {
  return base::findIf(parameterInfos(),
                      [name](const ParameterInfo& info) { return info.spec.key == name; });
}

}  // namespace metrics
