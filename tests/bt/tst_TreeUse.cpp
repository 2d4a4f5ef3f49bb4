#include <algorithm>
#include <filesystem>
#include <string>

#include <QtTest>

#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/robot/Nav2Files.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeUse.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

using bt::TreeUse;

namespace {

const std::string kNavigatorFile =
    SOURCE_DIR "/resources/nav2_trees/humble/navigate_to_pose_w_replanning_and_recovery.xml";

/// With a person of this behaviour, on the way to one goal.
sim2d::Scenario scenarioOf(sim2d::BehaviorType type) {
  sim2d::Scenario scenario;
  scenario.goals.push_back({{}, 1, base::Vec2(1.0, 0.0), {}});
  sim2d::Human human;
  human.name = "Ana";
  human.id = 1;
  human.goals = {1};
  human.behavior.type = type;
  scenario.humans = {human};
  return scenario;
}

std::string treeTextOf(sim2d::BehaviorType type, bt::TreeStyle style) {
  const sim2d::Scenario scenario = scenarioOf(type);
  return bt::makeTreeText(scenario, scenario.humans.front(), style, bt::humanNodes().catalogue());
}

TreeUse useOf(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(xml, "t.xml");
  return file ? bt::treeUse(*file) : TreeUse::Unknown;
}

TreeUse useOfNodes(const std::string& nodes) {
  return useOf("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence>" + nodes +
               "</Sequence></BehaviorTree></root>");
}

/// How many nodes of the catalogue, each alone in a tree, have this use; the others are Unknown.
int countWithUse(const bt::NodeCatalogue& catalogue, TreeUse use) {
  int count = 0;
  for (const bt::NodeManifest& node : catalogue.all()) {
    const TreeUse found = useOfNodes("<" + node.id + "/>");
    if (found != use && found != TreeUse::Unknown) {
      qWarning("%s", node.id.c_str());
      return -1;
    }
    count += found == use ? 1 : 0;
  }
  return count;
}

std::string codesOf(const base::Diagnostics& problems) {
  std::string codes;
  for (const base::Diagnostic& problem : problems) {
    codes += std::string(problem.code) + " ";
  }
  return codes;
}

}  // namespace

/// Trees of people and of robots, mixed up.
class TreeUseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shippedNavigatorTrees_areThoseOfRobots() {
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(SOURCE_DIR "/resources/nav2_trees")) {
      if (entry.path().extension() == ".xml") {
        QVERIFY2(useOf(*base::readTextFile(entry.path().string())) == TreeUse::Navigator,
                 entry.path().c_str());
        ++count;
      }
    }
    QCOMPARE(count, 50);
  }

  void generatedTrees_areThoseOfPeople() {
    for (int type = 1; type <= 6; ++type) {
      for (const bt::TreeStyle style : {bt::TreeStyle::Corrected, bt::TreeStyle::Hunav2}) {
        const std::string xml = treeTextOf(static_cast<sim2d::BehaviorType>(type), style);
        QVERIFY2(useOf(xml) == TreeUse::Person, xml.c_str());
      }
    }
  }

  void marks_areNodesOfOneKindOnly() {
    QCOMPARE(countWithUse(bt::humanNodes().catalogue(), TreeUse::Person), 22);
    QCOMPARE(countWithUse(bt::robotNodes().catalogue(), TreeUse::Navigator), 19);
    QCOMPARE(countWithUse(bt::builtinNodes(), TreeUse::Unknown),
             static_cast<int>(bt::builtinNodes().all().size()));
  }

  void mixedTree_isWhatMostNodesAre() {
    QVERIFY(useOfNodes("<SetGoal/><UpdateGoal/><Spin/>") == TreeUse::Person);
    QVERIFY(useOfNodes("<SetGoal/><BackUp/><Spin/>") == TreeUse::Navigator);
    QVERIFY(useOfNodes("<SetGoal/><Spin/>") == TreeUse::Unknown);
    QVERIFY(useOfNodes("<AlwaysSuccess/>") == TreeUse::Unknown);
  }

  /// Format 3, unknown nodes, ports and entries: none of it is reported.
  void navigatorTreeOfAPerson_isOneProblem() {
    const sim2d::Scenario scenario = scenarioOf(sim2d::BehaviorType::Regular);
    bt::TreeLoader loader(scenario);
    bt::TreeSource source;
    source.path = kNavigatorFile;
    base::Diagnostics problems;
    QVERIFY(!loader.load(scenario.humans.front(), source, problems));
    QCOMPARE(codesOf(problems), std::string("tree.of-robot "));
    QCOMPARE(problems.front().file, kNavigatorFile);
    QVERIFY(problems.front().line > 0);
  }

  /// Its include, which is not in the folder, is not reported either.
  void personsTreeOfARobot_isOneProblem() {
    const std::string file = SOURCE_DIR "/maps/two_workers/two_workers_agents__agent_1_bt.xml";
    const bt::NavigatorTree tree = bt::loadNavigatorTree(file, {});
    QVERIFY(!tree.program);
    QCOMPARE(codesOf(tree.problems), std::string("tree.of-person "));
    QCOMPARE(tree.problems.front().file, file);
  }
};

QTEST_APPLESS_MAIN(TreeUseTest)
#include "tst_TreeUse.moc"
