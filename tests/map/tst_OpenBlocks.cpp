#include <random>

#include <QtTest>

#include "sim2d/map/NavigationMap.h"
#include "tests/map/MapSketch.h"
#include "tests/support/Columns.h"

using namespace sketch;

namespace {

/// 20 x 12 m between walls, some shelves, some unknown cells.
OccupancyGrid hall(const Pose2& origin) {
  MapSketch sketch(20.0, 12.0);
  sketch.fill({0.0, 0.0}, {20.0, 0.1}).fill({0.0, 11.9}, {20.0, 12.0});
  sketch.fill({4.0, 3.0}, {9.0, 3.6})
      .fill({12.0, 6.0}, {12.3, 10.0})
      .fill({2.0, 8.0}, {3.0, 9.0}, -1);
  const OccupancyGrid plain = sketch.grid();
  return OccupancyGrid(plain.width(), plain.height(), plain.resolution(), origin, plain.cells());
}

}  // namespace

class OpenBlocksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void areFree_roomWithAPillar_knowsTheRectangles() {
    MapSketch sketch(10.0, 10.0);
    const OpenBlocks blocks(sceneOf(sketch.fill({5.0, 5.0}, {5.2, 5.2}).grid()).field);
    QVERIFY(blocks.areFree({1.0, 1.0}, {9.0, 4.0}));
    QVERIFY(blocks.areFree({9.0, 4.0}, {1.0, 1.0}));
    QVERIFY(blocks.areFree({6.5, 1.0}, {6.5, 9.0}));
    QVERIFY(blocks.areFree({2.0, 2.0}, {2.0, 2.0}));
    QVERIFY(!blocks.areFree({1.0, 1.0}, {9.0, 9.0}));
    QVERIFY(!blocks.areFree({1.0, 5.1}, {9.0, 5.1}));
    QVERIFY(!blocks.areFree({1.0, 9.0}, {9.0, 1.0}));
    QVERIFY(!blocks.areFree({1.0, 1.0}, {10.5, 1.0}));  // nobody knows what is outside
    QVERIFY(!blocks.areFree({1.0, 1.0}, {std::numeric_limits<double>::quiet_NaN(), 1.0}));
  }

  void areFree_randomLines_neverHideAWall_data() {
    addColumns<bool, double>({"hasMap", "yaw"});
    QTest::newRow("map") << true << 0.0;
    QTest::newRow("turned map") << true << 0.7;
    QTest::newRow("open plane") << false << 0.0;
  }

  void areFree_randomLines_neverHideAWall() {
    QFETCH(bool, hasMap);
    QFETCH(double, yaw);
    const Pose2 origin{Vec2(-3.0, 2.0), yaw};
    const auto toWorld = [&](const Vec2& local) { return origin.toWorld(local); };
    const Outline box{
        {toWorld({14.0, 2.0}), toWorld({17.0, 2.0}), toWorld({17.0, 2.2}), toWorld({14.0, 2.2})}};
    const Scene scene = sceneOf(hasMap ? hall(origin) : OccupancyGrid(), {{box}},
                                {toWorld({0.0, 0.0}), toWorld({20.0, 12.0})});
    const OpenBlocks blocks(scene.field);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-1.0, 21.0);
    std::uniform_real_distribution<double> y(-1.0, 13.0);
    int free = 0;
    int visible = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec2 from = toWorld({x(random), y(random)});
      const Vec2 to = toWorld({x(random), y(random)});
      const bool isVisible = scene.obstacles.isVisible(from, to);
      const bool isFree = blocks.areFree(from, to);
      QVERIFY(!isFree || isVisible);
      free += isFree ? 1 : 0;
      visible += isVisible ? 1 : 0;
    }
    QVERIFY2(free > visible / 8, qPrintable(QStringLiteral("%1 of %2").arg(free).arg(visible)));
  }
};

QTEST_APPLESS_MAIN(OpenBlocksTest)
#include "tst_OpenBlocks.moc"
