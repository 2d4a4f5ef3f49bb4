#include <QTemporaryDir>
#include <QtTest>

#include "DocumentChecks.h"
#include "editor/document/Autosave.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "tests/support/WrittenMap.h"

using namespace editor;
using small::check;

/// The map of a document: lost, broken, typed, exchanged.
class DocumentMapsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void setMap_another_endsTheWorkOnTheFirst() {
    small::Document document;
    const base::StopFlagPtr first = document.mapStopFlag();
    first->check();
    document.checkNow();
    const base::Diagnostics issues = document.issues();
    pushMap(document, {std::make_shared<sim2d::OccupancyGrid>(), {}, false, {}},
            std::get<ScenarioSettings>(*document.entity(kSettingsId)), QStringLiteral("plane"));
    QVERIFY_EXCEPTION_THROWN(first->check(), base::Stopped);
    document.mapStopFlag()->check();
    document.undoStack().undo();  // what was worked out for the room is bound to the first flag
    document.checkNow();
    QCOMPARE(document.issues().size(), issues.size());
    QVERIFY(!base::hasErrors(document.issues()));
  }

  void newOnMap_brokenMap_changesNothing() {
    const QTemporaryDir folder;
    const QString map = folder.filePath(QStringLiteral("flat.yaml"));
    check(base::writeFileAtomically(map.toStdString(), "image: flat.png\nresolution: 0\n"));
    small::Document document(false);
    QVERIFY(base::hasErrors(document.newOnMap(map)));
    QVERIFY(document.scenario() == small::scenario());
    check(sim2d::writeMap(*small::room(), map.toStdString()));
    check(document.newOnMap(map));
    QVERIFY(document.scenario().humans.empty());
    QVERIFY(!document.isDirty() && !document.undoStack().canUndo());  // nothing is done yet
    QVERIFY(*document.map() == *small::room());
    QVERIFY(document.files().contains(map));  // and is watched
  }

  void open_scenarioWithoutItsMap_opensWithAnErrorUntilThereIsOne() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("lost.yaml"));
    check(writeOnMap(path, "no_such_map"));
    ScenarioDocument document;
    check(document.open(path));
    QVERIFY(isMapLost(document));
    QVERIFY(document.map()->isEmpty());
    check(document.save(path));
    QVERIFY(document.scenario().map == std::string("no_such_map"));
    QVERIFY(!document.scenario().desktop.mapFile);
    QVERIFY(isMapLost(document));
    const QString map = folder.filePath(QStringLiteral("another.yaml"));
    check(sim2d::writeMap(*small::room(), map.toStdString()));
    check(document.openMap(map));
    QVERIFY(!document.mapState().isMissing && !isMapLost(document));
    document.undoStack().undo();
    QVERIFY(document.mapState().isMissing && isMapLost(document));
    pushOpenPlane(document);
    QVERIFY(!document.mapState().isMissing && !isMapLost(document));
    check(document.save(path));
    QVERIFY(document.scenario().desktop.mapFile == std::string("none"));
  }

  /// What somebody writes into the settings is not written over by the map that is shown.
  void save_mapFileOfTheSettings_isKeptAndCountsFromTheNextOpening() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document first;
    check(first.save(path));
    const auto other = std::make_shared<sim2d::OccupancyGrid>(20, 10, 0.1, sim2d::Pose2{},
                                                              std::vector<std::int8_t>(200, 0));
    check(sim2d::writeMap(*other, folder.filePath(QStringLiteral("other.yaml")).toStdString()));
    for (const char* wanted : {"other.yaml", "none"}) {
      ScenarioDocument document;
      check(document.open(path));
      pushChange<ScenarioSettings>(
          document, kSettingsId, QStringLiteral("Map file"),
          [wanted](ScenarioSettings& settings) { settings.desktop.mapFile = wanted; });
      check(document.save(path));
      check(document.save(path));  // once more changes nothing
      ScenarioDocument again;
      check(again.open(path));
      QCOMPARE(*again.scenario().desktop.mapFile, std::string(wanted));
      QCOMPARE(again.map()->width(), wanted == std::string("none") ? 0 : 20);
    }
  }

  void saveAs_besideTheMapThatWasMissing_findsIt_data() {
    QTest::addColumn<bool>("isFile");
    QTest::newRow("map") << false;
    QTest::newRow("map_file") << true;
  }
  void saveAs_besideTheMapThatWasMissing_findsIt() {
    QFETCH(bool, isFile);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a/lost.yaml"));
    sim2d::Scenario scenario = small::scenario();
    (isFile ? scenario.desktop.mapFile : scenario.map) = isFile ? "hall.yaml" : "hall";
    check(base::writeFileAtomically(path.toStdString(), sim2d::writeScenario(scenario)));
    check(sim2d::writeMap(*small::room(),
                          folder.filePath(QStringLiteral("b/hall.yaml")).toStdString()));
    ScenarioDocument document;
    check(document.open(path));
    QVERIFY(document.mapState().isMissing);
    check(document.save(folder.filePath(QStringLiteral("b/found.yaml"))));
    QVERIFY2(
        !document.mapState().isMissing,
        document.mapState().isMissing ? document.mapState().problems.front().text().c_str() : "");
    QVERIFY(*document.map() == *small::room());
  }

  /// What was saved is there to be opened, wherever the map has gone.
  void save_mapsFolderIsGone_writesTheMapAgain() {
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("scenarios")));
    const QString path = folder.filePath(QStringLiteral("scenarios/room.yaml"));
    small::Document document;
    check(document.save(path));
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(0.5, 0.0));
    QDir maps(folder.filePath(QStringLiteral("maps")));
    QCOMPARE(QFileInfo(document.mapPath()).absolutePath(), maps.absolutePath());
    QVERIFY(maps.removeRecursively());
    check(document.save(path));
    ScenarioDocument again;
    check(again.open(path));
    QVERIFY(!again.mapState().isMissing);
    QVERIFY(*again.map() == *small::room());
  }

  /// Who hears of the map reads in the settings which one it is.
  void editMap_undo_settingsAreThereFirst() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("lost.yaml"));
    check(writeOnMap(path, "nowhere"));
    ScenarioDocument document;
    check(document.open(path));
    QStringList heard;
    connect(&document, &ScenarioDocument::mapChanged, this, [&] {
      heard << QString::fromStdString(document.scenario().desktop.mapFile.value_or("named"));
    });
    pushOpenPlane(document);
    document.undoStack().undo();
    QCOMPARE(heard, (QStringList{QStringLiteral("none"), QStringLiteral("named")}));
  }

  /// A crash in between makes no error a warning.
  void restore_brokenMap_isTheSameErrorAsOpening() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    small::Document document;
    check(document.save(path));
    pushMove(document, {{EntityKind::Human, 1}}, Vec2(0.5, 0.0));
    const QString copy = folder.filePath(QStringLiteral("copy"));
    check(base::writeFilesAtomically(snapshotFiles(document.snapshot(), copy)));
    check(base::writeFileAtomically(document.mapPath().toStdString(), "image: x.pgm\n"));
    for (const bool isLost : {false, true}) {
      ScenarioDocument opened;
      check(opened.open(path));
      QVERIFY(opened.mapState().isMissing);
      const base::Diagnostics asOpened = opened.mapState().problems;
      QVERIFY(base::hasErrors(asOpened));
      if (isLost) {  // already when the copy was made
        check(base::writeFilesAtomically(snapshotFiles(opened.snapshot(), copy)));
      }
      ScenarioDocument again;
      again.restore(*readSnapshot(copy));
      QVERIFY(again.mapState().isMissing);
      QCOMPARE(again.mapState().problems.size(), asOpened.size());
      QCOMPARE(again.mapState().problems.front().text(), asOpened.front().text());
      QVERIFY(base::hasErrors(again.issues()));
    }
  }

  void open_mapIsBroken_isAnErrorThatKeepsNothingShut() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("room.yaml"));
    sim2d::Scenario scenario = small::scenario();
    scenario.desktop.mapFile = "flat.yaml";
    const std::string map = folder.filePath(QStringLiteral("flat.yaml")).toStdString();
    check(base::writeFileAtomically(map, "image: flat.png\nresolution: 0\norigin: [0, 0, 0]\n"));
    check(base::writeFileAtomically(path.toStdString(), sim2d::writeScenario(scenario)));
    ScenarioDocument document;
    check(document.open(path));
    QCOMPARE(document.scenario().humans.size(), scenario.humans.size());
    bool isError = false;
    for (const base::Diagnostic& issue : document.issues()) {
      isError = isError ||
                (issue.severity == base::Severity::Error && issue.file == map && issue.line == 2);
    }
    QVERIFY(isError);
  }

  void openMap_undone_theMapBeforeIsBack() {
    const QTemporaryDir folder;
    small::Document document;
    check(document.save(folder.filePath(QStringLiteral("room.yaml"))));
    const std::string name = document.scenario().map.value_or("");
    const auto other = std::make_shared<sim2d::OccupancyGrid>(20, 10, 0.1, sim2d::Pose2{},
                                                              std::vector<std::int8_t>(200, 0));
    const QString file = folder.filePath(QStringLiteral("other.yaml"));
    check(sim2d::writeMap(*other, file.toStdString()));
    check(document.openMap(file));
    QVERIFY(*document.map() == *other);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Change map"));
    document.undoStack().undo();
    QVERIFY(*document.map() == *small::room());
    QVERIFY(document.scenario().map == name);
    document.undoStack().redo();
    QVERIFY(*document.map() == *other);
  }

 private:
  static base::Diagnostics writeOnMap(const QString& path, const char* map) {
    sim2d::Scenario scenario = small::scenario();
    scenario.map = map;
    return base::writeFileAtomically(path.toStdString(), sim2d::writeScenario(scenario));
  }
  /// As `check` tells it: an error at the key that names the map.
  static bool isMapLost(const ScenarioDocument& document) {
    const base::Diagnostics issues = document.issues();
    return std::any_of(issues.begin(), issues.end(), [](const base::Diagnostic& issue) {
      return issue.severity == base::Severity::Error && issue.line > 0 && issue.column > 0 &&
             issue.message.rfind("map 'no_such_map' not found (tried ", 0) == 0;
    });
  }
};

QTEST_MAIN(DocumentMapsTest)
#include "tst_DocumentMaps.moc"
