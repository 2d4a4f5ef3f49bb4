#include <QtTest>

#include "bt/human/BehaviorBlocks.h"
#include "bt/human/TreeGenerator.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"

using bt::Block;
using bt::BlockRepeat;

namespace {

const bt::NodeCatalogue& catalogue() {
  static const bt::NodeLibrary library = bt::humanNodes();
  return library.catalogue();
}

sim2d::Human curious() {
  sim2d::Human human;
  human.name = "Chloe";
  human.id = 1;
  human.goals = {2, 1};
  human.behavior.type = sim2d::BehaviorType::Curious;
  return human;
}

std::vector<std::string> namesBelowRoot(const bt::TreeSpec& tree) {
  std::vector<std::string> names;
  for (const bt::NodeSpec& child : tree.root.children) {
    names.push_back(child.label());
  }
  return names;
}

}  // namespace

class BehaviorBlocksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void kinds_areTheTenOfTheWizard() {
    const std::vector<std::string> expected = {
        "EngageRobot",       "TalkInteract",      "RobotAvoidance",  "FollowAgent",
        "BlockingBehavior",  "GroupFormation",    "SpeechDetection", "AttentionSeeking",
        "GreetingInitiator", "ProtectiveGuardian"};
    QCOMPARE(bt::blockTypes().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QCOMPARE(bt::blockTypes()[i].id, expected[i]);
    }
    const bt::BlockParameter* guard = bt::blockType("ProtectiveGuardian")->parameter("robot");
    QCOMPARE(guard->min, 5.0);
    QCOMPARE(guard->max, 25.0);
    QCOMPARE(guard->initial, std::string("15"));
    QCOMPARE(bt::blockType("Dance"), static_cast<const bt::BlockType*>(nullptr));
  }

  void block_anyKind_isValidAndReadBack_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("mode");
    for (const bt::BlockType& kind : bt::blockTypes()) {
      const bt::BlockParameter* mode = kind.parameter("mode");
      const std::vector<std::string> modes =
          mode != nullptr ? mode->choices : std::vector<std::string>{""};
      for (const std::string& each : modes) {
        QTest::newRow((kind.id + " " + each).c_str())
            << QString::fromStdString(kind.id) << QString::fromStdString(each);
      }
    }
  }
  void block_anyKind_isValidAndReadBack() {
    QFETCH(QString, id);
    QFETCH(QString, mode);
    for (const BlockRepeat repeat : {BlockRepeat::Always, BlockRepeat::Once, BlockRepeat::Random}) {
      Block block{id.toStdString(), {}, repeat, 0.25};
      if (!mode.isEmpty()) {
        block.values["mode"] = mode.toStdString();
      }
      if (bt::blockType(block.id)->parameter("people") != nullptr) {
        block.values["people"] = "3,4";
      }
      const bt::BlockParameter* duration = bt::blockType(block.id)->parameter("duration");
      if (duration != nullptr &&
          (duration->mode.empty() || duration->mode == block.value("mode"))) {
        block.values["duration"] = "12.5";
      }
      bt::TreeFile file;
      file.mainTree = "T";
      file.trees.resize(1);
      file.trees[0].id = "T";
      file.trees[0].root = bt::branchNode("Fallback", "Root", {});
      QVERIFY(bt::setBlocks(file.trees[0], {block}));
      const bt::TreeIssues issues = bt::checkTree(file.trees[0], catalogue(), {"T"});
      QVERIFY2(issues.empty(), issues.empty() ? "" : issues[0].diagnostic.message.c_str());
      const base::Result<bt::TreeFile> read = bt::readTreeText(bt::writeTree(file, catalogue()));
      QVERIFY(read);
      const std::vector<Block> found = bt::blocksOf(read->trees[0]);
      QCOMPARE(found.size(), std::size_t(1));
      QVERIFY(found[0] == block);
      QCOMPARE(found[0].value("duration"), block.value("duration"));
    }
  }

  void setBlocks_generatedTree_keepsGoalsAndReaction() {
    bt::TreeFile file = bt::makeTree({}, curious(), catalogue());
    const bt::TreeFile before = file;
    QVERIFY(bt::setBlocks(file.trees[0], {{"GreetingInitiator", {}}, {"RobotAvoidance", {}}}));
    QCOMPARE(namesBelowRoot(file.trees[0]),
             (std::vector<std::string>{"SetGoals", "GreetingInitiatorBlock", "RobotAvoidanceBlock",
                                       "CurNav", "RegNav"}));
    std::vector<Block> blocks = bt::blocksOf(file.trees[0]);
    std::swap(blocks[0], blocks[1]);
    QVERIFY(bt::setBlocks(file.trees[0], blocks));
    QCOMPARE(namesBelowRoot(file.trees[0])[1], std::string("RobotAvoidanceBlock"));
    QVERIFY(bt::setBlocks(file.trees[0], {}));
    QVERIFY(file == before);
  }

  void setGoals_replacesTheirPart() {
    bt::TreeFile file = bt::makeTree({}, curious(), catalogue());
    QVERIFY(bt::setTreeGoals(file.trees[0], {3}));
    sim2d::Human other = curious();
    other.goals = {3};
    QVERIFY(file == bt::makeTree({}, other, catalogue()));
  }

  void rootWithoutFallback_isLeftAlone() {
    bt::TreeSpec tree;
    tree.root = bt::branchNode("Sequence", "Root", {});
    QVERIFY(!bt::setBlocks(tree, {{"EngageRobot", {}}}));
    QVERIFY(tree.root.children.empty());
  }

  void read_onceAsTheWizardWritesIt() {
    bt::NodeSpec block = bt::blockToNode({"EngageRobot", {{"distance", "2"}}});
    for (bt::NodeSpec& child : block.children) {
      child = bt::around("RunOnce", child);
    }
    const std::optional<Block> read = bt::readBlock(block);
    QVERIFY(read);
    QCOMPARE(read->repeat, BlockRepeat::Once);
    QCOMPARE(read->value("distance"), std::string("2"));
  }

  void read_changedByHand_isNoBlock() {
    bt::NodeSpec block = bt::blockToNode({"EngageRobot", {}});
    bt::setAttribute(block.children[1].ports, "yaw_tolerance", "0.5");
    QVERIFY(!bt::readBlock(block));
    block = bt::blockToNode({"EngageRobot", {}});
    block.children.pop_back();
    QVERIFY(!bt::readBlock(block));
    QVERIFY(!bt::readBlock(bt::branchNode("Sequence", "DanceBlock", {})));
  }

  void ports_areThoseOfTheOriginalManager() {
    // ApproachAgent of HuNavSim 2.0 knows no distance and no speed.
    for (const bt::BlockType& kind : bt::blockTypes()) {
      const std::string text = [&] {
        bt::TreeFile file;
        file.trees.resize(1);
        file.trees[0].id = "T";
        file.trees[0].root = bt::blockToNode({kind.id, {}, BlockRepeat::Random});
        return bt::writeTree(file, catalogue());
      }();
      const std::size_t approach = text.find("<ApproachAgent");
      if (approach != std::string::npos) {
        QVERIFY(text.substr(approach, text.find("/>", approach) - approach).find("max_vel") ==
                std::string::npos);
      }
      QVERIFY(text.find("RandomChanceCondition agent_id") == std::string::npos);
    }
  }
};

QTEST_APPLESS_MAIN(BehaviorBlocksTest)
#include "tst_BehaviorBlocks.moc"
