#include <cmath>
#include <limits>

#include <QtTest>

#include "editor/look/TableExport.h"
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

/// The row of a metric; null when it is not in the table.
QTreeWidgetItem* rowOf(const MetricsDock& dock, const QString& key) {
  for (QTreeWidgetItemIterator each(&dock.table().tree()); *each != nullptr; ++each) {
    if ((*each)->data(0, editor::kSavedKeyRole) == key) {
      return *each;
    }
  }
  return nullptr;
}

/// The text in a column of the row of a metric.
QString textOf(const MetricsDock& dock, const std::string& key, int column = 1) {
  const QTreeWidgetItem* row = rowOf(dock, QString::fromStdString(key));
  return row == nullptr ? QStringLiteral("no row") : row->text(column);
}

/// As a user does it.
void clickMetric(const MetricsDock& dock, const QString& key) {
  QTreeWidget& tree = dock.table().tree();
  QTreeWidgetItem* row = rowOf(dock, key);
  tree.scrollToItem(row);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, tree.visualItemRect(row).center());
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
  MetricsDock dock{document, feed, runner, editor::Theme::light()};
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

  /// Neither an empty plot nor a dash alone: both say what is missing.
  void run_withoutARobot_saysWhyThereIsNoValue() {
    Measured run;
    sim2d::Scenario scenario = passing();
    scenario.robots.clear();
    run.document.load(scenario);
    run.dock.resize(900, 300);
    run.dock.show();
    QVERIFY(QTest::qWaitForWindowExposed(&run.dock));
    run.run();
    clickMetric(run.dock, QStringLiteral("path_length"));
    QCOMPARE(textOf(run.dock, "path_length"), QStringLiteral("–"));
    QCOMPARE(textOf(run.dock, "path_length", editor::MetricsTable::SparklineColumn),
             QStringLiteral("needs a robot"));
    QVERIFY(!run.dock.plot().isVisible());
    const auto isSaid = [&run](const QString& text) {
      const QList<QLabel*> labels = run.dock.findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&text](const QLabel* label) {
        return label->isVisible() && label->text().startsWith(text);
      });
    };
    QVERIFY(isSaid(QStringLiteral("Path length needs a robot: press B")));
    run.runner.reset();
    run.document.load(passing());
    run.run();
    QTRY_VERIFY(run.dock.plot().isVisible());
    QVERIFY(!isSaid(QStringLiteral("Path length needs a robot")));
    QCOMPARE(textOf(run.dock, "path_length", editor::MetricsTable::SparklineColumn), QString());
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
      const QString shown = textOf(dock, expected.info.key);
      QVERIFY2(shown == editor::metricText(expected), expected.info.key.c_str());
      defined += expected.value.value ? 1 : 0;
    }
    QVERIFY(defined > 10);
    dock.resize(900, 220);
    dock.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dock));
    const QTreeWidget& tree = dock.table().tree();
    for (int row = 0; row < 4; ++row) {  // there is room for one line
      QTRY_VERIFY(tree.visualItemRect(tree.topLevelItem(0)->child(row)).height() < 30);
    }
    clickMetric(dock, QStringLiteral("path_length"));
    QCOMPARE(dock.shownKey(), std::string("path_length"));
    QVERIFY(!feed.snapshot().curves.at("path_length").times.empty());
  }

  /// The plot shows what the search leaves, and the choice again afterwards.
  void search_ofAMetric_isFollowedByThePlot() {
    Measured run;
    MetricsDock& dock = run.dock;
    dock.resize(1000, 260);
    dock.show();
    QVERIFY(QTest::qWaitForWindowActive(&dock));
    run.run();
    clickMetric(dock, QStringLiteral("path_length"));
    QCOMPARE(dock.plot().title(), rowOf(dock, QStringLiteral("path_length"))->text(0));
    dock.table().search().setFocus();
    QTest::keyClicks(&dock.table().search(), QStringLiteral("smallest distance to people"));
    QVERIFY(rowOf(dock, QStringLiteral("path_length"))->isHidden());
    QCOMPARE(dock.shownKey(), std::string("minimum_distance_to_people"));
    QCOMPARE(dock.plot().title(),
             rowOf(dock, QStringLiteral("minimum_distance_to_people"))->text(0));
    QVERIFY(dock.plot().lines() == 1);
    QTest::keyClick(&dock.table().search(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&dock.table().search(), Qt::Key_Delete);
    QCOMPARE(dock.shownKey(), std::string("path_length"));
    QCOMPARE(dock.plot().title(), rowOf(dock, QStringLiteral("path_length"))->text(0));
  }

  /// A click does not move what is below the pointer: the next click meets the same row.
  void click_onAMetric_movesNothing() {
    Measured run;
    MetricsDock& dock = run.dock;
    dock.resize(1000, 260);
    dock.show();
    QVERIFY(QTest::qWaitForWindowActive(&dock));
    run.run();
    QTreeWidget& tree = dock.table().tree();
    const auto places = [&] {
      std::vector<QRect> all;
      for (QTreeWidgetItemIterator each(&tree); *each != nullptr; ++each) {
        all.push_back(tree.visualItemRect(*each));
      }
      all.push_back(tree.geometry());
      all.push_back(dock.plot().geometry());
      return all;
    };
    tree.scrollToItem(rowOf(dock, QStringLiteral("path_length")));
    const std::vector<QRect> before = places();
    clickMetric(dock, QStringLiteral("path_length"));
    QTest::keyClick(&tree, Qt::Key_Space);  // not measured any more
    QTRY_VERIFY_WITH_TIMEOUT(run.feed.isCurrent(), 20000);
    const std::vector<QRect> unticked = places();
    QCOMPARE(unticked.size(), before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      QCOMPARE(unticked[k], before[k]);
    }
    QCOMPARE(textOf(dock, "path_length"), QString());
    run.document.setSelection({run.document.entities(base::EntityKind::Human).front()});
    // The columns of people narrow the names, which may wrap; table and plot stay.
    const std::vector<QRect> after = places();
    QCOMPARE(after.back(), before.back());
    QCOMPARE(after[after.size() - 2], before[before.size() - 2]);
  }

  /// The column of a person has the metrics of a run in which only this person is seen.
  void people_thatAreSelected_haveTheirOwnValues() {
    sim2d::Scenario scenario = passing();
    sim2d::Human second = scenario.humans[0];
    second.key.key = 7;
    second.id = 2;
    second.name = "Ben";
    second.initPose.position = {0.0, -3.0};
    scenario.humans.push_back(second);
    Measured run;
    run.document.load(scenario);
    MetricsDock& dock = run.dock;
    run.run();
    QCOMPARE(dock.table().tree().columnCount(), 4);
    const auto people = run.document.entities(base::EntityKind::Human);
    run.document.setSelection({people[0], people[1]});
    QCOMPARE(dock.table().tree().columnCount(), 6);
    QCOMPARE(dock.table().tree().headerItem()->text(5), QStringLiteral("Ben"));
    for (const std::int64_t step : {std::int64_t{-1}, std::int64_t{30}, std::int64_t{12}}) {
      step < 0 ? run.runner.seekNewest() : run.runner.seek(step);
      QTRY_VERIFY_WITH_TIMEOUT(dock.people().isCurrent() && run.feed.isCurrent(), 20000);
      for (int person = 0; person < 2; ++person) {
        sim2d::Trace alone = run.runner.recording()->trace();
        alone.frames.resize(step < 0 ? alone.frames.size() : static_cast<std::size_t>(step) + 1);
        alone.events.erase(std::remove_if(alone.events.begin(), alone.events.end(),
                                          [&](const auto& event) {
                                            return event.second.id == 2 - person ||
                                                   (step >= 0 && event.first > step);
                                          }),
                           alone.events.end());
        for (sim2d::Frame& frame : alone.frames) {
          sim2d::forEachColumn(frame.humans, [&](auto& column) {
            column.erase(column.begin() + (1 - person), column.begin() + (2 - person));
          });
          frame.forces = {};
        }
        const auto expected = metrics::evaluate(alone, run.feed.selection(), {});
        QVERIFY(bool(expected));
        int compared = 0;
        for (const metrics::MetricResult& result : expected->results) {
          const QString shown = textOf(dock, result.info.key, 4 + person);
          QVERIFY2(
              shown == (result.info.needs.people ? editor::metricText(result) : QString()),
              qPrintable(QString::fromStdString(result.info.key) + QStringLiteral(": ") + shown));
          compared += result.info.needs.people && result.value.value ? 1 : 0;
        }
        QVERIFY(compared > 10);
      }
    }
    QVERIFY(textOf(dock, "minimum_distance_to_people", 4) !=
            textOf(dock, "minimum_distance_to_people", 5));
    run.document.setSelection({});
    QCOMPARE(dock.table().tree().columnCount(), 4);
  }

  /// A share of the time in % has a count of 0 or 1 per step, a distance has metres.
  void plot_ofValuesPerStep_hasTheirUnit() {
    Measured run;
    run.run();
    const auto& curves = run.feed.snapshot().curves;
    int perStep = 0;
    for (const metrics::MetricResult& result : run.feed.snapshot().results) {
      const app::MetricTimeSeries& curve = curves.at(result.info.key);
      const bool isShare = result.info.unit == "%" && curve.isPerSample;
      const bool isZeroOrOne =
          std::all_of(curve.values.begin(), curve.values.end(),
                      [](double value) { return value == 0.0 || value == 1.0; });
      if (isShare && isZeroOrOne && curve.kind == metrics::Kind::Count) {
        QCOMPARE(curve.unit, std::string());
        QCOMPARE(curve.axisUnit(), std::string("count per step"));
        ++perStep;
      }
      QVERIFY(curve.kind == metrics::Kind::Count || curve.kind == metrics::Kind::Boolean ||
              curve.unit == result.info.unit);
    }
    QVERIFY(perStep > 0);
    run.dock.show();
    clickMetric(run.dock, QStringLiteral("path_length"));
    QCOMPARE(run.dock.plot().unitText(), QStringLiteral("Curve: so far · m"));
    run.dock.table().setCurrentKey("minimum_distance_to_people");
    QVERIFY(!curves.at("path_length").isPerSample);
  }

  /// At 0.0 s, and in any width.
  void plot_axisLabels_doNotOverlap() {
    editor::MetricPlot plot(editor::Theme::light(), true);
    app::MetricTimeSeries curve;
    curve.times = {0.0};
    curve.values = {0.3};
    plot.QWidget::show();
    QVERIFY(QTest::qWaitForWindowExposed(&plot));
    for (const int width : {180, 200, 240, 320, 500}) {
      plot.resize(width, 160);
      plot.show({}, {}, {{&curve}});
      QCoreApplication::processEvents();
      const QImage picture = plot.grab().toImage();
      const QRgb ground = editor::Theme::light().color(editor::Role::Panel).rgb();
      std::vector<std::pair<int, int>> words;  // groups of inked columns below the axis
      int last = -100;
      for (int x = 0; x < picture.width(); ++x) {
        bool isInked = false;
        for (int y = picture.height() - 20; y < picture.height() - 6; ++y) {
          isInked = isInked || picture.pixel(x, y) != ground;
        }
        if (isInked && x - last > 6) {
          words.emplace_back(x, x);
        }
        if (isInked) {
          words.back().second = last = x;
        }
      }
      QVERIFY(words.size() >= 2);
      for (const auto& [from, to] : words) {
        QVERIFY2(to - from < 40,
                 qPrintable(QStringLiteral("%1 to %2 at %3").arg(from).arg(to).arg(width)));
      }
    }
  }

  /// The context menu of the plot, as its user opens it.
  void plot_contextMenu_copiesAndSaves() {
    Measured run;
    MetricsDock& dock = run.dock;
    dock.resize(1000, 260);
    dock.show();
    QVERIFY(QTest::qWaitForWindowActive(&dock));
    run.run();
    clickMetric(dock, QStringLiteral("path_length"));
    QSignalSpy asked(&dock.plot(), &editor::ExportablePlot::exportRequested);
    for (const char* words : {"Copy plot", "Save plot…"}) {
      QContextMenuEvent event(QContextMenuEvent::Mouse, QPoint(40, 40),
                              dock.plot().mapToGlobal(QPoint(40, 40)));
      QCoreApplication::sendEvent(&dock.plot(), &event);
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      QVERIFY(menu != nullptr);
      for (QAction* action : menu->actions()) {
        if (action->text() == QString::fromUtf8(words)) {
          QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
          break;
        }
      }
    }
    QTRY_COMPARE(asked.count(), 2);
    QCOMPARE(asked[0][1].toBool(), false);
    QCOMPARE(asked[1][1].toBool(), true);
    const editor::PlottedFigure figure = dock.plot().figure();
    QCOMPARE(figure.unit, QStringLiteral("m"));
    QCOMPARE(figure.curves.size(), std::size_t{1});
    QCOMPARE(figure.curves[0].times.size(), figure.curves[0].values.size());
    QVERIFY(figure.curves[0].times.size() > 5);
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
    clickMetric(dock, QStringLiteral("path_length"));
    const auto showsThoseOf = [&](int id) {
      metrics::Selection selection = feed.selection();
      selection.robotId = id;
      const auto expected = metrics::evaluate(runner.recording()->trace(), selection, {});
      return std::all_of(expected->results.begin(), expected->results.end(),
                         [&](const metrics::MetricResult& result) {
                           return textOf(dock, result.info.key) == editor::metricText(result);
                         });
    };
    QVERIFY(showsThoseOf(-1) && !showsThoseOf(-2));
    QTest::keyClick(&dock.robot(), Qt::Key_Down);
    QCOMPARE(feed.robot(), -2);
    QTRY_VERIFY_WITH_TIMEOUT(feed.isCurrent(), 20000);
    QVERIFY(showsThoseOf(-2) && !showsThoseOf(-1));
    QCOMPARE(dock.table().currentKey(), std::string("path_length"));
    QCOMPARE(dock.shownKey(), std::string("path_length"));
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
        QCOMPARE(textOf(dock, result.info.key), editor::metricText(result));
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
      const QString shown = isFine ? QString::fromStdString(dock.shownKey()) : QString();
      dock.resize(900, 300);
      dock.show();
      clickMetric(dock, QStringLiteral("path_length"));  // of the user: it stays
      runner.stepOnce();
      isFine = isFine && isAt(steps + 1);
      return isFine && dock.shownKey() == "path_length" ? shown : QString();
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
