#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <QtTest>
#include <queue>

#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/OpenList.h"
#include "sim2d/nav/nav2/global/ThetaStarPlanner.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/MetaTypes.h"
#include "tests/nav/ThetaStarReference.h"

using namespace costs;
using namespace sim2d::nav2;

namespace {

struct Trial {
  Costmap costmap;
  ThetaStarParameters parameters;
  Pose2 start, goal;
};

/// Walls at random with costs round them; every fifth map has patches of unknown cells, and the
/// parameters differ from map to map. Start and goal may be anywhere, in obstacles too.
Trial trialOf(std::uint64_t seed, int side) {
  Numbers numbers(seed * 7919);
  Trial trial{cluttered(side, seed, seed % 2 == 0 ? 0.05 : 0.1), {}, {}, {}};
  if (seed % 5 == 0) {
    for (int i = 0; i < side; ++i) {
      const Cell cell{static_cast<int>(numbers.between(0, side)),
                      static_cast<int>(numbers.between(0, side))};
      trial.costmap.set(cell, 255);
    }
  }
  trial.parameters.howManyCorners = seed % 7 == 0 ? 4 : 8;
  trial.parameters.allowUnknown = seed % 10 != 0;
  if (seed % 3 == 0) {
    trial.parameters.eucCost = numbers.between(0.5, 3.0);
    trial.parameters.traversalCost = numbers.between(0.0, 6.0);
  }
  const auto anywhere = [&] {
    const Cell cell{static_cast<int>(numbers.between(0, side)),
                    static_cast<int>(numbers.between(0, side))};
    return Pose2{trial.costmap.cellToWorld(cell), 0.0};
  };
  trial.start = anywhere();
  trial.goal = anywhere();
  return trial;
}

std::optional<double> line(const Costmap& costmap, Distro distro, Cell from, Cell to) {
  return thetaStarLineCost(costmap, ThetaStarCosts({}), distro, from, to);
}

/// What a free cell adds to a line: 2 (26/252)^2, and one of cost 128: 2 (141.2/252)^2.
constexpr double kFree = 2.0 * 26.0 * 26.0 / (252.0 * 252.0);
constexpr double kMiddle = 2.0 * 141.2 * 141.2 / (252.0 * 252.0);

bool isAbout(const std::optional<double>& found, double wanted) {
  return found && std::fabs(*found - wanted) < 1e-12;
}

}  // namespace

/// Theta* of each branch against a second implementation and by hand. With HUNAV_ALL_TESTS the maps
/// are larger, too.
class Nav2ThetaStarTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plans_randomMaps_equalTheSecondImplementation_data() {
    QTest::addColumn<Distro>("distro");
    QTest::addColumn<int>("maps");
    QTest::addColumn<int>("side");
    QTest::newRow("humble") << Distro::Humble << 1000 << 60;
    QTest::newRow("jazzy") << Distro::Jazzy << 1000 << 60;
    QTest::newRow("kilted") << Distro::Kilted << 1000 << 60;
    QTest::newRow("lyrical") << Distro::Lyrical << 1000 << 60;
    QTest::newRow("main") << Distro::Main << 1000 << 60;
    if (qEnvironmentVariableIsSet("HUNAV_ALL_TESTS")) {
      QTest::newRow("jazzy, large") << Distro::Jazzy << 1000 << 200;
      QTest::newRow("main, large") << Distro::Main << 1000 << 200;
    }
  }

  void plans_randomMaps_equalTheSecondImplementation() {
    QFETCH(Distro, distro);
    QFETCH(int, maps);
    QFETCH(int, side);
    int found = 0;
    double farthest = 0.0;
    for (int seed = 1; seed <= maps; ++seed) {
      const Trial trial = trialOf(static_cast<std::uint64_t>(seed), side);
      const Cell from = *trial.costmap.worldToCell(trial.start.position);
      const Cell to = *trial.costmap.worldToCell(trial.goal.position);
      if (from == to) {
        continue;
      }
      const Path path = makeGlobalPlanner(trial.parameters, distro)
                            ->plan({trial.costmap, trial.start, trial.goal})
                            .path;
      const std::vector<Vec2> wanted =
          thetareference::ThetaStar(trial.costmap, trial.parameters, distro)
              .path(from.column, from.row, to.column, to.row);
      QCOMPARE(path.size(), wanted.size());
      for (std::size_t i = 0; i < path.size(); ++i) {
        farthest = std::max(farthest, (path[i].position - wanted[i]).norm());
      }
      found += path.empty() ? 0 : 1;
    }
    QVERIFY2(farthest < 1e-12, qPrintable(QString::number(farthest)));
    QVERIFY2(2 * found > maps, qPrintable(QString::number(found)));
    qInfo("%d maps, %d paths, largest difference %.1e m", maps, found, farthest);
  }

  /// In a corridor the queue is empty when its only cell has been popped, which ends Nav2's loop.
  void plans_corridorOfOneCell_fail() {
    for (const Distro distro : kDistros) {
      const auto planner = makeGlobalPlanner(ThetaStarParameters(), distro);
      const Costmap narrow = drawn({"#####", ".....", "#####"});
      QVERIFY(planner->plan({narrow, {{0.5, 1.5}, 0.0}, {{4.5, 1.5}, 0.0}}).error ==
              PlanError::NoValidPath);
      const Costmap wide = drawn({"#####", ".....", ".....", "#####"});
      QVERIFY(planner->plan({wide, {{0.5, 1.5}, 0.0}, {{4.5, 1.5}, 0.0}}).error == PlanError::None);
    }
  }

  void plans_goalPoppedLast_fails() {
    // Three cells in an angle, without diagonals. From the corner both others are queued; the start
    // was popped before, so that the goal leaves the queue empty if it is popped last.
    ThetaStarParameters parameters;
    parameters.howManyCorners = 4;
    const auto planner = makeGlobalPlanner(parameters, Distro::Jazzy);
    const auto error = [&](const Costmap& costmap) {
      return planner->plan({costmap, {{0.5, 0.5}, 0.0}, {{1.5, 0.5}, 0.0}}).error;
    };
    QVERIFY(error(drawn({"##", ".."})) == PlanError::NoValidPath);
    QVERIFY(error(drawn({".#", ".."})) == PlanError::None);  // the cell above remains in the queue
  }

  /// Lines between lower left corners.
  void lines_ofJazzy_byHand() {
    const auto jazzy = [](const Costmap& costmap, Cell from, Cell to) {
      return line(costmap, Distro::Jazzy, from, to);
    };
    const Costmap open(8, 8, 1.0, Vec2::Zero());
    QVERIFY(isAbout(jazzy(open, {3, 3}, {3, 3}), 0.0));
    QVERIFY(isAbout(jazzy(open, {1, 3}, {6, 3}), 5 * kFree));  // one cell for each column
    QVERIFY(isAbout(jazzy(open, {1, 1}, {6, 6}), 5 * kFree));  // the diagonal's own cells
    // From corner (0, 0) to (3, 2): column 0 passes row 0; column 1 rows 0 and 1; column 2 row 1.
    QVERIFY(isAbout(jazzy(open, {0, 0}, {3, 2}), 4 * kFree));
    QVERIFY(isAbout(jazzy(open, {0, 0}, {2, 3}), 4 * kFree));
    QVERIFY(isAbout(jazzy(open, {3, 2}, {0, 0}), 4 * kFree));
    // Along an axis the cells above the line count, and those below where the former are blocked.
    const Costmap above = drawn({".....", "..#..", "..m..", "....."});
    QVERIFY(isAbout(jazzy(above, {0, 2}, {4, 2}), 3 * kFree + kMiddle));
    const Costmap both = drawn({".....", "..#..", "..#..", "....."});
    QVERIFY(!jazzy(both, {0, 2}, {4, 2}));
    // Leftwards along an axis the lower left corners lie at the same height.
    QVERIFY(isAbout(jazzy(above, {4, 2}, {0, 2}), 3 * kFree + kMiddle));
    // A cell of 252 (c' = 252.8) blocks; a diagonal ignores the cells at its sides.
    QVERIFY(!jazzy(drawn({"...", ".o.", "..."}), {0, 0}, {2, 2}));
    QVERIFY(isAbout(jazzy(drawn({"##.", "#.#", ".##"}), {0, 0}, {2, 2}), 2 * kFree));
    QVERIFY(isAbout(jazzy(drawn({"##.", "#?#", ".##"}), {0, 0}, {2, 2}),
                    kFree + 2.0 * 253.0 * 253.0 / (252.0 * 252.0)));
  }

  /// Bresenham's cells, the first counted and the last not.
  void lines_ofMain_byHand() {
    const auto main = [](const Costmap& costmap, Cell from, Cell to) {
      return line(costmap, Distro::Main, from, to);
    };
    const Costmap open(8, 8, 1.0, Vec2::Zero());
    QVERIFY(isAbout(main(open, {3, 3}, {3, 3}), 0.0));
    QVERIFY(isAbout(main(open, {1, 3}, {6, 3}), 5 * kFree));
    QVERIFY(isAbout(main(open, {0, 0}, {3, 2}), 3 * kFree));
    QVERIFY(!main(drawn({".....", "..o..", "....."}), {0, 1}, {4, 1}));
    // Both cells beside a diagonal step must be safe by their own cost: 252 is, 253 is not.
    QVERIFY(isAbout(main(drawn({"o.", ".o"}), {0, 0}, {1, 1}), kFree));
    QVERIFY(!main(drawn({"i.", ".."}), {0, 0}, {1, 1}));
    QVERIFY(!main(drawn({"..", ".i"}), {0, 0}, {1, 1}));
    // (0, 0) to (2, 1): e = 1, so 2 e == dx, and the first step is the diagonal one, over (1, 1).
    QVERIFY(isAbout(main(drawn({".m.", "..."}), {0, 0}, {2, 1}), kFree + kMiddle));
    QVERIFY(isAbout(main(drawn({"...", ".m."}), {0, 0}, {2, 1}), 2 * kFree));
    // (0, 0) to (1, 2): e = -1, so 2 e == -dy, and the first step goes straight up, over (0, 1).
    QVERIFY(isAbout(main(drawn({"..", "m.", ".."}), {0, 0}, {1, 2}), kFree + kMiddle));
    QVERIFY(isAbout(main(drawn({"..", ".m", ".."}), {0, 0}, {1, 2}), 2 * kFree));
  }

  void lines_besideTheMap_wrapAround() {
    const Costmap bottom = drawn({".....", "..#.."});
    QVERIFY(!line(bottom, Distro::Jazzy, {0, 0}, {4, 0}));  // below row 0 nothing is read
    // Column -1 of row 1 is the last cell of row 0.
    QVERIFY(
        isAbout(line(drawn({"..", "#.", ".m"}), Distro::Jazzy, {0, 0}, {0, 2}), kFree + kMiddle));
    QVERIFY(!line(drawn({"..", "#.", ".#"}), Distro::Jazzy, {0, 0}, {0, 2}));
    QVERIFY(!line(drawn({"..", "..", "#."}), Distro::Jazzy, {0, 0}, {0, 2}));
  }

  void heap_fallingKeys_movesAsTheStandardLibrary() {
    Numbers numbers(3);
    std::vector<double> keys(400);
    const auto keyOf = [&](std::size_t node) { return keys[node]; };
    const auto isDearer = [&](std::size_t a, std::size_t b) { return keys[a] > keys[b]; };
    for (int round = 0; round < 50; ++round) {
      for (double& key : keys) {
        key = std::floor(numbers.between(0.0, 60.0));  // many are equal
      }
      StaleHeap heap;
      std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(isDearer)> wanted(
          isDearer);
      for (std::size_t node = 0; node < keys.size() || !wanted.empty();) {
        if (node < keys.size() && (wanted.empty() || numbers.next() < 0.6)) {
          heap.push(node, keyOf);
          wanted.push(node);
          ++node;
        } else {
          QCOMPARE(heap.pop(keyOf), wanted.top());
          wanted.pop();
        }
        keys[static_cast<std::size_t>(numbers.between(0.0, 400.0))] -= 5.0;
      }
      QVERIFY(heap.isEmpty());
    }
  }

  void hypot_wholeNumbers_isTheCLibrarys() {
    int others = 0;  // that the correctly rounded root would not match
    for (int x = 0; x <= 1500; ++x) {
      for (int y = 0; y <= x; ++y) {
        const double wanted = std::hypot(x, y);
        QCOMPARE(hypotAsGlibc(-x, y), wanted);
        QCOMPARE(hypotAsGlibc(y, x), wanted);
        others += wanted != std::sqrt(static_cast<double>(x * x + y * y)) ? 1 : 0;
      }
    }
    QVERIFY(others > 100);
  }
};

QTEST_APPLESS_MAIN(Nav2ThetaStarTest)
#include "tst_Nav2ThetaStar.moc"
