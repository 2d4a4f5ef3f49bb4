#include <cstdint>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/dwb/MapGrid.h"
#include "tests/nav/ControlScene.h"
#include "tests/nav/PlainDwb.h"

using namespace sim2d::nav2;
using base::Vec2;
using sim2d::Cell;

namespace {

/// Numbers that look random, the same each time.
class Dice {
 public:
  int below(int limit) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<int>((state_ >> 33U) % static_cast<std::uint64_t>(limit));
  }

 private:
  std::uint64_t state_ = 1;
};

}  // namespace

class MapGridTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void oneSeed_isManhattan();
  void noSeed_isUnreachable();
  void twoSeeds_byHand();
  void anySeeds_equalThePlainQueue();
  void askedInAnyOrder_valuesAreTheSame();
  void refined_gaps_byHand();
  void seeds_firstStretchOnTheMap();
};

void MapGridTest::oneSeed_isManhattan() {
  MapGrid grid;
  grid.clear(7, 5);
  grid.seed({2, 3});
  QVERIFY(grid.hasSeeds());
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      QCOMPARE(grid.at(row * 7 + column), std::abs(column - 2.0) + std::abs(row - 3.0));
    }
  }
}

void MapGridTest::noSeed_isUnreachable() {
  MapGrid grid;
  grid.clear(4, 3);
  grid.seed({0, 0});
  QCOMPARE(grid.at(11), 5.0);
  grid.clear(4, 3);
  QVERIFY(!grid.hasSeeds());
  QCOMPARE(grid.at(0), 13.0);
}

/// Seeds (0, 0) and (4, 1) in a strip of two rows: each cell belongs to the seed nearer in a
/// straight line, and is told in steps. (2, 0): 2 against sqrt 5, (2, 1): sqrt 5 against 2.
void MapGridTest::twoSeeds_byHand() {
  MapGrid grid;
  grid.clear(5, 2);
  grid.seed({0, 0});
  grid.seed({4, 1});
  const double expected[] = {0, 1, 2, 2, 1, 1, 2, 2, 1, 0};
  for (int cell = 0; cell < 10; ++cell) {
    QCOMPARE(grid.at(cell), expected[cell]);
  }
}

void MapGridTest::anySeeds_equalThePlainQueue() {
  Dice dice;
  MapGrid grid;
  for (int game = 0; game < 60; ++game) {
    const int width = 1 + dice.below(70), height = 1 + dice.below(40);
    const Costmap map(width, height, 0.05, Vec2::Zero());
    std::vector<Cell> seeds;
    for (int i = dice.below(12); i >= 0; --i) {
      seeds.push_back({dice.below(width), dice.below(height)});
    }
    grid.clear(width, height);
    for (const Cell cell : seeds) {
      grid.seed(cell);
    }
    const plain_dwb::Grid plain(map, seeds);
    for (int asked = 0; asked < width * height; ++asked) {
      const int cell = game % 2 == 0 ? asked : dice.below(width * height);
      QCOMPARE(grid.at(cell), plain.at({cell % width, cell / width}));
      if (game % 3 == 2 && asked > 5) {
        break;  // the next one begins half grown
      }
    }
  }
}

void MapGridTest::askedInAnyOrder_valuesAreTheSame() {
  MapGrid forward, backward;
  for (MapGrid* grid : {&forward, &backward}) {
    grid->clear(30, 30);
    for (int i = 0; i < 20; ++i) {
      grid->seed({i, i / 2 + 5});
    }
  }
  for (int cell = 899; cell >= 0; --cell) {
    backward.at(cell);
  }
  for (int cell = 0; cell < 900; ++cell) {
    QCOMPARE(forward.at(cell), backward.at(cell));
  }
}

/// Resolution 0.1: from 0 to 0.65, trunc(6.5 - 2) - 1 = 3 parts: two places between. Up to
/// 0.4 there is none: trunc(2) - 1 = 1 part; nor up to 0.2, which is no gap.
void MapGridTest::refined_gaps_byHand() {
  const auto xs = [](const Path& path) {
    QVector<double> found;
    for (const Pose2& pose : path) {
      found.push_back(std::round(pose.position.x() * 1e6) / 1e6);
    }
    return found;
  };
  const auto to = [](double x) { return Path{{Vec2(0, 0), 0.5}, {Vec2(x, 0), 0.0}}; };
  QCOMPARE(xs(adjustPlanResolution(to(0.65), 0.1)),
           (QVector<double>{0.0, 0.216667, 0.433333, 0.65}));
  QCOMPARE(xs(adjustPlanResolution(to(0.45), 0.1)), (QVector<double>{0.0, 0.45}));
  QCOMPARE(xs(adjustPlanResolution(to(0.2), 0.1)), (QVector<double>{0.0, 0.2}));
  QCOMPARE(xs(adjustPlanResolution({}, 0.1)), QVector<double>());
}

void MapGridTest::seeds_firstStretchOnTheMap() {
  Costmap map(20, 20, 0.1, Vec2(0.0, 0.0));
  Path path;
  for (int i = -3; i < 30; ++i) {
    path.push_back({Vec2(0.1 * i + 0.05, 0.55), 0.0});
  }
  std::vector<Cell> seeds = pathSeeds(path, map);
  QCOMPARE(seeds.size(), std::size_t{20});
  QVERIFY(seeds.front() == (Cell{0, 5}) && seeds.back() == (Cell{19, 5}));
  map.set({0, 5}, kNoInformation);  // unknown cells are skipped at the start ...
  map.set({8, 5}, kNoInformation);  // ... and end the stretch later
  map.set({4, 5}, kLethal);         // obstacles do not
  seeds = pathSeeds(path, map);
  QCOMPARE(seeds.size(), std::size_t{7});
  QVERIFY(seeds.front() == (Cell{1, 5}) && seeds.back() == (Cell{7, 5}));
  QVERIFY(pathSeeds({{Vec2(-5.0, 0.0), 0.0}}, map).empty());
}

QTEST_APPLESS_MAIN(MapGridTest)
#include "tst_MapGrid.moc"
