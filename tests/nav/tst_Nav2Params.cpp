#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/RosValue.h"
#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

/// Reading of nav2_params.yaml: as ROS 2 and Nav2 read it, every key told apart.
class Nav2ParamsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rosType_text_decides_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("type");
    const std::vector<std::pair<const char*, const char*>> rows = {{"1", "integer"},
                                                                   {"-3", "integer"},
                                                                   {"1.0", "double"},
                                                                   {"1e3", "double"},
                                                                   {".5", "double"},
                                                                   {".inf", "double"},
                                                                   {"true", "bool"},
                                                                   {"Off", "bool"},
                                                                   {"y", "bool"},
                                                                   {"\"1\"", "string"},
                                                                   {"'true'", "string"},
                                                                   {"abc", "string"},
                                                                   {"[1, 2]", "integer_array"},
                                                                   {"[1.0, 2.0]", "double_array"},
                                                                   {"[1, 2.0]", "mixed_array"},
                                                                   {"[a, b]", "string_array"},
                                                                   {"[]", "empty_array"}};
    for (const auto& [yaml, type] : rows) {
      QTest::newRow(yaml) << QString::fromUtf8(yaml) << QString::fromUtf8(type);
    }
  }

  void rosType_text_decides() {
    QFETCH(QString, yaml);
    QFETCH(QString, type);
    base::Diagnostics problems;
    const base::YamlNode value = base::parseYaml(yaml.toStdString(), {}, problems);
    QCOMPARE(rosTypeName(value), type.toStdString());
  }

  void parse_namespacesAndNesting_areNodes() {
    const ParameterFile file = parsed(R"(/robot1/planner_server:
  ros__parameters: {a: 1}
ns:
  controller_server:
    ros__parameters: {b: 2}
local_costmap:
  local_costmap:
    ros__parameters: {c: 3}
robot2:
  global_costmap:
    global_costmap:
      ros__parameters: {d: 4}
)");
    QCOMPARE(file.nodes().size(), std::size_t{4});
    QCOMPARE(file.nodes()[0].node, std::string("planner_server"));
    QCOMPARE(file.nodes()[0].nameSpace, std::string("/robot1"));
    QCOMPARE(file.nodes()[1].nameSpace, std::string("ns"));
    QCOMPARE(file.nodes()[2].node, std::string("local_costmap"));
    QCOMPARE(file.nodes()[2].nameSpace, std::string());
    QCOMPARE(file.nodes()[3].nameSpace, std::string("robot2"));
    QCOMPARE(valueOf(file.parametersOf("global_costmap"), "d"), std::string("4"));
  }

  void parse_forAllNodes_comesFirst() {
    const ParameterFile file = parsed(R"(planner_server:
  ros__parameters: {a: 1}
/**:
  ros__parameters: {a: 2, b: 3}
)");
    QCOMPARE(valueOf(file.parametersOf("planner_server"), "a"), std::string("1"));
    QCOMPARE(valueOf(file.parametersOf("planner_server"), "b"), std::string("3"));
    QCOMPARE(valueOf(file.parametersOf("bt_navigator"), "a"), std::string("2"));
  }

  void parse_ownNamespace_winsOverOthers() {
    const ParameterFile file = parsed(R"(robot1:
  planner_server:
    ros__parameters: {a: 1}
robot2:
  planner_server:
    ros__parameters: {a: 2, b: 3}
)");
    QCOMPARE(valueOf(file.parametersOf("planner_server", "robot2"), "a"), std::string("2"));
    QCOMPARE(valueOf(file.parametersOf("planner_server", "robot1"), "b"), std::string("-"));
    QCOMPARE(valueOf(file.parametersOf("planner_server"), "a"), std::string("1"));
  }

  void read_otherNamespace_isNoted_data() {
    QTest::addColumn<QString>("robot");
    QTest::addColumn<QString>("noted");  // namespace; empty: none
    QTest::newRow("the first") << ""
                               << "two";
    QTest::newRow("its own") << "two"
                             << "one";
  }

  /// One of two namespaces counts; no key of the other is lost.
  void read_otherNamespace_isNoted() {
    QFETCH(QString, robot);
    QFETCH(QString, noted);
    const std::string node =
        ":\n  velocity_smoother:\n    ros__parameters: {smoothing_frequency: 10.0}\n";
    const Nav2ReadResult reading = readNav2Parameters(parsed("one" + node + "two" + node),
                                                      {Distro::Jazzy, robot.toStdString()});
    int count = 0;
    for (const KeyUsage& key : reading.parameters.notes.keys) {
      count += key.path.find('/') != std::string::npos ? 1 : 0;
    }
    QCOMPARE(count, 1);
    const KeyUsage* const other =
        noteOf(reading, noted.toStdString() + "/velocity_smoother.smoothing_frequency");
    QVERIFY(other != nullptr);
    QVERIFY(other->use == KeyUse::Ignored);
    QVERIFY(noteOf(reading, "velocity_smoother.smoothing_frequency")->use == KeyUse::Used);
  }

  void parse_dottedAndNestedNames_areOne() {
    const ParameterFile file = parsed(R"(controller_server:
  ros__parameters:
    FollowPath.a: 1
    FollowPath:
      a: 2
      Inner: {b: 3}
)");
    const NodeParameters node = file.parametersOf("controller_server");
    QCOMPARE(valueOf(node, "FollowPath.a"), std::string("2"));
    QCOMPARE(valueOf(node, "FollowPath.Inner.b"), std::string("3"));
  }

  /// As rcl_yaml_param_parser does; `a.b` and `a: {b}` are the same parameter.
  void parse_repeatedKey_lastCountsWithAWarning() {
    const auto file = ParameterFile::parse(R"(controller_server:
  ros__parameters:
    a: 1
    b: 2
    a: 3
    c.d: 4
    c: {d: 5}
)",
                                           "p.yaml");
    QVERIFY(file);
    const NodeParameters node = file->parametersOf("controller_server");
    QCOMPARE(valueOf(node, "a"), std::string("3"));
    QCOMPARE(valueOf(node, "c.d"), std::string("5"));
    QCOMPARE(
        texts(file.diagnostics()),
        std::string("p.yaml:3:5: warning: key 'a' is repeated: the value of line 5 is used, not "
                    "that of line 3\np.yaml:6:5: warning: key 'c.d' is repeated: the value of "
                    "line 7 is used, not that of line 6\n"));
  }

  void parse_repeatedBlocks_areMerged() {
    const auto file = ParameterFile::parse(R"(controller_server:
  ros__parameters:
    A: {a: 1, b: 2}
controller_server:
  ros__parameters:
    A: {b: 3}
    c: 4
)",
                                           "p.yaml");
    QVERIFY(file);
    const NodeParameters node = file->parametersOf("controller_server");
    QCOMPARE(valueOf(node, "A.a"), std::string("1"));
    QCOMPARE(valueOf(node, "A.b"), std::string("3"));
    QCOMPARE(valueOf(node, "c"), std::string("4"));
    const base::Diagnostic* const block = problemOf(file.diagnostics(), "yaml.block-repeated");
    QVERIFY(block != nullptr && block->line == 4);
    const base::Diagnostic* const key = problemOf(file.diagnostics(), "yaml.key-repeated");
    QVERIFY(key != nullptr && key->line == 3);
  }

  void parse_noParameters_isAnError() {
    const auto file = ParameterFile::parse("some_node: {a: 1}\n", "p.yaml");
    QVERIFY(!file);
    QVERIFY(problemOf(file.diagnostics(), "nav2.no-parameters"));
    QVERIFY(problemOf(file.diagnostics(), "nav2.outside-node"));
  }

  void read_integerForADouble_isAnErrorAtItsPlace() {
    const Nav2ReadResult reading = readOf(kPursuit + "      lookahead_dist: 1\n");
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.wrong-type");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->line, 5);
    QCOMPARE(problem->column, 23);
    QVERIFY(problem->message.find("double") != std::string::npos &&
            problem->message.find("integer") != std::string::npos);
  }

  void read_everyProblem_isToldAtOnce() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(      lookahead_dist: true
velocity_smoother:
  ros__parameters:
    max_velocity: [0.5, 0.0]
    scale_velocities: 1
local_costmap:
  local_costmap:
    ros__parameters:
      width: 3.0
      plugins: ["inflation_layer"]
      inflation_layer:
        plugin: "nav2_costmap_2d::InflationLaier"
)");
    QVERIFY(!reading.ok());
    std::vector<int> lines;
    for (const base::Diagnostic& problem : reading.problems) {
      if (problem.severity == base::Severity::Error) {
        lines.push_back(problem.line);
      }
    }
    QCOMPARE(lines, (std::vector<int>{5, 8, 9, 13, 16}));
  }

  void read_absentKey_takesTheCodesDefault() {
    const Nav2ReadResult reading = readOf(kPursuit);
    // Of Nav2's code, not of its examples: 5 x 5 m at 0.1 m, 0.1 m, 10.0.
    QCOMPARE(reading.parameters.localCostmap.parameters.resolution, 0.1);
    QCOMPARE(reading.parameters.localCostmap.parameters.robotRadius, 0.1);
    QCOMPARE(reading.parameters.localCostmap.plugins.size(), std::size_t{3});
    const auto& layer =
        std::get<InflationLayerParameters>(reading.parameters.localCostmap.plugins[2].parameters);
    QCOMPARE(layer.costScalingFactor, 10.0);
    QCOMPARE(layer.inflationRadius, 0.55);
    QCOMPARE(xyGoalTolerance(reading.parameters), 0.25);
    const auto& defaults = reading.parameters.notes.defaults;
    QVERIFY(std::any_of(defaults.begin(), defaults.end(), [](const DefaultedKey& each) {
      return each.path == "local_costmap.resolution" && each.value == "0.1";
    }));
  }

  void read_unknownKey_tellsTheNearest() {
    const Nav2ReadResult reading = readOf(kPursuit + "      lookahaed_dist: 0.6\n");
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unknown-key");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->severity, base::Severity::Warning);
    QCOMPARE(problem->line, 5);
    QVERIFY(problem->message.find("Nav2 Jazzy does not read it") != std::string::npos);
    QVERIFY(problem->message.find("FollowPath.lookahead_dist") != std::string::npos);
    QCOMPARE(noteOf(reading, "controller_server.FollowPath.lookahaed_dist")->use, KeyUse::Unknown);
  }

  void read_otherNodes_areIdleOrUnknown() {
    const Nav2ReadResult reading = readOf(R"(amcl:
  ros__parameters: {alpha1: 0.2}
planer_server:
  ros__parameters: {x: 1}
)" + kPursuit);
    QCOMPARE(noteOf(reading, "amcl.alpha1")->use, KeyUse::Ignored);
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unknown-node");
    QVERIFY(problem != nullptr && problem->message.find("planner_server") != std::string::npos);
  }

  void read_recoveriesServer_isTheBehaviorServer() {
    const Nav2ReadResult reading = readOf(R"(recoveries_server:
  ros__parameters:
    cycle_frequency: 5.0
    behavior_plugins: ["spin"]
    spin: {plugin: "nav2_recoveries/Spin"}
)" + kPursuit,
                                          Distro::Humble);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(reading.parameters.behaviors.server.cycleFrequency, 5.0);
    QVERIFY(reading.parameters.behaviors.hasSpin && !reading.parameters.behaviors.hasWait);
  }

  /// Counts beyond what fits are no counts, whatever their sign.
  void read_hugeCount_isOutOfRange() {
    for (const char* const count : {"99999999999", "-9223372036854775808"}) {
      const Nav2ReadResult reading = readNav2Parameters(
          parsed("controller_server:\n  ros__parameters:\n    FollowPath:\n"
                 "      plugin: \"nav2_mppi_controller::MPPIController\"\n      time_steps: " +
                 std::string(count) + "\n      critics: [\"GoalCritic\"]\n"),
          {Distro::Jazzy, {}});
      QVERIFY2(problemOf(reading.problems, "nav2.number-out-of-range"),
               texts(reading.problems).c_str());
      QVERIFY(!problemOf(reading.problems, "nav2.wrong-type"));
    }
  }

  void set_value_integersPassForDoubles() {
    ParameterFile file = parsed(kPursuit);
    const Nav2ReadResult before = readNav2Parameters(file, {Distro::Jazzy, {}});
    QVERIFY(setNav2Value(file, before, "FollowPath.lookahead_dist", "2").empty());
    QVERIFY(setNav2Value(file, before, "local_costmap.width", "7").empty());
    QVERIFY(setNav2Value(file, before, "velocity_smoother.max_velocity", "[1, 0, 2]").empty());
    const Nav2ReadResult after = readNav2Parameters(file, {Distro::Jazzy, {}});
    QVERIFY2(after.ok(), texts(after.problems).c_str());
    QCOMPARE(controllerValue(after.parameters, "FollowPath.lookahead_dist", 0.0), 2.0);
    QCOMPARE(after.parameters.localCostmap.parameters.width, 7);
    QCOMPARE(after.parameters.velocitySmoother.maxVelocity, (std::vector<double>{1.0, 0.0, 2.0}));
  }

  /// A value of the scenario is at no line of the file, which has another value there.
  void set_value_problemsNameNoFile() {
    ParameterFile file = parsed(kPursuit);
    const Nav2ReadResult before = readNav2Parameters(file, {Distro::Jazzy, {}});
    QVERIFY(setNav2Value(file, before, "local_costmap.width", "wide").empty());
    QVERIFY(setNav2Value(file, before, "FollowPath.lookahead_dist", "-2").empty());
    const Nav2ReadResult after = readNav2Parameters(file, {Distro::Jazzy, {}});
    const base::Diagnostic* const type = problemOf(after.problems, "nav2.wrong-type");
    QVERIFY(type != nullptr);
    QVERIFY2(type->file.empty() && type->line == 0, type->text().c_str());
    const base::Diagnostic range = withFilePosition(
        after.parameters, base::withContext("controller_server",
                                            base::withContext("FollowPath.lookahead_dist",
                                                              base::error("run.failed", {"odd"}))));
    QVERIFY2(range.file.empty() && range.line == 0, range.text().c_str());
  }

  void set_unknownPath_tellsTheNearest() {
    ParameterFile file = parsed(kPursuit);
    const Nav2ReadResult reading = readNav2Parameters(file, {Distro::Jazzy, {}});
    const base::Diagnostics wrong = setNav2Value(file, reading, "FollowPath.lookahed_dist", "2.0");
    QCOMPARE(wrong.size(), std::size_t{1});
    QVERIFY(wrong.front().message.find("FollowPath.lookahead_dist") != std::string::npos);
  }

  void set_keyOfBothCostmaps_needsItsNode() {
    ParameterFile file = parsed(kPursuit);
    const Nav2ReadResult reading = readNav2Parameters(file, {Distro::Jazzy, {}});
    const base::Diagnostics wrong =
        setNav2Value(file, reading, "inflation_layer.inflation_radius", "0.7");
    QVERIFY(problemOf(wrong, "nav2.set-ambiguous"));
    QVERIFY(setNav2Value(file, reading, "local_costmap.inflation_layer.inflation_radius", "0.7")
                .empty());
  }

  void shipped_files_haveNoProblems_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("distro");
    QTest::newRow("generic") << "generic" << 1;
    QTest::newRow("turtlebot3") << "turtlebot3" << 0;
    QTest::newRow("turtlebot4") << "turtlebot4" << 1;
    QTest::newRow("tiago") << "tiago" << 0;
    QTest::newRow("nova_carter") << "nova_carter" << 1;
  }

  void shipped_files_haveNoProblems() {
    QFETCH(QString, name);
    QFETCH(int, distro);
    const auto file =
        ParameterFile::read(SOURCE_DIR "/resources/nav2_params/" + name.toStdString() + ".yaml");
    QVERIFY(file);
    const Nav2ReadResult reading = readNav2Parameters(*file);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(static_cast<int>(reading.parameters.distro), distro);
    for (const KeyUsage& key : reading.parameters.notes.keys) {
      // Humble's example has it, and nothing reads it.
      const bool isLeftOver = key.path == "controller_server.FollowPath.stateful";
      QVERIFY2(key.use == KeyUse::Used || key.use == KeyUse::Ignored || isLeftOver,
               key.path.c_str());
    }
  }
};

QTEST_GUILESS_MAIN(Nav2ParamsTest)
#include "tst_Nav2Params.moc"
