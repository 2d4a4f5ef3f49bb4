#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

void readPlannerParameters(YamlMap& view, Robot& robot) {
  robot.plannerParameters = readParameters(view, "planner_parameters");
}

void writePlannerParameters(YamlNode& tree, const Robot& robot) {
  writeParameters(tree, "planner_parameters", robot.plannerParameters);
}

void readStart(YamlMap& view, Robot& robot) {
  if (view.find("start") == nullptr) {
    view.error("start", "yaml.missing");
    return;
  }
  YamlMap start = view.map("start");
  robot.start.position = readPoint(start);
  robot.start.heading = start.number("h").value_or(0.0);
  refuseUnknown(start);
}

void writeStart(YamlNode& tree, const Robot& robot) {
  YamlNode& start = tree.child("start");
  setPoint(start, robot.start.position);
  setChild(start, "h", decimals(robot.start.heading));
}

void readGoal(YamlMap& view, Robot& robot) {
  if (view.find("goal") != nullptr) {
    YamlMap point = view.map("goal");
    robot.goal.point = readPoint(point);
    refuseUnknown(point);
  }
}

void writeGoal(YamlNode& tree, const Robot& robot) {
  if (robot.goal.point) {
    setPoint(tree.child("goal"), *robot.goal.point);
  }
}

void readGoals(YamlMap& view, Robot& robot) {
  const bool both = view.node().find("goal") != nullptr && view.node().find("goals") != nullptr;
  if (both) {
    view.error("goals", "scenario.two-goals");
  }
  robot.goal.goals = view.integers("goals");
  if (both) {
    robot.goal.goals.clear();
  }
}

void writeGoals(YamlNode& tree, const Robot& robot) {
  if (!robot.goal.point && !robot.goal.goals.empty()) {
    setChild(tree, "goals", integerList(robot.goal.goals));
  }
}

void readFootprint(YamlMap& view, Robot& robot) {
  robot.footprintY = view.numbers("footprint_y");
  if (robot.footprintX.size() != robot.footprintY.size()) {
    view.error("footprint_y", "scenario.footprint-uneven");
  } else if (!robot.footprintX.empty() && robot.footprintX.size() < 3) {
    view.error("footprint_x", "scenario.footprint-too-small");
  }
}

/// Limits and body are the type's; those of another type than the usual one are not known here.
FieldOf<Robot> limit(std::string key, std::optional<double> Robot::*member,
                     double ResolvedRobot::*resolved, std::string help, base::FormHints form,
                     std::string unit, base::Range range = base::kPositive) {
  const auto ofUsualType = [resolved](const Robot& robot, const DesktopSettings& /*desktop*/) {
    const ResolvedRobot usual;
    return robot.type.value_or(usual.type) == usual.type ? base::ParameterValue(usual.*resolved)
                                                         : base::ParameterValue();
  };
  return field(std::move(key), member, std::move(help), std::move(form), std::move(unit), range)
      .resolvedTo(resolved)
      .with(&Field<Robot>::fallbackOf, ofUsualType);
}

/// Equal in one part.
template <class Part>
std::function<bool(const Robot&, const Robot&)> sameIn(Part part) {
  return [part](const Robot& a, const Robot& b) { return part(a) == part(b); };
}

}  // namespace

Fields<Robot> robotFields() {
  using Resolved = ResolvedRobot;
  constexpr base::Range kBodyRadius{0.0, 100.0, true};
  constexpr base::Range kSpeed{0.0, 100.0, true};
  return {
      field("type", &Robot::type, "Kind of robot", {"Type"}).resolvedTo(&Resolved::type),
      field("planner", &Robot::planner, "What drives it to its goals", {"Planner"})
          .resolvedTo(&Resolved::planner),
      FieldOf<Robot>("planner_parameters", "Of the planner: name and value of each", {"Parameters"})
          .madeBy(readPlannerParameters, writePlannerParameters,
                  sameIn([](auto& of) -> auto& { return of.plannerParameters; })),
      FieldOf<Robot>("start", "Where it begins: `x`, `y` and heading `h`", {"Position"})
          .required()
          .madeBy(readStart, writeStart, sameIn([](auto& of) -> auto& { return of.start; })),
      FieldOf<Robot>("goal", "Where it drives to: `x` and `y`", {"Point"})
          .madeBy(readGoal, writeGoal, sameIn([](auto& of) -> auto& { return of.goal.point; })),
      FieldOf<Robot>("goals", "Numbers of global goals in order, instead of `goal`", {"Or route"})
          .keptAt([](auto& of) -> auto& { return of.goal.goals; })
          .with(&Field<Robot>::read, readGoals)
          .with(&Field<Robot>::write, writeGoals),
      field("goal_radius", &Robot::goalRadius, "A goal is reached when the robot is this near",
            {"Arrival radius", 2, 0.05}, "m", base::kPositive)
          .resolvedTo(&Resolved::goalRadius),
      field("start_time", &Robot::startTime, "When it sets off", {"Sets off at", 1, 1.0}, "s",
            base::kNotNegative)
          .resolvedTo(&Resolved::startTime),
      limit("radius", &Robot::radius, &Resolved::radius, "Of the disc that the robot is",
            {"Radius", 2, 0.01, 1.0}, "m", kBodyRadius),
      limit("mass", &Robot::mass, &Resolved::mass, "Of the robot", {"Mass", 1, 1.0}, "kg"),
      limit("max_vel", &Robot::maxVel, &Resolved::maxVel, "Its speed at the most",
            {"Top speed", 2, 0.05, 2.0}, "m/s", kSpeed),
      limit("max_acc", &Robot::maxAcc, &Resolved::maxAcc, "How fast its speed changes",
            {"Acceleration", 2, 0.1, 3.0}, "m/s²"),
      limit("max_omega", &Robot::maxOmega, &Resolved::maxOmega, "Its turn rate at the most",
            {"Turn speed"}, "rad/s"),
      limit("max_alpha", &Robot::maxAlpha, &Resolved::maxAlpha, "How fast its turn rate changes",
            {"Turn accel."}, "rad/s²"),
      field("footprint_x", &Robot::footprintX,
            "Corners in the robot's frame, instead of the disc: their x", {"Footprint"}, "m"),
      field("footprint_y", &Robot::footprintY, "Their y, as many", {}, "m")
          .with(&Field<Robot>::read, readFootprint)};
}

}  // namespace sim2d
