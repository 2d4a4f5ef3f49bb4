#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/FieldBuilder.h"
#include "sim2d/scenario/ScenarioYaml.h"

// Robots, obstacles, doors, areas and docks: objects with a map of their own in the node
// hunavsim_desktop.
namespace sim2d {
namespace {

void readPlannerParameters(YamlMap& view, Robot& robot) {
  robot.plannerParameters = readParameters(view, "planner_parameters");
}

void writePlannerParameters(YamlNode& tree, const Robot& robot) {
  writeParameters(tree, "planner_parameters", robot.plannerParameters);
}

/// Flattens nested maps to dotted names: {FollowPath: {temperature: 0.2}}.
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
  warnUnknownKeys(start);
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
    warnUnknownKeys(point);
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
  robot.footprintY = view.numbers("footprint_y", base::kBodyOffsetRange);
  if (robot.footprintX.size() != robot.footprintY.size()) {
    view.error("footprint_y", "scenario.footprint-uneven");
  } else if (!robot.footprintX.empty() && robot.footprintX.size() < 3) {
    view.error("footprint_x", "scenario.footprint-too-small");
  }
}

ResolvedRobot typeOf(const Robot& robot) {
  return robotOfType(robot.type.value_or(ResolvedRobot{}.type));
}

/// Limits and body default to those of the robot type; spec.fallback is that of the default type.
FieldBuilder<Robot> limit(FieldBuilder<Robot> field, double ResolvedRobot::*resolved) {
  const auto ofItsType = [resolved](const Robot& robot, const DesktopSettings& /*desktop*/) {
    return ParameterValue(typeOf(robot).*resolved);
  };
  return std::move(field).resolvedTo(resolved).with(&Field<Robot>::fallbackOf, ofItsType);
}

FieldBuilder<Robot> kinematicsField() {
  return field("kinematics", &Robot::kinematics, "Kinematics of the drive", {"Drive"})
      .words({"differential", "omnidirectional", "ackermann"})
      .resolvedTo(&ResolvedRobot::kinematics)
      .with(&Field<Robot>::fallbackOf, [](const Robot& robot, const DesktopSettings& /*desktop*/) {
        return ParameterValue(std::string(kinematicsName(typeOf(robot).kinematics)));
      });
}

FieldBuilder<Robot> turningRadiusField() {
  return field("turning_radius", &Robot::turningRadius,
               "Minimum turning radius of a robot with Ackermann steering", {"Turning radius"}, "m",
               {base::kMinSize, 1000.0})
      .resolvedAt([](auto& of) -> auto& { return of.turningRadius; })
      .with(&Field<Robot>::fallbackOf, [](const Robot& robot, const DesktopSettings& /*desktop*/) {
        const double radius = typeOf(robot).turningRadius;
        return radius > 0.0 ? ParameterValue(radius) : ParameterValue();
      });
}

/// A nested map with its own field table.
template <class Part>
FieldBuilder<Robot> sensorField(const std::string& key, Part Robot::*part, std::string help) {
  return FieldBuilder<Robot>(key, std::move(help))
      .withCustomIo(
          [key, part](YamlMap& view, Robot& robot) {
            readObject(view.map(key), robot.*part, fieldTables());
          },
          [key, part](YamlNode& tree, const Robot& robot) {
            YamlNode node = objectTree(robot.*part, fieldTables());
            if (!node.isNull()) {
              setChild(tree, key, std::move(node));
            }
          },
          part);
}

template <class T>
void readPoints(YamlMap& view, T& to, std::size_t least) {
  const std::vector<double> xs = view.numbers("xs", base::kCoordinateRange);
  const std::vector<double> ys = view.numbers("ys", base::kCoordinateRange);
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

/// The corners in the lists `xs` and `ys`, which are read together.
template <class T>
FieldBuilder<T> xs(std::function<void(YamlMap&, T&)> readBoth) {
  return FieldBuilder<T>("xs", "X coordinates of the corners", {"Corners"}, "m",
                         base::kCoordinateRange)
      .withCustomIo(std::move(readBoth), writeAxis<T>(0), &T::points)
      .typed(ParameterType::Numbers)
      .required();
}

template <class T>
FieldBuilder<T> ys() {
  return FieldBuilder<T>("ys", "Y coordinates of the corners, as many as `xs`", {}, "m",
                         base::kCoordinateRange)
      .withCustomIo([](YamlMap&, T&) {}, writeAxis<T>(1), &T::points)
      .typed(ParameterType::Numbers)
      .required();
}

/// A required coordinate of a point, given as a member or an accessor function.
template <class T, class Point>
FieldBuilder<T> place(std::string key, std::string help, std::string label, Point point, int axis) {
  return FieldBuilder<T>(std::move(key), std::move(help), {std::move(label)}, "m",
                         base::kCoordinateRange)
      .storedAt([ point, axis ](auto& of) -> auto& { return std::invoke(point, of)(axis); })
      .required();
}

FieldBuilder<Obstacle> length(std::string key, double Obstacle::*member, std::string help,
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
FieldBuilder<T> thickness(double usual, double step) {
  return field("thickness", &T::thickness, "Thickness", {"Thickness", 2, step}, "m", base::kLength)
      .defaultsTo(usual);
}

constexpr char kBetweenFiles = ';';  // separates several entries in one text

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

/// Reads a text or a list of texts.
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

/// Forms show all entries as one text, separated by ';'.
FieldBuilder<Robot> nav2ParamsField() {
  return FieldBuilder<Robot>(
             "nav2_params",
             "Planner nav2: the parameter file (`nav2_params.yaml`) or the name of a shipped one; "
             "a list: several files, of which later ones override earlier ones, and single values "
             "in ROS 2 syntax (`FollowPath.max_vel_x:=0.3`)",
             {"Nav2 parameters"})
      .typed(ParameterType::Text)
      .withCustomIo(readNav2Params, writeNav2Params, &Robot::nav2Params)
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
      .defaultsTo(std::string());
}

Fields<Robot> driverFields() {
  using Resolved = ResolvedRobot;
  return {
      field("type", &Robot::type, "Robot type", {"Type"}).resolvedTo(&Resolved::type),
      field("planner", &Robot::planner, "Planner that drives the robot to its goals", {"Planner"})
          .resolvedTo(&Resolved::planner),
      field("command", &Robot::command,
            "Planner external: the planner program with its arguments, or unix:PATH of a socket; "
            "runs only with --allow-code",
            {"Command"})
          .resolvedTo(&Resolved::command),
      FieldBuilder<Robot>("planner_parameters", "Parameters of the planner: name and value of each",
                          {"Parameters"})
          .withCustomIo(readPlannerParameters, writePlannerParameters, &Robot::plannerParameters),
      nav2ParamsField(),
      field("nav2_tree", &Robot::nav2Tree,
            "Planner nav2: the navigator's behaviour tree file or the name of a shipped one",
            {"Nav2 tree"})
          .resolvedTo(&Resolved::nav2Tree),
      field("nav2_distro", &Robot::nav2Distro,
            "Planner nav2: Nav2 branch whose defaults and algorithms are used; absent: detected "
            "from the parameter file",
            {"Nav2 branch"})
          .words({"humble", "jazzy", "kilted", "lyrical", "main"})
          .computedTo(&Resolved::nav2Distro),
      field(
          "nav2_topics", &Robot::nav2Topics,
          "Planner nav2: topic messages and service calls, separated by `;`, each with a time [s], "
          "a name and the message: `12 controller_selector FollowPath2; 20 /pause`",
          {"Nav2 topics"})
          .resolvedTo(&Resolved::nav2Topics),
      FieldBuilder<Robot>("nav2",
                          "Planner nav2: values that override those of the parameter file, by node "
                          "and name",
                          {"Nav2 values"})
          .withCustomIo(readNav2, writeNav2, &Robot::nav2Values),
      field("nav2_body", &Robot::nav2Body,
            "Planner nav2: true: radius or footprint are read from local_costmap in the parameter "
            "files",
            {"Body from Nav2"})
          .defaultsTo(false)};
}

Fields<Robot> wayFields() {
  using Resolved = ResolvedRobot;
  return {FieldBuilder<Robot>("start", "Start pose: `x`, `y` and heading `h`", {"Position"})
              .required()
              .withCustomIo(readStart, writeStart, &Robot::start),
          FieldBuilder<Robot>("goal", "Goal position: `x` and `y`", {"Point"})
              .withCustomIo(readGoal, writeGoal, [](auto& of) { return of.goal.point; }),
          FieldBuilder<Robot>("goals", "Numbers of global goals in order, instead of `goal`",
                              {"Or route"})
              .storedAt([](auto& of) -> auto& { return of.goal.goals; })
              .with(&Field<Robot>::read, readGoals)
              .with(&Field<Robot>::write, writeGoals),
          field("goal_radius", &Robot::goalRadius,
                "Distance within which a goal is reached; with `nav2` the navigator decides",
                {"Arrival radius", 2, 0.05}, "m", base::kLength)
              .resolvedTo(&Resolved::goalRadius),
          field("start_time", &Robot::startTime, "Time at which the robot starts",
                {"Starts at", 1, 1.0}, "s", base::kTime)
              .resolvedTo(&Resolved::startTime)};
}

Fields<Robot> bodyFields() {
  using Resolved = ResolvedRobot;
  return {
      limit(field("radius", &Robot::radius, "Radius of the robot's circular body",
                  {"Radius", 2, 0.01, 1.0}, "m", base::kBodySize),
            &Resolved::radius),
      limit(field("mass", &Robot::mass, "Mass of the robot", {"Mass", 1, 1.0}, "kg", base::kMass),
            &Resolved::mass),
      limit(field("max_vel", &Robot::maxVel, "Maximum speed", {"Top speed", 2, 0.05, 2.0}, "m/s",
                  base::kPositiveSpeed),
            &Resolved::maxVel),
      limit(field("max_acc", &Robot::maxAcc, "Maximum acceleration", {"Acceleration", 2, 0.1, 3.0},
                  "m/s²", base::kAcceleration),
            &Resolved::maxAcc),
      limit(field("max_omega", &Robot::maxOmega, "Maximum turn rate", {"Turn rate"}, "rad/s",
                  base::kPositiveSpeed),
            &Resolved::maxOmega),
      limit(field("max_alpha", &Robot::maxAlpha, "Maximum angular acceleration", {"Turn accel."},
                  "rad/s²", base::kAcceleration),
            &Resolved::maxAlpha),
      field("footprint_x", &Robot::footprintX,
            "X coordinates of the footprint's corners in the robot's frame; replaces the circular "
            "body",
            {"Footprint"}, "m", base::kBodyOffsetRange),
      field("footprint_y", &Robot::footprintY,
            "Y coordinates of these corners, as many as `footprint_x`", {}, "m",
            base::kBodyOffsetRange)
          .with(&Field<Robot>::read, readFootprint),
      kinematicsField(),
      turningRadiusField(),
      sensorField("lidar", &Robot::lidar,
                  "Lidar of the robot, keys below; absent: that of the robot type"),
      sensorField("detector", &Robot::detector, "Detection of people and other robots, keys below"),
      sensorField("odometry_noise", &Robot::odometryNoise,
                  "Odometry errors, which accumulate; absent: none"),
      sensorField("localization", &Robot::localization,
                  "Errors and corrections of the localization (AMCL); absent: none"),
      sensorField("battery", &Robot::battery, "Battery of the robot; absent: it never runs low")};
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
  return {field("kind", &Obstacle::kind, "Shape; each shape uses some of the other keys")
              .words({"box", "circle", "polygon", "wall"})
              .required(),
          place<Obstacle>("x", "Centre", "X", centre, 0).with(only, placed),
          place<Obstacle>("y", "Centre", "Y", centre, 1).with(only, placed),
          FieldBuilder<Obstacle>("h", "Direction of `length`", {"Heading"}, "rad", base::kHeading)
              .storedAt([](auto& of) -> auto& { return of.pose.heading; })
              .defaultsTo(0.0)
              .with(only, box),
          length("length", &Obstacle::length, "Size along the heading", "Length").with(only, box),
          length("width", &Obstacle::width, "Size across the heading", "Width").with(only, box),
          length("radius", &Obstacle::radius, "Radius of the circle", "Radius")
              .with(only, oneOf({ObstacleKind::Circle})),
          xs<Obstacle>(readCorners).with(only, corners),
          ys<Obstacle>().with(only, corners),
          thickness<Obstacle>(0.1, 0.05).with(only, oneOf({ObstacleKind::Wall}))};
}

Fields<Door> doorFields() {
  return {place<Door>("x1", "First end", "From X", &Door::from, 0),
          place<Door>("y1", "First end", "From Y", &Door::from, 1),
          place<Door>("x2", "Second end", "To X", &Door::to, 0),
          place<Door>("y2", "Second end", "To Y", &Door::to, 1),
          thickness<Door>(0.05, 0.01),
          field("open", &Door::open, "Whether the door is open at the start", {"Open at start"})
              .defaultsTo(true),
          field("toggles", &Door::toggles, "Times at which the door opens or closes",
                {"Toggles at"}, "s", base::kTime)};
}

Fields<Dock> dockFields() {
  const auto centre = [](auto& of) -> auto& {
    return of.pose.position;
  };
  return {field("kind", &Dock::kind, "Whether the dock charges robots", {"Kind"})
              .words({"charging", "parking"})
              .required(),
          place<Dock>("x", "Centre of a docked robot", "X", centre, 0),
          place<Dock>("y", "Centre of a docked robot", "Y", centre, 1),
          FieldBuilder<Dock>("h", "Heading of a robot that docks forward", {"Heading"}, "rad",
                             base::kHeading)
              .storedAt([](auto& of) -> auto& { return of.pose.heading; })
              .defaultsTo(0.0)};
}

Fields<Area> areaFields() {
  return {
      field("kind", &Area::kind, "Purpose of the area", {"Kind"})
          .words({"source", "sink", "wait", "exit", "speed"})
          .required(),
      xs<Area>([](YamlMap& view, Area& to) { readPoints(view, to, 3); }),
      ys<Area>(),
      field("like", &Area::like, "Source: the person that is copied", {"Copies"}),
      field("rate", &Area::rate, "Source: people per second", {"Rate", 3, 0.05}, "1/s",
            {0.0, 1000.0}),
      field("from", &Area::from, "Source: people are spawned from this time on", {"From", 1, 1.0},
            "s", base::kTime)
          .defaultsTo(0.0),
      field("until", &Area::until,
            "Source: no people are spawned after this time; absent: never ends", {"Until", 1, 1.0},
            "s", base::kTime),
      field("count", &Area::count, "Source: maximum number of people; absent: no limit",
            {"Max. people", 0, 1.0}, {}, {0.0, 1000000.0}),
      field("factor", &Area::factor, "Speed: factor of the walking speed of people inside",
            {"Speed factor", 2, 0.1}, {}, {0.01, 10.0})
          .defaultsTo(1.0),
      field("carry_speed", &Area::carrySpeed,
            "Speed: speed with which people inside are carried, as by a travelator",
            {"Carrying speed", 2, 0.1}, "m/s", {0.0, 10.0})
          .defaultsTo(0.0),
      field("carry_h", &Area::carryHeading, "Speed: direction in which people inside are carried",
            {"Carrying direction", 2, 0.1}, "rad", {-10.0, 10.0})
          .defaultsTo(0.0)};
}

}  // namespace sim2d
