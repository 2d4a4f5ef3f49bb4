#include <algorithm>
#include <cmath>
#include <map>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Export.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioFile.h"

using base::Vec2;
using sim2d::Human;
using sim2d::Scenario;

namespace {

/// What no other fixture has: gaps in numbers, names with blanks, a goal of nobody's route, one
/// without goals, a number as behaviour that is none, skins and factors out of range, drawn
/// numbers.
const char kOdd[] = R"(hunav_loader:
  ros__parameters:
    map: yard
    global_goals:
      2: {x: 1.0, y: 2.0, h: 0.75}
      5: {x: 3.125, y: 4.0}
      9: {x: -7.5, y: 0.0}
    agents: [Ana Maria, 2nd, Cleo, Dan]
    Ana Maria:
      id: 7
      skin: 14
      group_id: 3
      init_pose: {x: 0.5, y: 0.5, h: 0.3}
      behavior: {type: Scared, configuration: 1, dist: 3.0, safe_distance: 4.25, duration: 7.5}
      goals: [5, 2, 5]
    2nd:
      id: 9
      group_id: 3
      init_pose: {x: 2.5, y: 0.5, h: 0.0}
      behavior: {type: Curious, dist: 6.5, stop_dist: 1.25, once: true}
    Cleo:
      id: 11
      init_pose: {x: 4.5, y: 0.5, h: -1.5}
      behavior: {type: Threatening, dist: 2.5, front_dist: 0.75, configuration: 2}
      cyclic_goals: false
      max_vel: 1.75
      goals: [2]
    Dan:
      id: 12
      init_pose: {x: 6.5, y: 0.5, h: 3.0}
      behavior: {type: Impassive, configuration: 1, goal_force_factor: 1.5}
      goals: [2, 5]
hunavsim_desktop:
  ros__parameters:
    format: 1
    map_file: none
    seed: 12
    robots: [robot1, robot2, robot3, robot4]
    robot1: {start: {x: 1.5, y: -1.25, h: 0.5}, goals: [5, 2]}
    robot2: {start: {x: 4.0, y: -3.0, h: 0.0}, goals: [9]}
    robot3: {start: {x: 7.0, y: -3.0, h: 0.0}, goals: [9, 9]}
    robot4: {start: {x: 10.0, y: -3.0, h: 0.0}, goals: [2, 9, 5]}
    doors: [gate]
    gate: {x1: 8.0, y1: 0.0, x2: 9.0, y2: 0.0, toggles: [3.0]}
    Dan: {start_time: 3.0, at_end: leave}
)";

std::string textOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += problem.text() + "\n";
  }
  return text;
}

/// One export, and what a reader of the target finds: nothing of our own block.
struct RoundTrip {
  const sim2d::TargetInfo* target = nullptr;
  Scenario before, whole, there;
  sim2d::Dialect dialect = sim2d::Dialect::C;
  base::Diagnostics report;
  std::string command;

  bool isNative() const { return target->target == sim2d::ExportTarget::Native; }
  /// A line of the report has all of these words.
  bool tells(const std::vector<std::string>& words) const {
    return std::any_of(report.begin(), report.end(), [&](const base::Diagnostic& said) {
      return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return said.message.find(word) != std::string::npos;
      });
    });
  }
};

/// Positions of the goals of a person, in order.
std::vector<Vec2> routeOf(const Scenario& scenario, const std::vector<int>& goals) {
  std::vector<Vec2> route;
  for (const int goal : goals) {
    const sim2d::GlobalGoal* found = scenario.goal(goal);
    route.push_back(found != nullptr ? found->position : Vec2(1e9, 1e9));
  }
  return route;
}

/// Numbers of the goals that the target does not read, as the report lists them.
std::vector<std::string> goalsApart(const RoundTrip& trip) {
  std::vector<std::string> numbers;
  for (const base::Diagnostic& said : trip.report) {
    if (said.code == "export.goals-apart") {
      for (const std::string& number : base::split(said.value("goals"), ',')) {
        numbers.push_back(base::trimmed(number));
      }
    }
  }
  return numbers;
}

std::vector<Vec2> wayOf(const Scenario& scenario, const sim2d::Robot& robot) {
  const std::vector<Vec2> goals = routeOf(scenario, robot.goal.goals);
  return robot.goal.point ? std::vector<Vec2>{*robot.goal.point} : goals;
}

/// What counts for a person and can be said to any wrapper, by the keys of the file.
std::vector<std::pair<std::string, double>> numbersOf(const Scenario& scenario, const Human& human,
                                                      bool isDrawn) {
  const sim2d::ResolvedHuman counts = sim2d::resolveHuman(scenario, human, 1);
  std::vector<std::pair<std::string, double>> numbers = {
      {"skin", human.skin.value_or(0)},   {"group_id", counts.groupId},
      {"max_vel", counts.desiredSpeed},   {"radius", counts.radius},
      {"goal_radius", counts.goalRadius}, {"cyclic_goals", counts.cyclicGoals ? 1.0 : 0.0},
      {"x", human.initPose.position.x()}, {"y", human.initPose.position.y()},
      {"h", human.initPose.heading},      {"type", static_cast<double>(counts.behavior)}};
  const auto add = [&](bool applies, const char* key, double value) {
    if (applies && !isDrawn) {
      numbers.emplace_back(key, value);
    }
  };
  using Type = sim2d::BehaviorType;
  const bool reacts = sim2d::reactsToRobot(counts.behavior);
  add(reacts, "dist", counts.noticeDistance);
  add(reacts && counts.behavior != Type::Curious, "duration", counts.reactionDuration);
  add(reacts, "once", counts.reactionOnce ? 1.0 : 0.0);
  add(counts.behavior == Type::Scared, "safe_distance", counts.safeDistance);
  add(counts.behavior == Type::Curious, "stop_dist", counts.stopDistance);
  add(counts.behavior == Type::Threatening, "front_dist", counts.frontDistance);
  add(true, "goal_force_factor", counts.goalFactor);
  add(true, "obstacle_force_factor", counts.obstacleFactor);
  add(true, "social_force_factor", counts.socialFactor);
  add(true, "other_force_factor", counts.otherFactor);
  return numbers;
}

/// What differs and is not told.
std::string silentLoss(const RoundTrip& trip, const Human& before, const Human& after) {
  const bool isDrawn =
      sim2d::isDrawn(before.behavior.configuration.value_or(sim2d::Configuration::Default));
  const auto was = numbersOf(trip.before, before, isDrawn);
  const auto is = numbersOf(trip.there, after, isDrawn);
  for (std::size_t k = 0; k < was.size(); ++k) {
    const bool isSame = std::fabs(was[k].second - is[k].second) < 1e-9;
    if (was[k].first != is[k].first || (!isSame && !trip.tells({after.name, was[k].first}) &&
                                        !trip.tells({before.name, was[k].first}))) {
      return was[k].first + " " + base::formatDouble(was[k].second) + " is " +
             base::formatDouble(is[k].second);
    }
  }
  if (before.name != after.name && !trip.tells({before.name, after.name})) {
    return "name";
  }
  const bool isRoute = routeOf(trip.before, before.goals) == routeOf(trip.there, after.goals) ||
                       (before.goals.empty() && trip.tells({after.name, "has no goal"}));
  if (!isRoute) {
    return "goals";
  }
  for (const auto& [key, isThere] : {std::pair("start_time", before.ours.startTime.has_value()),
                                     std::pair("kind", before.ours.kind.has_value()),
                                     std::pair("mass", before.ours.mass.has_value()),
                                     std::pair("model", before.ours.model.has_value()),
                                     std::pair("at_end", before.ours.atEnd.has_value()),
                                     std::pair("wait", !before.ours.wait.empty())}) {
    if (isThere && !trip.isNative() && !trip.tells({after.name, key})) {
      return key;
    }
  }
  return {};
}

}  // namespace

/// Each export read again by our own reader: what the target has no place for is in the report.
class ExportRoundTripTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  RoundTrip exported(const QString& scenario, const std::string& target) {
    app::RunSpec options;
    options.scenario = scenario.toStdString();
    const base::Result<app::Bundle> source = app::readExportSource(options, {});
    if (!source) {
      qFatal("%s", textOf(source.diagnostics()).c_str());
    }
    app::ExportRequest request;
    request.target = target;
    request.folder = folder_.filePath(QString::fromStdString(target)).toStdString();
    const app::ExportPlan plan = app::planExport(*source, request);
    RoundTrip trip;
    trip.target = sim2d::exportTarget(target);
    trip.before = *source->scenario;
    trip.report = plan.report;
    trip.command = plan.startCommand;
    const std::string text = plan.files.at(0).content.content;
    const sim2d::ScenarioReading whole = sim2d::readScenarioText(text, "whole.yaml");
    const sim2d::ScenarioReading there =
        sim2d::readScenarioText(text.substr(0, text.find("\nhunavsim_desktop:")), "there.yaml");
    if (base::hasErrors(plan.report) || !whole.ok() || !there.ok()) {
      qFatal("%s", (textOf(plan.report) + textOf(whole.diagnostics)).c_str());
    }
    trip.whole = whole.scenario;
    trip.there = there.scenario;
    trip.dialect = there.dialect;
    return trip;
  }

 private Q_SLOTS:
  void export_readAgain_losesNothingInSilence_data() {
    QTest::addColumn<QString>("scenario");
    QTest::addColumn<QString>("target");
    const QString odd = folder_.filePath(QStringLiteral("odd.yaml"));
    QVERIFY(base::writeFileAtomically(odd.toStdString(), kOdd).empty());
    const std::pair<const char*, QString> files[] = {
        {"odd", odd},
        {"café", QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml")},
        {"workers", QStringLiteral(SOURCE_DIR "/maps/two_workers/two_workers_agents.yaml")},
        {"of 2024", QStringLiteral(TEST_DATA_DIR "/scenario/dialect_b.yaml")},
        {"of 2022", QStringLiteral(TEST_DATA_DIR "/scenario/dialect_a.yaml")}};
    for (const auto& [name, file] : files) {
      for (const sim2d::TargetInfo& target : sim2d::exportTargets()) {
        QTest::addRow("%s to %s", name, target.name.c_str())
            << file << QString::fromStdString(target.name);
      }
    }
  }
  void export_readAgain_losesNothingInSilence() {
    QFETCH(QString, scenario);
    QFETCH(QString, target);
    const RoundTrip trip = exported(scenario, target.toStdString());
    QCOMPARE(trip.dialect, trip.target->dialect);
    QCOMPARE(trip.there.humans.size(), trip.before.humans.size());
    for (std::size_t k = 0; k < trip.there.humans.size(); ++k) {
      const std::string lost = silentLoss(trip, trip.before.humans[k], trip.there.humans[k]);
      QVERIFY2(lost.empty(), (trip.before.humans[k].name + ": " + lost).c_str());
    }
    checkGoals(trip);
    checkOurs(trip);
  }

  void export_native_copiesFilesOfPlanners() {
    std::string text = kOdd;
    const auto addKey = [&text](const std::string& robot, const std::string& keys) {
      const std::size_t end = text.find('}', text.find(robot + ": {start"));
      text.insert(text.find('\n', end) - 1, ", " + keys);
    };
    addKey("robot1", "planner: replay, planner_parameters: {file: recorded/drive.csv}");
    addKey("robot2", "planner: nav2, nav2_params: own.yaml");
    addKey("robot3", "planner: replay, planner_parameters: {file: ../outside.csv}");
    addKey("robot4", "planner: replay, planner_parameters: {file: /tmp/absolute.csv}");
    QTemporaryDir source;
    const std::string folder = source.path().toStdString();
    QVERIFY(QDir(source.path()).mkpath(QStringLiteral("recorded")));
    QVERIFY(base::writeFileAtomically(folder + "/files.yaml", text).empty());
    QVERIFY(base::writeFileAtomically(folder + "/recorded/drive.csv", "time,linear\n").empty());
    QVERIFY(
        base::writeFileAtomically(folder + "/own.yaml", "/**: {ros__parameters: {}}\n").empty());
    app::RunSpec options;
    options.scenario = folder + "/files.yaml";
    const base::Result<app::Bundle> bundle = app::readExportSource(options, {});
    QVERIFY2(bundle, textOf(bundle.diagnostics()).c_str());
    for (const char* const target : {"native", "isaac"}) {
      app::ExportRequest request;
      request.target = target;
      request.folder = folder_.filePath(QStringLiteral("copied")).toStdString();
      const app::ExportPlan plan = app::planExport(*bundle, request);
      std::map<std::string, std::string> copied;
      for (const app::ExportPlan::File& file : plan.files) {
        copied[file.name] = file.content.content;
      }
      const bool isNative = request.target == "native";
      QCOMPARE(copied.count("scenarios/recorded/drive.csv"), std::size_t{isNative ? 1U : 0U});
      QCOMPARE(copied.count("scenarios/own.yaml"), std::size_t{isNative ? 1U : 0U});
      if (isNative) {
        QCOMPARE(copied["scenarios/recorded/drive.csv"], std::string("time,linear\n"));
      }
      std::string reported;
      for (const base::Diagnostic& problem : plan.report) {
        if (std::string_view(problem.code) == "export.file-not-copied") {
          reported += problem.value("robot") + " " + problem.value("file") + ";";
        }
      }
      QCOMPARE(reported, std::string(isNative ? "robot3 ../outside.csv;" : ""));
    }
  }

  void export_startCommand_isOfTheRobotAndTheWorlds() {
    const QString odd = folder_.filePath(QStringLiteral("odd.yaml"));
    const std::string gazebo = exported(odd, "gazebo-classic").command;
    QVERIFY2(gazebo.find("gzpose_x:=1.500 gzpose_y:=-1.250 gzpose_Y:=0.500") != std::string::npos,
             gazebo.c_str());
    const std::string isaac = exported(odd, "isaac").command;  // has no world of this name
    QVERIFY2(isaac.find("--world empty_world") != std::string::npos, isaac.c_str());
  }

 private:
  static std::optional<double> headingOf(const sim2d::GlobalGoal& goal) {
    for (const base::UnknownKey& key : goal.unknown) {
      if (key.key == "h") {
        return base::parseDouble(base::trimmed(key.yaml));
      }
    }
    return std::nullopt;
  }

  static void checkGoals(const RoundTrip& trip) {
    for (const sim2d::GlobalGoal& goal : trip.before.goals) {
      const bool isThere = std::any_of(
          trip.there.goals.begin(), trip.there.goals.end(), [&](const sim2d::GlobalGoal& each) {
            return each.position == goal.position && headingOf(each) == headingOf(goal);
          });
      QVERIFY2(isThere, std::to_string(goal.id).c_str());
    }
    std::vector<std::string> apart;  // the format before the last one has goals of people alone
    for (const sim2d::GlobalGoal& goal : trip.before.goals) {
      const bool isWalkedTo = std::any_of(
          trip.before.humans.begin(), trip.before.humans.end(), [&goal](const Human& human) {
            return std::count(human.goals.begin(), human.goals.end(), goal.id) > 0;
          });
      if (trip.dialect == sim2d::Dialect::B && !isWalkedTo) {
        apart.push_back(std::to_string(goal.id));
      }
    }
    QCOMPARE(goalsApart(trip), apart);
  }

  /// Our block comes back whole, and what it alone has is named.
  static void checkOurs(const RoundTrip& trip) {
    const auto check = [&trip](const auto& was, const auto& is) {
      QCOMPARE(is.size(), was.size());
      for (std::size_t k = 0; k < was.size(); ++k) {
        QCOMPARE(is[k].name, was[k].name);
        QVERIFY2(trip.isNative() || k > 3 || trip.tells({was[k].name, "hunavsim_desktop"}),
                 was[k].name.c_str());
      }
    };
    check(trip.before.robots, trip.whole.robots);
    check(trip.before.obstacles, trip.whole.obstacles);
    check(trip.before.doors, trip.whole.doors);
    check(trip.before.areas, trip.whole.areas);
    QVERIFY(trip.before.obstacles == trip.whole.obstacles);
    QVERIFY(trip.before.doors == trip.whole.doors);
    for (std::size_t k = 0; k < trip.before.robots.size(); ++k) {
      const sim2d::Robot& was = trip.before.robots[k];
      const sim2d::Robot& is = trip.whole.robots[k];
      QVERIFY(is.start.position == was.start.position);
      QVERIFY(wayOf(trip.whole, is) == wayOf(trip.before, was));
    }
    QCOMPARE(trip.whole.desktop.seed, trip.before.desktop.seed);
    QCOMPARE(trip.whole.desktop.duration, trip.before.desktop.duration);
    QCOMPARE(trip.whole.desktop.groups, trip.before.desktop.groups);
  }
};

QTEST_APPLESS_MAIN(ExportRoundTripTest)
#include "tst_ExportRoundTrip.moc"
