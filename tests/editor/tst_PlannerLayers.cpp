#include <cmath>
#include <limits>

#include <QImage>
#include <QSignalSpy>
#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/RobotPainters.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/runs/RunOverlayUpdater.h"
#include "editor/run/SimulationRunner.h"

using editor::CanvasOptions;
using editor::Vec2;
using Way = sim2d::RobotTelemetry::Candidate;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// 2 x 2 m of 1 m cells from (5, 4): free, 126, 254, 255.
sim2d::CostGridPtr fourCells() {
  auto grid = std::make_shared<sim2d::CostGrid>();
  grid->columns = grid->rows = 2;
  grid->resolution = 1.0;
  grid->origin = {5.0, 4.0};
  grid->costs = {0, 126, 254, 255};
  return grid;
}

sim2d::RobotTelemetry withPrices() {
  sim2d::RobotTelemetry senses;
  senses.believed = {{6.0, 4.5}, 0.0};
  senses.controller = "FollowPath";
  senses.ways = {{{{6.0, 4.5}, {9.0, 4.5}}, 3.0, true, {{"PathDist", 2.0}, {"GoalDist", 1.0}}},
                 {{{6.0, 4.5}, {9.0, 6.5}}, 5.0, false, {{"PathDist", 3.0}, {"GoalDist", 2.0}}},
                 {{{6.0, 4.5}, {9.0, 2.5}}, kNever, false, {{"PathDist", 1.0}}}};
  return senses;
}

int lightnessOf(const QColor& color) {
  return color.red() + color.green() + color.blue();
}

}  // namespace

/// Costmaps, priced ways and aims of planners on the map, with their legend.
class PlannerLayersTest : public QObject, private CanvasTester {
  Q_OBJECT

 private:
  void showSenses(const sim2d::RobotTelemetry& senses) {
    start(small::scenario());
    auto frame = std::make_shared<sim2d::Frame>();
    frame->step = 20;
    frame->time = 1.0;
    frame->robots.add(-1, {{6.0, 4.5}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
    frame->robotPaths.resize(1);
    frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
    frame->doorOpen = {1};
    scene_.showFrame(frame);
  }
  QImage shot(const std::vector<bool CanvasOptions::*>& on) {
    CanvasOptions options;
    options.lidar = options.grid = options.trails = options.names = options.routes = false;
    options.contacts = true;  // with room for the legend
    for (bool CanvasOptions::*option : on) {
      options.*option = true;
    }
    scene_.setOptions(options);
    QCoreApplication::processEvents();
    return view_.viewport()->grab().toImage();
  }
  QColor colorAt(const QImage& image, const Vec2& world) const {
    return image.pixelColor(view_.viewportFrom(world) * int(image.devicePixelRatio()));
  }
  editor::LegendPart partCalled(const QString& title) const {
    for (const editor::LegendPart& part : editor::legendOf(scene_, 50.0)) {
      if (part.title.startsWith(title)) {
        return part;
      }
    }
    return {};
  }

 private Q_SLOTS:
  void cleanup() { scene_.showFrame(nullptr); }

  void scale_isOfWhatMayBeDriven() {
    std::vector<Way> ways;
    for (int k = 0; k <= 10; ++k) {
      ways.push_back({{}, 10.0 + k, false});
    }
    ways.push_back({{}, kNever, false});
    const editor::CostScale scale = editor::costScaleOf(ways);
    QCOMPARE(scale.low, 10.0);
    QCOMPARE(scale.high, 19.0);  // nine in ten
    QCOMPARE(scale.open, std::size_t{11});
    QCOMPARE(scale.refused, std::size_t{1});
    QCOMPARE(editor::costShare(scale, 14.5), 0.5);
    QCOMPARE(editor::costShare(scale, 1000.0), 1.0);
    QCOMPARE(editor::costShare(editor::costScaleOf({}), 3.0), 0.0);
  }

  void arc_isOfTheCircleThatTouchesTheHeading() {
    // From the origin along +x to (2, 2): a quarter of the circle round (0, 2).
    const std::vector<Vec2> arc = editor::pursuitArc({{0.0, 0.0}, 0.0}, {2.0, 2.0});
    for (const Vec2& point : arc) {
      QVERIFY(std::abs((point - Vec2(0.0, 2.0)).norm() - 2.0) < 1e-9);
    }
    QVERIFY((arc.back() - Vec2(2.0, 2.0)).norm() < 1e-9);
    QCOMPARE(editor::pursuitArc({{1.0, 1.0}, 0.5 * base::kPi}, {1.0, 3.0}).size(), std::size_t{2});
  }

  void costs_onTheMap_haveTheirColours_data() {
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
  }
  void costs_onTheMap_haveTheirColours() {
    QFETCH(bool, isDark);
    sim2d::RobotTelemetry senses;
    senses.localCosts = fourCells();
    showSenses(senses);
    const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
    scene_.setTheme(theme);
    const QImage off = shot({});
    const QImage on = shot({&CanvasOptions::localCosts});
    QCOMPARE(colorAt(on, {5.2, 4.2}), colorAt(off, {5.2, 4.2}));  // free
    const int ground = lightnessOf(colorAt(off, {6.8, 4.2}));
    const int near = std::abs(lightnessOf(colorAt(on, {6.8, 4.2})) - ground);
    const int obstacle = std::abs(lightnessOf(colorAt(on, {5.2, 5.8})) - ground);
    QVERIFY2(near > 40, qPrintable(QString::number(near)));
    QVERIFY(obstacle > 2 * near);
    QVERIFY(colorAt(on, {6.8, 5.8}) != colorAt(off, {6.8, 5.8}));  // unknown
    scene_.setTheme(editor::Theme::light());
  }

  void costs_ofBoth_theLocalOnesTakeTheirPlace() {
    sim2d::RobotTelemetry senses;
    senses.localCosts = fourCells();
    auto global = std::make_shared<sim2d::CostGrid>(*fourCells());
    global->columns = 4;
    global->costs = {254, 254, 254, 254, 254, 254, 254, 254};
    senses.globalCosts = global;
    showSenses(senses);
    const QImage off = shot({});
    const QImage both = shot({&CanvasOptions::localCosts, &CanvasOptions::globalCosts});
    QCOMPARE(colorAt(both, {5.2, 4.2}), colorAt(off, {5.2, 4.2}));  // free in the local one
    QVERIFY(colorAt(both, {8.2, 4.2}) != colorAt(off, {8.2, 4.2}));
  }

  void masks_onTheMap_areRedAmberAndBlue() {
    sim2d::RobotTelemetry senses;
    using Kind = sim2d::MaskGrid::Kind;
    for (const auto& [kind, costs] :
         {std::pair{Kind::Keepout, std::vector<std::uint8_t>{100, 0, 0, 0}},
          std::pair{Kind::Speed, std::vector<std::uint8_t>{0, 20, 60, 0}},
          std::pair{Kind::Switch, std::vector<std::uint8_t>{0, 0, 0, 100}}}) {
      auto grid = std::make_shared<sim2d::CostGrid>(*fourCells());
      grid->costs = costs;
      senses.masks.push_back({kind, grid});
    }
    showSenses(senses);
    const QImage off = shot({});
    const QImage on = shot({&CanvasOptions::masks});
    const QColor keepout = colorAt(on, {5.2, 4.2}), slow = colorAt(on, {6.8, 4.2});
    const QColor fast = colorAt(on, {5.2, 5.8}), flipped = colorAt(on, {6.8, 5.8});
    QVERIFY(keepout.red() > keepout.green() + 30 && keepout.red() > keepout.blue() + 30);
    QVERIFY(slow.red() > slow.blue() + 30 && slow.green() > slow.blue() + 15);
    QVERIFY(fast.red() - fast.blue() < slow.red() - slow.blue());  // a higher limit is paler
    QVERIFY(fast != colorAt(off, {5.2, 5.8}));
    QVERIFY(flipped.blue() > flipped.red() + 15);
    QStringList rows;
    for (const editor::LegendRow& row : partCalled(QStringLiteral("Filter masks")).rows) {
      rows << row.label + QLatin1Char('=') + row.value;
    }
    QCOMPARE(rows.join(QLatin1Char(' ')),
             QStringLiteral("Keep out=100 % Speed limit=20–60 % Switch="));
    scene_.setTheme(editor::Theme::dark());
    QVERIFY(colorAt(shot({&CanvasOptions::masks}), {5.2, 4.2}) != keepout);
    scene_.setTheme(editor::Theme::light());
  }

  void ways_onTheMap_areBlueOrOrangeByTheirPrice() {
    sim2d::RobotTelemetry senses = withPrices();
    senses.ways[0].cost = 3.0;
    senses.ways.push_back({{{6.0, 4.5}, {8.0, 7.0}}, 3.1, false, {{"PathDist", 3.1}}});
    showSenses(senses);
    const QImage off = shot({});
    const QImage on = shot({&CanvasOptions::candidates});
    const auto warmth = [&](const Vec2& place) {  // red over blue, of what was drawn near
      int most = 0, sum = 0;
      for (int dx = -3; dx <= 3; ++dx) {
        for (int dy = -3; dy <= 3; ++dy) {
          const QPoint at = view_.viewportFrom(place) + QPoint(dx, dy);
          const QColor a = off.pixelColor(at), b = on.pixelColor(at);
          const int change = std::abs(a.red() - b.red()) + std::abs(a.blue() - b.blue());
          if (change > most) {
            most = change;
            sum = b.red() - b.blue();
          }
        }
      }
      return sum;
    };
    QVERIFY(warmth({8.7, 6.3}) > 40);   // dear
    QVERIFY(warmth({7.6, 6.5}) < -40);  // nearly the best
  }

  void legend_tellsWhatEachCriticGave() {
    showSenses(withPrices());
    shot({&CanvasOptions::candidates});
    const editor::LegendPart part = partCalled(QStringLiteral("FollowPath"));
    QStringList label;
    for (const editor::LegendRow& row : part.rows) {
      label << row.label + QLatin1Char('=') + row.value;
    }
    QCOMPARE(label.join(QLatin1Char(' ')),
             QStringLiteral("= 3.00=≥ 5.00 Rejected=1 Chosen=3.00 PathDist=2.00 GoalDist=1.00"));
  }

  void legend_withoutCosts_saysSo() {
    showSenses({});
    shot({&CanvasOptions::localCosts});
    const editor::LegendPart part = partCalled(QStringLiteral("Costs"));
    QCOMPARE(part.rows.size(), std::size_t{1});
    QVERIFY(part.rows.front().isNote);
  }

  /// Nothing is gathered while nobody looks; from the next step on it is.
  void run_tellsWhileALayerIsShown() {
    sim2d::Scenario scenario = small::scenario();
    scenario.robots.front().planner = "nav2";
    scenario.robots.front().nav2Params = {SOURCE_DIR "/maps/planners/nav2_dwb.yaml"};
    scenario.robots.front().nav2Tree =
        SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
    scenario.robots.front().goal.point = Vec2(9.0, 4.5);
    start(scenario);
    editor::SimulationRunner runner;
    runner.setRequest([this] { return editor::runRequestOf(document_); });
    editor::RunEvents events(document_, runner);
    editor::RunOverlayUpdater layers(runner, events, view_);
    shot({});
    for (int step = 0; step < 10; ++step) {
      runner.stepOnce();
      QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == step + 1);
    }
    QVERIFY(runner.newestFrame()->senses->front().localCosts == nullptr);
    QVERIFY(runner.newestFrame()->senses->front().ways.empty());
    shot({&CanvasOptions::localCosts, &CanvasOptions::candidates});
    runner.stepOnce();
    QTRY_COMPARE(runner.newestFrame()->step, std::int64_t{11});
    QVERIFY(runner.newestFrame()->senses->front().localCosts != nullptr);
    for (int step = 11; step < 14; ++step) {  // until the controller's next cycle
      runner.stepOnce();
      QTRY_COMPARE(runner.newestFrame()->step, std::int64_t{step + 1});
    }
    QVERIFY(!runner.newestFrame()->senses->front().ways.empty());
    runner.reset();
  }
};

QTEST_MAIN(PlannerLayersTest)
#include "tst_PlannerLayers.moc"
