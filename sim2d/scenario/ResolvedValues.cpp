#include "sim2d/scenario/ResolvedValues.h"

#include <algorithm>
#include <array>
#include <limits>

#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

/// Numbers of the drawn parameters. They are part of each draw and must not change.
enum class Parameter : std::uint32_t {
  GoalFactor = 0,
  ObstacleFactor,
  SocialFactor,
  Duration,
  Distance,
  Speed,
  SafeDistance,
  StopDistance,
  FrontDistance,
  FreeSpeed,
};

struct Distribution {
  double mean, deviation, least;  // normal; `least` replaces smaller values
  double low, high;               // uniform
  double most = std::numeric_limits<double>::infinity();
};

/// Draws values for configuration 2 or 3; a draw depends only on seed, agent and parameter.
class Sampler {
 public:
  Sampler(long long seed, int id, Configuration configuration)
      : rng_(static_cast<std::uint64_t>(seed), id),
        normal_(configuration == Configuration::Normal) {}

  double draw(Parameter parameter, const Distribution& from) const {
    const auto index = static_cast<std::uint32_t>(parameter);
    if (!normal_) {
      return rng_.uniform(from.low, from.high, base::DrawPurpose::Parameter, index);
    }
    const double value =
        rng_.normal(from.mean, from.deviation, base::DrawPurpose::Parameter, index);
    return std::clamp(value, from.least, from.most);
  }

 private:
  base::AgentRng rng_;
  bool normal_;
};

void applyFactors(ResolvedHuman& to, const Behavior& from, ObstaclePoints points) {
  if (to.configuration == Configuration::Custom) {
    to.goalFactor = from.goalForceFactor.value_or(to.goalFactor);
    to.obstacleFactor = from.obstacleForceFactor.value_or(to.obstacleFactor);
    to.socialFactor = from.socialForceFactor.value_or(to.socialFactor);
    return;
  }
  // Each rule of obstacle points has its own factors.
  const bool rays = points == ObstaclePoints::Rays;
  to.goalFactor = rays ? 10.0 : 2.0;
  to.obstacleFactor = rays ? 2.0 : 10.0;
  to.socialFactor = 5.0;
  to.otherFactor = std::max(to.otherFactor, 0.0);
}

/// Mean, deviation and lower bound of HuNavSim's loader; its clamps are the upper bounds.
void drawFactors(ResolvedHuman& to, const Sampler& sampler) {
  to.goalFactor = sampler.draw(Parameter::GoalFactor, {2.0, 1.5, 0.5, 2.0, 5.0, 5.0});
  to.obstacleFactor = sampler.draw(Parameter::ObstacleFactor, {10.0, 4.0, 0.5, 2.0, 50.0, 50.0});
  to.socialFactor = sampler.draw(Parameter::SocialFactor, {4.0, 3.5, 3.0, 4.0, 20.0, 20.0});
}

/// The distributions of HuNavSim's editor.
void drawReaction(ResolvedHuman& to, const Sampler& sampler) {
  if (!reactsToRobot(to.behavior)) {
    return;
  }
  const bool isSurprised = to.behavior == BehaviorType::Surprised;
  const bool isCurious = to.behavior == BehaviorType::Curious;
  const double usualDuration = isSurprised ? 30.0 : 40.0;
  to.reactionDuration = sampler.draw(Parameter::Duration, {usualDuration, 15.0, 10.0, 25.0, 60.0});
  to.noticeDistance =
      sampler.draw(Parameter::Distance, isCurious ? Distribution{10.0, 3.0, 1.5, 5.0, 15.0}
                                                  : Distribution{4.0, 2.0, 1.5, 2.0, 6.0});
  if (to.behavior == BehaviorType::Scared) {
    to.reactionSpeed = sampler.draw(Parameter::Speed, {0.6, 0.2, 0.4, 0.4, 1.0});
    to.safeDistance = sampler.draw(Parameter::SafeDistance, {5.0, 1.5, 2.0, 3.0, 8.0});
  } else if (isCurious) {
    to.reactionSpeed = sampler.draw(Parameter::Speed, {1.0, 0.3, 0.4, 0.6, 1.2});
    to.stopDistance = sampler.draw(Parameter::StopDistance, {1.5, 0.3, 0.5, 1.0, 2.5});
  } else if (to.behavior == BehaviorType::Threatening) {
    to.frontDistance = sampler.draw(Parameter::FrontDistance, {1.4, 0.3, 0.5, 0.5, 2.0});
  }
}

std::optional<double> parameterValue(const std::string& text) {
  const std::string word = base::toLower(text);
  if (word == "true" || word == "false") {
    return word == "true" ? 1.0 : 0.0;
  }
  return base::parseDouble(text);
}

/// Values that are not numbers are omitted; the check reports them.
std::vector<std::pair<std::string, double>> numbersOf(const ParameterTexts& parameters) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const auto& [name, text] : parameters) {
    if (const auto value = parameterValue(text)) {
      numbers.emplace_back(name, *value);
    }
  }
  return numbers;
}

void resolveRobotGoals(ResolvedRobot& to, const RobotGoal& from, const Scenario& scenario) {
  if (from.point) {
    to.goals.push_back(*from.point);
    to.goalIds.push_back(0);
    return;
  }
  for (const int id : from.goals) {
    if (const GlobalGoal* goal = scenario.goal(id)) {
      to.goals.push_back(goal->position);
      to.goalIds.push_back(id);
    }
  }
}

void resolveFootprint(ResolvedRobot& to, const Robot& from) {
  const std::size_t corners = std::min(from.footprintX.size(), from.footprintY.size());
  if (corners > 0 || from.radius) {
    to.footprint.clear();  // that of the type
  }
  for (std::size_t i = 0; i < corners; ++i) {
    to.footprint.emplace_back(from.footprintX[i], from.footprintY[i]);
  }
  if (to.footprint.empty()) {
    return;
  }
  if (signedArea(to.footprint) < 0.0) {
    std::reverse(to.footprint.begin(), to.footprint.end());
  }
  to.radius = circumscribedRadius(
      Footprint{0.0, to.footprint});  // circumscribed radius, used where a disc is needed
}

}  // namespace

ResolvedHuman resolveHuman(const Environment& scenario, const Human& human, long long seed) {
  ResolvedHuman result;
  result.id = human.id;
  result.name = human.name;
  const double goalRadius = human.goalRadius.value_or(0.0);
  result.goalRadius = goalRadius > 0.0 ? goalRadius : 0.1;  // as SetGoal does
  result.start = {human.initPose.position, base::wrapToPi(human.initPose.heading)};
  result.behavior = human.behavior.type.value_or(BehaviorType::Regular);
  result.configuration = human.behavior.configuration.value_or(Configuration::Default);
  resolveFields(human, result);
  resolveFields(human.behavior, result);
  resolveFields(human.ours, result);
  result.reactionSpeed = human.behavior.vel.value_or(human.maxVel.value_or(2.0));
  result.mass = human.ours.mass.value_or(massOf(result.kind));
  result.model = human.ours.model ? *human.ours.model : scenario.desktop.model.value_or("sfm");
  result.modelParameters = modelParametersOf(scenario, result.model);
  result.route =
      human.ours.route ? *human.ours.route : scenario.desktop.route.value_or(Route::Planned);
  applyFactors(result, human.behavior,
               scenario.desktop.obstaclePoints.value_or(ObstaclePoints::Boundary));
  if (isDrawn(result.configuration)) {
    const Sampler sampler(seed, human.id, result.configuration);
    drawFactors(result, sampler);
    drawReaction(result, sampler);
  }
  return result;
}

std::vector<std::string_view> reactionKeys(BehaviorType type) {
  switch (type) {
    case BehaviorType::Surprised:
      return {"dist", "duration", "once"};
    case BehaviorType::Scared:
      return {"dist", "duration", "once", "vel", "safe_distance"};
    case BehaviorType::Curious:
      return {"dist", "duration", "once", "vel", "stop_dist"};
    case BehaviorType::Threatening:
      return {"dist", "duration", "once", "front_dist"};
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
  }
  return {};
}

const std::vector<std::string_view>& factorKeys() {
  static const std::vector<std::string_view> kKeys = {"goal_force_factor", "obstacle_force_factor",
                                                      "social_force_factor", "other_force_factor"};
  return kKeys;
}

ResolvedRobot robotOfType(const std::string& type) {
  const RobotType* const known = findRobotType(type);
  const RobotType& taken = known != nullptr ? *known : robotTypes().front();
  const RobotBody& body = taken.body;
  ResolvedRobot result;
  result.radius = circumscribedRadius(body.footprint);
  result.mass = body.mass;
  result.maxVel = body.limits.maxVel;
  result.maxAcc = body.limits.maxAcc;
  result.maxOmega = body.limits.maxOmega;
  result.maxAlpha = body.limits.maxAlpha;
  result.maxReverse = body.limits.maxReverse;
  result.footprint = body.footprint.corners;
  result.kinematics = body.kinematics;
  result.turningRadius = body.limits.turningRadius;
  setLidarFromType(taken, result);
  return result;
}

ResolvedRobot resolveRobot(const Scenario& scenario, const Robot& robot, int id) {
  ResolvedRobot result = robotOfType(robot.type.value_or(ResolvedRobot{}.type));
  const double reverse = result.maxReverse / result.maxVel;
  result.id = id;
  result.name = robot.name;
  result.plannerParameters = numbersOf(robot.plannerParameters);
  for (const auto& [name, yaml] : robot.plannerParameters) {
    result.plannerTexts.emplace_back(name, base::scalarText(yaml));
  }
  result.nav2Params = robot.nav2Params;
  result.nav2Distro = robot.nav2Distro;
  for (const auto& [name, yaml] : robot.nav2Values) {
    result.nav2Values.emplace_back(name, yaml);
  }
  result.start = {robot.start.position, base::wrapToPi(robot.start.heading)};
  resolveRobotGoals(result, robot.goal, scenario);
  resolveFields(robot, result);
  result.maxReverse = reverse * result.maxVel;
  resolveSensors(robot, result);
  resolveFootprint(result, robot);
  return result;
}

std::vector<std::pair<std::string, double>> modelParametersOf(const Environment& scenario,
                                                              const std::string& model) {
  for (const auto& [name, parameters] : scenario.desktop.modelParameters) {
    if (name == model) {
      return numbersOf(parameters);
    }
  }
  return {};
}

const KindProfile& profileOf(PersonKind kind) {
  // Masses. Adult: the value of the format. Child: ten years old (median 31 to 32 kg, WHO growth
  // reference 2007). Elderly: about the mean of people over 75 (NHANES 2015-2018). Wheelchair,
  // luggage: an adult with a manual chair or a case of 20 kg.
  // Radii. Adult, elderly: the value of the format. Child, luggage: our assumptions. Wheelchair:
  // between the half width and the half length of the chair of ISO 7193, 0.70 x 1.20 m.
  // Speeds. Adult: Weidmann 1993. Child: ten years old, from his curve over age. Elderly: 70 to 79
  // years, comfortable gait of 1.13 to 1.26 m/s (Bohannon & Williams Andrews 2011). Wheelchair:
  // manual, level ground, 0.69 ± 0.35 m/s (Boyce, Shields & Silcock 1999). Luggage: 10 % below the
  // adult's, our assumption.
  static const std::array<KindProfile, 5> kProfiles = {{{80.0, 0.35, 1.34, 0.26, 0.6, 2.1},
                                                        {32.0, 0.26, 1.20, 0.20, 0.6, 1.8},
                                                        {75.0, 0.35, 1.18, 0.20, 0.5, 1.7},
                                                        {100.0, 0.45, 0.69, 0.25, 0.15, 1.35},
                                                        {100.0, 0.40, 1.20, 0.24, 0.5, 1.9}}};
  return kProfiles.at(static_cast<std::size_t>(kind));
}

double sampleSpeed(PersonKind kind, long long seed, int person) {
  const KindProfile& profile = profileOf(kind);
  const base::AgentRng rng(static_cast<std::uint64_t>(seed), person);
  const auto index = static_cast<std::uint32_t>(Parameter::FreeSpeed);
  const double speed =
      rng.normal(profile.meanSpeed, profile.deviation, base::DrawPurpose::Parameter, index);
  return std::clamp(speed, profile.slowest, profile.fastest);
}

double massOf(PersonKind kind) {
  return profileOf(kind).mass;
}

const char* personKindName(PersonKind kind) {
  return fieldOf<PersonExtension>("kind")->spec.choices[static_cast<std::size_t>(kind)].c_str();
}

}  // namespace sim2d
