#include <algorithm>
#include <string>

#include <QDirIterator>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Nav2Robots.h"
#include "sim2d/base/Text.h"

/// A parameter file by itself: each contradiction is told, once, where it stands.
class Nav2CheckTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void shippedFile_hasNoErrors_data();
  void shippedFile_hasNoErrors();
  void oneChange_isToldOnceWithItsLine_data();
  void oneChange_isToldOnceWithItsLine();
  void rotation_outsideOfTheGoalsTolerance_isReported();
  void pursuit_otherScalingThanTheLayer_isTold();
  void pursuitBehindAShim_isLookedAt_data();
  void pursuitBehindAShim_isLookedAt();
  void bothCostmaps_areTold();
  void branch_thatIsGiven_isNotGuessed();
  void shippedTrees_haveNoProblems();
  void noFile_isAnError();
  void fieldFile_isTakenAsRos2Takes_data();
  void fieldFile_isTakenAsRos2Takes();
  void wrongValue_isToldAloneAtItsLine_data();
  void wrongValue_isToldAloneAtItsLine();

 private:
  base::Diagnostics checked(const std::string& text, app::Nav2Branch branch = {}) {
    const std::string path = folder_.filePath(QStringLiteral("nav2_params.yaml")).toStdString();
    return base::writeFileAtomically(path, text).empty() ? app::checkNav2Files({path}, branch)
                                                         : base::Diagnostics();
  }

  QTemporaryDir folder_;
};

namespace {

std::string shippedText(const std::string& name) {
  return *base::readTextFile(SOURCE_DIR "/resources/nav2_params/" + name + ".yaml");
}

std::string wordsOf(const base::Diagnostics& problems) {
  std::string words;
  for (const base::Diagnostic& problem : problems) {
    words += problem.severity == base::Severity::Info ? "" : problem.text() + "\n";
  }
  return words;
}

int lineOf(const std::string& text, const std::string& part) {
  return 1 + static_cast<int>(std::count(
                 text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
}

}  // namespace

void Nav2CheckTest::shippedFile_hasNoErrors_data() {
  QTest::addColumn<QString>("name");
  for (const char* const name : {"generic", "turtlebot3", "turtlebot4", "tiago", "nova_carter"}) {
    QTest::newRow(name) << QString::fromLatin1(name);
  }
}

void Nav2CheckTest::shippedFile_hasNoErrors() {
  QFETCH(QString, name);
  const base::Diagnostics found = checked(shippedText(name.toStdString()));
  QVERIFY2(!base::hasErrors(found), wordsOf(found).c_str());
}

void Nav2CheckTest::oneChange_isToldOnceWithItsLine_data() {
  QTest::addColumn<QString>("from");  // in the file like TurtleBot 4's
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("code");
  QTest::addColumn<bool>("isError");
  const auto row = [](const char* name, const char* from, const char* to, const char* code,
                      bool isError) {
    QTest::newRow(name) << QString::fromLatin1(from) << QString::fromLatin1(to)
                        << QString::fromLatin1(code) << isError;
  };
  row("whole number", "temperature: 0.3", "temperature: 1", "nav2.wrong-type", true);
  row("key of nobody", "gamma: 0.015", "gama: 0.015", "nav2.unknown-key", false);
  row("asked too seldom", "controller_frequency: 20.0", "controller_frequency: 10.0",
      "nav2.mppi-period", true);
  row("asked too often", "controller_frequency: 20.0", "controller_frequency: 50.0",
      "nav2.mppi-no-shift", false);
  row("two shapes", "robot_radius: 0.175\n      plugins",
      "robot_radius: 0.175\n      footprint: \"[[0.2, 0.1], [-0.2, 0.1], [0.0, -0.2]]\"\n      "
      "plugins",
      "nav2.two-shapes", false);
  row("edges of a radius", "consider_footprint: false", "consider_footprint: true",
      "nav2.no-footprint", true);
  row("inflation within the body", "inflation_radius: 0.45", "inflation_radius: 0.1",
      "nav2.inflation-cut", false);
  row("faster than the smoother", "vx_max: 0.26", "vx_max: 0.5", "nav2.faster-than", false);
  row("map too small", "width: 3\n      height: 3", "width: 1\n      height: 1",
      "nav2.map-too-small", false);
  row("costmap without updates", "update_frequency: 5.0", "update_frequency: 0.0",
      "nav2.never-updated", false);
  row("misspelt class", "nav2_mppi_controller::MPPIController",
      "nav2_mppi_controller::MPPIControler", "nav2.unknown-plugin", true);
  row("class of another package", "nav2_mppi_controller::MPPIController", "nav2_mppi::Controller",
      "nav2.treated-as", false);
}

void Nav2CheckTest::oneChange_isToldOnceWithItsLine() {
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, code);
  QFETCH(bool, isError);
  std::string text = shippedText("turtlebot4");
  const std::size_t at = text.find(from.toStdString());
  QVERIFY(at != std::string::npos);
  text.replace(at, static_cast<std::size_t>(from.size()), to.toStdString());
  const base::Diagnostics found = checked(text);
  const auto isIt = [&](const base::Diagnostic& each) {
    return each.code == code.toStdString() && each.severity != base::Severity::Info;
  };
  QVERIFY2(std::count_if(found.begin(), found.end(), isIt) == 1, wordsOf(found).c_str());
  const base::Diagnostic& problem = *std::find_if(found.begin(), found.end(), isIt);
  QCOMPARE(problem.severity == base::Severity::Error, isError);
  if (code == QStringLiteral("nav2.wrong-type")) {
    QCOMPARE(problem.line, lineOf(text, "temperature: 1"));
    QCOMPARE(problem.column, 20);
  }
}

/// DWB stops and rotates within its own tolerance.
void Nav2CheckTest::rotation_outsideOfTheGoalsTolerance_isReported() {
  const auto reported = [this](const std::string& checker, const std::string& keys) {
    const base::Diagnostics found = checked(
        "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
        "    goal_checker: {plugin: \"nav2_controller::SimpleGoalChecker\", "
        "xy_goal_tolerance: " +
        checker +
        "}\n    FollowPath: {plugin: \"dwb_core::DWBLocalPlanner\", max_vel_x: 0.3, "
        "max_vel_theta: 1.0, " +
        keys + "}\n");
    return wordsOf(found).find("RotateToGoal only rotates") != std::string::npos;
  };
  QVERIFY(reported("0.1", "critics: [RotateToGoal, GoalDist]"));
  QVERIFY(reported("0.1", "xy_goal_tolerance: 0.15, critics: [RotateToGoal, GoalDist]"));
  QVERIFY(!reported("0.1", "xy_goal_tolerance: 0.05, critics: [RotateToGoal, GoalDist]"));
  QVERIFY(!reported("0.1", "critics: [GoalDist]"));
  QVERIFY(!reported("0.25", "critics: [RotateToGoal, GoalDist]"));
}

/// Pursuit reads distances out of costs: both must agree on how these fall.
void Nav2CheckTest::pursuit_otherScalingThanTheLayer_isTold() {
  const auto text = [](const std::string& scaling) {
    return "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
           "    FollowPath:\n"
           "      plugin: nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\n"
           "      inflation_cost_scaling_factor: " +
           scaling +
           "\nlocal_costmap:\n  local_costmap:\n    ros__parameters:\n      rolling_window: true\n"
           "      plugins: [inflation_layer]\n      inflation_layer:\n"
           "        plugin: nav2_costmap_2d::InflationLayer\n        cost_scaling_factor: 4.0\n";
  };
  const auto isTold = [](const base::Diagnostics& found) {
    return std::any_of(found.begin(), found.end(),
                       [](const auto& each) { return each.code == "nav2.scaling-differs"; });
  };
  QVERIFY(isTold(checked(text("3.0"))));
  QVERIFY(!isTold(checked(text("4.0"))));
}

void Nav2CheckTest::pursuitBehindAShim_isLookedAt_data() {
  QTest::addColumn<QString>("primary");  // keys of the shim
  QTest::newRow("beside") << "primary_controller: "
                             "nav2_regulated_pure_pursuit_controller::"
                             "RegulatedPurePursuitController, desired_linear_vel: 1.5, "
                             "inflation_cost_scaling_factor: 7.0, lookahead_dist: 3.0";
  QTest::newRow("main") << "primary_controller: {plugin: "
                           "nav2_regulated_pure_pursuit_controller::"
                           "RegulatedPurePursuitController, max_linear_vel: 1.5, "
                           "inflation_cost_scaling_factor: 7.0, lookahead_dist: 3.0}";
}

/// Each is wrong in the same way without the shim.
void Nav2CheckTest::pursuitBehindAShim_isLookedAt() {
  QFETCH(QString, primary);
  const std::string sign = QTest::currentDataTag() == std::string("main")
                               ? "    path_handler_plugins: [PathHandler]\n"
                                 "    PathHandler: {plugin: "
                                 "nav2_controller::FeasiblePathHandler}\n"
                               : "";
  const base::Diagnostics found =
      checked("controller_server:\n  ros__parameters:\n" + sign +
              "    FollowPath: {plugin: nav2_rotation_shim_controller::RotationShimController, " +
              primary.toStdString() +
              "}\nlocal_costmap:\n  local_costmap:\n    ros__parameters:\n"
              "      rolling_window: true\n");
  for (const char* code : {"nav2.scaling-differs", "nav2.faster-than", "nav2.map-too-small"}) {
    const auto count = std::count_if(found.begin(), found.end(),
                                     [&](const auto& each) { return each.code == code; });
    QVERIFY2(count == 1, (code + ("\n" + wordsOf(found))).c_str());
  }
}

void Nav2CheckTest::bothCostmaps_areTold() {
  std::string text = shippedText("turtlebot4");
  const std::string from = "inflation_radius: 0.45";
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
    text.replace(at, from.size(), "inflation_radius: 0.05");
  }
  const base::Diagnostics found = checked(text);
  const auto cut = std::count_if(found.begin(), found.end(), [](const auto& each) {
    return each.code == std::string("nav2.inflation-cut");
  });
  QVERIFY2(cut == 2, wordsOf(found).c_str());
}

/// progress_checker_plugins is read since Jazzy, progress_checker_plugin in Humble.
void Nav2CheckTest::branch_thatIsGiven_isNotGuessed() {
  const std::string text = shippedText("generic");
  const auto has = [](const base::Diagnostics& found, const std::string& words) {
    return std::any_of(found.begin(), found.end(), [&](const base::Diagnostic& each) {
      return each.text().find(words) != std::string::npos;
    });
  };
  QVERIFY(has(checked(text), "read as a file of jazzy"));
  const base::Diagnostics found = checked(text, sim2d::nav2::Distro::Humble);
  QVERIFY(!has(found, "read as a file of"));
  QVERIFY(
      has(found, "progress_checker_plugins is a key of Jazzy, Kilted, Lyrical and main: Humble"));
}

void Nav2CheckTest::shippedTrees_haveNoProblems() {
  int count = 0;
  QDirIterator files(QStringLiteral(SOURCE_DIR "/resources/nav2_trees"), {QStringLiteral("*.xml")},
                     QDir::Files, QDirIterator::Subdirectories);
  for (; files.hasNext(); ++count) {
    const std::string path = files.next().toStdString();
    QCOMPARE(wordsOf(app::checkNavigatorTree(path)), std::string());
  }
  QVERIFY(count >= 15);
}

void Nav2CheckTest::noFile_isAnError() {
  QVERIFY(base::hasErrors(app::checkNav2Files({"nowhere/nav2_params.yaml"})));
  QVERIFY(base::hasErrors(app::checkNav2Files({"/dev/zero"})));
}

void Nav2CheckTest::fieldFile_isTakenAsRos2Takes_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("told");  // but for Infos
  QTest::newRow("repeated key") << "nav2_duplicate_key"
                                << ":3:5: warning: key 'controller_frequency' is repeated: the "
                                   "value of line 8 is used, not that of line 3\n";
  QTest::newRow("key of Ackermann alone") << "nav2_min_turning_diffdrive"
                                          << "";
  QTest::newRow("disabled monitor") << "nav2_monitor_disabled"
                                    << "";
  QTest::newRow("cells without a side")
      << "nav2_costmap_resolution_zero"
      << ":9:19: error: local_costmap: resolution: 0 must be from 0.005 to 10\n";
  QTest::newRow("placeholder of a number")
      << "nav2_launch_placeholders"
      << ":9:27: warning: controller_server.controller_frequency: 'FREQUENCY' is a placeholder "
         "that "
         "launch files replace; the default 20.0 is used\n";
  QTest::newRow("placeholder of a tree")
      << "nav2_launch_placeholders"
      << ":5:39: warning: bt_navigator.default_nav_through_poses_bt_xml: 'TO_BE_OVERRIDDEN' is a "
         "placeholder that launch files replace; the default \"\" is used\n";
  QTest::newRow("placeholder of a filter")
      << "nav2_launch_placeholders"
      << ":21:18: warning: keepout_filter is disabled: its 'enabled' is a placeholder that Nav2's "
         "launch files replace\n";
  QTest::newRow("aliases") << "nav2_aliases"
                           << ":16:11: warning: an alias (*name) is replaced by its value; ROS 2's "
                              "own parser rejects aliases, launch tools replace them\n";
  QTest::newRow("namespaces, documents")
      << "nav2_namespaces"
      << ":10:1: warning: a second document (---): its nodes are read after those of the first, as "
         "ROS 2 does\n";
  QTest::newRow("only amcl")
      << "nav2_only_amcl"
      << ":1: warning: this file contains only amcl: it configures no controller "
         "(controller_plugins of controller_server), so it cannot drive a robot by itself\n";
}

void Nav2CheckTest::fieldFile_isTakenAsRos2Takes() {
  QFETCH(QString, name);
  QFETCH(QString, told);
  const std::string path = SOURCE_DIR "/tests/data/nav2/" + name.toStdString() + ".yaml";
  const base::Diagnostics found = app::checkNav2Files({path});
  const std::string words = wordsOf(found);
  QVERIFY2(told.isEmpty() || words.find(path + told.toStdString()) != std::string::npos,
           words.c_str());
  const auto errors = std::count_if(found.begin(), found.end(), [](const auto& each) {
    return each.severity == base::Severity::Error;
  });
  QVERIFY2(errors == (told.contains(QStringLiteral("error")) ? 1 : 0), words.c_str());
  for (const base::Diagnostic& each : found) {  // what is as Nav2 has it is no problem
    QVERIFY2(each.code != "nav2.unknown-key" && each.code != "nav2.wrong-value", words.c_str());
  }
  if (name == QStringLiteral("nav2_only_amcl")) {
    QCOMPARE(words, path + told.toStdString());
  }
}

void Nav2CheckTest::wrongValue_isToldAloneAtItsLine_data() {
  QTest::addColumn<QString>("from");  // in the file like TurtleBot 4's, or its controller's block
  QTest::addColumn<QString>("to");
  QTest::addColumn<QString>("told");
  const auto row = [](const char* from, const char* to, const char* told) {
    QTest::addRow("%s", to) << QString::fromLatin1(from) << QString::fromLatin1(to)
                            << QString::fromLatin1(told);
  };
  row("width: 3\n", "width: 30000\n", "width: 30000 must be from 1 to 1000");
  row("      resolution: 0.05\n", "      resolution: 0.0\n",
      "resolution: 0 must be from 0.005 to 10");
  row("width: 3\n", "width: 500\n", "width: 500 m with cells of 0.06 m (resolution) exceed");
  row("robot_radius: 0.175\n", "robot_radius: -1.0\n", "robot_radius: -1 must be from 0 to 10");
  row("vx_max: 0.26\n", "vx_max: -1.0\n", "vx_max -1 is not greater than 0");
  row("time_steps: 56\n", "time_steps: 100000\n", "time_steps 1e+05 is not 2 to 200");
  row("controller_frequency: 20.0\n", "controller_frequency: 0.0\n",
      "controller_frequency 0 is not above 0");
}

/// No other value is checked against one that is itself wrong.
void Nav2CheckTest::wrongValue_isToldAloneAtItsLine() {
  QFETCH(QString, from);
  QFETCH(QString, to);
  QFETCH(QString, told);
  std::string text = shippedText("turtlebot4");
  const std::size_t at = text.find(from.toStdString());
  QVERIFY(at != std::string::npos);
  text.replace(at, static_cast<std::size_t>(from.size()), to.toStdString());
  base::Diagnostics errors = checked(text);
  errors.erase(std::remove_if(errors.begin(), errors.end(),
                              [](const base::Diagnostic& each) {
                                return each.severity != base::Severity::Error;
                              }),
               errors.end());
  QVERIFY2(errors.size() == 1, wordsOf(errors).c_str());
  QVERIFY2(errors.front().message.find(told.toStdString()) != std::string::npos,
           wordsOf(errors).c_str());
  QCOMPARE(errors.front().line, lineOf(text, to.toStdString()));
}

QTEST_APPLESS_MAIN(Nav2CheckTest)
#include "tst_Nav2Check.moc"
