#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

// Robots, obstacles, doors, areas and docks: the things that have a map of their own in our block.
namespace sim2d {
namespace {

void readPlannerParameters(YamlMap& view, Robot& robot) {
  robot.plannerParameters = readParameters(view, "planner_parameters");
}

void writePlannerParameters(YamlNode& tree, const Robot& robot) {
  writeParameters(tree, "planner_parameters", robot.plannerParameters);
}

/// Values by their names with all maps in them: {FollowPath: {temperature: 0.2}}.
void readNav2Values(YamlMap& view, const std::string& prefix, ParameterTexts& values) {
  for (const YamlNode& item : view.node().items) {
    if (item.isMap()) {
      YamlMap inner = view.map(item.key);
      readNav2Values(inner, prefix + item.key + ".", values);
    } else if (view.find(item.key) != nullptr) {
      YamlNode bare = item;
      bare.key.clear();
      values.emplace_back(prefix + item.key, emitYaml(bare));
    }
  }
}

void readNav2(YamlMap& view, Robot& robot) {
  YamlMap values = view.map("nav2");
  readNav2Values(values, {}, robot.nav2Values);
}

void writeNav2(YamlNode& tree, const Robot& robot) {
  for (const auto& [name, yaml] : robot.nav2Values) {
    YamlNode* at = &tree.child("nav2");
    const std::vector<std::string> words = base::split(name, '.');
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
      at = &at->child(words[i]);
    }
    setUnknown(*at, {{words.back(), yaml}});
  }
}

void readStart(YamlMap& view, Robot& robot) {
  if (view.find("start") == nullptr) {
    view.error("start", "yaml.missing");
    return;
  }
  YamlMap start = view.map("start");
  robot.start.position = readPoint(start);
  robot.start.heading = start.number("h", base::kHeading).value_or(0.0);
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
  robot.footprintY = view.numbers("footprint_y", base::kOnBody);
  if (robot.footprintX.size() != robot.footprintY.size()) {
    view.error("footprint_y", "scenario.footprint-uneven");
  } else if (!robot.footprintX.empty() && robot.footprintX.size() < 3) {
    view.error("footprint_x", "scenario.footprint-too-small");
  }
}

ResolvedRobot typeOf(const Robot& robot) {
  return robotOfType(robot.type.value_or(ResolvedRobot{}.type));
}

/// Limits and body are the type's; those of another type than the usual one are not known here.
FieldOf<Robot> limit(FieldOf<Robot> field, double ResolvedRobot::*resolved) {
  const auto ofItsType = [resolved](const Robot& robot, const DesktopSettings& /*desktop*/) {
    return ParameterValue(typeOf(robot).*resolved);
  };
  return std::move(field).resolvedTo(resolved).with(&Field<Robot>::fallbackOf, ofItsType);
}

FieldOf<Robot> kinematicsField() {
  return field("kinematics", &Robot::kinematics, "How it moves", {"Drive"})
      .words({"differential", "omnidirectional", "ackermann"})
      .resolvedTo(&ResolvedRobot::kinematics)
      .with(&Field<Robot>::fallbackOf, [](const Robot& robot, const DesktopSettings& /*desktop*/) {
        return ParameterValue(std::string(kinematicsName(typeOf(robot).kinematics)));
      });
}

FieldOf<Robot> turningRadiusField() {
  return field("turning_radius", &Robot::turningRadius,
               "Of the narrowest curve of a robot that steers like a car", {"Turning radius"}, "m",
               {base::kSmallestSize, 1000.0})
      .resolvedAt([](auto& of) -> auto& { return of.turningRadius; })
      .with(&Field<Robot>::fallbackOf, [](const Robot& robot, const DesktopSettings& /*desktop*/) {
        const double radius = typeOf(robot).turningRadius;
        return radius > 0.0 ? ParameterValue(radius) : ParameterValue();
      });
}

/// A map in the robot's with a table of its own.
template <class Part>
FieldOf<Robot> sensorField(const std::string& key, Part Robot::*part, std::string help) {
  return FieldOf<Robot>(key, std::move(help))
      .madeBy([key, part](YamlMap& view,
                          Robot& robot) { readThing(view.map(key), robot.*part, fieldTables()); },
              [key, part](YamlNode& tree, const Robot& robot) {
                YamlNode node = fieldTree(robot.*part, fieldTables());
                if (!node.isNull()) {
                  setChild(tree, key, std::move(node));
                }
              },
              part);
}

template <class T>
void readPoints(YamlMap& view, T& to, std::size_t least) {
  const std::vector<double> xs = view.numbers("xs", base::kWithinReach);
  const std::vector<double> ys = view.numbers("ys", base::kWithinReach);
  if (xs.size() != ys.size()) {
    view.error("ys", "scenario.points-uneven");
    return;
  }
  if (xs.size() < least) {
    view.error("xs", "scenario.too-few-points", {least});
  }
  for (std::size_t i = 0; i < xs.size(); ++i) {
    to.points.emplace_back(xs[i], ys[i]);
  }
}

template <class T>
std::function<void(YamlNode&, const T&)> writeAxis(int axis) {
  return [axis](YamlNode& tree, const T& of) {
    std::vector<double> values;
    for (const Vec2& point : of.points) {
      values.push_back(point(axis));
    }
    if (!values.empty()) {
      setChild(tree, axis == 0 ? "xs" : "ys", decimalList(values));
    }
  };
}

/// Corners: the lists `xs` and `ys`, which are read together.
template <class T>
FieldOf<T> xs(std::function<void(YamlMap&, T&)> readBoth) {
  return FieldOf<T>("xs", "Its corners: their x", {"Corners"}, "m", base::kWithinReach)
      .madeBy(std::move(readBoth), writeAxis<T>(0), &T::points)
      .typed(ParameterType::Numbers)
      .required();
}

template <class T>
FieldOf<T> ys() {
  return FieldOf<T>("ys", "Their y, as many", {}, "m", base::kWithinReach)
      .madeBy([](YamlMap&, T&) {}, writeAxis<T>(1), &T::points)
      .typed(ParameterType::Numbers)
      .required();
}

/// A coordinate that must be there, of the point that is a member or that a function gives.
template <class T, class Point>
FieldOf<T> place(std::string key, std::string help, std::string label, Point point, int axis) {
  return FieldOf<T>(std::move(key), std::move(help), {std::move(label)}, "m", base::kWithinReach)
      .keptAt([ point, axis ](auto& of) -> auto& { return std::invoke(point, of)(axis); })
      .required();
}

FieldOf<Obstacle> length(std::string key, double Obstacle::*member, std::string help,
                         std::string label) {
  return field(std::move(key), member, std::move(help), {std::move(label)}, "m", base::kLength)
      .required();
}

std::function<bool(const Obstacle&)> oneOf(std::vector<ObstacleKind> kinds) {
  return [kinds = std::move(kinds)](const Obstacle& obstacle) {
    return std::find(kinds.begin(), kinds.end(), obstacle.kind) != kinds.end();
  };
}

template <class T>
FieldOf<T> thickness(double usual, double step) {
  return field("thickness", &T::thickness, "How thick it is", {"Thickness", 2, step}, "m",
               base::kLength)
      .orElse(usual);
}

constexpr char kBetweenFiles = ';';  // where several stand in one text

std::vector<std::string> nav2ParamsOf(const std::string& text) {
  std::vector<std::string> entries;
  for (const std::string& entry : base::split(text, kBetweenFiles)) {
    if (std::string plain = base::trimmed(entry); !plain.empty()) {
      entries.push_back(std::move(plain));
    }
  }
  return entries;
}

ParameterValue nav2ParamsValue(const std::vector<std::string>& entries) {
  return entries.empty() ? ParameterValue()
                         : base::join(entries, std::string(1, kBetweenFiles) + " ");
}

/// One text, or a list of them.
void readNav2Params(YamlMap& view, Robot& robot) {
  const YamlNode* const value = view.find("nav2_params");
  if (value != nullptr && value->isList()) {
    robot.nav2Params = view.names("nav2_params");
  } else if (value != nullptr) {
    const std::optional<std::string> text = view.text("nav2_params");
    robot.nav2Params = text && !text->empty() ? std::vector{*text} : std::vector<std::string>();
  }
}

void writeNav2Params(YamlNode& tree, const Robot& robot) {
  if (robot.nav2Params.size() == 1) {
    setChild(tree, "nav2_params", stringNode(robot.nav2Params.front()));
  } else if (!robot.nav2Params.empty()) {
    YamlNode list(YamlNode::Kind::List);
    for (const std::string& entry : robot.nav2Params) {
      list.items.push_back(stringNode(entry));
    }
    setChild(tree, "nav2_params", std::move(list));
  }
}

/// In forms all of them are one text, with ';' between.
FieldOf<Robot> nav2ParamsField() {
  return FieldOf<Robot>("nav2_params",
                        "Of planner nav2: the parameter file (`nav2_params.yaml`), or a name of "
                        "those shipped; a list: several files, later values win, and single values "
                        "as ROS 2 takes them (`FollowPath.max_vel_x:=0.3`)",
                        {"Nav2 parameters"})
      .typed(ParameterType::Text)
      .madeBy(readNav2Params, writeNav2Params, &Robot::nav2Params)
      .with(&Field<Robot>::get,
            [](const Robot& robot, const ParameterSpec& /*spec*/) {
              return nav2ParamsValue(robot.nav2Params);
            })
      .with(&Field<Robot>::set,
            [](Robot& robot, const ParameterValue& value, const ParameterSpec& /*spec*/) {
              const auto* const text = std::get_if<std::string>(&value);
              robot.nav2Params = nav2ParamsOf(text != nullptr ? *text : std::string());
            })
      .with(&Field<Robot>::resolved,
            [](const ResolvedRobot& robot, const ParameterSpec& /*spec*/) {
              return nav2ParamsValue(robot.nav2Params);
            })
      .orElse(std::string());
}

Fields<Robot> driverFields() {
  using Resolved = ResolvedRobot;
  return {
      field("type", &Robot::type, "Kind of robot", {"Type"}).resolvedTo(&Resolved::type),
      field("planner", &Robot::planner, "What drives it to its goals", {"Planner"})
          .resolvedTo(&Resolved::planner),
      field("command", &Robot::command,
            "Of planner external: the program that plans, with its arguments, or unix:PATH of a "
            "socket; runs with --allow-code only",
            {"Command"})
          .resolvedTo(&Resolved::command),
      FieldOf<Robot>("planner_parameters", "Of the planner: name and value of each", {"Parameters"})
          .madeBy(readPlannerParameters, writePlannerParameters, &Robot::plannerParameters),
      nav2ParamsField(),
      field("nav2_tree", &Robot::nav2Tree,
            "Of planner nav2: the navigator's behaviour tree, or a name of those shipped",
            {"Nav2 tree"})
          .resolvedTo(&Resolved::nav2Tree),
      field("nav2_distro", &Robot::nav2Distro,
            "Of planner nav2: whose defaults and ways count; absent: as the file tells",
            {"Nav2 branch"})
          .words({"humble", "jazzy", "kilted", "lyrical", "main"})
          .countsAs(&Resolved::nav2Distro),
      field(
          "nav2_topics", &Robot::nav2Topics,
          "Of planner nav2: messages of topics and calls of services, each a time [s], a name and "
          "the message, with `;` between: `12 controller_selector FollowPath2; 20 /pause`",
          {"Nav2 topics"})
          .resolvedTo(&Resolved::nav2Topics),
      FieldOf<Robot>("nav2",
                     "Of planner nav2: values instead of those of its file, by node and name",
                     {"Nav2 values"})
          .madeBy(readNav2, writeNav2, &Robot::nav2Values),
      field(
          "nav2_body", &Robot::nav2Body,
          "Of planner nav2: true: radius or footprint are those of local_costmap in its parameter "
          "files",
          {"Body from Nav2"})
          .orElse(false)};
}

Fields<Robot> wayFields() {
  using Resolved = ResolvedRobot;
  return {
      FieldOf<Robot>("start", "Where it begins: `x`, `y` and heading `h`", {"Position"})
          .required()
          .madeBy(readStart, writeStart, &Robot::start),
      FieldOf<Robot>("goal", "Where it drives to: `x` and `y`", {"Point"})
          .madeBy(readGoal, writeGoal, [](auto& of) { return of.goal.point; }),
      FieldOf<Robot>("goals", "Numbers of global goals in order, instead of `goal`", {"Or route"})
          .keptAt([](auto& of) -> auto& { return of.goal.goals; })
          .with(&Field<Robot>::read, readGoals)
          .with(&Field<Robot>::write, writeGoals),
      field("goal_radius", &Robot::goalRadius,
            "A goal is reached when the robot is this near; with `nav2` its navigator decides",
            {"Arrival radius", 2, 0.05}, "m", base::kLength)
          .resolvedTo(&Resolved::goalRadius),
      field("start_time", &Robot::startTime, "When it sets off", {"Sets off at", 1, 1.0}, "s",
            base::kTime)
          .resolvedTo(&Resolved::startTime)};
}

Fields<Robot> bodyFields() {
  using Resolved = ResolvedRobot;
  return {limit(field("radius", &Robot::radius, "Of the disc that the robot is",
                      {"Radius", 2, 0.01, 1.0}, "m", base::kBodySize),
                &Resolved::radius),
          limit(field("mass", &Robot::mass, "Of the robot", {"Mass", 1, 1.0}, "kg", base::kMass),
                &Resolved::mass),
          limit(field("max_vel", &Robot::maxVel, "Its speed at the most",
                      {"Top speed", 2, 0.05, 2.0}, "m/s", base::kSpeedOfMotion),
                &Resolved::maxVel),
          limit(field("max_acc", &Robot::maxAcc, "How fast its speed changes",
                      {"Acceleration", 2, 0.1, 3.0}, "m/s²", base::kAcceleration),
                &Resolved::maxAcc),
          limit(field("max_omega", &Robot::maxOmega, "Its turn rate at the most", {"Turn speed"},
                      "rad/s", base::kSpeedOfMotion),
                &Resolved::maxOmega),
          limit(field("max_alpha", &Robot::maxAlpha, "How fast its turn rate changes",
                      {"Turn accel."}, "rad/s²", base::kAcceleration),
                &Resolved::maxAlpha),
          field("footprint_x", &Robot::footprintX,
                "Corners in the robot's frame, instead of the disc: their x", {"Footprint"}, "m",
                base::kOnBody),
          field("footprint_y", &Robot::footprintY, "Their y, as many", {}, "m", base::kOnBody)
              .with(&Field<Robot>::read, readFootprint),
          kinematicsField(),
          turningRadiusField(),
          sensorField("lidar", &Robot::lidar, "Its lidar: keys below; absent: the type's"),
          sensorField("detector", &Robot::detector, "How it knows of people and other robots"),
          sensorField("odometry_noise", &Robot::odometryNoise,
                      "Errors of its odometry, which add up; absent: none"),
          sensorField("localization", &Robot::localization,
                      "Errors and corrections of its localiser (AMCL); absent: none"),
          sensorField("battery", &Robot::battery, "Its battery; absent: it never runs low")};
}

}  // namespace

Fields<Robot> robotFields() {
  Fields<Robot> fields = driverFields();
  for (Fields<Robot> more : {wayFields(), bodyFields()}) {
    std::move(more.begin(), more.end(), std::back_inserter(fields));
  }
  return fields;
}

Fields<Obstacle> obstacleFields() {
  const auto only = &Field<Obstacle>::applies;
  const auto centre = [](auto& of) -> auto& {
    return of.pose.position;
  };
  const auto placed = oneOf({ObstacleKind::Box, ObstacleKind::Circle});
  const auto box = oneOf({ObstacleKind::Box});
  const auto corners = oneOf({ObstacleKind::Polygon, ObstacleKind::Wall});
  const auto readCorners = [](YamlMap& view, Obstacle& to) {
    readPoints(view, to, to.kind == ObstacleKind::Wall ? 2 : 3);
  };
  return {field("kind", &Obstacle::kind, "Its shape; the other keys belong to some shapes")
              .words({"box", "circle", "polygon", "wall"})
              .required(),
          place<Obstacle>("x", "Its centre", "X", centre, 0).with(only, placed),
          place<Obstacle>("y", "Its centre", "Y", centre, 1).with(only, placed),
          FieldOf<Obstacle>("h", "Where its length points to", {"Heading"}, "rad", base::kHeading)
              .keptAt([](auto& of) -> auto& { return of.pose.heading; })
              .orElse(0.0)
              .with(only, box),
          length("length", &Obstacle::length, "Along its heading", "Length").with(only, box),
          length("width", &Obstacle::width, "Across its heading", "Width").with(only, box),
          length("radius", &Obstacle::radius, "Of the circle", "Radius")
              .with(only, oneOf({ObstacleKind::Circle})),
          xs<Obstacle>(readCorners).with(only, corners),
          ys<Obstacle>().with(only, corners),
          thickness<Obstacle>(0.1, 0.05).with(only, oneOf({ObstacleKind::Wall}))};
}

Fields<Door> doorFields() {
  return {place<Door>("x1", "One end", "From X", &Door::from, 0),
          place<Door>("y1", "One end", "From Y", &Door::from, 1),
          place<Door>("x2", "The other end", "To X", &Door::to, 0),
          place<Door>("y2", "The other end", "To Y", &Door::to, 1),
          thickness<Door>(0.05, 0.01),
          field("open", &Door::open, "Open at the start", {"At the start"}).orElse(true),
          field("toggles", &Door::toggles, "It opens or closes at each of these times",
                {"Changes at"}, "s", base::kTime)};
}

Fields<Dock> dockFields() {
  const auto centre = [](auto& of) -> auto& {
    return of.pose.position;
  };
  return {field("kind", &Dock::kind, "Whether robots are charged there", {"Kind"})
              .words({"charging", "parking"})
              .required(),
          place<Dock>("x", "Centre of a docked robot", "X", centre, 0),
          place<Dock>("y", "Centre of a docked robot", "Y", centre, 1),
          FieldOf<Dock>("h", "Heading of a robot that docks with its nose first", {"Heading"},
                        "rad", base::kHeading)
              .keptAt([](auto& of) -> auto& { return of.pose.heading; })
              .orElse(0.0)};
}

Fields<Area> areaFields() {
  return {field("kind", &Area::kind, "What it is for", {"Kind"})
              .words({"source", "sink", "wait", "exit"})
              .required(),
          xs<Area>([](YamlMap& view, Area& to) { readPoints(view, to, 3); }),
          ys<Area>(),
          field("like", &Area::like, "Source: the person it copies", {"Like"}),
          field("rate", &Area::rate, "Source: people per second", {"Rate", 3, 0.05}, "1/s",
                {0.0, 1000.0}),
          field("from", &Area::from, "Source: people come from this time on", {"From", 1, 1.0}, "s",
                base::kTime)
              .orElse(0.0),
          field("until", &Area::until, "Source: nobody comes after this time", {"Until", 1, 1.0},
                "s", base::kTime),
          field("count", &Area::count, "Source: at most so many people", {"At most", 0, 1.0}, {},
                {0.0, 1000000.0})};
}

}  // namespace sim2d
