#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/FieldTables.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

constexpr base::Range kSpeed{0.0, 100.0};
constexpr base::Range kBodyRadius{0.0, 100.0, true};

void readConfiguration(YamlMap& view, Behavior& behavior) {
  const auto number = view.bigInteger("configuration", -2147483647);
  if (number && (*number < 0 || *number > 3)) {
    view.warning("configuration", std::to_string(*number) + " is none of 0 to 3 (taken as 0)");
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
  if (type && !type->empty()) {
    setBehaviorType(behavior, *type);
    warnForeign(behavior, *view.node().find("type"), view.pathOf("type"), view.entity(),
                view.report());
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
                           double ResolvedHuman::*resolved, std::string help) {
  return field(std::move(key), member, std::move(help))
      .in("m")
      .within(base::kNotNegative)
      .resolvedTo(resolved)
      .digits(2);
}

FieldOf<Behavior> factor(std::string key, std::optional<double> Behavior::*member, double usual,
                         std::string help) {
  return field(std::move(key), member, std::move(help)).orElse(usual);
}

}  // namespace

Fields<Human> humanFields() {
  return {
      FieldOf<Human>("id", "Number of the person; names the tree file")
          .keptAt([](auto& of) -> auto& { return of.id; })
          .within({0.0, 2147483647.0})
          .noneAt(-1)
          .form("Number", 0, 1.0),
      field("group_id", &Human::groupId, "People of one group keep together; -1 is alone")
          .resolvedTo(&ResolvedHuman::groupId)
          .form("Walks with", 0, 1.0),
      field("skin", &Human::skin, "How the simulator dresses the person").form("Figure", 0, 1.0),
      field("max_vel", &Human::maxVel, "The speed the person wants to walk at")
          .in("m/s")
          .within(kSpeed)
          .resolvedTo(&ResolvedHuman::desiredSpeed)
          .form("Top speed", 2, 0.05, 2.0),
      field("radius", &Human::radius, "Of the disc that the body is")
          .in("m")
          .within(kBodyRadius)
          .resolvedTo(&ResolvedHuman::radius)
          .form("Radius", 2, 0.01, 0.8),
      field("goal_radius", &Human::goalRadius,
            "A goal is reached when the person is this near; 0 counts as 0.1")
          .in("m")
          .within(base::kNotNegative)
          .orElse(0.1)
          .form("Arrival radius", 2, 0.05),
      field("cyclic_goals", &Human::cyclicGoals, "Start again after the last goal")
          .resolvedTo(&ResolvedHuman::cyclicGoals)
          .form("Repeat")};
}

Fields<Behavior> behaviorFields() {
  using Resolved = ResolvedHuman;
  return {FieldOf<Behavior>("type", "How the person reacts to the robot")
              .madeBy(readType, writeType,
                      [](const Behavior& a, const Behavior& b) {
                        return a.type == b.type && a.foreignType == b.foreignType;
                      })
              .words({"Regular", "Impassive", "Surprised", "Scared", "Curious", "Threatening"})
              .orElse(std::string("Regular"))
              .form("Behaviour"),
          distance("dist", &Behavior::dist, &Resolved::noticeDistance,
                   "The robot is noticed within this distance")
              .digits(digitsWith(BehaviorType::Surprised, 3, 2))
              .form("Sees within", 2, 0.5, 15.0),
          field("duration", &Behavior::duration, "How long the reaction goes on")
              .in("s")
              .within(base::kNotNegative)
              .resolvedTo(&Resolved::reactionDuration)
              .digits(digitsWith(BehaviorType::Threatening, 2, 1))
              .form("Lasts", 1, 1.0, 80.0),
          field("once", &Behavior::once, "React only once")
              .resolvedTo(&Resolved::reactionOnce)
              .form("Only once"),
          field("vel", &Behavior::vel, "Speed while reacting; absent: `max_vel`, 2.0 without it")
              .in("m/s")
              .within(kSpeed)
              .digits(digitsWith(BehaviorType::Scared, 3, 2))
              .form("Speed", 2, 0.1, 2.0),
          distance("safe_distance", &Behavior::safeDistance, &Resolved::safeDistance,
                   "Distance at which the person feels safe again")
              .digits(1)
              .form("Keeps away", 2, 0.5, 10.0),
          distance("stop_dist", &Behavior::stopDist, &Resolved::stopDistance,
                   "How near the person comes to the robot")
              .form("Stops at", 2, 0.1, 3.0),
          distance("front_dist", &Behavior::frontDist, &Resolved::frontDistance,
                   "How far before the robot the person stands")
              .form("Blocks at", 2, 0.1, 3.0),
          FieldOf<Behavior>("configuration", "Whose force factors count: 0 to 3, see below")
              .madeBy(readConfiguration, writeConfiguration,
                      [](const Behavior& a, const Behavior& b) {
                        return a.configuration == b.configuration;
                      })
              .typed(base::ParameterType::Integer)
              .within({0.0, 3.0})
              .orElse(0)
              .form("Strength", 0, 1.0),
          factor("goal_force_factor", &Behavior::goalForceFactor, 2.0, "Pull of the goal")
              .form("Goal", 2, 0.5, 10.0),
          factor("obstacle_force_factor", &Behavior::obstacleForceFactor, 10.0, "Push of walls")
              .form("Obstacles", 2, 0.5, 50.0),
          factor("social_force_factor", &Behavior::socialForceFactor, 5.0, "Push of other people")
              .form("People", 2, 0.5, 20.0),
          factor("other_force_factor", &Behavior::otherForceFactor, 20.0,
                 "Push away from the robot while scared; never drawn")
              .resolvedTo(&Resolved::otherFactor)
              .form("Robot", 2, 1.0, 25.0)};
}

Fields<PersonExtension> personFields() {
  using Ours = PersonExtension;
  return {
      field("start_time", &Ours::startTime, "Enters the world at this time")
          .in("s")
          .within(base::kNotNegative)
          .resolvedTo(&ResolvedHuman::startTime)
          .form("Comes at", 1, 1.0),
      field("kind", &Ours::kind, "Gives the mass and the figure on the map")
          .words({"adult", "child", "elderly", "wheelchair", "luggage"})
          .resolvedTo(&ResolvedHuman::kind)
          .form("Body"),
      field("mass", &Ours::mass, "Absent: by kind 80, 32, 75, 100, 100")
          .in("kg")
          .within(base::kPositive)
          .orElseBy([](const Ours& of, const DesktopSettings& /*desktop*/) {
            return massOf(of.kind.value_or(PersonKind::Adult));
          })
          .form("Mass", 1, 1.0),
      field("model", &Ours::model, "How the person moves among others; absent: the scenario's")
          .orElseBy([](const Ours& /*of*/, const DesktopSettings& desktop) {
            return desktop.model.value_or(ResolvedHuman().model);
          })
          .form("Model"),
      field("route", &Ours::route, "Ways round walls, or straight on; absent: the scenario's")
          .words(routeWords())
          .orElseBy([](const Ours& /*of*/, const DesktopSettings& desktop) {
            return routeWords()[static_cast<std::size_t>(desktop.route.value_or(Route::Planned))];
          })
          .form("Routes"),
      field("at_end", &Ours::atEnd, "After the last goal of a route that does not repeat")
          .words({"stop", "leave", "restart"})
          .resolvedTo(&ResolvedHuman::atEnd)
          .form("At the end"),
      field("wait", &Ours::wait, "One time for each goal of the route")
          .in("s")
          .within(base::kNotNegative)
          .resolvedTo(&ResolvedHuman::wait)
          .form("Waits"),
      field("tree", &Ours::tree, "Relative to the scenario; may be shared by several people")
          .form("Tree file")};
}

}  // namespace sim2d
