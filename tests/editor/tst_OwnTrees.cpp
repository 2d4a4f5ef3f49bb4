#include <algorithm>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "DocumentChecks.h"
#include "bt/human/TreeLoader.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"

using namespace editor;
using small::check;
using small::kOwnTree;

namespace {

/// The small scenario, to be saved in a folder of its own.
struct Room {
  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("room.yaml"));
  small::Document document{false};

  std::string treePath(int id) const {
    return folder.filePath(QStringLiteral("room__agent_%1_bt.xml").arg(id)).toStdString();
  }
  std::string treeText(int id) const {
    const auto text = base::readTextFile(treePath(id));
    return text.diagnostics().empty() ? *text : std::string();
  }
};

struct SavedRoom : Room {
  SavedRoom() { check(document.save(path)); }
};

}  // namespace

/// Trees that somebody wrote, when the scenario around them changes and is saved.
class OwnTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void save_goalsChanged_generatedTreeFollowsSilently() {
    SavedRoom room;
    ScenarioDocument& document = room.document;
    const std::string before = room.treeText(1);
    pushRoute(document, {{EntityKind::Human, 1}}, {3});
    QVERIFY(document.treeConflicts(room.path).empty());
    check(document.save(room.path));
    QVERIFY(room.treeText(1) != before);
    QVERIFY(editor::generatedStyle(room.treeText(1), document.scenario(),
                                   *document.human({EntityKind::Human, 1})));
  }

  void undo_ofAnEditThatABlockTreeFollows_leavesItUpToDate() {
    SavedRoom room;
    ScenarioDocument& document = room.document;
    const EntityId person{EntityKind::Human, 1};
    pushAddBlock(document, {person}, {"GreetingInitiator", {}});
    check(document.save(room.path));
    pushRoute(document, {person}, {3});
    QVERIFY(!document.isTreeOutdated(person));
    document.undoStack().undo();
    QVERIFY(!document.isTreeOutdated(person));
    QVERIFY(document.treeConflicts(room.path).empty());
  }

  void save_treeOfTheOriginalsStyle_staysInItsStyle() {
    SavedRoom room;
    ScenarioDocument& document = room.document;
    const EntityId chloe{EntityKind::Human, 3};
    const std::string theirs =
        generatedTree(document.scenario(), *document.human(chloe), bt::TreeStyle::Hunav2);
    check(base::writeFileAtomically(room.treePath(3), theirs));
    ScenarioDocument again;
    check(again.open(room.path));
    const EntityId same = again.entities(EntityKind::Human)[2];
    QVERIFY(!again.tree(same));
    QVERIFY(again.treeToRun(same) == theirs);
    check(again.save(room.path));
    QVERIFY(room.treeText(3) == theirs);
    pushRoute(again, {same}, {2, 3});
    QVERIFY(again.treeConflicts(room.path).empty());
    check(again.save(room.path));
    QVERIFY(generatedStyle(room.treeText(3), again.scenario(), *again.human(same)) ==
            bt::TreeStyle::Hunav2);
    QVERIFY(room.treeText(3) != theirs);
  }

  void treeQuestions_goalsOfAnOwnTreeChanged_asksAndObeys_data() {
    QTest::addColumn<bool>("keeps");
    QTest::newRow("keep mine") << true;
    QTest::newRow("take the generated one") << false;
  }

  void treeQuestions_goalsOfAnOwnTreeChanged_asksAndObeys() {
    QFETCH(bool, keeps);
    Room room;
    ScenarioDocument& document = room.document;
    const EntityId ana{EntityKind::Human, 1};
    pushTrees(document, {{ana, kOwnTree}}, QStringLiteral("Tree"));
    QVERIFY(document.treeConflicts(room.path).empty());
    check(document.save(room.path));
    pushRoute(document, {ana}, {3});
    const std::vector<TreeConflict> questions = document.treeConflicts(room.path);
    QCOMPARE(questions.size(), std::size_t(1));
    QVERIFY(questions[0].human == ana);
    QVERIFY(questions[0].why == TreeConflict::Why::BehaviourChanged);
    QVERIFY(questions[0].mine == kOwnTree);
    QVERIFY(questions[0].replacement == generatedTree(document.scenario(), *document.human(ana)));
    check(document.save(room.path, keeps ? TreeReplacements() : TreeReplacements{ana}));
    QVERIFY((room.treeText(1) == kOwnTree) == keeps);
    QVERIFY(document.tree(ana).has_value() == keeps);
    QVERIFY(document.treeConflicts(room.path).empty());  // asked once per change
    QVERIFY(!document.isDirty());
    document.undoStack().undo();
    QVERIFY(document.isDirty());
  }

  void treeQuestions_treeEditedByAnotherProgram_isNeverReplacedInSilence() {
    SavedRoom room;
    ScenarioDocument& document = room.document;
    check(base::writeFileAtomically(room.treePath(1), kOwnTree));
    pushRoute(document, {{EntityKind::Human, 1}}, {3});
    const std::vector<TreeConflict> questions = document.treeConflicts(room.path);
    QCOMPARE(questions.size(), std::size_t(1));
    QVERIFY(questions[0].why == TreeConflict::Why::ChangedOnDisk);
    QVERIFY(questions[0].mine == kOwnTree);
    check(document.save(
        room.path));  // no answer: what is there stays, and is the person's from now on
    QVERIFY(room.treeText(1) == kOwnTree);
    QVERIFY(document.tree({EntityKind::Human, 1}) == kOwnTree);
    document.undoStack().undo();
    check(document.save(room.path, {EntityId{EntityKind::Human, 1}}));
    QVERIFY(editor::generatedStyle(room.treeText(1), document.scenario(),
                                   *document.human({EntityKind::Human, 1})));
  }

  void treeQuestions_onlyACommentAddedByAnotherProgram_asksAndKeepsIt() {
    SavedRoom room;
    ScenarioDocument& document = room.document;
    const std::string theirs = room.treeText(1) + "<!-- not before Monday -->\n";
    check(base::writeFileAtomically(room.treePath(1), theirs));
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(0.1, 0.0));
    QCOMPARE(document.treeConflicts(room.path).size(), std::size_t(1));
    check(document.save(room.path));
    QVERIFY(room.treeText(1) == theirs);
  }

  void open_commentInAGeneratedTree_isAskedForAndNotReplaced() {
    SavedRoom room;
    const std::string theirs = room.treeText(1) + "<!-- not before Monday -->\n";
    check(base::writeFileAtomically(room.treePath(1), theirs));
    ScenarioDocument again;
    check(again.open(room.path));
    const EntityId ana = again.entities(EntityKind::Human)[0];
    QVERIFY(again.tree(ana) == theirs);
    sim2d::Human brave = *again.human(ana);
    brave.behavior.type = brave.behavior.type == sim2d::BehaviorType::Curious
                              ? sim2d::BehaviorType::Scared
                              : sim2d::BehaviorType::Curious;
    QVERIFY(!updatedTree(again, brave));
    pushRoute(again, {ana}, {3});
    const std::vector<TreeConflict> questions = again.treeConflicts(room.path);
    QCOMPARE(questions.size(), std::size_t(1));
    QVERIFY(questions[0].why == TreeConflict::Why::BehaviourChanged);
    QVERIFY(questions[0].mine == theirs);
    check(again.save(room.path));
    QVERIFY(room.treeText(1) == theirs);
  }

  void checkNow_treeFileIsWrong_issuesSayWhatTheRunWouldSay_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("cut off") << QByteArray(kOwnTree).left(70);
    QTest::newRow("unknown node") << QByteArray(kOwnTree).replace("AlwaysSuccess", "Dance");
    QTest::newRow("include is lost") << QByteArray(kOwnTree).replace(
        "  <BehaviorTree", "  <include path='no.xml'/><BehaviorTree");
    QTest::newRow("goals of others") << QByteArray(kOwnTree).replace(
        "<AlwaysSuccess/>", "<SetGoal agent_id='{id}' goal_id='77'/>");
  }

  void checkNow_treeFileIsWrong_issuesSayWhatTheRunWouldSay() {
    QFETCH(QByteArray, text);
    SavedRoom room;
    for (const int id : {1, 2}) {  // the same text in two files
      check(base::writeFileAtomically(room.treePath(id), text.toStdString()));
    }
    ScenarioDocument again;
    check(again.open(room.path));
    again.checkNow();
    const std::vector<std::string> told = textsOf(again.issues());
    for (const int id : {1, 2}) {
      base::Diagnostics wanted;
      bt::TreeLoader(again.scenario())
          .load(*again.scenario().humanById(id), room.treePath(id), wanted);
      QVERIFY(!wanted.empty());
      for (const std::string& one : textsOf(wanted)) {
        QVERIFY2(std::count(told.begin(), told.end(), one) > 0, one.c_str());
      }
    }
    for (const EntityId id : again.entities(EntityKind::Human)) {
      again.exchangeTree(id, std::nullopt);
    }
    again.checkNow();
    for (const std::string& one : textsOf(again.issues())) {
      QVERIFY2(one.find(".xml") == std::string::npos, one.c_str());
    }
  }

  void checkNow_ownTreeOfANewScenario_isToldByItsPerson() {
    small::Document document(false);
    const EntityId ana{EntityKind::Human, 1};
    document.exchangeTree(ana, std::string("<root BTCPP_format='4'><Behav"));
    document.checkNow();
    int told = 0;
    for (const base::Diagnostic& issue : document.issues()) {
      const bool isXml = issue.message.find("not well-formed XML") != std::string::npos;
      told += isXml && issue.entity == ana && issue.severity == base::Severity::Error ? 1 : 0;
    }
    QCOMPARE(told, 1);
  }

  void checkNow_namedTreeIsLost_isAnErrorUntilItIsThere() {
    const Room room;
    sim2d::Scenario scenario = small::scenario();
    scenario.desktop.mapFile = "none";
    scenario.humans[0].ours.tree = "lost.xml";
    check(base::writeFileAtomically(room.path.toStdString(), sim2d::writeScenario(scenario)));
    ScenarioDocument document;
    check(document.open(room.path));
    const std::string lost = room.folder.filePath(QStringLiteral("lost.xml")).toStdString();
    const auto countLost = [&] {
      document.checkNow();
      const base::Diagnostics issues = document.issues();
      return std::count_if(issues.begin(), issues.end(), [&](const base::Diagnostic& issue) {
        return issue.file == lost && issue.severity == base::Severity::Error;
      });
    };
    QCOMPARE(countLost(), std::ptrdiff_t(1));
    check(base::writeFileAtomically(lost, kOwnTree));
    QCOMPARE(countLost(), std::ptrdiff_t(0));
  }

  void saveAs_overAnOlderScenario_asksOnlyAboutTreesWrittenByHand() {
    const Room room;
    {
      small::Document old(false);
      for (const EntityId id : old.entities(EntityKind::Human)) {
        pushRoute(old, {id}, {3, 2, 1});
      }
      check(old.save(room.path));
      check(base::writeFileAtomically(room.treePath(2), kOwnTree));
    }
    small::Document document(false);
    const std::vector<TreeConflict> questions = document.treeConflicts(room.path);
    QCOMPARE(questions.size(), std::size_t(1));
    QCOMPARE(questions[0].name.c_str(), "Ben");
  }

  void saveAs_sharedTreeOfOneChanged_theOtherKeepsIt() {
    const Room room;
    check(base::writeFileAtomically(room.folder.filePath(QStringLiteral("both.xml")).toStdString(),
                                    kOwnTree));
    sim2d::Scenario scenario = small::scenario();
    scenario.map = "none_here";
    scenario.yamlBaseName = "room";
    scenario.humans[0].ours.tree = "both.xml";
    scenario.humans[1].ours.tree = "both.xml";
    check(base::writeFileAtomically(room.path.toStdString(), sim2d::writeScenario(scenario)));
    ScenarioDocument document;
    check(document.open(room.path));
    const std::vector<EntityId> people = document.entities(EntityKind::Human);
    const std::string changed = std::string(kOwnTree) + "<!-- more -->\n";
    pushTrees(document, {{people[1], changed}}, QStringLiteral("Tree"));
    check(document.save(room.path));
    ScenarioDocument again;
    check(again.open(room.path));
    QVERIFY(again.tree(again.entities(EntityKind::Human)[0]) == kOwnTree);
    QVERIFY(again.tree(again.entities(EntityKind::Human)[1]) == changed);
  }

  void save_treeFileCannotBeRead_isLeftAsItIs() {
    if (::geteuid() == 0) {
      QSKIP("the superuser may read everything");
    }
    const SavedRoom room;
    const QString file = QString::fromStdString(room.treePath(1));
    const std::string before = room.treeText(1);
    QVERIFY(QFile::setPermissions(file, QFile::WriteOwner));
    ScenarioDocument again;
    again.open(room.path);
    QVERIFY(again.treeConflicts(room.path).empty());
    for (const bool isCustom : {false, true}) {
      if (isCustom) {  // nothing may pass for saved that is not
        pushTrees(again, {{again.entities(EntityKind::Human)[0], kOwnTree}},
                  QStringLiteral("Tree"));
      }
      const base::Diagnostics told = again.save(room.path);
      QCOMPARE(told.size(), std::size_t(1));
      QCOMPARE(std::string(told[0].code), std::string("document.tree-unreadable"));
      QCOMPARE(base::hasErrors(told), isCustom);
      QCOMPARE(again.isDirty(), isCustom);
    }
    QVERIFY(QFile::setPermissions(file, QFile::ReadOwner | QFile::WriteOwner));
    QCOMPARE(room.treeText(1), before);
  }

 private:
  static std::vector<std::string> textsOf(const base::Diagnostics& found) {
    std::vector<std::string> texts;
    for (const base::Diagnostic& diagnostic : found) {
      texts.push_back(diagnostic.text());
    }
    return texts;
  }
};

QTEST_MAIN(OwnTreesTest)
#include "tst_OwnTrees.moc"
