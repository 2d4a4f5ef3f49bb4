#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "sim2d/nav/nav2/params/RosValue.h"
#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

namespace {

base::YamlNode yamlOf(const std::string& text) {
  base::Diagnostics problems;
  return base::parseYaml(text, {}, problems);
}

double frequencyOf(const Nav2ReadResult& reading) {
  return controllerValue(reading.parameters, "controller_frequency", 20.0);
}

/// kPursuit with one more key of the controller server.
std::string pursuitWith(const std::string& key) {
  return kPursuit + "    " + key + "\n";
}

}  // namespace

/// Parameter files as they are found on robots: placeholders of launch files, other spellings of
/// YAML, mistakes that do not keep a robot from driving.
class Nav2ToleranceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void placeholder_ofAnyType_isOneOfThese_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<bool>("isPlaceholder");
    const std::vector<std::pair<const char*, bool>> rows = {{"$(var a)", true},
                                                            {"\"$(find-pkg-share a)\"", true},
                                                            {"${A}", true},
                                                            {"\"{{ a }}\"", true},
                                                            {"<robot_namespace>", true},
                                                            {"\"@A@\"", true},
                                                            {"TO_BE_OVERRIDDEN", true},
                                                            {"KEEPOUT_ZONE_ENABLED", true},
                                                            {"TODO", true},
                                                            {"", true},
                                                            {"$(find-pkg-share a)/b.xml", false},
                                                            {"<robot_namespace>/scan", false},
                                                            {"REEDS_SHEPP", false},
                                                            {"scan", false},
                                                            {"a < b > c", false},
                                                            {"1.0", false}};
    for (const auto& [yaml, isPlaceholder] : rows) {
      QTest::addRow("'%s'", yaml) << QString::fromLatin1(yaml) << isPlaceholder;
    }
  }

  void placeholder_ofAnyType_isOneOfThese() {
    QFETCH(QString, yaml);
    QFETCH(bool, isPlaceholder);
    QCOMPARE(isLaunchPlaceholder("name", yamlOf(yaml.toStdString())), isPlaceholder);
  }

  void placeholder_ofAKeyThatCounts_isAWarningWithTheDefault_data() {
    QTest::addColumn<QString>("value");
    for (const char* const value :
         {"$(var frequency)", "\"\"", "FREQUENCY", "<frequency>", "\"20 $(var unit)\"", ""}) {
      QTest::addRow("'%s'", value) << QString::fromLatin1(value);
    }
  }

  void placeholder_ofAKeyThatCounts_isAWarningWithTheDefault() {
    QFETCH(QString, value);
    const Nav2ReadResult reading =
        readOf(pursuitWith("controller_frequency: " + value.toStdString()));
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.placeholder");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->line, 5);
    QCOMPARE(problem->value("key"), std::string("controller_server.controller_frequency"));
    QCOMPARE(problem->value("value"), std::string("20.0"));
    QVERIFY(base::problemText(problem->code)->isSubstitution);
    QCOMPARE(frequencyOf(reading), 20.0);
  }

  void placeholder_ofAKeyWithoutEffect_isNotReported() {
    const Nav2ReadResult reading = readOf(pursuitWith("use_sim_time: $(var use_sim_time)") +
                                          "amcl:\n  ros__parameters:\n    set_initial_pose: <x>\n");
    QCOMPARE(texts(reading.problems), std::string());
    QVERIFY(noteOf(reading, "controller_server.use_sim_time")->use == KeyUse::Ignored);
  }

  void placeholder_forAListOfPlugins_givesNav2sList() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: LAYERS
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(reading.parameters.localCostmap.plugins.size(), std::size_t{3});  // Nav2's own three
    QVERIFY(problemOf(reading.problems, "nav2.placeholder") != nullptr);
  }

  void placeholder_thatSwitchesAFilterOn_leavesItOff() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      filters: [keepout_filter]
      keepout_filter:
        plugin: "nav2_costmap_2d::KeepoutFilter"
        enabled: KEEPOUT_ZONE_ENABLED
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QVERIFY(reading.parameters.localCostmap.filters.empty());
    QVERIFY(problemOf(reading.problems, "nav2.launch-word") != nullptr);
  }

  void integerForADouble_isNoPlaceholder() {
    for (const char* const value : {"20", "true", "fast", "[20.0]"}) {
      const Nav2ReadResult reading =
          readOf(pursuitWith(std::string("controller_frequency: ") + value));
      QVERIFY2(problemOf(reading.problems, "nav2.wrong-type") != nullptr, value);
    }
  }

  void number_beyondTheLimits_isCut() {
    const Nav2ReadResult reading = readOf(kPursuit + "      lookahead_time: .inf\n");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.number-cut");
    QVERIFY(problem != nullptr);
    QCOMPARE(problem->value("used"), std::string("1e+09"));
    QVERIFY(!readOf(kPursuit + "      lookahead_time: .nan\n").ok());
  }

  void yaml_aliasesAndMergeKeys_areReplaced() {
    const auto file = ParameterFile::parse(R"(controller_server:
  ros__parameters: &all
    a: &one 1
    b: {c: 2, d: 3}
    e: *one
planner_server:
  ros__parameters:
    <<: *all
    a: 7
)",
                                           "p.yaml");
    QVERIFY2(bool(file), texts(file.diagnostics()).c_str());
    QCOMPARE(
        texts(file.diagnostics()),
        std::string("p.yaml:5:8: warning: an alias (*name) is replaced by its value; ROS 2's own "
                    "parser rejects aliases, launch tools replace them\n"));
    const NodeParameters planner = file->parametersOf("planner_server");
    QCOMPARE(valueOf(planner, "a"), std::string("7"));  // its own wins
    QCOMPARE(valueOf(planner, "b.d"), std::string("3"));
    QCOMPARE(valueOf(planner, "e"), std::string("1"));
    QCOMPARE(planner.find("b.d")->value->line, 4);  // where it stands
  }

  /// Nine levels of nine aliases each stand for 4e8 values.
  void yaml_aliasesOfAliases_haveALimit() {
    std::string text = "amcl:\n  ros__parameters:\n    a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
    for (int i = 1; i <= 9; ++i) {
      const std::string before = "*a" + std::to_string(i - 1);
      text += "    a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
      for (int k = 1; k < 9; ++k) {
        text += ", " + before;
      }
      text += "]\n";
    }
    const auto file = ParameterFile::parse(text, "p.yaml");
    QVERIFY(!file);
    QVERIFY(problemOf(file.diagnostics(), "yaml.too-many-aliases") != nullptr);
  }

  void yaml_mergeOfNoMap_isAnError() {
    const auto file = ParameterFile::parse("amcl:\n  ros__parameters:\n    <<: 1\n", "p.yaml");
    QCOMPARE(
        texts(file.diagnostics()),
        std::string("p.yaml:3:5: error: the value of a merge key (<<) must be a map or a list of "
                    "maps\n"));
  }

  void yaml_severalDocuments_areRead() {
    const auto file = ParameterFile::parse(
        "---\namcl:\n  ros__parameters: {a: 1}\n---\nplanner_server:\n  ros__parameters: {b: "
        "2}\n...\n"
        "---\namcl:\n  ros__parameters: {a: 3}\n",
        "p.yaml");
    QVERIFY2(bool(file), texts(file.diagnostics()).c_str());
    QCOMPARE(valueOf(file->parametersOf("planner_server"), "b"), std::string("2"));
    QCOMPARE(valueOf(file->parametersOf("amcl"), "a"), std::string("3"));
    QVERIFY(problemOf(file.diagnostics(), "yaml.documents-merged") != nullptr);
  }

  void yaml_byteOrderMarkTabsAndCrLf_areRead() {
    const auto file = ParameterFile::parse(
        "\xEF\xBB\xBF# parameters\r\n\t# a comment\r\namcl:\r\n  ros__parameters:\r\n    a:\t1\r\n"
        "    b: [1,\r\n\t2]\r\n",
        "p.yaml");
    QVERIFY2(bool(file), texts(file.diagnostics()).c_str());
    QCOMPARE(valueOf(file->parametersOf("amcl"), "a"), std::string("1"));
    QCOMPARE(file->parametersOf("amcl").find("b")->value->items.size(), std::size_t{2});
  }

  void yaml_tabAsIndentation_isAnErrorAtItsPlace() {
    const auto file = ParameterFile::parse("amcl:\n\tros__parameters:\n\t\ta: 1\n", "p.yaml");
    QVERIFY(!file);
    QCOMPARE(file.diagnostics().front().line, 2);
    QCOMPARE(std::string(file.diagnostics().front().code), std::string("yaml.tab"));
  }

  void yaml_template_isOneClearError() {
    const auto file = ParameterFile::parse(
        "amcl:\n  ros__parameters:\n    base_frame_id: {{ robot }}/base\n", "p.yaml");
    QCOMPARE(
        texts(file.diagnostics()),
        std::string("p.yaml:3:20: error: '{{' is a template (Jinja, xacro, Helm), not YAML: render "
                    "it first\n"));
  }

  void parameters_misspeltOrMissing_areReadWithAWarning_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("node");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* name, const char* text, const char* node, const char* code) {
      QTest::newRow(name) << QString::fromLatin1(text) << QString::fromLatin1(node)
                          << QString::fromLatin1(code);
    };
    row("one underscore", "controller_server:\n  ros_parameters: {a: 1}\n", "controller_server",
        "nav2.parameters-misspelt");
    row("params", "amcl:\n  params: {a: 1}\n", "amcl", "nav2.parameters-misspelt");
    row("missing", "controller_server:\n  a: 1\n", "controller_server", "nav2.parameters-missing");
    row("missing in a costmap", "local_costmap:\n  local_costmap:\n    a: 1\n", "local_costmap",
        "nav2.parameters-missing");
    row("missing in a namespace", "robot1:\n  planner_server:\n    a: 1\n", "planner_server",
        "nav2.parameters-missing");
  }

  void parameters_misspeltOrMissing_areReadWithAWarning() {
    QFETCH(QString, text);
    QFETCH(QString, node);
    QFETCH(QString, code);
    QVERIFY(looksLikeNav2(text.toStdString()) || text.startsWith(QLatin1String("robot1")));
    const auto file = ParameterFile::parse(text.toStdString(), "p.yaml");
    QVERIFY2(bool(file), texts(file.diagnostics()).c_str());
    QCOMPARE(valueOf(file->parametersOf(node.toStdString()), "a"), std::string("1"));
    QCOMPARE(file.diagnostics().size(), std::size_t{1});
    QCOMPARE(std::string(file.diagnostics().front().code), code.toStdString());
  }

  void nodes_inNamespacesOfAnyDepth_areRead_data() {
    QTest::addColumn<QString>("text");
    const std::vector<std::pair<const char*, const char*>> rows = {
        {"none", "planner_server:\n  ros__parameters: {a: 1}\n"},
        {"slash", "/planner_server:\n  ros__parameters: {a: 1}\n"},
        {"path", "/fleet/robot1/planner_server:\n  ros__parameters: {a: 1}\n"},
        {"maps", "fleet:\n  robot1:\n    planner_server:\n      ros__parameters: {a: 1}\n"},
        {"both", "/fleet:\n  robot1/planner_server:\n    ros__parameters: {a: 1}\n"},
        {"all", "/**/planner_server:\n  ros__parameters: {a: 1}\n"},
        {"one", "/*/planner_server:\n  ros__parameters: {a: 1}\n"},
        {"all as a map", "/**:\n  planner_server:\n    ros__parameters: {a: 1}\n"},
        {"word", "<robot_namespace>:\n  planner_server:\n    ros__parameters: {a: 1}\n"}};
    for (const auto& [name, text] : rows) {
      QTest::newRow(name) << QString::fromLatin1(text);
    }
  }

  void nodes_inNamespacesOfAnyDepth_areRead() {
    QFETCH(QString, text);
    const auto file = ParameterFile::parse(text.toStdString(), "p.yaml");
    QVERIFY2(bool(file), texts(file.diagnostics()).c_str());
    QCOMPARE(texts(file.diagnostics()), std::string());
    QCOMPARE(valueOf(file->parametersOf("planner_server"), "a"), std::string("1"));
    const std::string costmap =
        QString(text)
            .replace(QLatin1String("planner_server"), QLatin1String("local_costmap/local_costmap"))
            .toStdString();
    QCOMPARE(valueOf(parsed(costmap).parametersOf("local_costmap"), "a"), std::string("1"));
  }

  void nodes_forAllOfANamespace_areOfThatRobot() {
    const ParameterFile file = parsed(R"(robot1:
  /**:
    ros__parameters: {a: 1}
robot2:
  /**:
    ros__parameters: {a: 2}
  planner_server:
    ros__parameters: {b: 3}
)");
    QCOMPARE(valueOf(file.parametersOf("planner_server", "robot2"), "a"), std::string("2"));
    QCOMPARE(valueOf(file.parametersOf("planner_server", "robot1"), "a"), std::string("1"));
  }

  void mistake_thatNav2Overlooks_isAWarning_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("code");
    QTest::addColumn<int>("line");
    const auto row = [](const char* name, const char* text, const char* code, int line) {
      QTest::newRow(name) << QString::fromLatin1(text) << QString::fromLatin1(code) << line;
    };
    row("plugin twice",
        "planner_server:\n  ros__parameters:\n    planner_plugins: [a, a]\n"
        "    a: {plugin: nav2_navfn_planner::NavfnPlanner}\n",
        "nav2.plugin-twice", 7);
    row("no polygon",
        "local_costmap:\n  local_costmap:\n    ros__parameters:\n"
        "      robot_radius: 0.3\n      footprint: \"[0.3, 0.2]\"\n",
        "nav2.footprint-invalid", 9);
    row("behaviour of another package",
        "behavior_server:\n  ros__parameters:\n"
        "    behavior_plugins: [wave]\n    wave: {plugin: my_robot::WaveHand}\n",
        "nav2.left-out", 8);
  }

  /// A robot with such a file drives.
  void mistake_thatNav2Overlooks_isAWarning() {
    QFETCH(QString, text);
    QFETCH(QString, code);
    QFETCH(int, line);
    const Nav2ReadResult reading = readOf(kPursuit + text.toStdString());
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const base::Diagnostic* const problem = problemOf(reading.problems, code.toStdString());
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->line, line);
  }

  /// As Nav2's Optimizer: "sign of the parameter ax_min is incorrect".
  void mppi_positiveDeceleration_isTurnedRound() {
    const auto mppi = readMppi({{"ax_min", Nav2Value(2.5)},
                                {"critics", Nav2Value(std::vector<std::string>{"GoalCritic"})}},
                               Distro::Jazzy);
    QVERIFY2(bool(mppi), texts(mppi.diagnostics()).c_str());
    QCOMPARE(mppi->settings.axMin, -2.5);
    QVERIFY(problemOf(mppi.diagnostics(), "nav2.positive-deceleration") != nullptr);
  }
};

QTEST_APPLESS_MAIN(Nav2ToleranceTest)
#include "tst_Nav2Tolerance.moc"
