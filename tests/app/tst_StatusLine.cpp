#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/look/Form.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "tests/app/QuietWindow.h"

using editor::SimulationRunner;

/// What the line at the bottom says of a run.
class StatusLineTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  SimulationRunner& runner() { return window_->workspace().runner(); }
  bool isHinted(const char* words) const {
    return widgets::findIf<QLabel>(*window_->statusBar(), [&](const QLabel* label) {
             return label->text().contains(QString::fromUtf8(words));
           }) != nullptr;
  }
  void setDuration(std::optional<double> seconds) {
    editor::pushChange<editor::ScenarioSettings>(
        document(), editor::kSettingsId, QString(),
        [seconds](editor::ScenarioSettings& settings) { settings.desktop.duration = seconds; });
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    begin();
    QVERIFY(window_->open(quiet::demoPath()));
  }
  void cleanup() {
    runner().reset();
    end();
  }

  void run_thatIsOver_saysWhyAndIsPlayedAgain() {
    setDuration(2.0);
    runner().setSpeed(std::numeric_limits<double>::infinity());
    window_->workspace().playback().playPause->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 20000);
    QVERIFY(isHinted("Time limit reached, 2.0 s · Space replays"));
    QVERIFY(isSaid(QStringLiteral("Finished")));
    runner().setSpeed(1.0);
    window_->workspace().view().setFocus();
    QTest::keyClick(window_->workspace().view().viewport(), Qt::Key_Space);
    QCOMPARE(runner().state(), SimulationRunner::State::Running);
    QVERIFY(isSaid(QStringLiteral("Playing back")));
    QVERIFY(isHinted("Space pauses · End shows the last step"));
    window_->workspace().playback().newest->trigger();
    runner().reset();
    QVERIFY(!isHinted("Time limit reached"));
  }

  /// A run goes on for a second after the arrival (stop rule of a scenario without a duration).
  void run_thatArrived_saysWhen() {
    setDuration(std::nullopt);
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 30000);
    QCOMPARE(runner().result()->reason, std::string("arrived"));
    const QString said = QStringLiteral("The robot has arrived, %1 s")
                             .arg(runner().newestFrame()->time - 1.0, 0, 'f', 1);
    QVERIFY2(isHinted(said.toUtf8().constData()), qPrintable(said));
  }

  void run_whoseNavigationFailed_saysWhy() {
    setDuration(std::nullopt);
    const QString tree = QStringLiteral(TEST_OUTPUT_DIR "/tmp/status_failure.xml");
    base::writeFileAtomically(tree.toStdString(),
                              "<root BTCPP_format=\"4\" main_tree_to_execute=\"T\">"
                              "<BehaviorTree ID=\"T\"><AlwaysFailure/></BehaviorTree></root>");
    for (const base::EntityId& id : document().entities(base::EntityKind::Robot)) {
      editor::pushChange<sim2d::Robot>(document(), id, QString(), [&tree](sim2d::Robot& robot) {
        robot.planner = sim2d::kNav2Planner;
        robot.nav2Params = {SOURCE_DIR "/resources/nav2_params/generic.yaml"};
        robot.nav2Tree = tree.toStdString();
      });
    }
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 30000);
    QVERIFY(isHinted("Navigation failed: node AlwaysFailure, "));
  }

  void run_isWatchedForPeopleAndRobots() {
    runner().play();
    const auto select = [this](base::EntityKind kind) {
      document().setSelection({document().entities(kind).front()});
      return editor::displayName(*document().entity(document().selection().front())) +
             QStringLiteral(" · ");
    };
    QVERIFY(isHinted(select(base::EntityKind::Human).toUtf8().constData()));
    QVERIFY(isHinted(select(base::EntityKind::Robot).toUtf8().constData()));
    QVERIFY(!isHinted(select(base::EntityKind::Obstacle).toUtf8().constData()));
  }

  void run_whoseScenarioIsEdited_keepsItsWords() {
    setDuration(std::nullopt);
    runner().play();
    QVERIFY(isHinted("Until the robot arrives, at most 120 s"));
    setDuration(7.0);
    QVERIFY(document().undoStack().canUndo());
    runner().pause();
    runner().play();
    QVERIFY(isHinted("Until the robot arrives, at most 120 s"));
  }

  void hint_thatDoesNotFit_losesItsLastPartsFirst() {
    window_->resize(window_->minimumSize());
    runner().play();
    QVector<editor::ElidedLabel*> hints;
    for (QLabel* label : window_->statusBar()->findChildren<QLabel*>()) {
      if (auto* elided = dynamic_cast<editor::ElidedLabel*>(label)) {
        hints << elided;
      }
    }
    QVERIFY(!hints.isEmpty());
    QCoreApplication::processEvents();
    editor::ElidedLabel& hint = *hints.front();
    QVERIFY(hint.visibleText().size() < hint.text().size());
    QCOMPARE(hint.text(), QStringLiteral("Space pauses · Click a person for details"));
    hint.resize(hint.fontMetrics().horizontalAdvance(hint.text()) - 5, hint.height());
    QCOMPARE(hint.visibleText(), QStringLiteral("Space pauses …"));
    hint.resize(hint.fontMetrics().horizontalAdvance(QStringLiteral("Space pau")), hint.height());
    const QString shown = hint.visibleText();  // of one part the middle
    QVERIFY2(shown.startsWith(QStringLiteral("Sp")) && !shown.endsWith(QStringLiteral("…")),
             qPrintable(shown));
    QCOMPARE(hint.toolTip(), hint.text());
  }
};

QTEST_MAIN(StatusLineTest)
#include "tst_StatusLine.moc"
