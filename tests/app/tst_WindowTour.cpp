#include "app/window/help/ManualViewer.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/MetricsTable.h"
#include "tests/app/Hands.h"

using app::TourStep;

/// The guided tour, done with mouse and keys as it asks, and in other ways.
class WindowTourTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private:
  app::GuidedTour& tour() { return window_->tour(); }
  void start() {
    window_->actions().tour->trigger();
    QVERIFY(tour().isActive());
    QCoreApplication::processEvents();
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() { end(); }

  void steps_followTheState() {
    app::TourState state;
    QCOMPARE(app::tourStepOf(state), TourStep::Person);
    state.hasPerson = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Goal);
    state.hasGoal = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Goal);  // not assigned yet
    state.hasRoute = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Robot);
    state.hasRobot = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Robot);  // without a goal nothing is measured
    state.hasRobotGoal = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Run);
    state.hasRun = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Metric);
    state.hasReadMetric = true;
    QCOMPARE(app::tourStepOf(state), TourStep::Done);
    state.hasRoute = false;  // undone
    QCOMPARE(app::tourStepOf(state), TourStep::Goal);
  }

  void tour_doneAsItSays_endsAtTheLastStep() {
    start();
    Hands hands(*window_);
    QVERIFY(!window_->isOnStartPage());
    QCOMPARE(tour().step(), TourStep::Person);
    QVERIFY(tour().target() != nullptr && tour().target()->isVisible());
    quiet::shoot(*window_, "tour-person");
    hands.chooseTool(QStringLiteral("tool-person"));
    QVERIFY(tour().target() == nullptr);
    QVERIFY2(tour().text().startsWith(QStringLiteral("Click on the map")),
             qPrintable(tour().text()));
    hands.clickMap({4.0, 4.0});
    QCOMPARE(tour().step(), TourStep::Goal);
    hands.press(Qt::Key_G);
    hands.clickMap({8.0, 4.0});
    QCOMPARE(tour().step(), TourStep::Goal);
    QVERIFY2(tour().text().contains(QStringLiteral("assign")), qPrintable(tour().text()));
    hands.press(Qt::Key_R);
    hands.clickMap({4.0, 4.0});
    hands.clickMap({8.0, 4.0});
    hands.press(Qt::Key_Return);
    QCOMPARE(tour().step(), TourStep::Robot);
    QVERIFY(tour().target() != nullptr && tour().target()->isVisible());
    quiet::shoot(*window_, "tour-robot");
    hands.press(Qt::Key_B);
    QVERIFY(tour().target() == nullptr);
    hands.clickMap({4.0, 5.5});
    QCOMPARE(tour().step(), TourStep::Robot);
    QVERIFY2(tour().text().contains(QStringLiteral("drive to")), qPrintable(tour().text()));
    hands.clickMap({8.0, 5.5});
    QCOMPARE(tour().step(), TourStep::Run);
    quiet::shoot(*window_, "tour-run");
    hands.press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(tour().step() == TourStep::Metric, 60000);
    window_->workspace().runner().pause();
    window_->docks().toggleOf(*window_->docks().dock(QStringLiteral("metrics")))->trigger();
    QTreeWidget& tree = window_->docks().panel<editor::MetricsDock>().table().tree();
    const auto metric = [&tree]() -> QTreeWidgetItem* {
      for (QTreeWidgetItemIterator row(&tree); *row != nullptr; ++row) {
        const QRect place = tree.visualItemRect(*row);
        if ((*row)->parent() != nullptr && !place.isEmpty() &&
            tree.viewport()->rect().contains(place.center())) {
          return *row;
        }
      }
      return nullptr;
    };
    QTRY_VERIFY_WITH_TIMEOUT(tree.isVisible() && metric() != nullptr, 60000);
    QCOMPARE(tour().step(), TourStep::Metric);  // the panel's own selection does not count
    quiet::shoot(*window_, "tour-metric");
    hands.clickOn(*tree.viewport(), tree.visualItemRect(metric()).center());
    QCOMPARE(tour().step(), TourStep::Done);
    auto& dock = window_->docks().panel<editor::MetricsDock>();
    dock.table().search().setText(QStringLiteral("path_length"));
    QTRY_VERIFY(!dock.plot().figure().curves.empty());
    const metrics::MetricResult* path =
        metrics::findResult(window_->workspace().feed().shown(), "path_length");
    QVERIFY(path != nullptr && path->value.value.has_value());
    quiet::shoot(*window_, "tour-done");
    auto* more =
        widgets::withText<QPushButton>(tour(), QStringLiteral("First scenario in the manual"));
    QTest::mouseClick(more, Qt::LeftButton);
    QCOMPARE(window_->help().viewer()->page(), QStringLiteral("first-scenario"));
    auto* close = widgets::withText<QPushButton>(tour(), QStringLiteral("Close"));
    QTest::mouseClick(close, Qt::LeftButton);
    QVERIFY(!tour().isVisible() && !tour().isActive());
  }

  void undo_ofAStep_goesBack() {
    start();
    Hands hands(*window_);
    hands.press(Qt::Key_P);
    hands.clickMap({4.0, 4.0});
    QCOMPARE(tour().step(), TourStep::Goal);
    hands.press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(tour().step(), TourStep::Person);
  }

  void skip_leavesTheScenarioOpen() {
    start();
    auto* skip = widgets::withText<QPushButton>(tour(), QStringLiteral("Skip tour"));
    QTest::mouseClick(skip, Qt::LeftButton);
    QVERIFY(!tour().isVisible());
    QVERIFY(!window_->findChild<QWidget*>(QStringLiteral("tour-frame"))->isVisible());
    QVERIFY(!window_->isOnStartPage());
    Hands hands(*window_);
    hands.press(Qt::Key_P);
    hands.clickMap({4.0, 4.0});
    QVERIFY(!tour().isVisible());
  }

  void startPage_shownAgain_endsTheTour() {
    start();
    answerBox(QMessageBox::Discard);  // the new room is not saved
    window_->actions().close->trigger();
    QVERIFY(window_->isOnStartPage());
    QVERIFY(!tour().isActive());
  }

  void card_coversNeitherTheOptionsNorTheMiddleOfTheMap() {
    start();
    const QWidget& view = window_->workspace().view();
    QVERIFY(view.rect().contains(tour().geometry()));
    QVERIFY(!tour().geometry().contains(view.rect().center()));
    window_->resize(900, 560);
    QCoreApplication::processEvents();
    QVERIFY(view.rect().contains(tour().geometry()));
  }

  void theme_dark_isLegible() {
    window_->actions().switchTheme->trigger();
    start();
    QVERIFY(editor::contrastRatio(window_->workspace().theme().color(editor::Role::Text),
                                  window_->workspace().theme().color(editor::Role::Panel)) >= 4.5);
    quiet::shoot(*window_, "tour-dark");
    window_->actions().switchTheme->trigger();
  }
};

QTEST_MAIN(WindowTourTest)
#include "tst_WindowTour.moc"
