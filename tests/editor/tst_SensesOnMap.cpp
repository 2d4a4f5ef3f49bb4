#include <limits>

#include <QImage>
#include <QSignalSpy>
#include <QtTest>

#include "CanvasTester.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/MapLegend.h"
#include "editor/canvas/RobotPainters.h"
#include "editor/canvas/ViewOverlays.h"
#include "editor/run/SimulationRunner.h"

using editor::CanvasOptions;
using editor::Role;
using editor::Vec2;

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

}  // namespace

/// What robots perceive and weigh, as layers of a run.
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
    QTRY_COMPARE(view_.viewport()->width(), alone - editor::LegendStrip::kWidth);  // beside the map
    shot(&CanvasOptions::lidar, false);
    QVERIFY(parts().empty());
    QTRY_COMPARE(view_.viewport()->width(), alone);
  }

  void legend_withDetections_standsBesideTheMap() {
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
};

QTEST_MAIN(SensesOnMapTest)
#include "tst_SensesOnMap.moc"
