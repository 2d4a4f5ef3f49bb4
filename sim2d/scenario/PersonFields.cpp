#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

void readConfiguration(YamlMap& view, Behavior& behavior) {
  const auto number = view.integer("configuration", -2147483647);
  if (number && (*number < 0 || *number > 3)) {
    view.warning("configuration", "scenario.bad-configuration", {*number});
    behavior.configuration = Configuration::Default;
  } else if (number) {
    behavior.configuration = static_cast<Configuration>(*number);
  }
}

void writeConfiguration(YamlNode& tree, const Behavior& behavior) {
  if (behavior.configuration) {
    setChild(tree, "configuration", number(static_cast<int>(*behavior.configuration)));
  }
}

void readType(YamlMap& view, Behavior& behavior) {
  const auto type = view.text("type");
  if (type && type->empty()) {
    view.warning("type", "scenario.empty-behavior");
  } else if (type) {
    setBehaviorType(behavior, *type);
    warnForeign(behavior, *view.node().find("type"), "type", view);
  }
}

void writeType(YamlNode& tree, const Behavior& behavior) {
  if (behavior.type) {
    // a number that we do not know stays a string for ROS
    setChild(tree, "type",
             stringNode(behavior.foreignType.empty() ? behaviorName(*behavior.type)
                                                     : behavior.foreignType));
  }
}

/// Digits after the point differ from type to type, as in HuNavSim's own editor.
std::function<int(const Behavior&)> digitsWith(BehaviorType type, int digits, int otherwise) {
  return [=](const Behavior& behavior) {
    return behavior.type.value_or(BehaviorType::Regular) == type ? digits : otherwise;
  };
}

FieldOf<Behavior> distance(std::string key, std::optional<double> Behavior::*member,
                           double ResolvedHuman::*resolved, std::string help,
                           base::FormHints form) {
  return field(std::move(key), member, std::move(help), std::move(form), "m", base::kDistance)
      .resolvedTo(resolved)
      .digits(2);
}

FieldOf<Behavior> factor(std::string key, std::optional<double> Behavior::*member,
                         double ResolvedHuman::*resolved, std::string help, base::FormHints form) {
  return field(std::move(key), member, std::move(help), std::move(form), {}, base::kFactor)
      .countsAs(resolved)
      .orElse(ResolvedHuman().*resolved);
}

}  // namespace

Fields<Human> humanFields() {
  using Resolved = ResolvedHuman;
  return {
      field("id", &Human::id, "Number of the person; names the tree file", {"Number", 0, 1.0}, {},
            {0.0, 2147483647.0})
          .noneAt(-1),
      field("group_id", &Human::groupId, "People of one group keep together; -1 is alone",
            {"Walks with", 0, 1.0})
          .resolvedTo(&Resolved::groupId),
      field("skin", &Human::skin, "How the simulator dresses the person", {"Figure", 0, 1.0}),
      field("max_vel", &Human::maxVel, "The speed the person wants to walk at",
            {"Top speed", 2, 0.05, 2.0}, "m/s", base::kSpeed)
          .resolvedTo(&Resolved::desiredSpeed),
      field(
          "radius", &Human::radius,
          "Of the disc that the body is; people of the model das, but for wheelchairs, have 0.20 m",
          {"Radius", 2, 0.01, 0.8}, "m", base::kBodySize)
          .resolvedTo(&Resolved::radius),
      field("goal_radius", &Human::goalRadius,
            "A goal is reached when the person is this near; 0 counts as 0.1",
            {"Arrival radius", 2, 0.05}, "m", base::kDistance)
          .countsAs(&Resolved::goalRadius)
          .orElse(0.1),
      field("cyclic_goals", &Human::cyclicGoals, "Start again after the last goal", {"Repeat"})
          .resolvedTo(&Resolved::cyclicGoals)};
}

Fields<Behavior> behaviorFields() {
  using Resolved = ResolvedHuman;
  return {
      FieldOf<Behavior>("type", "How the person reacts to the robot", {"Behaviour"})
          .madeBy(readType, writeType, [](auto& of) { return std::tie(of.type, of.foreignType); })
          .words({"Regular", "Impassive", "Surprised", "Scared", "Curious", "Threatening"})
          .orElse(std::string("Regular")),
      distance("dist", &Behavior::dist, &Resolved::noticeDistance,
               "The robot is noticed within this distance", {"Sees within", 2, 0.5, 15.0})
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Surprised, 3, 2)),
      field("duration", &Behavior::duration, "How long the reaction goes on",
            {"Lasts", 1, 1.0, 80.0}, "s", base::kTime)
          .resolvedTo(&Resolved::reactionDuration)
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Threatening, 2, 1)),
      field("once", &Behavior::once, "React only once", {"Only once"})
          .resolvedTo(&Resolved::reactionOnce),
      field("vel", &Behavior::vel, "Speed while reacting; absent: `max_vel`, 2.0 without it",
            {"Speed", 2, 0.1, 2.0}, "m/s", base::kSpeed)
          .countsAs(&Resolved::reactionSpeed)
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Scared, 3, 2)),
      distance("safe_distance", &Behavior::safeDistance, &Resolved::safeDistance,
               "Distance at which the person feels safe again", {"Keeps away", 2, 0.5, 10.0})
          .digits(1),
      distance("stop_dist", &Behavior::stopDist, &Resolved::stopDistance,
               "How near the person comes to the robot", {"Stops at", 2, 0.1, 3.0}),
      distance("front_dist", &Behavior::frontDist, &Resolved::frontDistance,
               "How far before the robot the person stands", {"Blocks at", 2, 0.1, 3.0}),
      FieldOf<Behavior>("configuration", "Whose force factors count, see below",
                        {"Strength", 0, 1.0}, {}, {0.0, 3.0})
          .madeBy(readConfiguration, writeConfiguration, &Behavior::configuration)
          .typed(ParameterType::Integer)
          .orElse(0),
      factor("goal_force_factor", &Behavior::goalForceFactor, &Resolved::goalFactor,
             "Pull of the goal", {"Goal", 2, 0.5, 10.0}),
      factor("obstacle_force_factor", &Behavior::obstacleForceFactor, &Resolved::obstacleFactor,
             "Push of walls", {"Obstacles", 2, 0.5, 50.0}),
      factor("social_force_factor", &Behavior::socialForceFactor, &Resolved::socialFactor,
             "Push of other people", {"People", 2, 0.5, 20.0}),
      factor("other_force_factor", &Behavior::otherForceFactor, &Resolved::otherFactor,
             "Push away from the robot while scared; never drawn", {"Robot", 2, 1.0, 25.0})
          .resolvedTo(&Resolved::otherFactor)};
}

Fields<PersonExtension> personFields() {
  using Ours = PersonExtension;
  using Resolved = ResolvedHuman;
  const auto massByKind = [](const Ours& of, const DesktopSettings& /*desktop*/) {
    return massOf(of.kind.value_or(PersonKind::Adult));
  };
  const auto modelOf = [](const Ours& /*of*/, const DesktopSettings& desktop) {
    return desktop.model.value_or(Resolved().model);
  };
  const auto routeOf = [](const Ours& /*of*/, const DesktopSettings& desktop) {
    return routeWords()[static_cast<std::size_t>(desktop.route.value_or(Route::Planned))];
  };
  return {
      field("start_time", &Ours::startTime, "Enters the world at this time", {"Comes at", 1, 1.0},
            "s", base::kTime)
          .resolvedTo(&Resolved::startTime),
      field("kind", &Ours::kind, "Gives the mass and the figure on the map", {"Body"})
          .words({"adult", "child", "elderly", "wheelchair", "luggage"})
          .resolvedTo(&Resolved::kind),
      field("mass", &Ours::mass, "Absent: by kind 80, 32, 75, 100, 100", {"Mass", 1, 1.0}, "kg",
            base::kMass)
          .countsAs(&Resolved::mass)
          .with(&Field<Ours>::fallbackOf, massByKind),
      field("model", &Ours::model, "How the person moves among others; absent: the scenario's",
            {"Model"})
          .with(&Field<Ours>::fallbackOf, modelOf),
      field("route", &Ours::route, "Ways round walls, or straight on; absent: the scenario's",
            {"Routes"})
          .words(routeWords())
          .with(&Field<Ours>::fallbackOf, routeOf),
      field("at_end", &Ours::atEnd, "After the last goal of a route that does not repeat",
            {"At the end"})
          .words({"stop", "leave", "restart"})
          .resolvedTo(&Resolved::atEnd),
      field("wait", &Ours::wait, "One time for each goal of the route", {"Waits"}, "s", base::kTime)
          .resolvedTo(&Resolved::wait),
      field("tree", &Ours::tree, "Relative to the scenario; may be shared by several people",
            {"Tree file"})};
}

}  // namespace sim2d
