#include <QTemporaryDir>
#include <QtTest>

#include "bt/engine/Program.h"
#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ResolvedValues.h"

using sim2d::BehaviorType;

namespace {

sim2d::Scenario scenarioWith(BehaviorType type, const std::vector<int>& goals) {
  sim2d::Scenario scenario;
  scenario.yamlBaseName = "demo";
  for (int id = 1; id <= 3; ++id) {
    scenario.goals.push_back({{}, id, base::Vec2(id, 0.0), {}});
  }
  sim2d::Human human;
  human.name = "agent1";
  human.id = 1;
  human.goals = goals;
  human.maxVel = 1.9;
  human.behavior.type = type;
  human.behavior.configuration = sim2d::Configuration::Custom;
  human.behavior.dist = 4.25;
  human.behavior.duration = 30.0;
  human.behavior.once = true;
  human.behavior.vel = 0.7;
  human.behavior.stopDist = 1.3333333;
  human.behavior.frontDist = 1.4;
  human.behavior.safeDistance = 6.0;
  scenario.humans = {human};
  return scenario;
}

std::string textOf(const sim2d::Scenario& scenario, bt::TreeStyle style) {
  return bt::makeTreeText(scenario, scenario.humans.front(), style, bt::humanNodes().catalogue());
}

/// From "<BehaviorTree" to its end, without the white space between elements.
std::string treeElement(const std::string& text) {
  const std::size_t begin = text.find("<BehaviorTree");
  const std::size_t end = text.find("</BehaviorTree>");
  std::string element;
  bool isBetween = false;
  for (const char c : text.substr(begin, end - begin)) {
    if (isBetween && (c == ' ' || c == '\n')) {
      continue;
    }
    isBetween = c == '>';
    element += c;
  }
  std::string compact;
  for (std::size_t i = 0; i < element.size(); ++i) {
    if (element[i] != ' ' || element.compare(i, 3, " />") != 0) {
      compact += element[i];
    }
  }
  return compact;
}

const char* const kGoals =
    R"(<Sequence name="SetGoals"><RunOnce><SetGoal agent_id="{id}" goal_id="2"/></RunOnce>)"
    R"(<Inverter><RunOnce><SetGoal agent_id="{id}" goal_id="3"/></RunOnce></Inverter></Sequence>)";
const char* const kRegNav =
    R"(<Sequence name="RegNav"><SetBlackboard output_key="agentid" value="{id}"/>)"
    R"(<SetBlackboard output_key="timestep" value="{dt}"/>)"
    R"(<SubTree ID="RegularNavTree" id="{agentid}" dt="{timestep}"/></Sequence></Fallback>)";

/// Problems of a sequence of these nodes as the tree of the scenario's first person.
base::Diagnostics problemsOf(const std::string& nodes, const sim2d::Scenario& scenario) {
  const auto file = bt::readTreeText("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence>" +
                                         nodes + "</Sequence></BehaviorTree></root>",
                                     "t.xml");
  const auto table = bt::resolveIncludes(*file);
  return bt::checkAgentTree(*table, scenario.humans.front(), scenario,
                            bt::humanNodes().catalogue());
}

}  // namespace

Q_DECLARE_METATYPE(sim2d::BehaviorType)

class HumanTemplatesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void corrected_ofEachBehaviour_isThePattern_data() {
    QTest::addColumn<BehaviorType>("type");
    QTest::addColumn<QByteArray>("tree");
    QTest::addColumn<QByteArray>("reaction");
    QTest::newRow("surprised")
        << BehaviorType::Surprised
        << QByteArray(R"(ID="SurprisedNavTree"><Fallback name="SurprisedFallback">)")
        << QByteArray(
               R"(<Sequence name="SurNav"><IsRobotVisible agent_id="{id}" distance="4.25"/>)"
               R"(<Inverter><TimeExpiredCondition seconds="30" ts="{dt}" only_once="true"/></Inverter>)"
               R"(<SurprisedNav agent_id="{id}" time_step="{dt}"/></Sequence>)");
    QTest::newRow("scared")
        << BehaviorType::Scared
        << QByteArray(R"(ID="ScaredNavTree"><Fallback name="ScaredFallback">)")
        << QByteArray(
               R"(<Sequence name="ScaNav"><IsRobotVisible agent_id="{id}" distance="4.25"/>)"
               R"(<RunOnce then_skip="false"><ForceFailure><AvoidRobot agent_id="{id}" time_step="{dt}" )"
               R"(runaway_vel="0.7" safe_distance="6" duration="30"/></ForceFailure></RunOnce></Sequence>)");
    QTest::newRow("curious")
        << BehaviorType::Curious
        << QByteArray(R"(ID="CuriousNavTree"><Fallback name="CuriousFallback">)")
        << QByteArray(
               R"(<Sequence name="CurNav"><IsRobotVisible agent_id="{id}" distance="4.25"/>)"
               R"(<RunOnce then_skip="false"><ForceFailure><ApproachRobot agent_id="{id}" time_step="{dt}" )"
               R"(closest_dist="1.33333" max_vel="0.7" duration="30"/></ForceFailure></RunOnce></Sequence>)");
    QTest::newRow("threatening")
        << BehaviorType::Threatening
        << QByteArray(R"(ID="ThreateningNavTree"><Fallback name="ThreateningFallback">)")
        << QByteArray(
               R"(<Sequence name="ThreadNav"><IsRobotVisible agent_id="{id}" distance="4.25"/>)"
               R"(<RunOnce then_skip="false"><ForceFailure><BlockRobot agent_id="{id}" time_step="{dt}" )"
               R"(front_dist="1.4" duration="30"/></ForceFailure></RunOnce></Sequence>)");
  }
  void corrected_ofEachBehaviour_isThePattern() {
    QFETCH(BehaviorType, type);
    QFETCH(QByteArray, tree);
    QFETCH(QByteArray, reaction);
    const std::string found =
        treeElement(textOf(scenarioWith(type, {2, 3}), bt::TreeStyle::Corrected));
    const QByteArray expected = "<BehaviorTree " + tree + kGoals + reaction + kRegNav;
    QCOMPARE(QByteArray::fromStdString(found), expected);
  }

  void corrected_regularAndImpassive_navigate() {
    const char* const expected =
        R"(<Sequence name="RegularNavigation"><Inverter><IsGoalReached agent_id="{id}"/></Inverter>)"
        R"(<RegularNav agent_id="{id}" time_step="{dt}"/></Sequence><UpdateGoal agent_id="{id}"/></Fallback>)";
    for (const BehaviorType type : {BehaviorType::Regular, BehaviorType::Impassive}) {
      const std::string found =
          treeElement(textOf(scenarioWith(type, {2, 3}), bt::TreeStyle::Corrected));
      QCOMPARE(
          QByteArray::fromStdString(found),
          QByteArray(R"(<BehaviorTree ID="RegularNavTree"><Fallback name="RegularNavFallback">)") +
              kGoals + expected);
    }
  }

  void corrected_repeatedReaction_isNotWrapped() {
    sim2d::Scenario scenario = scenarioWith(BehaviorType::Scared, {1});
    scenario.humans.front().behavior.once = false;
    const std::string text = textOf(scenario, bt::TreeStyle::Corrected);
    QVERIFY(text.find("ForceFailure>") == std::string::npos);
    QVERIFY(text.find("<AvoidRobot agent_id=\"{id}\"") != std::string::npos);
  }

  void q31_reactionSpeed_isVelAndMaxVelOnDemand() {
    const sim2d::Scenario scenario = scenarioWith(BehaviorType::Curious, {1});
    sim2d::Compatibility quirks;
    quirks.set(31);
    const bt::NodeLibrary library = bt::humanNodes();
    const bt::TreeFile file =
        bt::makeTree(scenario, scenario.humans.front(), library.catalogue(), quirks);
    const std::string text = bt::writeTree(file, library.catalogue());
    QVERIFY(text.find("max_vel=\"1.9\"") != std::string::npos);
  }

  void q30_visibility_isTestedOnceOnDemand() {
    const sim2d::Scenario scenario = scenarioWith(BehaviorType::Curious, {1});
    sim2d::Compatibility quirks;
    quirks.set(30);
    const bt::NodeLibrary library = bt::humanNodes();
    const bt::TreeFile file =
        bt::makeTree(scenario, scenario.humans.front(), library.catalogue(), quirks);
    const std::vector<bt::NodeSpec>& children = file.trees.front().root.children[1].children;
    QVERIFY(children[0].id == "RunOnce" && children[0].children[0].id == "IsRobotVisible");
    QVERIFY(children[1].id == "RunOnce" && children[1].children[0].id == "ApproachRobot");
  }

  void q32_withoutGoals_hasNoGoalBlock() {
    const sim2d::Scenario scenario = scenarioWith(BehaviorType::Regular, {});
    const bt::NodeLibrary library = bt::humanNodes();
    const bt::TreeFile file = bt::makeTree(scenario, scenario.humans.front(), library.catalogue());
    QCOMPARE(file.trees.front().root.children.size(), std::size_t(2));
    sim2d::Compatibility quirks;
    quirks.set(32);
    const bt::TreeFile old =
        bt::makeTree(scenario, scenario.humans.front(), library.catalogue(), quirks);
    const bt::NodeSpec& block = old.trees.front().root.children.front();
    QVERIFY(block.children.size() == 1 && block.children[0].id == "RunOnce");
  }

  void generated_ofEachBehaviourAndStyle_loadsWithoutWarning_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("isCorrected");
    for (int type = 1; type <= 6; ++type) {
      for (const bool isCorrected : {true, false}) {
        QTest::addRow("%s %s", sim2d::behaviorName(static_cast<BehaviorType>(type)),
                      isCorrected ? "corrected" : "hunav2")
            << type << isCorrected;
      }
    }
  }
  void generated_ofEachBehaviourAndStyle_loadsWithoutWarning() {
    QFETCH(int, type);
    QFETCH(bool, isCorrected);
    const bt::NodeLibrary library = bt::humanNodes();
    const sim2d::Scenario scenario = scenarioWith(static_cast<BehaviorType>(type), {1, 3, 2});
    QTemporaryDir folder;
    const std::string stem = folder.path().toStdString() + "/";
    const std::string path = stem + bt::treeFileName("demo", 1);
    QVERIFY(base::writeFileAtomically(stem + bt::kRegularNavFile,
                                      bt::regularNavText(library.catalogue()))
                .empty());
    const bt::TreeStyle style = isCorrected ? bt::TreeStyle::Corrected : bt::TreeStyle::Hunav2;
    QVERIFY(base::writeFileAtomically(path, textOf(scenario, style)).empty());
    base::Result<bt::TreeTable> table = bt::loadTrees(path);
    QVERIFY2(table,
             base::hasErrors(table.diagnostics()) ? table.diagnostics()[0].text().c_str() : "");
    const auto program = bt::compile(*table, library);
    for (const base::Diagnostic& diagnostic : program.diagnostics()) {
      QFAIL(diagnostic.text().c_str());
    }
    QVERIFY(program);
    QVERIFY(bt::treeGoals(*table) == (std::vector<int>{1, 3, 2}));
    QVERIFY(
        bt::checkAgentTree(*table, scenario.humans.front(), scenario, library.catalogue()).empty());
  }

  void hunav2_layout_isThePanels() {
    const std::string text =
        textOf(scenarioWith(BehaviorType::Scared, {2, 3}), bt::TreeStyle::Hunav2);
    QVERIFY(text.rfind("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<root main_tree_to_execute=\"ScaredNavTree\" BTCPP_format=\"4\">\n",
                       0) == 0);
    QVERIFY(text.find("</TreeNodesModel>\n  <include path=\"BTRegularNav.xml\" />\n\n"
                      "    <BehaviorTree ID=\"ScaredNavTree\">\n") != std::string::npos);
    QVERIFY(text.find("</BehaviorTree>\n</root>\n") != std::string::npos);
    const char* const reaction =
        R"(<Sequence name="ScaNav"><RunOnce><IsRobotVisible agent_id="{id}" distance="4.25"/></RunOnce>)"
        R"(<RunOnce><AvoidRobot agent_id="{id}" time_step="{dt}" runaway_vel="1.9" safe_distance="6" duration="30"/>)"
        R"(</RunOnce></Sequence>)";
    QCOMPARE(QByteArray::fromStdString(treeElement(text)),
             QByteArray(R"(<BehaviorTree ID="ScaredNavTree"><Fallback name="ScaredFallback">)") +
                 kGoals + reaction + kRegNav);
  }

  void hunav2_wrapperLayout_isThatOfItsSimulators() {
    sim2d::Scenario scenario = scenarioWith(BehaviorType::Curious, {2, 3});
    scenario.simulator = "Isaac Sim";
    const std::string text = textOf(scenario, bt::TreeStyle::Hunav2);
    const char* const expected = R"(</TreeNodesModel>

<include path="BTRegularNav.xml" />


<!--<BehaviorTree ID="CuriousNavTree">-->
<BehaviorTree ID="DefaultTree">
  <Fallback name="CuriousFallback">
    <!-- Goal setting Sequence -->
    <Sequence name="SetGoals">
        <RunOnce>
          <SetGoal agent_id="{id}" goal_id="2"/>
        </RunOnce>
        <Inverter>
          <RunOnce>
            <SetGoal agent_id="{id}" goal_id="3"/>
          </RunOnce>
        </Inverter>

    </Sequence>
    <Sequence name="CurNav">
      <IsRobotVisible agent_id="{id}" distance="4.25"/>
      <Inverter>
        <TimeExpiredCondition seconds="30" ts="{dt}" only_once="true"/>
      </Inverter>
      <CuriousNav agent_id="{id}" time_step="{dt}" stop_distance="1.33333" agent_vel="1.9"/>
    </Sequence>
    <Sequence name="RegNav">
      <SetBlackboard output_key="agentid" value="{id}"/>
      <SetBlackboard output_key="timestep" value="{dt}"/>
      <SubTree ID="RegularNavTree" id="{agentid}" dt="{timestep}"/>
    </Sequence>
  </Fallback>
</BehaviorTree>



</root>

)";
    QCOMPARE(QByteArray::fromStdString(text.substr(text.find("</TreeNodesModel>"))),
             QByteArray(expected));
    QVERIFY(text.find("<root main_tree_to_execute=\"DefaultTree\" BTCPP_format=\"4\">") !=
            std::string::npos);
  }

  void hunav2_withoutKeys_takesThePanelsDefaults() {
    sim2d::Scenario scenario = scenarioWith(BehaviorType::Curious, {});
    scenario.humans.front().behavior = {};
    scenario.humans.front().behavior.type = BehaviorType::Curious;
    scenario.humans.front().maxVel.reset();
    const std::string text = treeElement(textOf(scenario, bt::TreeStyle::Hunav2));
    QVERIFY(text.find(R"(distance="5")") != std::string::npos);
    QVERIFY(text.find(R"(closest_dist="1.5" max_vel="2" duration="40")") != std::string::npos);
    QVERIFY(
        text.find(
            R"(<Sequence name="SetGoals"><RunOnce><SetGoal agent_id="{id}" goal_id="1"/></RunOnce></Sequence>)") !=
        std::string::npos);
  }

  void model_namesTheNodesOfHuNavSimAlone() {
    const sim2d::Scenario scenario = scenarioWith(BehaviorType::Regular, {1});
    const bt::TreeFile file =
        bt::makeTree(scenario, scenario.humans.front(), bt::humanNodes().catalogue());
    QVERIFY(file.model.has_value());
    QCOMPARE(file.model->children.size(), std::size_t(39));
  }

  void shortNumber_hasSixDigits_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("whole") << 40.0 << QByteArray("40");
    QTest::newRow("half") << 1.5 << QByteArray("1.5");
    QTest::newRow("noise") << 1.8999999999999999 << QByteArray("1.9");
    QTest::newRow("many") << 3.14159265 << QByteArray("3.14159");
    QTest::newRow("small") << 0.05 << QByteArray("0.05");
  }
  void shortNumber_hasSixDigits() {
    QFETCH(double, value);
    QFETCH(QByteArray, text);
    QCOMPARE(QByteArray::fromStdString(bt::shortNumber(value)), text);
  }

  void treeFileName_hasTwoUnderscores() {
    QVERIFY(bt::treeFileName("cafe_agents", 12) == "cafe_agents__agent_12_bt.xml");
  }

  void checkAgentTree_badWeights_warns() {
    const base::Diagnostics found = problemsOf(
        "\n<ProbabilityChoice weights='3;1'><AlwaysSuccess/><AlwaysFailure/></ProbabilityChoice>\n"
        "<ProbabilityChoice weights='3;1;1'><AlwaysSuccess/></ProbabilityChoice>\n"
        "<ProbabilityChoice weights='often'><AlwaysSuccess/></ProbabilityChoice>\n",
        scenarioWith(BehaviorType::Regular, {}));
    QCOMPARE(found.size(), std::size_t(2));
    QCOMPARE(found[0].line, 3);
    QCOMPARE(found[1].line, 4);
  }

  void checkAgentTree_strangeIds_warns() {
    const base::Diagnostics found = problemsOf(
        "\n<SetGoal agent_id='{id}' goal_id='7'/>\n"
        "<LookAtAgent observer_id='{id}' target_id='5'/>\n"
        "<SetGroupWalk main_agent_id='1' non_main_agent_ids='1,8'/>",
        scenarioWith(BehaviorType::Regular, {1, 2}));
    QCOMPARE(found.size(), std::size_t(4));  // goal 7, person 5, person 8, other goals
    QCOMPARE(found[0].line, 2);
    QCOMPARE(found[1].line, 3);
    QVERIFY(!base::hasErrors(found));
  }

  /// Two numbers of one place are one goal, as files have them that name each person's goals.
  void checkAgentTree_otherNumbersOfTheSamePlaces_isSilent() {
    sim2d::Scenario scenario = scenarioWith(BehaviorType::Regular, {3, 4});
    scenario.goals.at(2).position = base::Vec2(1.0, 0.0);         // as goal 1
    scenario.goals.push_back({{}, 4, base::Vec2(2.0, 0.0), {}});  // as goal 2
    const auto check = [&](const std::vector<int>& goals) {
      scenario.humans.front().goals = goals;
      return problemsOf(
          "<SetGoal agent_id='{id}' goal_id='1'/><SetGoal agent_id='{id}' goal_id='2'/>", scenario);
    };
    QVERIFY(check({3, 4}).empty());
    QVERIFY(check({3, 2}).empty());
    for (const std::vector<int>& other : {std::vector<int>{4, 3}, {3}, {3, 4, 3}}) {
      const base::Diagnostics found = check(other);
      QCOMPARE(found.size(), std::size_t(1));
      QVERIFY(found[0].code == "tree.other-goals");
    }
  }
};

QTEST_APPLESS_MAIN(HumanTemplatesTest)
#include "tst_HumanTemplates.moc"
