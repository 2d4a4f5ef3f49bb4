#include <cmath>
#include <limits>

#include <QtTest>

#include "editor/panels/MetricsDock.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/Playback.h"
#include "editor/run/SimulationRunner.h"
#include "tests/editor/SmallScenario.h"

using editor::MetricsDock;
using editor::MetricsFeed;
using editor::ScenarioDocument;
using editor::SimulationRunner;

namespace {

/// A person and a robot that pass each other.
sim2d::Scenario passing() {
  sim2d::Scenario scenario;
  scenario.goals = {small::goal(2, 1, {6.0, 0.0})};
  sim2d::Human human = small::person(1, "Ana", {0.0, 0.0}, 0.0, sim2d::BehaviorType::Regular, {1});
  human.maxVel = 1.2;
  human.radius = 0.35;
  human.goalRadius = 0.3;
  human.cyclicGoals = false;
  scenario.humans = {human};
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, 3};
  robot.name = "robot1";
  robot.start.position = base::Vec2(6.0, 1.2);
  robot.start.heading = base::kPi;
  robot.goal.point = base::Vec2(1.0, 1.2);
  scenario.robots.push_back(robot);
  scenario.desktop.duration = 4.0;
  return scenario;
}

/// The row of a metric; -1 when it is not in the table.
int rowOf(const MetricsDock& dock, const QString& key) {
  const QAbstractItemModel& model = *dock.table().model();
  const QModelIndexList found =
      model.match(model.index(0, 0), Qt::UserRole, key, 1, Qt::MatchExactly);
  return found.isEmpty() ? -1 : found.front().row();
}

/// A run of the two as fast as possible, with its metrics.
struct Measured {
  Measured() {
    document.load(passing());
    runner.setRequest([this] { return editor::runRequestOf(document); });
    runner.setSpeed(std::numeric_limits<double>::infinity());
  }
  /// Until its end; all of it is measured then.
  void run() {
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished() && feed.isCurrent(), 20000);
  }

  ScenarioDocument document;
  SimulationRunner runner;
  MetricsFeed feed{document, runner};
  MetricsDock dock{feed, runner, editor::Theme::light()};
};

}  // namespace

class MetricsPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plot_narrow_lastTimeIsWhole() {
    editor::MetricPlot plot(editor::Theme::light(), true);
    plot.resize(180, 160);
    plot.QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    for (const double end : {5.0, 60.0, 1000.0}) {
      app::MetricTimeSeries curve;
      curve.times = {0.0, end};
      curve.values = {0.0, 1.0};
      plot.show({}, {}, {{&curve}});
      QCoreApplication::processEvents();
      const QImage picture = plot.grab().toImage();
      const QRgb ground = editor::Theme::light().color(editor::Role::Panel).rgb();
      bool hasAxis = false;
      for (int y = picture.height() - 24; y < picture.height() - 6; ++y) {
        QCOMPARE(picture.pixel(picture.width() - 2, y), ground);  // nothing runs out of the plot
        for (int x = 3 * picture.width() / 4; x < picture.width(); ++x) {
          hasAxis = hasAxis || picture.pixel(x, y) != ground;
        }
      }
      QVERIFY(hasAxis);
    }
  }

  void dock_afterARun_equalsEvaluate() {
    Measured run;
    SimulationRunner& runner = run.runner;
    MetricsFeed& feed = run.feed;
    MetricsDock& dock = run.dock;
    QSignalSpy notStarted(&runner, &SimulationRunner::notStarted);
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished() || notStarted.count() > 0, 20000);
    QCOMPARE(notStarted.count(), 0);
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
    const auto evaluation = metrics::evaluate(runner.recording()->trace(), feed.selection(), {});
    QVERIFY(bool(evaluation));
    QCOMPARE(feed.snapshot().results.size(), evaluation->results.size());
    int defined = 0;
    for (const metrics::MetricResult& expected : evaluation->results) {
      const QString key = QString::fromStdString(expected.info.key);
      const int row = rowOf(dock, key);
      QVERIFY2(row >= 0, qPrintable(key));
      const QString shown = dock.table().model()->index(row, 1).data().toString();
      QVERIFY2(shown == editor::metricText(expected), qPrintable(key));
      defined += expected.value.value ? 1 : 0;
    }
    QVERIFY(defined > 10);
    dock.resize(900, 220);
    dock.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dock));
    const auto* table = dock.findChild<QTableView*>();
    QTRY_VERIFY(table->rowHeight(0) < 30);  // there is room for one line
    QTRY_VERIFY(table->rowHeight(3) < 30);
    dock.table().selectRow(rowOf(dock, QStringLiteral("path_length")));
    QVERIFY(!feed.snapshot().curves.at("path_length").times.empty());
  }

  void dock_choice_isBesideTheTableWhenAskedFor() {
    Measured run;
    MetricsDock& dock = run.dock;
    auto* choice = new editor::MetricsChoice(run.document, run.feed, editor::Theme::light());
    dock.setChoice(*choice);
    dock.resize(900, 220);
    dock.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dock));
    QVERIFY(!choice->isVisible());
    QVERIFY(dock.choose().text().startsWith(choice->count()));
    QTest::mouseClick(&dock.choose(), Qt::LeftButton);
    QVERIFY(choice->isVisible());
    QVERIFY(choice->width() >= 200 && choice->width() < 400);
    choice->chooseAll(false);
    QVERIFY2(dock.choose().text().startsWith(QStringLiteral("0 of ")),
             qPrintable(dock.choose().text()));
    QTest::mouseClick(&dock.choose(), Qt::LeftButton);
    QVERIFY(!choice->isVisible());
  }

  /// With several robots the dock asks whose metrics are wanted; what is selected stays.
  void dock_severalRobots_showsTheChosenOne() {
    sim2d::Scenario scenario = passing();
    sim2d::Robot second = scenario.robots[0];
    second.key.key = 4;
    second.name = "slow";
    second.start.position.y() = 4.0;
    second.goal.point = base::Vec2(1.0, 4.0);
    second.maxVel = 0.3;
    Measured run;
    SimulationRunner& runner = run.runner;
    MetricsFeed& feed = run.feed;
    MetricsDock& dock = run.dock;
    dock.show();
    run.run();
    QVERIFY(!dock.robot().isVisible());
    scenario.robots.push_back(second);
    run.document.load(scenario);
    runner.reset();
    run.run();
    QVERIFY(dock.robot().isVisible());
    QCOMPARE(dock.robot().count(), 2);
    QCOMPARE(dock.robot().currentText(), QStringLiteral("robot1"));
    dock.table().selectRow(rowOf(dock, QStringLiteral("path_length")));
    const auto showsThoseOf = [&](int id) {
      metrics::Selection selection = feed.selection();
      selection.robotId = id;
      const auto expected = metrics::evaluate(runner.recording()->trace(), selection, {});
      return std::all_of(expected->results.begin(), expected->results.end(),
                         [&](const metrics::MetricResult& result) {
                           const int row = rowOf(dock, QString::fromStdString(result.info.key));
                           return dock.table().model()->index(row, 1).data() ==
                                  editor::metricText(result);
                         });
    };
    QVERIFY(showsThoseOf(-1) && !showsThoseOf(-2));
    QTest::keyClick(&dock.robot(), Qt::Key_Down);
    QCOMPARE(feed.robot(), -2);
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
    QVERIFY(showsThoseOf(-2) && !showsThoseOf(-1));
    const QModelIndexList kept = dock.table().selectionModel()->selectedRows();
    QCOMPARE(kept.size(), 1);
    QCOMPARE(kept.front().data(Qt::UserRole).toString(), QStringLiteral("path_length"));
  }

  /// "Now" is the moment that is shown, forwards and backwards.
  void dock_lookingBack_hasTheValuesOfThen() {
    Measured run;
    SimulationRunner& runner = run.runner;
    MetricsFeed& feed = run.feed;
    MetricsDock& dock = run.dock;
    run.run();
    const sim2d::Trace whole = runner.recording()->trace();
    for (const std::int64_t step : {20, 35, 8}) {
      runner.seek(step + 1);
      runner.seek(step);
      const auto isEmpty = [](const auto& result) { return !result.value.value; };
      const auto& meanwhile = feed.shown();  // not those of another moment
      QVERIFY(step == 35 || std::all_of(meanwhile.begin(), meanwhile.end(), isEmpty));
      QCOMPARE(meanwhile.size(), feed.snapshot().results.size());
      QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
      sim2d::Trace part = whole;
      part.frames.resize(static_cast<std::size_t>(step) + 1);
      part.events.erase(std::remove_if(part.events.begin(), part.events.end(),
                                       [&](const auto& event) { return event.first > step; }),
                        part.events.end());
      const auto expected = metrics::evaluate(part, feed.selection(), {});
      for (const metrics::MetricResult& result : expected->results) {
        const int row = rowOf(dock, QString::fromStdString(result.info.key));
        QCOMPARE(dock.table().model()->index(row, 1).data().toString(), editor::metricText(result));
      }
    }
    runner.seekNewest();
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
    QVERIFY(&feed.shown() == &feed.snapshot().results);
  }

  /// Work on the past is given up, and what follows it is right.
  void selection_whileThePastIsWorkedOut_beginsAnew() {
    Measured run;
    MetricsFeed& feed = run.feed;
    run.run();
    run.runner.seek(30);
    feed.setSelection(feed.selection());
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
    QCOMPARE(feed.shown().size(), feed.snapshot().results.size());
    QVERIFY(&feed.shown() != &feed.snapshot().results);
    const auto& results = feed.shown();
    QVERIFY(std::any_of(results.begin(), results.end(),
                        [](const auto& result) { return result.value.value.has_value(); }));
  }

  /// However often the table was told of the run meanwhile.
  void selection_atAMoment_dependsOnTheRunAlone() {
    const auto shownAfter = [](double seconds, bool slowly) {
      Measured run;
      SimulationRunner& runner = run.runner;
      MetricsFeed& feed = run.feed;
      MetricsDock& dock = run.dock;
      const auto steps = static_cast<std::int64_t>(std::llround(seconds / 0.05));
      const auto isAt = [&](std::int64_t step) {
        return QTest::qWaitFor([&] {
          return runner.newestFrame() && runner.newestFrame()->step >= step && feed.isCurrent();
        });
      };
      bool isFine = true;
      for (std::int64_t step = 1; step <= steps; ++step) {
        runner.stepOnce();
        isFine = isFine && (!slowly || isAt(step));
      }
      isFine = isFine && isAt(steps);
      const QModelIndexList rows = dock.table().selectionModel()->selectedRows();
      const QString shown =
          isFine && rows.size() == 1 ? rows.front().data(Qt::UserRole).toString() : QString();
      dock.table().selectRow(rowOf(dock, QStringLiteral("path_length")));  // of the user: it stays
      runner.stepOnce();
      isFine = isFine && isAt(steps + 1);
      const QModelIndexList kept = dock.table().selectionModel()->selectedRows();
      return isFine && kept.size() == 1 &&
                     kept.front().data(Qt::UserRole) == QLatin1String("path_length")
                 ? shown
                 : QString();
    };
    for (const double seconds : {0.5, 2.5}) {
      const QString atOnce = shownAfter(seconds, false);
      QVERIFY(!atOnce.isEmpty());
      QCOMPARE(shownAfter(seconds, true), atOnce);
    }
  }

  void text_ofValues_hasSteadyDecimals() {
    metrics::MetricResult result;
    result.info.unit = "m";
    result.value = 1.0;
    QCOMPARE(editor::metricText(result), QStringLiteral("1.00"));
    result.value = metrics::undefinedValue("nobody");
    QCOMPARE(editor::metricText(result), QStringLiteral("–"));
    result.value = 3.0;
    result.info.kind = metrics::Kind::Count;
    QCOMPARE(editor::metricText(result), QStringLiteral("3"));
    result.value = 1.0;
    result.info.kind = metrics::Kind::Boolean;
    QCOMPARE(editor::metricText(result), QStringLiteral("yes"));
  }

  void timeline_click_looksBack() {
    ScenarioDocument document;
    document.load(passing());
    SimulationRunner runner;
    runner.setRequest([&] { return editor::runRequestOf(document); });
    editor::RunEvents events(document, runner);
    editor::MapScene scene(document, editor::Theme::light());
    editor::MapView view(scene);
    MetricsFeed feed(document, runner);
    editor::PanelContext context(view, document, runner, events, feed);
    const editor::PanelRegistry panels = editor::standardPanels();
    const auto entry =
        std::find_if(panels.entries().begin(), panels.entries().end(),
                     [](const auto& each) { return each.info.title == QLatin1String("Events"); });
    const std::unique_ptr<QWidget> panel(entry->make(context));
    editor::TimelineBar timeline(document, events, runner, editor::Theme::light());
    timeline.resize(1000, 44);
    runner.setSpeed(std::numeric_limits<double>::infinity());
    runner.play();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isFinished(), 20000);
    QCOMPARE(timeline.length(), 4.0);
    QVERIFY(std::abs(timeline.timeAt(timeline.xOf(1.25)) - 1.25) < 1e-9);
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, QPoint(qRound(timeline.xOf(1.0)), 17));
    QTRY_VERIFY(runner.isLookingBack());
    QVERIFY(std::abs(runner.shownFrame()->time - 1.0) < 0.06);
    QVERIFY(!events.events().empty());
    const QAbstractItemModel& rows = *panel->findChild<QTableView*>()->model();
    QCOMPARE(rows.rowCount(), static_cast<int>(events.events().size()));
  }

  void clock_ofSeconds_isMinutesAndTenths() {
    QCOMPARE(editor::clockText(0.0), QStringLiteral("0:00.0"));
    QCOMPARE(editor::clockText(12.4), QStringLiteral("0:12.4"));
    QCOMPARE(editor::clockText(125.05), QStringLiteral("2:05.0"));
  }
};

QTEST_MAIN(MetricsPanelTest)
#include "tst_MetricsPanel.moc"
