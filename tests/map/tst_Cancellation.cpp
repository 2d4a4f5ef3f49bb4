#include <QtTest>

#include "sim2d/map/BlockGraph.h"
#include "sim2d/map/DistanceField.h"
#include "sim2d/map/GoalSearch.h"
#include "sim2d/map/NavigationMap.h"
#include "tests/map/MapSketch.h"

using namespace sketch;

/// Work on a map that is told to stop ends at its next row, and nothing half done is left of it.
class StoppedWorkTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() { stop_ = std::make_shared<base::StopFlag>(); }

  void work_stopped_throws() {
    const std::vector<char> none(grid_.cells().size(), 0);
    QCOMPARE(traceOutlines(grid_, *stop_).size(), traceOutlines(grid_).size());
    const auto ordinary =
        std::make_shared<const DistanceField>(grid_, obstacles_, std::vector<Vec2>(), 1e9, stop_);
    const Terrain terrain(*ordinary, 0.2);
    Cell open{100, 100};
    while (!terrain.isOpen(terrain.indexOf(open))) {
      ++open.column;
    }
    CellGoalSearch search(terrain, terrain.indexOf(open));
    const auto large =
        std::make_shared<const DistanceField>(grid_, obstacles_, std::vector<Vec2>(), 0.0, stop_);
    stop_->stop();
    QVERIFY_EXCEPTION_THROWN(traceOutlines(grid_, *stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(distancesToMarked(200, 200, none, *stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(quantizedDistancesToMarked(200, 200, none, *stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(DistanceField(grid_, obstacles_, {}, 1e9, stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(cellsOfObstacles(grid_, obstacles_, false, *stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(obstacles_.build(*stop_), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(TraversableSpace(ordinary, 0.2), base::Stopped);  // has unknown ground
    QVERIFY_EXCEPTION_THROWN(Terrain(*ordinary, 0.2), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(search.reach(terrain.indexOf({0, 0})), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(OpenBlocks{large}, base::Stopped);
    QVERIFY_EXCEPTION_THROWN(BlockGraph(*large, 0.35), base::Stopped);
  }

  void layers_stopped_keepNothing() {
    NavigationLayerCache layers(stop_);
    const auto before = layers.of(grid_, obstacles_, {});
    QCOMPARE(layers.of(grid_, obstacles_, {}), before);
    stop_->stop();
    QCOMPARE(layers.of(grid_, obstacles_, {}), before);  // it is there already
    obstacles_.setEnabled(0, false);
    for (int i = 0; i < 2; ++i) {
      QVERIFY_EXCEPTION_THROWN(layers.of(grid_, obstacles_, {}), base::Stopped);
    }
  }

  void plan_stopped_throws() {
    const auto field =
        std::make_shared<const DistanceField>(grid_, obstacles_, std::vector<Vec2>(), 0.0, stop_);
    PathPlanner before(field, 0.2);
    PathPlanner after(field, 0.2);
    const Vec2 from(0.3, 0.3);
    const Vec2 to(9.7, 9.7);
    QVERIFY(before.plan(from, to).size() > 2);
    stop_->stop();
    QVERIFY_EXCEPTION_THROWN(after.plan(from, to), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(after.isReachable(from, to), base::Stopped);
  }

  void needed_stopped_goesOn() {
    {
      const base::StopInhibitor first(stop_);
      const base::StopInhibitor second(stop_);
      stop_->stop();
      stop_->check();
    }
    QVERIFY_EXCEPTION_THROWN(stop_->check(), base::Stopped);
    QVERIFY_EXCEPTION_THROWN(base::StopInhibitor{stop_}, base::Stopped);
  }

 private:
  OccupancyGrid grid_ = randomMap(1);
  Obstacles obstacles_ = sceneOf(grid_).obstacles;
  std::shared_ptr<base::StopFlag> stop_;
};

QTEST_APPLESS_MAIN(StoppedWorkTest)
#include "tst_Cancellation.moc"
