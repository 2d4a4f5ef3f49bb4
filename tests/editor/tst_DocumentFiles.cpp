#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include "DocumentChecks.h"
#include "editor/document/Autosave.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"

using namespace editor;
using small::check;
using small::kOwnTree;

class DocumentFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void save_andOpenAgain_givesAnEqualDocument() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("scenarios/room_agents.yaml"));
    small::Document document;
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
    small::Document document(false);
    const EntityId ana{EntityKind::Human, 1};
    const std::string xml =
        "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
        "    <Sequence name=\"nothing else\">\n      <AlwaysSuccess/>\n    </Sequence>\n"
        "  </BehaviorTree>\n</root>\n";
    pushTrees(document, {{ana, xml}}, QStringLiteral("Tree"));
    check(document.save(path));
    ScenarioDocument again;
    check(again.open(path));
    const EntityId same = again.entities(EntityKind::Human).front();
    QVERIFY(again.tree(same) == xml);
  }

  void saveAs_otherFolder_keepsMapAndTreesReachable() {
    const QTemporaryDir folder;
    small::Document document;
    check(document.save(folder.filePath(QStringLiteral("a/first.yaml"))));
    check(document.save(folder.filePath(QStringLiteral("b/second.yaml"))));
    QVERIFY(document.scenario().yamlBaseName == std::string("second"));
    ScenarioDocument again;
    check(again.open(folder.filePath(QStringLiteral("b/second.yaml"))));
    QVERIFY(*again.map() == *document.map());
    QVERIFY(again.scenario() == document.scenario());
  }

  void open_missingFile_changesNothing() {
    small::Document document(false);
    QVERIFY(base::hasErrors(document.open(QStringLiteral("/nowhere/at/all.yaml"))));
    QVERIFY(document.scenario() == small::scenario());
  }

  void open_nothingReadable_isShownUnderItsNameUnlessAnotherIsOpen() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("wrong.yaml"));
    check(base::writeFileAtomically(path.toStdString(), "agents: [\n"));
    ScenarioDocument document;
    QVERIFY(base::hasErrors(document.open(path)));
    QCOMPARE(document.displayName(), QStringLiteral("wrong.yaml"));
    QVERIFY(document.isReadOnly());
    QVERIFY(base::hasErrors(document.issues()));
    QVERIFY(base::hasErrors(document.save(path)));
    small::Document busy(false);
    QVERIFY(base::hasErrors(busy.open(path)));
    QVERIFY(busy.scenario() == small::scenario());
    QVERIFY(!busy.isReadOnly());
  }

  void checkNow_startInWall_isTold() {
    small::Document document;
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

  void save_oneFileCannotBeWritten_leavesAllAsTheyWere() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document document(false);
    check(document.save(path));
    const std::map<QString, std::string> before = contentOf(folder);
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(1.0, 0.0));
    pushRoute(document, {{EntityKind::Human, 1}}, {3});
    const QString tree = folder.filePath(QStringLiteral("room__agent_6_bt.xml"));
    QVERIFY(QFile::remove(tree));
    QVERIFY(QDir().mkdir(tree));  // no file can be put there
    QVERIFY(base::hasErrors(document.save(path)));
    QVERIFY(document.isDirty());
    QVERIFY(QDir().rmdir(tree));
    std::map<QString, std::string> after = contentOf(folder);
    after[QFileInfo(tree).fileName()] = before.at(QFileInfo(tree).fileName());
    QVERIFY(after == before);
  }

  void save_nothingChanged_writesNothing() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document document(false);
    check(document.save(path));
    const QFileInfo first(path);
    const QDateTime written = first.lastModified();
    QTest::qWait(20);
    check(document.save(path));
    QCOMPARE(QFileInfo(path).lastModified(), written);
    QVERIFY(document.changedOnDisk().isEmpty());
  }

  void open_damagedFile_isShownAndNeverWrittenOver() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    sim2d::Scenario scenario = small::scenario();
    scenario.desktop.mapFile = "none";
    std::string text = sim2d::writeScenario(scenario);
    text.replace(text.find("id: 1"), 5, "id: one");
    check(base::writeFileAtomically(path.toStdString(), text));
    ScenarioDocument document;
    QVERIFY(base::hasErrors(document.open(path)));
    QVERIFY(document.isReadOnly());
    QCOMPARE(document.scenario().humans.size(), small::scenario().humans.size());
    bool hasLine = false;
    for (const base::Diagnostic& issue : document.issues()) {
      hasLine = hasLine || (issue.severity == base::Severity::Error && issue.line > 0);
    }
    QVERIFY(hasLine);
    pushMove(document, {document.entities(EntityKind::Human)[1]}, Vec2(0.1, 0.0));
    QVERIFY(base::hasErrors(document.save(path)));
    QVERIFY(*base::readTextFile(path.toStdString()) == text);
    const QString other = folder.filePath(QStringLiteral("mended.yaml"));
    check(document.save(other));
    QVERIFY(!document.isReadOnly());
    QVERIFY(!base::hasErrors(document.issues()));  // those of the damaged file are not its own
    QVERIFY(*base::readTextFile(path.toStdString()) == text);
    ScenarioDocument mended;
    check(mended.open(other));
    QCOMPARE(mended.scenario().humans.size(), small::scenario().humans.size());
  }

  void changedOnDisk_anotherProgramWrites_isNoticedOnce() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document document;
    check(document.save(path));
    QVERIFY(document.changedOnDisk().isEmpty());
    check(base::writeFileAtomically(treePath(folder, 2), kOwnTree));
    check(base::writeFileAtomically(path.toStdString(), "changed"));
    QCOMPARE(document.changedOnDisk().size(), 2);
    document.acceptDiskChanges();
    QVERIFY(document.changedOnDisk().isEmpty());
  }

  void snapshot_writtenAndRestored_isTheUnsavedDocument() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a/room.yaml"));
    small::Document document;
    check(document.save(path));
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(0.5, 0.0));
    const EntityId ben{EntityKind::Human, 2};
    pushTrees(document, {{ben, kOwnTree}}, QStringLiteral("Tree"));
    MapStroke stroke(document.map());
    stroke.paint({6.0, 4.2}, {6.0, 4.8}, 0.1, MapPaint::Occupied);
    pushStroke(document, stroke, QStringLiteral("Paint"));
    QVERIFY(document.map()->isWall(document.map()->worldToCell({6.0, 4.5})));
    const QString copy = folder.filePath(QStringLiteral("copy"));
    check(base::writeFilesAtomically(snapshotFiles(document.snapshot(), copy)));

    base::Result<DocumentSnapshot> read = readSnapshot(copy);
    QVERIFY(bool(read));
    QVERIFY(read.diagnostics().empty());  // nothing about the name of the copy
    ScenarioDocument again;
    again.restore(*std::move(read));
    QVERIFY(again.isDirty());
    QCOMPARE(again.path(), document.path());
    QVERIFY(again.scenario() == sim2d::withoutDefaults(document.scenario()));
    QVERIFY(*again.map() == *document.map());
    QVERIFY(again.tree(again.entities(EntityKind::Human)[1]) == kOwnTree);
    check(again.save(path));
    ScenarioDocument saved;
    check(saved.open(path));
    QVERIFY(*saved.map() == *document.map());
    QVERIFY(saved.tree(saved.entities(EntityKind::Human)[1]) == kOwnTree);
  }

  void checkNow_afterSaving_issuesHaveLines() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document document;
    pushMove(document, {{EntityKind::Human, 3}}, Vec2(-1.5, 0.5));  // into the wall
    check(document.save(path));
    document.checkNow();
    const std::string text = *base::readTextFile(path.toStdString());
    int aboutChloe = 0;
    for (const base::Diagnostic& issue : document.issues()) {
      if (issue.entity == EntityId({EntityKind::Human, 3})) {
        ++aboutChloe;
        QVERIFY(issue.line > 0);
        const QStringList lines = QString::fromStdString(text).split(QLatin1Char('\n'));
        QVERIFY(lines[issue.line - 1].contains(QStringLiteral("Chloe")));
      }
    }
    QVERIFY(aboutChloe > 0);
  }

 private:
  static std::string treePath(const QTemporaryDir& folder, int id) {
    return folder.filePath(QStringLiteral("room__agent_%1_bt.xml").arg(id)).toStdString();
  }
  /// Name and content of every file, temporary ones too.
  static std::map<QString, std::string> contentOf(const QTemporaryDir& folder) {
    std::map<QString, std::string> result;
    for (const QFileInfo& file :
         QDir(folder.path()).entryInfoList(QDir::Files | QDir::Hidden | QDir::System)) {
      result[file.fileName()] = *base::readTextFile(file.filePath().toStdString());
    }
    return result;
  }
};

QTEST_MAIN(DocumentFilesTest)
#include "tst_DocumentFiles.moc"
