#include <cmath>
#include <vector>

#include <QtTest>

#include "sim2d/nav/PolicyObservation.h"
#include "tests/nav/ExternalScene.h"

using namespace external;

namespace {

using Floats = std::vector<float>;

/// Distances behind, to the right, ahead and to the left of a sensor at the origin.
LaserScan fourBeams() {
  LaserScan scan;
  scan.angleMin = -base::kPi;
  scan.angleIncrement = base::kPi / 2.0;
  scan.distances = {1.0, 2.0, 3.0, 12.0};
  return scan;
}

Floats lidarOf(const Pose2& pose, const LaserScan* scan, std::size_t beams) {
  Floats values(beams);
  writePolicyLidar(pose, scan, beams, values.data());
  return values;
}

TrackedBody personAt(int id, const Vec2& position) {
  TrackedBody body;
  body.id = id;
  body.position = position;
  return body;
}

}  // namespace

class PolicyObservationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void state_turnedRobot_isInItsFrame() {
    Floats state(kPolicyStateColumns);
    writePolicyState({{1.0, 2.0}, base::kPi / 2.0}, {0.5, -0.25, 0.125}, {1.0, 5.0}, state.data());
    QVERIFY(std::fabs(state[0] - 3.0F) < 1e-6F && std::fabs(state[1]) < 1e-6F);
    QCOMPARE(Floats(state.begin() + 2, state.end()), Floats({0.5F, 0.125F, -0.25F}));
  }

  void people_nearestFirst_thenZeros() {
    std::vector<TrackedBody> bodies = {personAt(4, {0.0, 2.0}), personAt(3, {2.0, 0.0}),
                                       personAt(5, {1.0, 0.0}), personAt(6, {15.5, 0.0})};
    bodies[1].velocity = {0.5, 0.25};
    bodies[2].radius = 0.25;
    bodies.push_back(personAt(-1, {0.5, 0.0}));
    bodies.back().kind = BodyKind::Robot;
    const auto near = nearestPeople({0.0, 0.0}, bodies);
    QCOMPARE(near.size(), std::size_t{3});
    Floats rows(2 * kPolicyPersonColumns);
    writePolicyPeople({}, near, 2, rows.data());  // equal distances by id
    QCOMPARE(rows, Floats({1.0F, 0.0F, 0.0F, 0.0F, 0.25F, 2.0F, 0.0F, 0.5F, 0.25F, 0.35F}));
    rows.assign(4 * kPolicyPersonColumns, 9.0F);
    writePolicyPeople({}, near, 4, rows.data());
    QCOMPARE(rows[10], 0.0F);
    QCOMPARE(rows[11], 2.0F);
    QCOMPARE(Floats(rows.begin() + 15, rows.end()), Floats(5, 0.0F));
  }

  void lidar_sameBeams_areTheDistances() {
    const LaserScan scan = fourBeams();
    QCOMPARE(lidarOf({}, &scan, 4), Floats({1.0F, 2.0F, 3.0F, 10.0F}));  // at most 10 m
    QCOMPARE(lidarOf({}, nullptr, 2), Floats({10.0F, 10.0F}));
  }

  void lidar_otherBeams_takesTheNearest() {
    const LaserScan scan = fourBeams();  // asked for at -180, -120, -60, 0, 60 and 120 degrees
    QCOMPARE(lidarOf({}, &scan, 6), Floats({1.0F, 2.0F, 2.0F, 3.0F, 10.0F, 10.0F}));
    const LaserScan fine = [&scan] {
      LaserScan copy = scan;
      copy.angleIncrement = base::kPi / 4.0;
      copy.distances = {1.0, 9.0, 2.0, 9.0, 3.0, 9.0, 4.0, 9.0};
      return copy;
    }();
    QCOMPARE(lidarOf({}, &fine, 4), Floats({1.0F, 2.0F, 3.0F, 4.0F}));
  }

  void lidar_robotTurnedSinceTheScan_usesItsHeading() {
    const LaserScan scan = fourBeams();
    const Pose2 turned{{0.0, 0.0}, base::kPi / 2.0};
    QCOMPARE(lidarOf(turned, &scan, 4), Floats({2.0F, 3.0F, 10.0F, 1.0F}));
    LaserScan mounted = scan;  // the first beam looks ahead
    mounted.sensor.heading = base::kPi;
    QCOMPARE(lidarOf({}, &mounted, 4), Floats({3.0F, 10.0F, 1.0F, 2.0F}));
  }

  void lidar_fieldOfViewAndRange_endAtTenMetres() {
    LaserScan narrow;  // 45 degrees to either side
    narrow.angleMin = -base::kPi / 4.0;
    narrow.angleIncrement = base::kPi / 4.0;
    narrow.range = 6.5;
    narrow.distances = {5.0, 6.0, 6.5};
    QCOMPARE(lidarOf({}, &narrow, 4), Floats({10.0F, 10.0F, 6.0F, 10.0F}));
    QCOMPARE(lidarOf({}, &narrow, 8),
             Floats({10.0F, 10.0F, 10.0F, 5.0F, 6.0F, 10.0F, 10.0F, 10.0F}));
  }

  void grid_wallsAndBodies_areOccupied() {
    const Scene scene;  // with a block from (2, 3) to (3, 4)
    const PolicySizes sizes{0, 0, 4, 0.5};
    Floats cells(16);
    std::vector<TrackedBody> others = {personAt(1, {1.25, 2.25})};
    others[0].radius = 0.1;
    writePolicyGrid({{2.0, 3.0}, 0.0}, others, *scene.observation.obstacles, sizes, cells.data());
    QCOMPARE(cells, Floats({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1}));
    writePolicyGrid({{2.0, 3.0}, base::kPi / 2.0}, {}, *scene.observation.obstacles, sizes,
                    cells.data());  // the block is ahead to the right
    QCOMPARE(cells, Floats({0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0}));
  }

  void fill_sizes_decideWhichArraysExist() {
    const Scene scene;
    PolicyObservation seen({1, 0, 0, 0.1});
    seen.fill(scene.observation);
    QCOMPARE(seen.state, Floats({4.0F, 1.0F, 0.0F, 0.0F, 0.0F}));
    QCOMPARE(seen.people, Floats({1.5F, 1.0F, 0.0F, -0.5F, 0.3F}));
    QVERIFY(seen.lidar.empty() && seen.grid.empty());
  }
};

QTEST_GUILESS_MAIN(PolicyObservationTest)
#include "tst_PolicyObservation.moc"
