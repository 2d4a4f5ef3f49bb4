#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"

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
    warnUnknownBehavior(behavior, *view.node().find("type"), "type", view);
  }
}

void writeType(YamlNode& tree, const Behavior& behavior) {
  if (behavior.type) {
    // An unknown number stays a string for ROS.
    setChild(tree, "type",
             stringNode(behavior.unknownType.empty() ? behaviorName(*behavior.type)
                                                     : behavior.unknownType));
  }
}

/// The number of decimals depends on the type, as in HuNavSim's editor.
std::function<int(const Behavior&)> digitsWith(BehaviorType type, int digits, int otherwise) {
  return [=](const Behavior& behavior) {
    return behavior.type.value_or(BehaviorType::Regular) == type ? digits : otherwise;
  };
}

FieldBuilder<Behavior> distance(std::string key, std::optional<double> Behavior::*member,
                                double ResolvedHuman::*resolved, std::string help,
                                base::FormHints form) {
  return field(std::move(key), member, std::move(help), std::move(form), "m", base::kDistance)
      .resolvedTo(resolved)
      .digits(2);
}

FieldBuilder<Behavior> factor(std::string key, std::optional<double> Behavior::*member,
                              double ResolvedHuman::*resolved, std::string help,
                              base::FormHints form) {
  return field(std::move(key), member, std::move(help), std::move(form), {}, base::kFactor)
      .computedTo(resolved)
      .defaultsTo(ResolvedHuman().*resolved);
}

}  // namespace

Fields<Human> humanFields() {
  using Resolved = ResolvedHuman;
  return {
      field("id", &Human::id, "Id of the person; part of the name of the tree file",
            {"Number", 0, 1.0}, {}, {0.0, 2147483647.0})
          .withNoneValue(-1),
      field("group_id", &Human::groupId,
            "Group number; people of one group stay together; -1: no group", {"Walks with", 0, 1.0})
          .resolvedTo(&Resolved::groupId),
      field("skin", &Human::skin, "Appearance of the person in the simulator", {"Figure", 0, 1.0}),
      field("max_vel", &Human::maxVel, "Desired walking speed", {"Top speed", 2, 0.05, 2.0}, "m/s",
            base::kSpeed)
          .resolvedTo(&Resolved::desiredSpeed),
      field("radius", &Human::radius,
            "Radius of the circular body; with the model das it is 0.20 m, except for wheelchairs",
            {"Radius", 2, 0.01, 0.8}, "m", base::kBodySize)
          .resolvedTo(&Resolved::radius),
      field("goal_radius", &Human::goalRadius,
            "Distance within which a goal is reached; 0 counts as 0.1", {"Arrival radius", 2, 0.05},
            "m", base::kDistance)
          .computedTo(&Resolved::goalRadius)
          .defaultsTo(0.1),
      field("cyclic_goals", &Human::cyclicGoals, "Restart the route after the last goal",
            {"Repeat"})
          .resolvedTo(&Resolved::cyclicGoals)};
}

Fields<Behavior> behaviorFields() {
  using Resolved = ResolvedHuman;
  return {
      FieldBuilder<Behavior>("type", "How the person reacts to the robot", {"Behaviour"})
          .withCustomIo(readType, writeType,
                        [](auto& of) { return std::tie(of.type, of.unknownType); })
          .words({"Regular", "Impassive", "Surprised", "Scared", "Curious", "Threatening"})
          .defaultsTo(std::string("Regular")),
      distance("dist", &Behavior::dist, &Resolved::noticeDistance,
               "Distance within which the person notices the robot", {"Sees within", 2, 0.5, 15.0})
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Surprised, 3, 2)),
      field("duration", &Behavior::duration, "Duration of the reaction", {"Lasts", 1, 1.0, 80.0},
            "s", base::kTime)
          .resolvedTo(&Resolved::reactionDuration)
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Threatening, 2, 1)),
      field("once", &Behavior::once, "React only once", {"Only once"})
          .resolvedTo(&Resolved::reactionOnce),
      field("vel", &Behavior::vel,
            "Speed during the reaction; absent: `max_vel`, or 2.0 if "
            "that is absent too",
            {"Speed", 2, 0.1, 2.0}, "m/s", base::kSpeed)
          .computedTo(&Resolved::reactionSpeed)
          .with(&Field<Behavior>::digitsOf, digitsWith(BehaviorType::Scared, 3, 2)),
      distance("safe_distance", &Behavior::safeDistance, &Resolved::safeDistance,
               "Distance to which the person retreats from the robot", {"Keeps away", 2, 0.5, 10.0})
          .digits(1),
      distance("stop_dist", &Behavior::stopDist, &Resolved::stopDistance,
               "Distance to the robot at which the person stops", {"Stops at", 2, 0.1, 3.0}),
      distance("front_dist", &Behavior::frontDist, &Resolved::frontDistance,
               "Distance in front of the robot at which the person stands",
               {"Blocks at", 2, 0.1, 3.0}),
      FieldBuilder<Behavior>("configuration", "Source of the force factors, see below",
                             {"Strength", 0, 1.0}, {}, {0.0, 3.0})
          .withCustomIo(readConfiguration, writeConfiguration, &Behavior::configuration)
          .typed(ParameterType::Integer)
          .defaultsTo(0),
      factor("goal_force_factor", &Behavior::goalForceFactor, &Resolved::goalFactor,
             "Factor of the attractive force of the goal", {"Goal", 2, 0.5, 10.0}),
      factor("obstacle_force_factor", &Behavior::obstacleForceFactor, &Resolved::obstacleFactor,
             "Factor of the repulsive force of walls and obstacles", {"Obstacles", 2, 0.5, 50.0}),
      factor("social_force_factor", &Behavior::socialForceFactor, &Resolved::socialFactor,
             "Factor of the repulsive force of other people", {"People", 2, 0.5, 20.0}),
      factor("other_force_factor", &Behavior::otherForceFactor, &Resolved::otherFactor,
             "Factor of the repulsive force of the robot while scared; never randomised",
             {"Robot", 2, 1.0, 25.0})
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
  return {field("start_time", &Ours::startTime, "Time at which the person enters the world",
                {"Enters at", 1, 1.0}, "s", base::kTime)
              .resolvedTo(&Resolved::startTime),
          field("kind", &Ours::kind, "Body type; determines the mass and the symbol on the map",
                {"Body"})
              .words({"adult", "child", "elderly", "wheelchair", "luggage"})
              .resolvedTo(&Resolved::kind),
          field("mass", &Ours::mass, "Mass of the body; absent: 80, 32, 75, 100, 100 by kind",
                {"Mass", 1, 1.0}, "kg", base::kMass)
              .computedTo(&Resolved::mass)
              .with(&Field<Ours>::fallbackOf, massByKind),
          field("model", &Ours::model, "Pedestrian model; absent: that of the scenario", {"Model"})
              .with(&Field<Ours>::fallbackOf, modelOf),
          field("route", &Ours::route,
                "Paths planned around walls, or straight lines; absent: as in "
                "the scenario",
                {"Routes"})
              .words(routeWords())
              .with(&Field<Ours>::fallbackOf, routeOf),
          field("at_end", &Ours::atEnd,
                "What the person does after the last goal of a route that does "
                "not repeat",
                {"At the end"})
              .words({"stop", "leave", "restart"})
              .resolvedTo(&Resolved::atEnd),
          field("wait", &Ours::wait, "Waiting time at each goal of the route", {"Waits"}, "s",
                base::kTime)
              .resolvedTo(&Resolved::wait),
          field("tree", &Ours::tree,
                "Behaviour tree file, relative to the scenario; several people "
                "may use the same one",
                {"Tree file"})};
}

}  // namespace sim2d
