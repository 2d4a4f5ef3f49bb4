#include <QCryptographicHash>
#include <QImage>
#include <QtTest>

#include "QuietWindow.h"
#include "RunFiles.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapScene.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"

using app::MainWindow;
using namespace outside;

namespace {

constexpr int kInstants = 20;
constexpr std::int64_t kStepsBetween = 10;

/// The demo, run for 10.5 s by the program; empty when that failed.
QString runOfDemo(const QTemporaryDir& folder, const QString& scenario = quiet::demoPath()) {
  const QString path = folder.filePath(text("run"));
  const Finished run = runProgram("run % -o % --duration 10.5 --quiet", {scenario, path});
  return run.exitCode == 0 ? path : QString();
}

/// The canvas with everything that a folder records, as if all states so far had been shown.
QImage pictureAt(MainWindow& window, std::int64_t step) {
  app::Workspace& workspace = window.workspace();
  const sim2d::Recording& recording = *workspace.runner().recording();
  const std::size_t last = recording.indexAt(step);
  for (std::size_t k = 0; k <= last; ++k) {
    workspace.scene().showFrame(recording.frame(k));
  }
  workspace.view().setCanvasState(editor::CanvasState::Past);  // its line tells one from the other
  QTest::qWait(5);
  return workspace.view().viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

QByteArray hashOf(const QImage& picture) {
  const auto* bytes = reinterpret_cast<const char*>(picture.constBits());
  return QCryptographicHash::hash(
             QByteArray::fromRawData(bytes, static_cast<int>(picture.sizeInBytes())),
             QCryptographicHash::Sha256)
      .toHex();
}

/// What the nodes returned, by person and name; those not ticked yet are left out.
std::map<std::string, base::NodeStatus> treesAt(MainWindow& window, std::int64_t step) {
  std::map<std::string, base::NodeStatus> statuses;
  for (const auto& [person, tree] : window.workspace().runner().recording()->treesAt(step)) {
    for (std::size_t k = 0; k < tree.statuses.size(); ++k) {
      if (tree.statuses[k] != base::NodeStatus::Idle) {
        statuses[std::to_string(person) + "/" + (*tree.paths)[k]] = tree.statuses[k];
      }
    }
  }
  return statuses;
}

QStringList eventsUpTo(MainWindow& window, std::int64_t step) {
  QStringList texts;
  for (const editor::RunEvent& event : window.workspace().events().events()) {
    if (event.step <= step) {
      texts << QString::number(event.step) + QLatin1Char(' ') + event.text;
    }
  }
  return texts;
}

void hideWhatIsNotRecorded(MainWindow& window) {
  editor::CanvasOptions options = window.workspace().scene().options();
  options.robotPath = options.forces = false;
  window.workspace().scene().setOptions(options);
}

}  // namespace

/// The folder of a run in the window.
class RecordedRunTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The last third of the trajectory is gone, in the midst of a line.
  void cut_trajectory_isShownWithANotice() {
    const QTemporaryDir folder;
    const QString path = runOfDemo(folder);
    QVERIFY(!path.isEmpty());
    QFile file(path + text("/trajectory.csv"));
    const QByteArray whole = bytesOf(file.fileName());
    const int length = whole.lastIndexOf('\n', 2 * whole.size() / 3) + 9;
    QVERIFY(file.resize(length));
    const int lastStep = whole.left(length).trimmed().split('\n').last().split(',').first().toInt();
    auto window = quiet::shownWindow();
    window->open(path);
    editor::SimulationRunner& runner = window->workspace().runner();
    QVERIFY(window->workspace().isRecordedRun());
    QVERIFY(runner.recording() != nullptr);
    const std::int64_t end = runner.newestFrame()->step;
    QVERIFY2(end == lastStep - 1, qPrintable(QString::number(end)));
    const QString words = quiet::noticeOf(*window, "cut-run").text;
    QVERIFY2(words.contains(text("truncated")) && words.contains(text("of 10.5 s")),
             qPrintable(words));
    QVERIFY(window->workspace().recordedName().contains(text("(truncated)")));
    QVERIFY(!runner.canBranchFromShown());
    QTest::qWait(100);
    quiet::shoot(*window, "cut_run");
    QVERIFY(window->open(quiet::demoPath()));
    QVERIFY(quiet::noticeOf(*window, "cut-run").text.isEmpty());
    const Finished measured =
        runProgram("evaluate % -o %", {path, folder.filePath(text("measured"))});
    QCOMPARE(measured.exitCode, 2);  // figures are made of whole runs alone
    QVERIFY(QFile::remove(path + text("/manifest.json")));
    QVERIFY(file.resize(1000));
    window->open(path);
    QVERIFY(window->workspace().isRecordedRun());
  }

  void canvas_atTwentyInstants_showsWhatTheLiveRunShowed() {
    const QTemporaryDir folder;
    const QString path = runOfDemo(folder);
    QVERIFY(!path.isEmpty());
    auto live = quiet::shownWindow();
    QVERIFY(live->open(quiet::demoPath()));
    hideWhatIsNotRecorded(*live);
    auto recorded = quiet::shownWindow();
    QVERIFY(recorded->open(path));
    hideWhatIsNotRecorded(*recorded);
    editor::SimulationRunner& runner = live->workspace().runner();
    QByteArray before;
    for (int instant = 1; instant <= kInstants; ++instant) {
      const std::int64_t step = instant * kStepsBetween;
      for (int k = 0; k < kStepsBetween; ++k) {
        runner.stepOnce();
      }
      QTRY_VERIFY_WITH_TIMEOUT(runner.newestFrame() && runner.newestFrame()->step == step, 20000);
      recorded->workspace().runner().seek(step);
      QCOMPARE(recorded->workspace().runner().shownFrame()->step, step);
      const QByteArray expected = hashOf(pictureAt(*live, step));
      QCOMPARE(hashOf(pictureAt(*recorded, step)), expected);
      QVERIFY(before != expected);  // something moved
      before = expected;
      QVERIFY(treesAt(*recorded, step) == treesAt(*live, step));
      QCOMPARE(eventsUpTo(*recorded, step), eventsUpTo(*live, step));
    }
    QTRY_VERIFY_WITH_TIMEOUT(recorded->workspace().feed().isCurrent(), 20000);
    QCOMPARE(recorded->workspace().feed().snapshot().frames, std::size_t{211});
    quiet::leave(live);
    quiet::leave(recorded);
  }

  void scenario_goneOrChanged_isShownAsRecorded() {
    const QTemporaryDir folder;
    const QString scenario = quiet::copyOfDemo(folder.filePath(text("demo.yaml")));
    const QString path = runOfDemo(folder, scenario);
    QVERIFY(!path.isEmpty());
    QVERIFY(QFile::remove(scenario));
    auto window = quiet::shownWindow();
    QVERIFY(window->open(path));
    QCOMPARE(window->files().problems().size(), std::size_t{1});
    QVERIFY(window->files().problems()[0].severity == base::Severity::Warning);
    const sim2d::Scenario& shown = window->workspace().document().scenario();
    const sim2d::ScenarioReading demo = sim2d::readScenario(quiet::demoPath().toStdString());
    QCOMPARE(shown.humans.size(), demo.scenario.humans.size());
    QCOMPARE(shown.robots.size(), demo.scenario.robots.size());
    QVERIFY(shown.humans[0].name == demo.scenario.humans[0].name);
    QVERIFY(!window->workspace().document().map()->isEmpty());
    QVERIFY(!window->workspace().document().isDirty());
    const double length = window->workspace().runner().newestFrame()->time;
    QVERIFY(shown.desktop.duration == std::optional(length));  // not that of the file
    window->workspace().runner().reset();                      // nothing to go back to
    QVERIFY(window->isOnStartPage());
    quiet::leave(window);
  }

  /// As in the live run, also when the scenario with its trees is gone.
  void customTree_isShownAsSuch() {
    const QTemporaryDir folder;
    const QString scenario = quiet::copyOfDemo(folder.filePath(text("demo.yaml")));
    const QString tree = folder.filePath(text("demo__agent_2_bt.xml"));
    writeText(tree,
              "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><StopMovement "
              "agent_id=\"{id}\"/></BehaviorTree></root>");
    const QString path = runOfDemo(folder, scenario);
    QVERIFY(!path.isEmpty());
    QVERIFY(QFile::remove(scenario) && QFile::remove(tree));
    auto window = quiet::shownWindow();
    QVERIFY(window->open(path));
    app::Workspace& workspace = window->workspace();
    std::map<int, editor::Look> looks;
    for (const editor::ShownBody& body : workspace.scene().frameLayer().shownBodies()) {
      looks[body.id] = body.look;
    }
    QCOMPARE(looks.at(2), editor::Look::CustomTree);
    QVERIFY(looks.at(1) != editor::Look::CustomTree);
    for (const sim2d::Human& human : workspace.document().scenario().humans) {
      QCOMPARE(editor::lookOfPerson(workspace.document(), human) == editor::Look::CustomTree,
               human.id == 2);
    }
    quiet::leave(window);
  }

  void run_overADocument_isNotEditedAndLeavesItAsItWas() {
    const QTemporaryDir folder;
    const QString path = runOfDemo(folder);
    const QString before = quiet::copyOfDemo(folder.filePath(text("before.yaml")));
    auto window = quiet::shownWindow();
    QVERIFY(window->open(before));
    QVERIFY(window->open(path));
    app::Workspace& workspace = window->workspace();
    QVERIFY(workspace.runner().isRecorded());
    QVERIFY(window->windowTitle().startsWith(text("run (recorded run)")));
    QVERIFY(!window->actions().save->isEnabled() && !window->actions().exportTo->isEnabled());
    const sim2d::Scenario shown = workspace.document().scenario();
    const base::EntityId person = shown.humans.front().key;
    editor::pushTrees(workspace.document(), {{person, std::string("<root/>")}}, text("tree"));
    QTRY_VERIFY(!workspace.document().undoStack().canUndo());
    workspace.view().setFocus();
    QTest::keyClick(workspace.view().viewport(), Qt::Key_Space);
    QTRY_VERIFY(workspace.runner().shownFrame()->step > 2);
    QCOMPARE(workspace.runner().state(), editor::SimulationRunner::State::Running);
    QTest::keyClick(workspace.view().viewport(), Qt::Key_Space);
    QCOMPARE(workspace.runner().state(), editor::SimulationRunner::State::Paused);
    workspace.playback().reset->trigger();
    QCOMPARE(workspace.document().path(), before);
    QVERIFY(!workspace.document().isDirty() && window->actions().save->isEnabled());
    QVERIFY(workspace.runner().recording() == nullptr);
    quiet::leave(window);
  }

  void program_onAFolder_makesAPictureOrTellsWhatIsWrong() {
    const QTemporaryDir folder;
    const QString path = runOfDemo(folder);
    const QString picture = folder.filePath(text("a.png"));
    const QStringList words = list("% --at 4 --screenshot %", {path, picture});
    QCOMPARE(failureOf(words), QString());
    QCOMPARE(QImage(picture).size(), QSize(1280, 800));
    const QByteArray trajectory = bytesOf(path + text("/trajectory.csv"));
    writeText(path + text("/trajectory.csv"), trajectory.left(trajectory.size() / 2));
    const Finished cut = runProgram(words);
    QCOMPARE(cut.exitCode, 0);  // what is whole is shown, and told that there was more
    QVERIFY2(cut.err.contains(text("the run is incomplete")), qPrintable(cut.err));
    writeText(path + text("/trace.json"), "{");
    QCOMPARE(unexpected(runProgram(words), 2, "trace.json"), QString());
    QCOMPARE(runProgram({path}).exitCode, 2);  // without a picture as well
    QCOMPARE(unexpected(runProgram({folder.path()}), 2, "not a run folder"), QString());
  }
};

QTEST_MAIN(RecordedRunTest)
#include "tst_RecordedRun.moc"
