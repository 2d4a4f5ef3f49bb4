#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

namespace {

ParameterFile file(const std::string& text, const std::string& name) {
  const auto read = ParameterFile::parse(text, name);
  return read ? *read : ParameterFile();
}

ParameterFile both(const std::string& first, const std::string& second) {
  ParameterFile all = file(first, "a/first.yaml");
  all.append(file(second, "b/second.yaml"));
  return all;
}

const std::string kCostmaps = R"(local_costmap:
  local_costmap:
    ros__parameters: {robot_radius: 0.2}
global_costmap:
  global_costmap:
    ros__parameters: {robot_radius: 0.2}
)";

}  // namespace

/// Several parameter files and single values, read as one.
class Nav2ManyFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void append_laterFile_winsPerParameter() {
    const ParameterFile all = both(R"(planner_server:
  ros__parameters:
    a: 1
    b: 2
    list: [x, y, z]
    block: {c: 3, d: 4}
)",
                                   R"(planner_server:
  ros__parameters:
    b: 20
    list: [w]
    block.d: 40
)");
    const NodeParameters planner = all.parametersOf("planner_server");
    QCOMPARE(valueOf(planner, "a"), std::string("1"));
    QCOMPARE(valueOf(planner, "b"), std::string("20"));
    QCOMPARE(valueOf(planner, "block.c"), std::string("3"));
    QCOMPARE(valueOf(planner, "block.d"), std::string("40"));
    QCOMPARE(planner.find("list")->value->items.size(), std::size_t{1});  // replaced, not joined
    QCOMPARE(all.files(), (std::vector<std::string>{"a/first.yaml", "b/second.yaml"}));
  }

  void append_forAllInALaterFile_winsOverTheNode() {
    const std::string node = "planner_server:\n  ros__parameters: {a: 1}\n";
    const std::string all = "/**:\n  ros__parameters: {a: 2}\n";
    QCOMPARE(valueOf(both(node, all).parametersOf("planner_server"), "a"), std::string("2"));
    QCOMPARE(valueOf(both(all, node).parametersOf("planner_server"), "a"), std::string("1"));
    QCOMPARE(valueOf(file(node + all, "f").parametersOf("planner_server"), "a"), std::string("1"));
  }

  void append_problems_nameTheFileOfTheValue() {
    const ParameterFile all = both(
        kPursuit + "    controller_frequency: 20\n",
        "\ncontroller_server:\n  ros__parameters:\n    FollowPath:\n      lookahead_dist: 1\n");
    const Nav2ReadResult reading = readNav2Parameters(all, {Distro::Jazzy, {}});
    QCOMPARE(texts(reading.problems),
             std::string("a/first.yaml:5:27: error: controller_server.controller_frequency has an "
                         "invalid type: ROS 2 expects double, found integer\nb/second.yaml:5:23: "
                         "error: controller_server.FollowPath.lookahead_dist has an invalid type: "
                         "ROS 2 expects double, found integer\n"));
  }

  void override_text_isNodeNameAndValue_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("node");
    QTest::addColumn<QString>("name");  // empty: it is no single value
    QTest::addColumn<QString>("yaml");
    const auto row = [](const char* text, const char* node, const char* name, const char* yaml) {
      QTest::newRow(text) << QString::fromLatin1(text) << QString::fromLatin1(node)
                          << QString::fromLatin1(name) << QString::fromLatin1(yaml);
    };
    row("a.b:=1.0", "", "a.b", "1.0");
    row("n:a.b:=1.0", "n", "a.b", "1.0");
    row("/robot1/n:a:=x", "n", "a", "x");
    row("/**:a:=x", "", "a", "x");
    row("a:=[1.0, 2.0]", "", "a", "[1.0, 2.0]");
    row("a:=b:c:=d", "", "a", "b:c:=d");
    row("C:/params=1.yaml", "", "", "");
  }

  void override_text_isNodeNameAndValue() {
    QFETCH(QString, text);
    QFETCH(QString, node);
    QFETCH(QString, name);
    QFETCH(QString, yaml);
    const std::optional<ParameterOverride> given = parameterOverride(text.toStdString());
    QCOMPARE(given.has_value(), !name.isEmpty());
    if (given) {
      QCOMPARE(given->node, node.toStdString());
      QCOMPARE(given->name, name.toStdString());
      QCOMPARE(given->yaml, yaml.toStdString());
    }
  }

  void override_typed_isAsRos2TakesIt() {
    ParameterFile all = file(kPursuit, "f.yaml");
    const Nav2ReadResult before = readNav2Parameters(all, {Distro::Jazzy, {}});
    QCOMPARE(
        texts(overrideNav2Value(all, before, *parameterOverride("controller_frequency:=10.0"))),
        std::string());
    const Nav2ReadResult reading = readNav2Parameters(all, {Distro::Jazzy, {}});
    QCOMPARE(controllerValue(reading.parameters, "controller_frequency", 0.0), 10.0);
    ParameterFile wrong = file(kPursuit, "f.yaml");
    QVERIFY(
        overrideNav2Value(wrong, before, *parameterOverride("controller_frequency:=10")).empty());
    const Nav2ReadResult refused = readNav2Parameters(wrong, {Distro::Jazzy, {}});
    QCOMPARE(texts(refused.problems),
             std::string("error: controller_server.controller_frequency has an invalid type: ROS 2 "
                         "expects double, found integer\n"));
  }

  void override_withoutNode_isOfEachThatHasIt() {
    ParameterFile all = file(kPursuit + kCostmaps, "f.yaml");
    const Nav2ReadResult before = readNav2Parameters(all, {Distro::Jazzy, {}});
    const auto radii = [&all] {
      const Nav2ReadResult reading = readNav2Parameters(all, {Distro::Jazzy, {}});
      return std::pair(reading.parameters.localCostmap.parameters.robotRadius,
                       reading.parameters.globalCostmap.parameters.robotRadius);
    };
    QVERIFY(overrideNav2Value(all, before, *parameterOverride("robot_radius:=0.3")).empty());
    QVERIFY(radii() == std::pair(0.3, 0.3));
    QVERIFY(overrideNav2Value(all, before, *parameterOverride("local_costmap:robot_radius:=0.4"))
                .empty());
    QVERIFY(radii() == std::pair(0.4, 0.3));
    QVERIFY(overrideNav2Value(all, before, *parameterOverride("global_costmap.robot_radius:=0.5"))
                .empty());
    QVERIFY(radii() == std::pair(0.4, 0.5));
  }

  void override_unknown_isAnErrorWithTheNearest() {
    ParameterFile all = file(kPursuit, "f.yaml");
    const Nav2ReadResult before = readNav2Parameters(all, {Distro::Jazzy, {}});
    QCOMPARE(
        texts(overrideNav2Value(all, before, *parameterOverride("FollowPath.lookahead_dst:=1.0"))),
        std::string("error: 'FollowPath.lookahead_dst' is not a Nav2 parameter (did you mean "
                    "'FollowPath.lookahead_dist'?)\n"));
    QVERIFY(!overrideNav2Value(all, before, *parameterOverride("controller_frequency:=")).empty());
  }

  void folders_ofAParameter_beginWithItsFile() {
    const ParameterFile all = both(
        kPursuit, "bt_navigator:\n  ros__parameters:\n    default_nav_to_pose_bt_xml: tree.xml\n");
    const Nav2ReadResult reading = readNav2Parameters(all, {Distro::Jazzy, {}});
    QCOMPARE(parameterFolders(reading.parameters, "bt_navigator.default_nav_to_pose_bt_xml"),
             (std::vector<std::string>{"b", "a"}));
    QCOMPARE(parameterFolders(reading.parameters, "bt_navigator.other"),
             (std::vector<std::string>{"a", "b"}));
  }
};

QTEST_APPLESS_MAIN(Nav2ManyFilesTest)
#include "tst_Nav2ManyFiles.moc"
