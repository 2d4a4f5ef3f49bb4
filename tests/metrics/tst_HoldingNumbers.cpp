#include <QtTest>

#include "HandMade.h"
#include "metrics/RunResults.h"
#include "metrics/VoronoiCells.h"
#include "sim2d/base/Rng.h"

using namespace metrics;
using namespace handmade;

namespace {

constexpr double kPi = base::kPi;

/// Along x at 1 m/s from 0 to 5 m, then parked; samples every second.
SampledRun parkedRun(int seconds) {
  std::vector<Sample> samples;
  for (int t = 0; t <= seconds; ++t) {
    samples.push_back(sampleAt(t, std::min(t, 5), 0.0, t < 5 ? 1.0 : 0.0));
    samples.back().people = {personAt(1, 20.0, 20.0)};
  }
  SampledRun run = recordingOfSamples(std::move(samples));
  run.robotId = -1;
  run.goals = {{1, Vec2(5.0, 0.0), 0.2}};
  run.events = {{5.0, eventOf(EventKind::Arrived, -1)}};
  return run;
}

std::shared_ptr<const sim2d::Obstacles> wallsAlong(std::initializer_list<double> heights) {
  sim2d::Obstacles walls;
  for (const double y : heights) {
    sim2d::Outline outline;
    const double out = y < 0.0 ? y - 0.2 : y + 0.2;
    outline.points = {Vec2(-50.0, y), Vec2(50.0, y), Vec2(50.0, out), Vec2(-50.0, out)};
    if (y < 0.0) {
      std::reverse(outline.points.begin(), outline.points.end());
    }
    walls.add({outline});
  }
  walls.build();
  return std::make_shared<const sim2d::Obstacles>(std::move(walls));
}

/// A strip 1 m wide along x with a wall across it.
std::shared_ptr<const sim2d::Obstacles> stripWith(double left, double right) {
  const auto box = [](double x1, double y1, double x2, double y2) {
    sim2d::Outline outline;
    outline.points = {Vec2(x1, y1), Vec2(x2, y1), Vec2(x2, y2), Vec2(x1, y2)};
    return outline;
  };
  sim2d::Obstacles walls;
  walls.add({box(-50.0, -0.7, 50.0, -0.5)});
  walls.add({box(-50.0, 0.5, 50.0, 0.7)});
  walls.add({box(left, -0.6, right, 0.6)});
  walls.build();
  return std::make_shared<const sim2d::Obstacles>(std::move(walls));
}

/// A person's record on a straight line: heights by seconds, steps at which goals were reached.
sim2d::Trace walk(const std::vector<double>& ys, const std::vector<int>& goals,
                  const std::vector<std::string>& names = {}) {
  sim2d::Trace trace;
  trace.header.dt = 1.0;
  for (std::size_t k = 0; k < ys.size(); ++k) {
    sim2d::Frame frame;
    frame.step = static_cast<std::int64_t>(k);
    frame.time = static_cast<double>(k);
    frame.humans.add(1, {Vec2(static_cast<double>(k), ys[k]), 0.0}, Vec2::Zero(), 0.0, 0);
    frame.humans.group.push_back(-1);
    frame.humans.state.push_back(0);
    trace.frames.push_back(frame);
  }
  for (std::size_t k = 0; k < goals.size(); ++k) {
    sim2d::Event event = eventOf(EventKind::Goal, 1);
    event.text = k < names.size() ? names[k] : "";
    trace.events.emplace_back(goals[k], event);
  }
  return trace;
}

}  // namespace

/// Numbers that hold when somebody recomputes them: expected values by hand or by another method.
class HoldingNumbersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void robot_afterArrival_countsNoMore() {
    const SampledRun atOnce = parkedRun(5);
    const SampledRun later = parkedRun(200);
    for (const char* key : {"stl", "spl", "avg_robot_linear_speed", "time_not_moving",
                            "path_length", "path_efficiency", "stalled_time", "motion_energy"}) {
      QCOMPARE(valueOf(later, key), valueOf(atOnce, key));
    }
    QCOMPARE(valueOf(later, "total_time"), 200.0);
    QCOMPARE(valueOf(later, "timeout"), 0.0);  // of its way: 5 s, not 180 s
    QVERIFY(isNear(valueOf(atOnce, "avg_robot_linear_speed"), 5.0 / 6.0));
  }

  void robot_parkedAndTouched_hasSucceeded() {
    SampledRun run = parkedRun(20);
    run.samples[15].people = {personAt(1, 5.2, 0.0)};
    QCOMPARE(valueOf(run, "success"), 1.0);
    run.samples[3].people = {personAt(1, 3.2, 0.0)};
    QCOMPARE(valueOf(run, "success"), 0.0);
  }

  void robot_beforeItSetsOff_doesNotCount() {
    SampledRun run = parkedRun(5);
    for (Sample& sample : run.samples) {
      sample.time += 10.0;
    }
    run.events[0].first += 10.0;
    for (int t = 9; t >= 0; --t) {
      run.samples.insert(run.samples.begin(), sampleAt(t, 0.0, 0.0));
    }
    run.robotStartTime = 10.0;
    QCOMPARE(valueOf(run, "stl"), valueOf(parkedRun(5), "stl"));
    QCOMPARE(valueOf(run, "stalled_time"), valueOf(parkedRun(5), "stalled_time"));
  }

  void window_thatSaysItsEnd_isHeeded() {
    const SampledRun run = parkedRun(20);
    Selection selection;
    selection.window.until = "time 20";
    const base::Result<Evaluation> whole = evaluate(run, selection, {});
    QVERIFY(isNear(*whole->find("avg_robot_linear_speed")->value.value, 5.0 / 21.0));
    selection.window.until = "end";
    const base::Result<Evaluation> way = evaluate(run, selection, {});
    QVERIFY(isNear(*way->find("avg_robot_linear_speed")->value.value, 5.0 / 6.0));
    const Series& series = *way->find("avg_robot_linear_speed")->value.series;
    QCOMPARE(series.values.size(), way->times.size());
    QVERIFY(std::isnan(series.values.back()));
    MetricParameters original;
    original.profile = Profile::Hunav2;
    QVERIFY(isNear(*evaluate(run, selection, original)->find("avg_robot_linear_speed")->value.value,
                   5.0 / 21.0));
  }

  void lineCrossings_overTheSeam_areTold() {
    MetricParameters parameters;
    parameters.flowLineX1 = parameters.flowLineX2 = 9.9;
    parameters.flowLineY1 = -1.0;
    parameters.flowLineY2 = 1.0;
    SampledRun run =
        recordingOfSamples({sampleAt(0, 0, 50), sampleAt(1, 0, 50), sampleAt(2, 0, 50)});
    run.seam = {0.0, 10.0};
    const double places[] = {9.8, 0.2, 1.0};  // over the line and the seam, then on
    for (std::size_t k = 0; k < 3; ++k) {
      run.samples[k].people = {personAt(1, places[k], 0.0)};
    }
    QCOMPARE(valueOf(run, "line_crossings", parameters), 1.0);
    parameters.flowLineX1 = parameters.flowLineX2 = 5.0;
    QCOMPARE(valueOf(run, "line_crossings", parameters), 0.0);  // no jump back through it
    parameters.flowLineX1 = parameters.flowLineX2 = 0.1;
    QCOMPARE(valueOf(run, "line_crossings", parameters), 1.0);
  }

  /// Over the line once; then back at the start between two samples, without walking there.
  void lineCrossings_ofWhoComesAgain_countTheWalk() {
    MetricParameters parameters;
    parameters.flowLineX1 = parameters.flowLineX2 = 5.0;
    parameters.flowLineY1 = -1.0;
    parameters.flowLineY2 = 1.0;
    SampledRun run =
        recordingOfSamples({sampleAt(0, 0, 50), sampleAt(5, 0, 50), sampleAt(10, 0, 50)});
    const double places[] = {1.0, 9.0, 1.5};
    for (std::size_t k = 0; k < 3; ++k) {
      run.samples[k].people = {personAt(1, places[k], 0.0)};
    }
    QCOMPARE(valueOf(run, "line_crossings", parameters), 2.0);  // there and back
    const sim2d::Event enter = eventOf(EventKind::Enter, 1);
    run.events = {{0.0, enter}, {9.5, enter}};
    QCOMPARE(valueOf(run, "line_crossings", parameters), 1.0);
    Selection selection;
    selection.behaviors = true;
    const base::Result<Evaluation> all = evaluate(run, selection, parameters);
    QCOMPARE(all->behaviors.size(), std::size_t{1});
    const MetricResult* ofRegular = findResult(all->behaviors[0].results, "line_crossings");
    QCOMPARE(*ofRegular->value.value, 1.0);
  }

  void areaInCircle_knownShapes_isExact() {
    const std::vector<Vec2> large = {Vec2(9, 9), Vec2(-9, 9), Vec2(-9, -9), Vec2(9, -9)};
    QVERIFY(isNear(areaInCircle(large, 2.0), 4.0 * kPi));
    const std::vector<Vec2> small = {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)};
    QVERIFY(isNear(areaInCircle(small, 2.0), 4.0));
    // Half a circle, and a segment of it: r^2 acos(d/r) - d sqrt(r^2 - d^2).
    const std::vector<Vec2> half = {Vec2(9, 9), Vec2(0, 9), Vec2(0, -9), Vec2(9, -9)};
    QVERIFY(isNear(areaInCircle(half, 2.0), 2.0 * kPi));
    const std::vector<Vec2> cap = {Vec2(9, 9), Vec2(1, 9), Vec2(1, -9), Vec2(9, -9)};
    QVERIFY(isNear(areaInCircle(cap, 2.0), 4.0 * std::acos(0.5) - std::sqrt(3.0)));
  }

  /// In a strip of 1.2 m, somebody every 0.8 m: 1 / 0.96 per m² away from the ends.
  void voronoi_betweenWalls_isThatOfTheStrip() {
    RunContext context;
    context.walls = wallsAlong({-0.6, 0.6});
    VoronoiCellAreas areas(2.0);
    const double area = areas.areaOf(Vec2(0, 0), {Vec2(-0.8, 0), Vec2(0.8, 0)}, context);
    QVERIFY2(isNear(area, 0.96), std::to_string(area).c_str());
  }

  void voronoi_behindAWall_takesNothing() {
    RunContext context;
    context.walls = wallsAlong({0.3});
    VoronoiCellAreas areas(2.0);
    const double alone = areas.areaOf(Vec2(0, 0), {}, context);
    // Below y = 0.3 in a circle of 2 m.
    const double above = 4.0 * std::acos(0.15) - 0.3 * std::sqrt(4.0 - 0.09);
    QVERIFY2(isNear(alone, 4.0 * kPi - above), std::to_string(alone).c_str());
    QVERIFY(isNear(areas.areaOf(Vec2(0, 0), {Vec2(0, 0.8)}, context), alone));
  }

  void voronoi_overTheSeam_seesTheOthers() {
    SampledRun run = recordingOfSamples({sampleAt(0, 0, 50)});
    run.seam = {0.0, 4.0};
    run.walls = wallsAlong({-0.5, 0.5});
    for (int k = 0; k < 4; ++k) {
      run.samples[0].people.push_back(personAt(k + 1, 0.5 + k, 0.0));
    }
    QVERIFY(isNear(valueOf(run, "crowd_voronoi_density"), 1.0));
  }

  /// Somebody at 0.5 m, somebody at 3.2 m, a wall across the strip from 3.6 m to 3.7 m: over the
  /// seam they do not see each other.
  void voronoi_wallAtTheSeam_hides() {
    RunContext context;
    context.seam = {0.0, 4.0};
    context.walls = stripWith(3.6, 3.7);
    VoronoiCellAreas areas(2.0);
    // From the image of the wall, -0.3 m, to the middle, 1.85 m; from there to the wall.
    const double first = areas.areaOf(Vec2(0.5, 0), {Vec2(3.2, 0), Vec2(-0.8, 0)}, context);
    QVERIFY2(isNear(first, 2.15), std::to_string(first).c_str());
    const double second = areas.areaOf(Vec2(3.2, 0), {Vec2(0.5, 0), Vec2(4.5, 0)}, context);
    QVERIFY2(isNear(second, 1.75), std::to_string(second).c_str());
  }

  /// Beyond the ends there is nothing, so that it has no image within.
  void voronoi_wallBeyondTheSeam_doesNotCount() {
    RunContext context;
    context.seam = {0.0, 4.0};
    context.walls = stripWith(4.3, 4.4);
    VoronoiCellAreas areas(2.0);
    const double first = areas.areaOf(Vec2(0.5, 0), {Vec2(1.5, 0), Vec2(-0.5, 0)}, context);
    QVERIFY2(isNear(first, 1.0), std::to_string(first).c_str());
    const double last = areas.areaOf(Vec2(3.5, 0), {Vec2(2.5, 0), Vec2(4.5, 0)}, context);
    QVERIFY2(isNear(last, 1.0), std::to_string(last).c_str());
  }

  /// By darts: what is nearer, in the circle, and seen round the corner of a wall.
  void voronoi_roundACorner_agreesWithDarts() {
    sim2d::Obstacles walls;
    sim2d::Outline block;
    block.points = {Vec2(0.5, 0.2), Vec2(2.5, 0.2), Vec2(2.5, 1.5), Vec2(0.5, 1.5)};
    walls.add({block});
    walls.build();
    RunContext context;
    context.walls = std::make_shared<const sim2d::Obstacles>(std::move(walls));
    const std::vector<Vec2> others = {Vec2(-1.0, 0.4), Vec2(0.3, -1.2)};
    const double area = VoronoiCellAreas(2.0).areaOf(Vec2(0, 0), others, context);
    const base::AgentRng rng(3, 1);
    int hits = 0;
    constexpr int kDarts = 200000;
    for (int k = 0; k < kDarts; ++k) {
      const auto draw = [&](int which) {
        return 4.0 * rng.uniform01(base::DrawPurpose::Test,
                                   static_cast<std::uint32_t>(2 * k + which)) -
               2.0;
      };
      const Vec2 dart(draw(0), draw(1));
      const bool isNearest = std::all_of(others.begin(), others.end(), [&](const Vec2& other) {
        return dart.norm() <= (dart - other).norm();
      });
      hits += dart.norm() <= 2.0 && isNearest && context.walls->isVisible(Vec2(0, 0), dart) ? 1 : 0;
    }
    const double estimate = 16.0 * hits / kDarts;
    QVERIFY2(std::fabs(area - estimate) < 0.05,
             qPrintable(QStringLiteral("%1 and %2").arg(area).arg(estimate)));
  }

  void obstacles_withoutAny_areUndefined() {
    SampledRun run = parkedRun(5);
    for (const char* key : {"obstacle_collisions", "obstacle_safety", "obstacle_force_on_robot",
                            "obstacle_force_on_agents", "clearing_distance_min"}) {
      QVERIFY2(std::isnan(valueOf(run, key)), key);
    }
    run.hasObstacles = true;
    QCOMPARE(valueOf(run, "obstacle_collisions"), 0.0);
    QCOMPARE(valueOf(run, "obstacle_safety"), 0.0);
    run.goals.clear();
    QVERIFY(std::isnan(valueOf(run, "success")));
  }

  void curvature_ofStandingAndTurning_isNone() {
    // An arc of radius 2 m, then trembling by a nanometre.
    std::vector<Sample> samples;
    for (int k = 0; k < 20; ++k) {
      const double angle = 0.05 * k;
      samples.push_back(sampleAt(0.1 * k, 2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle), 1.0));
    }
    const Vec2 end = samples.back().robot.position;
    for (int k = 20; k < 40; ++k) {
      samples.push_back(sampleAt(0.1 * k, end.x() + (k % 2) * 1e-9, end.y() + (k % 3) * 1e-9));
    }
    const SampledRun run = recordingOfSamples(std::move(samples));
    QVERIFY(std::fabs(valueOf(run, "curvature_max") - 0.5) < 1e-3);
    QVERIFY(std::fabs(valueOf(run, "curvature_avg") - 0.5) < 1e-3);
  }

  void pathEfficiency_onOpenGround_isByTheStraightLine() {
    SampledRun run = recordingOfSamples({sampleAt(0, 0, 0), sampleAt(1, 3, 4)});
    QCOMPARE(valueOf(run, "path_efficiency"), 1.0);
    run.samples.push_back(sampleAt(2, 3, 0));
    QVERIFY(isNear(valueOf(run, "path_efficiency"), 3.0 / 9.0));
  }

  /// From below to above a block of 2 m by 6 m, whose corner lies 1 m ahead and 1 m aside.
  void pathEfficiency_roundABlock_isByTheWayRound() {
    const double radius = 0.2;
    sim2d::TraceHeader header;
    sim2d::Outline block;
    block.points = {Vec2(1.0, -5.0), Vec2(3.0, -5.0), Vec2(3.0, 1.0), Vec2(1.0, 1.0)};
    header.obstacles.push_back({"block", false, false, {}, {block}});
    header.robots.push_back({});
    header.robots[0].radius = radius;
    SampledRun run;
    static_cast<RunContext&>(run) = SampleBuilder(header).context();
    // Straight to the circle round the corner, along it, 2 m level, and the same down.
    const double side = std::sqrt(2.0 - radius * radius) +
                        radius * (kPi / 4.0 + std::asin(radius / std::sqrt(2.0)));
    run.samples = {sampleAt(0, 0, 0), sampleAt(1, 0, 3), sampleAt(2, 4, 3), sampleAt(3, 4, 0)};
    const double efficiency = valueOf(run, "path_efficiency");
    QVERIFY2(std::fabs(efficiency - (2.0 + 2.0 * side) / 10.0) < 1e-3,
             std::to_string(efficiency).c_str());
    run.goals = {{1, Vec2(4.0, 0.0), 0.2}};
    QVERIFY(std::fabs(valueOf(run, "spl") - efficiency) < 1e-12);
  }

  void responsibility_ofWhoNeverTurns_isUndefined() {
    std::vector<Sample> samples;
    for (int k = 0; k < 20; ++k) {
      const double noise = 1e-7 * (k % 3);
      samples.push_back(sampleAt(0.05 * k, 0.05 * k, 0.0, 1.0 + noise));
      samples.back().robot.velocity = Vec2(1.0, noise);
      samples.back().people = {personAt(1, 4.0 - 0.05 * k, 0.2, -1.0, noise)};
    }
    QVERIFY(std::isnan(valueOf(recordingOfSamples(samples), "responsibility")));
    for (std::size_t k = 10; k < 20; ++k) {
      samples[k].robot.velocity = Vec2(1.0, -0.1);
    }
    QCOMPARE(valueOf(recordingOfSamples(samples), "responsibility"), 100.0);
  }

  void aggregatedTime_whoNeverArrives_countsAll() {
    SampledRun run = parkedRun(20);
    for (Sample& sample : run.samples) {
      sample.people[0].wantsToArrive = true;
    }
    QCOMPARE(valueOf(run, "aggregated_time"), 25.0);  // 5 s of the robot, 20 s of the person
    run.events.insert(run.events.begin(), {4.0, eventOf(EventKind::Arrived, 1)});
    QCOMPARE(valueOf(run, "aggregated_time"), 9.0);
    // a robot that is not measured
    run.events.insert(run.events.begin(), {3.0, eventOf(EventKind::Arrived, -2)});
    QCOMPARE(valueOf(run, "aggregated_time"), 9.0);
  }

  void timeToCollision_farAhead_isCapped() {
    SampledRun run = recordingOfSamples({sampleAt(0, 0, 0, 1.0), sampleAt(1, 0, 0, 0.001)});
    run.samples[0].people = run.samples[1].people = {personAt(1, 2.5, 0.0)};
    QVERIFY(isNear(valueOf(run, "avg_time_to_collision"), (2.0 + 10.0) / 2.0));
    run.samples[0].people = run.samples[1].people = {personAt(1, -2.5, 0.0)};
    QVERIFY(std::isinf(valueOf(run, "min_time_to_collision")));
  }

  void dtw_ofARunWithItself_isZero() {
    std::vector<Sample> samples;
    std::vector<std::pair<double, Vec2>> way;
    for (int k = 0; k < 900; ++k) {  // more than are compared
      samples.push_back(sampleAt(0.1 * k, 0.05 * k, std::sin(0.02 * k * k / 30.0), 1.0));
      way.emplace_back(0.1 * k, samples.back().robot.position);
    }
    SampledRun run = recordingOfSamples(std::move(samples));
    run.reference = way;
    QCOMPARE(valueOf(run, "dtw"), 0.0);
  }

  /// With the robot the person goes round by a metre and reaches two goals, without it three.
  void counterfactual_oneGoalLess_comparesToTheLastCommon() {
    const sim2d::Trace with = walk({0, 1, 1, 0, 0, 0, 0, 0}, {2, 5});
    const sim2d::Trace without = walk({0, 0, 0, 0, 0, 0, 0, 0}, {2, 4, 6});
    const PersonEffect effect = personEffects(with, without).front();
    const double diagonal = std::sqrt(2.0);
    QVERIFY(isNear(effect.detour, (diagonal + 1.0 + diagonal + 2.0) - 4.0));
    QVERIFY(isNear(effect.delay, 1.0));
    const PersonEffect never = personEffects(walk({0, 1, 0}, {}), walk({0, 0, 0}, {2})).front();
    QVERIFY(std::isnan(never.delay));
    QVERIFY(isNear(never.detour, 2.0 * diagonal - 2.0));
  }

  /// Goal 2 is left out beside the robot: what comes after it is not compared.
  void counterfactual_otherGoals_comparesToTheLastSame() {
    const std::vector<double> straight(8, 0.0);
    const sim2d::Trace without = walk(straight, {3, 4, 6}, {"1", "2", "3"});
    const PersonEffect effect = personEffects(walk(straight, {2, 5}, {"1", "3"}), without).front();
    QVERIFY(isNear(effect.delay, -1.0));   // 2 s, not 3 s
    QVERIFY(isNear(effect.detour, -1.0));  // at 1 m/s
    const PersonEffect none = personEffects(walk(straight, {2, 5, 7}, {"2", "1", "3"}), without)[0];
    QVERIFY(std::isnan(none.delay));
  }
};

QTEST_APPLESS_MAIN(HoldingNumbersTest)
#include "tst_HoldingNumbers.moc"
