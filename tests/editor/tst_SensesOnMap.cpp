#include <cmath>
#include <limits>

#include <QImage>
#include <QSignalSpy>
#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/LegendStrip.h"
#include "editor/canvas/RobotPainters.h"
#include "editor/panels/EventsPanel.h"
#include "editor/panels/runs/RunInteraction.h"
#include "editor/run/SimulationRunner.h"

using editor::CanvasOptions;
using editor::Role;
using editor::Vec2;
using Way = sim2d::RobotTelemetry::Candidate;

namespace {

constexpr double kHuge = std::numeric_limits<double>::infinity();

/// One robot at (6, 4.5) that looks to the right, alone with what it perceives.
std::shared_ptr<sim2d::Frame> frameWith(const sim2d::RobotTelemetry& senses) {
  auto frame = std::make_shared<sim2d::Frame>();
  frame->step = 20;
  frame->time = 1.0;
  frame->robots.add(-1, {{6.0, 4.5}, 0.0}, {0.0, 0.0}, 0.0, sim2d::kNoGoal);
  frame->robotPaths.resize(1);
  frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
  frame->doorOpen = {1};
  return frame;
}

sim2d::RobotTelemetry withScan() {
  sim2d::RobotTelemetry senses;
  senses.believed = {{6.0, 4.5}, 0.0};
  sim2d::RobotTelemetry::Scan scan;
  scan.sensor = {{6.0, 4.5}, 0.5 * base::kPi};
  scan.angleMin = -0.5 * base::kPi;  // to the right on the map
  scan.angleIncrement = 0.5 * base::kPi;
  scan.range = 3.0;
  scan.distances = {2.0, 1.5, 3.0};  // the last one hits nothing
  senses.scan = scan;
  return senses;
}

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
                 {{{6.0, 4.5}, {9.0, 2.5}}, kHuge, false, {{"PathDist", 1.0}}}};
  return senses;
}

int lightnessOf(const QColor& color) {
  return color.red() + color.green() + color.blue();
}

}  // namespace

/// What robots perceive and weigh, as layers of a run: senses, and the costmaps, priced ways and
/// aims of planners, with their legends.
class SensesOnMapTest : public QObject, private CanvasTester {
  Q_OBJECT

 private:
  QImage shot(bool CanvasOptions::*option, bool on) {
    CanvasOptions options;
    options.lidar = options.detections = options.candidates = false;
    options.grid = options.trails = options.names = options.routes = options.groups = false;
    if (option != nullptr) {
      options.*option = on;
    }
    scene_.setOptions(options);
    QCoreApplication::processEvents();
    return view_.viewport()->grab().toImage();
  }
  /// The largest difference of colour within 3 px of a place.
  int changeAt(const QImage& before, const QImage& after, const Vec2& world) const {
    const QPoint centre = view_.viewportFrom(world) * int(before.devicePixelRatio());
    int most = 0;
    for (int dx = -3; dx <= 3; ++dx) {
      for (int dy = -3; dy <= 3; ++dy) {
        const QColor a = before.pixelColor(centre + QPoint(dx, dy));
        const QColor b = after.pixelColor(centre + QPoint(dx, dy));
        most = std::max(most, std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                                  std::abs(a.blue() - b.blue()));
      }
    }
    return most;
  }
  bool isReddish(const QImage& image, const Vec2& world) const {
    const QPoint centre = view_.viewportFrom(world) * int(image.devicePixelRatio());
    for (int dx = -3; dx <= 3; ++dx) {
      for (int dy = -3; dy <= 3; ++dy) {
        const QColor pixel = image.pixelColor(centre + QPoint(dx, dy));
        if (pixel.red() - pixel.blue() > 30) {
          return true;
        }
      }
    }
    return false;
  }
  void showSenses(const sim2d::RobotTelemetry& senses) {
    start(small::scenario());
    scene_.showFrame(frameWith(senses));
  }

  QImage plannerShot(const std::vector<bool CanvasOptions::*>& on) {
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

  void endOfABeam_isAlongItsAngle() {
    const sim2d::RobotTelemetry::Scan scan = *withScan().scan;
    QVERIFY(isNear(editor::beamEnd(scan, 0), {8.0, 4.5}, 1e-9));
    QVERIFY(isNear(editor::beamEnd(scan, 1), {6.0, 6.0}, 1e-9));
    QVERIFY(isNear(editor::beamEnd(scan, 2), {3.0, 4.5}, 1e-9));
    QVERIFY(editor::isBeamHit(scan, 0) && !editor::isBeamHit(scan, 2));
  }

  void dearness_goesFromTheBestToTheWorstThatHitsNothing() {
    std::vector<sim2d::RobotTelemetry::Candidate> ways(5);
    const double costs[] = {7.0, kHuge, 1.0, 1000.0, 2.0};
    for (std::size_t i = 0; i < ways.size(); ++i) {
      ways[i].cost = costs[i];
    }
    const std::vector<double> dear = editor::relativeCosts(ways);
    const double expected[] = {2.0 / 3.0, 1.0, 0.0, 1.0, 1.0 / 3.0};
    for (std::size_t i = 0; i < dear.size(); ++i) {
      QVERIFY(std::abs(dear[i] - expected[i]) < 1e-12);
    }
    QVERIFY(editor::relativeCosts({}).empty());
    QCOMPARE(editor::relativeCosts({ways[0]}), std::vector<double>{0.0});
  }

  /// 1 m/s ahead and 1 rad/s: a state of 0.05 s before is 0.05 m back and turned 0.05 rad less.
  void believed_oneStepOlder_isNotElsewhere() {
    sim2d::RobotTelemetry senses = withScan();
    auto frame = frameWith(senses);
    frame->robots.vx[0] = 1.0;
    frame->robots.omega[0] = 1.0;
    senses.believed = {{5.95, 4.5}, -0.05};
    frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
    QVERIFY(!editor::divergentPoseEstimate(*frame, 0));
    senses.believed = {{5.95, 4.9}, -0.05};
    frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1, senses);
    QVERIFY(editor::divergentPoseEstimate(*frame, 0).has_value());
    frame->senses = std::make_shared<const std::vector<sim2d::RobotTelemetry>>(1);  // it stands
    QVERIFY(!editor::divergentPoseEstimate(*frame, 0));
  }

  void options_atFirst_areCalm() {
    const CanvasOptions options;
    QVERIFY(options.lidar && options.robotPath);
    QVERIFY(!options.detections && !options.candidates);
  }

  void lidar_onTheMap_hasAFanAndDotsAtHits() {
    showSenses(withScan());
    const QImage off = shot(&CanvasOptions::lidar, false);
    const QImage on = shot(&CanvasOptions::lidar, true);
    const int dot = changeAt(off, on, {8.0, 4.5});
    const int fan = changeAt(off, on, {6.8, 5.0});
    QVERIFY(dot > 150);
    QVERIFY(fan > 10 && fan < dot / 2);
    QVERIFY(changeAt(off, on, {3.05, 4.5}) < dot / 2);  // no dot where a beam hits nothing
    QCOMPARE(changeAt(off, on, {6.5, 3.0}), 0);         // behind the sensor
  }

  void detections_onTheMap_areRingsAndTheBelievedPlaceAGhost() {
    sim2d::RobotTelemetry senses = withScan();
    senses.believed = {{4.5, 3.0}, 0.0};
    senses.bodies = {{7, false, {9.0, 6.0}, {0.0, 0.0}, 0.35}};
    showSenses(senses);
    const QImage off = shot(&CanvasOptions::detections, false);
    const QImage on = shot(&CanvasOptions::detections, true);
    bool isRing = false;  // it is dashed
    for (int i = 0; i < 16; ++i) {
      const Vec2 at = editor::Pose2{{9.0, 6.0}, i * base::kPi / 8}.ahead(0.35 + editor::kTrackGap);
      isRing = isRing || changeAt(off, on, at) > 100;
    }
    QVERIFY(isRing);
    QCOMPARE(changeAt(off, on, {9.0, 6.0}), 0);
    QVERIFY(changeAt(off, on, {4.5, 3.0}) > 60);
  }

  void candidates_onTheMap_theChosenIsTheStrongest() {
    sim2d::RobotTelemetry senses = withScan();
    senses.ways = {{{{6.0, 4.5}, {9.0, 4.5}}, 1.0, true},
                   {{{6.0, 4.5}, {9.0, 6.5}}, 2.0, false},
                   {{{6.0, 4.5}, {9.0, 2.5}}, kHuge, false}};
    showSenses(senses);
    const QImage off = shot(&CanvasOptions::candidates, false);
    const QImage on = shot(&CanvasOptions::candidates, true);
    const int chosen = changeAt(off, on, {8.7, 4.5});
    const int weighed = changeAt(off, on, {8.7, 6.3});
    const int blocked = changeAt(off, on, {8.7, 2.7});
    QVERIFY(chosen > weighed && weighed > 20);
    QVERIFY(blocked > 20 && blocked < chosen);
    QVERIFY(isReddish(on, {8.7, 2.7}) && !isReddish(on, {8.7, 6.3}));
  }

  void legend_ofTheSelectedRobot_hasWhatIsShown() {
    sim2d::RobotTelemetry senses = withScan();
    showSenses(senses);
    shot(&CanvasOptions::lidar, true);
    const int alone = view_.viewport()->width();
    const auto parts = [this] { return editor::legendOf(scene_, 50.0); };
    QVERIFY(parts().empty());
    document_.setSelection({{base::EntityKind::Robot, 21}});
    shot(&CanvasOptions::lidar, true);
    QCOMPARE(parts().size(), std::size_t{1});
    QCOMPARE(parts().front().title, QStringLiteral("Robot"));
    const auto* legend = view_.findChild<editor::LegendStrip*>();
    QTRY_VERIFY(legend->isVisible());
    QCOMPARE(view_.viewport()->width(), alone);  // Over the map.
    shot(&CanvasOptions::lidar, false);
    QVERIFY(parts().empty());
    QTRY_VERIFY(!legend->isVisible());
    QCOMPARE(view_.viewport()->width(), alone);
  }

  void legend_withDetections_isShown() {
    sim2d::RobotTelemetry senses = withScan();
    senses.bodies.resize(1);
    showSenses(senses);
    shot(&CanvasOptions::detections, true);
    document_.setSelection({{base::EntityKind::Robot, 21}});
    const std::vector<editor::LegendPart> parts = editor::legendOf(scene_, 50.0);
    QCOMPARE(parts.size(), std::size_t{1});
    QCOMPARE(parts.front().title, QStringLiteral("Robot"));
    QCOMPARE(parts.front().rows.size(), std::size_t{1});
  }

  /// Frames of a run in the window have senses; recorded ones have none, and nothing is drawn.
  void senses_ofARun_areInItsNewestFramesOnly() {
    start(small::scenario());
    editor::SimulationRunner runner;
    runner.setRequest([this] {
      editor::RunRequest request = editor::runRequestOf(document_);
      request.rule = {3, false};
      return request;
    });
    QSignalSpy finished(&runner, &editor::SimulationRunner::finished);
    runner.setSpeed(kHuge);
    runner.play();
    QVERIFY(finished.wait(60000));
    QVERIFY(runner.newestFrame()->senses != nullptr);
    QCOMPARE(runner.newestFrame()->senses->size(), std::size_t{1});
    const editor::FramePtr recorded = runner.recording()->frame(1);
    QVERIFY(recorded->senses == nullptr);
    scene_.showFrame(recorded);
    const QImage off = shot(&CanvasOptions::contacts, true);  // with room for the legend
    CanvasOptions all = scene_.options();
    all.lidar = all.detections = all.candidates = true;
    scene_.setOptions(all);
    QCoreApplication::processEvents();
    QCOMPARE(view_.viewport()->grab().toImage(), off);
  }

  void scale_isOfWhatMayBeDriven() {
    std::vector<Way> ways;
    for (int k = 0; k <= 10; ++k) {
      ways.push_back({{}, 10.0 + k, false});
    }
    ways.push_back({{}, kHuge, false});
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
    const QImage off = plannerShot({});
    const QImage on = plannerShot({&CanvasOptions::localCosts});
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
    const QImage off = plannerShot({});
    const QImage both = plannerShot({&CanvasOptions::localCosts, &CanvasOptions::globalCosts});
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
    const QImage off = plannerShot({});
    const QImage on = plannerShot({&CanvasOptions::masks});
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
    QVERIFY(colorAt(plannerShot({&CanvasOptions::masks}), {5.2, 4.2}) != keepout);
    scene_.setTheme(editor::Theme::light());
  }

  void ways_onTheMap_areBlueOrOrangeByTheirPrice() {
    sim2d::RobotTelemetry senses = withPrices();
    senses.ways[0].cost = 3.0;
    senses.ways.push_back({{{6.0, 4.5}, {8.0, 7.0}}, 3.1, false, {{"PathDist", 3.1}}});
    showSenses(senses);
    const QImage off = plannerShot({});
    const QImage on = plannerShot({&CanvasOptions::candidates});
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
    plannerShot({&CanvasOptions::candidates});
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
    plannerShot({&CanvasOptions::localCosts});
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
    plannerShot({});
    for (int step = 0; step < 10; ++step) {
      runner.stepOnce();
      QTRY_VERIFY(runner.newestFrame() != nullptr && runner.newestFrame()->step == step + 1);
    }
    QVERIFY(runner.newestFrame()->senses->front().localCosts == nullptr);
    QVERIFY(runner.newestFrame()->senses->front().ways.empty());
    plannerShot({&CanvasOptions::localCosts, &CanvasOptions::candidates});
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

QTEST_MAIN(SensesOnMapTest)
#include "tst_SensesOnMap.moc"
