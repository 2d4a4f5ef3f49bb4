#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"

using namespace editor;

class DocumentFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void save_andOpenAgain_givesAnEqualDocument() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("scenarios/room_agents.yaml"));
    ScenarioDocument document;
    document.load(small::scenario());
    document.setMap(small::room());
    QVERIFY(document.isDirty());
    check(document.save(path));
    QVERIFY(!document.isDirty());
    QVERIFY(document.scenario().yamlBaseName == std::string("room_agents"));
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("behavior_trees/BTRegularNav.xml"))));
    QVERIFY(QFile::exists(
        folder.filePath(QStringLiteral("behavior_trees/room_agents__agent_3_bt.xml"))));

    ScenarioDocument again;
    check(again.open(path));
    QVERIFY(again.scenario() == document.scenario());
    QVERIFY(*again.map() == *document.map());
    for (const EntityId id : again.entities(EntityKind::Human)) {
      QVERIFY(!again.tree(id));
    }
    const std::string text = *base::readTextFile(path.toStdString());
    check(again.save(path));
    QVERIFY(*base::readTextFile(path.toStdString()) == text);
  }

  void save_ownTree_isKeptWordForWord() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    ScenarioDocument document;
    document.load(small::scenario());
    const EntityId ana{EntityKind::Human, 1};
    const std::string xml =
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
        "    <Sequence name=\"nothing else\">\n      <AlwaysSuccess/>\n    </Sequence>\n"
        "  </BehaviorTree>\n</root>\n";
    document.undoStack().push(new EditTree(document, ana, xml, QStringLiteral("Tree")));
    check(document.save(path));
    ScenarioDocument again;
    check(again.open(path));
    const EntityId same = again.entities(EntityKind::Human).front();
    QVERIFY(again.tree(same) == xml);
  }

  void saveAs_otherFolder_keepsMapAndTreesReachable() {
    const QTemporaryDir folder;
    ScenarioDocument document;
    document.load(small::scenario());
    document.setMap(small::room());
    check(document.save(folder.filePath(QStringLiteral("a/first.yaml"))));
    check(document.save(folder.filePath(QStringLiteral("b/second.yaml"))));
    QVERIFY(document.scenario().yamlBaseName == std::string("second"));
    ScenarioDocument again;
    check(again.open(folder.filePath(QStringLiteral("b/second.yaml"))));
    QVERIFY(*again.map() == *document.map());
    QVERIFY(again.scenario() == document.scenario());
  }

  void open_missingFile_changesNothing() {
    ScenarioDocument document;
    document.load(small::scenario());
    QVERIFY(base::hasErrors(document.open(QStringLiteral("/nowhere/at/all.yaml"))));
    QVERIFY(document.scenario() == small::scenario());
  }

  void open_scenarioWithoutItsMap_warnsAndOpens() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("lost.yaml"));
    sim2d::Scenario scenario = small::scenario();
    scenario.map = "no_such_map";
    check(base::writeFileAtomically(path.toStdString(), sim2d::writeScenario(scenario)));
    ScenarioDocument document;
    check(document.open(path));
    QVERIFY(!document.loadDiagnostics().empty());
    QVERIFY(document.map()->isEmpty());
    check(document.save(path));
    QVERIFY(document.scenario().map == std::string("no_such_map"));
    QVERIFY(!document.scenario().desktop.mapFile);
  }

  void checkNow_startInWall_isTold() {
    ScenarioDocument document;
    document.load(small::scenario());
    document.setMap(small::room());
    int told = 0;
    connect(&document, &ScenarioDocument::issuesChanged, this, [&told] { ++told; });
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(-2.0, 0.0));
    document.checkNow();
    QVERIFY(told >= 1);
    bool isAboutAna = false;
    for (const base::Diagnostic& issue : document.issues()) {
      isAboutAna = isAboutAna || issue.entity == EntityId({EntityKind::Human, 1});
    }
    QVERIFY(isAboutAna);
  }

 private:
  static void check(const base::Diagnostics& found) {
    for (const base::Diagnostic& diagnostic : found) {
      QVERIFY2(diagnostic.severity != base::Severity::Error, diagnostic.text().c_str());
    }
  }
};

QTEST_MAIN(DocumentFilesTest)
#include "tst_DocumentFiles.moc"
