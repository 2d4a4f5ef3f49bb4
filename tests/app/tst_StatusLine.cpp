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
    QVERIFY(isSaid(QStringLiteral("Goal not reached")));
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

  void run_withoutARobot_isOnlyFinished() {
    setDuration(1.0);
    editor::pushRemove(document(), document().entities(base::EntityKind::Robot));
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 20000);
    QVERIFY(isSaid(QStringLiteral("Finished")));
  }

  /// The text of the button under the mouse does not replace why the run stopped.
  void reason_ofAStop_staysWhileAButtonIsHovered() {
    setDuration(1.0);
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 20000);
    QVERIFY(isHinted("Time limit reached, 1.0 s · Space replays"));
    const auto hover = [this](const QString& tip) {
      QStatusTipEvent event(tip);
      QCoreApplication::sendEvent(window_.get(), &event);
    };
    hover(QStringLiteral("Run one step"));
    QVERIFY(isHinted("Time limit reached, 1.0 s · Run one step"));
    hover({});
    QVERIFY(isHinted("Time limit reached, 1.0 s · Space replays"));
    document().setSelection({document().entities(base::EntityKind::Robot).front()});
    const QString robot = editor::displayName(*document().entity(document().selection().front()));
    const QString first = QStringLiteral("Time limit reached, 1.0 s · %1 · ").arg(robot);
    QVERIFY(isHinted(first.toUtf8().constData()));
  }

  /// A run goes on for a second after the arrival (stop rule of a scenario without a duration).
  void run_thatArrived_saysWhen() {
    setDuration(std::nullopt);
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 30000);
    QCOMPARE(runner().result()->reason, std::string("arrived"));
    QVERIFY(isSaid(QStringLiteral("Goal reached")));
    const QString said = QStringLiteral("The robot has arrived, %1 s")
                             .arg(runner().newestFrame()->time - 1.0, 0, 'f', 1);
    QVERIFY2(isHinted(said.toUtf8().constData()), qPrintable(said));
  }

  /// The clock of the run, and the duration that the metric has.
  void run_thatArrivedAfterALateStart_saysBothTimes() {
    static constexpr double kStart = 1.5;  // [s]
    setDuration(std::nullopt);
    for (const base::EntityId& id : document().entities(base::EntityKind::Robot)) {
      editor::pushChange<sim2d::Robot>(document(), id, QString(),
                                       [](sim2d::Robot& robot) { robot.startTime = kStart; });
    }
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().play();
    QTRY_VERIFY_WITH_TIMEOUT(runner().isFinished(), 30000);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().feed().isCurrent(), 20000);
    const metrics::MetricResult* metric =
        metrics::findResult(window_->workspace().feed().shown(), "time_to_reach_goal");
    QVERIFY(metric != nullptr && metric->value.value.has_value());
    const QString said = QStringLiteral("The robot has arrived, %1 s, %2 s after its start")
                             .arg(*metric->value.value + kStart, 0, 'f', 1)
                             .arg(*metric->value.value, 0, 'f', 1);
    QVERIFY2(isHinted(said.toUtf8().constData()), qPrintable(said));
    int arrivals = 0;
    for (const editor::RunEvent& event : window_->workspace().events().events()) {
      arrivals += event.event.id < 0 && event.text.contains(QStringLiteral("arrived")) ? 1 : 0;
      QVERIFY(event.event.id >= 0 || event.event.kind != sim2d::EventKind::Goal);
    }
    QCOMPARE(arrivals, 1);
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

  /// Neither the speed of a run nor a growing count moves a button away from the mouse.
  void buttons_ofPanels_keepTheirPlacesDuringARun() {
    const auto places = [this] {
      QStringList all;
      for (const QToolButton* button : window_->statusBar()->findChildren<QToolButton*>()) {
        const QString name = button->text().section(QStringLiteral("  "), 0, 0);
        all << QStringLiteral("%1 %2").arg(name).arg(button->mapTo(window_.get(), QPoint()).x());
      }
      return all;
    };
    QCoreApplication::processEvents();
    const QStringList before = places();
    QVERIFY(before.size() >= 4);
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runner().stepOnce();
    QTRY_VERIFY(runner().newestFrame() != nullptr && runner().newestFrame()->step >= 1);
    editor::PanelContext& context = window_->docks().context();
    auto* events = window_->docks().dock(QStringLiteral("events"))->widget();
    auto* issues = window_->docks().dock(QStringLiteral("issues"))->widget();
    Q_EMIT context.counted(events, 1, base::Severity::Info);
    Q_EMIT context.counted(issues, 2, base::Severity::Warning);
    QCoreApplication::processEvents();
    QCOMPARE(places(), before);
    runner().play();
    QCOMPARE(runner().state(), SimulationRunner::State::Running);
    QCoreApplication::processEvents();
    QCOMPARE(places(), before);
    for (const char* panel : {"runs", "study", "nav2"}) {
      QWidget* counted = window_->docks().dock(QString::fromLatin1(panel))->widget();
      for (const int count : {1, 20, 345}) {
        Q_EMIT context.counted(counted, count, base::Severity::Info);
        QCoreApplication::processEvents();
        QCOMPARE(places(), before);
      }
    }
    for (const int count : {9, 10, 99, 100, 999, 1152, 7}) {
      Q_EMIT context.counted(events, count, base::Severity::Info);
      QCoreApplication::processEvents();
      QCOMPARE(places(), before);
    }
    runner().pause();
    QCoreApplication::processEvents();
    QCOMPARE(places(), before);
  }

  /// The tools need the map: while the tree hides it, the hint says how to get it back.
  void hint_withoutTheMap_leadsBackToIt() {
    QVERIFY(!isHinted("F8 returns to the map"));
    window_->docks().treeMaximized()->setChecked(true);
    QTRY_VERIFY(isHinted("F8 returns to the map"));
    window_->docks().treeMaximized()->setChecked(false);
    QTRY_VERIFY(!isHinted("F8 returns to the map"));
  }

  void hint_thatDoesNotFit_isElidedAtItsEnd() {
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
    for (const char* const room : {"Space pauses · Click a", "Space pauses", "Space pau"}) {
      hint.resize(hint.fontMetrics().horizontalAdvance(QString::fromUtf8(room)), hint.height());
      const QString shown = hint.visibleText();
      QVERIFY2(shown.endsWith(QStringLiteral("…")), qPrintable(shown));
      QVERIFY2(hint.text().startsWith(shown.chopped(1)), qPrintable(shown));
    }
    QCOMPARE(hint.toolTip(), hint.text());
  }
};

QTEST_MAIN(StatusLineTest)
#include "tst_StatusLine.moc"
