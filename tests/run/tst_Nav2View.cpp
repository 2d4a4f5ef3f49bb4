#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "app/run/Bundle.h"
#include "bt/robot/Nav2Servers.h"

/// What a robot with Nav2 tells of itself for display, and that telling changes nothing.
class Nav2ViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void watched_isTheSameRun_data();
  void watched_isTheSameRun();
  void unwatched_tellsNothing();
  void dwb_pricesAddUpAndTheCheapestIsChosen();
  void mppi_hasSamplesAndTheOptimum();
  void pursuit_aimsAtItsLookaheadDistance();
  void costs_fallWithTheDistanceAsNav2Says();
  void masks_effectsInPercent();
  void masks_rotated_coverTheSameGround();
};

namespace {

using base::Vec2;
using sim2d::MaskGrid;

sim2d::nav2::CostmapPlugin filterNamed(const char* name,
                                       const sim2d::nav2::LayerParameters& parameters) {
  return {name, parameters};
}

std::unique_ptr<sim2d::World> worldWith(const QString& controller) {
  app::RunSpec options;
  options.scenario = SOURCE_DIR "/maps/planners/doorway_agents.yaml";
  options.planner = "nav2";
  options.nav2Params = {
      (QStringLiteral(SOURCE_DIR "/maps/planners/nav2_%1.yaml").arg(controller)).toStdString()};
  options.nav2Tree =
      SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
  const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
  app::Verdict verdict = app::check(bundle);
  return std::move(verdict.world);
}

std::shared_ptr<sim2d::PlannerDebugFlags> watching(bool costs, bool ways) {
  auto watch = std::make_shared<sim2d::PlannerDebugFlags>();
  watch->costs = costs;
  watch->ways = ways;
  return watch;
}

/// After so many steps, watched all the time.
std::unique_ptr<sim2d::World> driven(const QString& controller, int steps) {
  std::unique_ptr<sim2d::World> world = worldWith(controller);
  if (world != nullptr) {
    world->publishSensors(true);
    world->setPlannerDebug(watching(true, true));
    for (int step = 0; step < steps && world->step(); ++step) {
    }
  }
  return world;
}

const sim2d::RobotTelemetry& sensesOf(const sim2d::World& world) {
  return world.frame().senses->front();
}

double sumOf(const sim2d::RobotTelemetry::Candidate& way) {
  double sum = 0.0;
  for (const auto& [critic, score] : way.scores) {
    sum += score;
  }
  return sum;
}

}  // namespace

void Nav2ViewTest::watched_isTheSameRun_data() {
  QTest::addColumn<QString>("controller");
  for (const char* name : {"mppi", "dwb", "rpp"}) {
    QTest::newRow(name) << QString::fromLatin1(name);
  }
}

void Nav2ViewTest::watched_isTheSameRun() {
  QFETCH(QString, controller);
  const std::unique_ptr<sim2d::World> plain = worldWith(controller);
  const std::unique_ptr<sim2d::World> watched = worldWith(controller);
  QVERIFY(plain != nullptr && watched != nullptr);
  const auto watch = watching(false, false);
  const double start = watched->frame().robots.x[0];
  watched->publishSensors(true);
  watched->setPlannerDebug(watch);
  for (int step = 0; step < 120; ++step) {
    watch->costs = step % 3 != 0;  // switched on and off as it goes
    watch->ways = step % 5 != 0;
    QVERIFY(plain->step() && watched->step());
    QVERIFY(plain->frame().robots == watched->frame().robots);
    QVERIFY(plain->frame().humans == watched->frame().humans);
    QVERIFY(plain->frame().events == watched->frame().events);
  }
  QCOMPARE(plain->plannerReports(), watched->plannerReports());
  QVERIFY(watched->frame().robots.x[0] - start > 1.0);  // it drove
}

void Nav2ViewTest::unwatched_tellsNothing() {
  const std::unique_ptr<sim2d::World> world = worldWith(QStringLiteral("dwb"));
  world->publishSensors(true);
  world->setPlannerDebug(watching(false, false));
  for (int step = 0; step < 60; ++step) {
    QVERIFY(world->step());
  }
  const sim2d::RobotTelemetry& senses = sensesOf(*world);
  QVERIFY(senses.localCosts == nullptr && senses.globalCosts == nullptr);
  QVERIFY(senses.ways.empty() && senses.lookahead.empty() && senses.predicted.empty());
}

void Nav2ViewTest::dwb_pricesAddUpAndTheCheapestIsChosen() {
  const auto world = driven(QStringLiteral("dwb"), 80);
  const std::vector<sim2d::RobotTelemetry::Candidate>& ways = sensesOf(*world).ways;
  QVERIFY(ways.size() > 100);  // 20 x 20 velocities, those in reach
  QCOMPARE(std::count_if(ways.begin(), ways.end(), [](const auto& way) { return way.isChosen; }),
           std::ptrdiff_t{1});
  const auto chosen =
      std::find_if(ways.begin(), ways.end(), [](const auto& way) { return way.isChosen; });
  for (const auto& way : ways) {
    QVERIFY(way.isChosen || way.cost >= chosen->cost);
  }
  QVERIFY(std::abs(sumOf(*chosen) - chosen->cost) < 1e-4 * std::abs(chosen->cost));
  QStringList critics;
  for (const auto& [critic, score] : chosen->scores) {
    critics << QString::fromStdString(critic);
  }
  const QStringList listed =
      QStringLiteral("RotateToGoal Oscillation BaseObstacle GoalAlign PathAlign PathDist GoalDist")
          .split(QLatin1Char(' '));
  for (const QString& critic : critics) {
    QVERIFY2(listed.contains(critic), qPrintable(critic));
  }
  QVERIFY(critics.contains(QStringLiteral("PathDist")));
  QCOMPARE(sensesOf(*world).controller, std::string("FollowPath"));
}

void Nav2ViewTest::mppi_hasSamplesAndTheOptimum() {
  const auto world = driven(QStringLiteral("mppi"), 80);
  const std::vector<sim2d::RobotTelemetry::Candidate>& ways = sensesOf(*world).ways;
  QCOMPARE(ways.size(), std::size_t{41});  // a sample of 40, and what is followed
  QVERIFY(ways.back().isChosen);
  QCOMPARE(ways.back().scores.size() > 2, true);
  const Vec2 robot(world->frame().robots.x[0], world->frame().robots.y[0]);
  for (const auto& way : ways) {  // 2.8 s at 1 m/s at most, and a little for the last step
    QVERIFY((way.points.front() - robot).norm() < 0.2);
    QVERIFY((way.points.back() - robot).norm() < 3.2);
  }
}

void Nav2ViewTest::pursuit_aimsAtItsLookaheadDistance() {
  const auto world = driven(QStringLiteral("rpp"), 80);
  const sim2d::RobotTelemetry& senses = sensesOf(*world);
  QVERIFY(senses.ways.empty());
  QCOMPARE(senses.lookahead.size(), std::size_t{1});
  const double speed = std::hypot(world->frame().robots.vx[0], world->frame().robots.vy[0]);
  const double wanted = std::clamp(1.5 * speed, 0.3, 0.9);  // lookahead_time * speed
  const double distance = (senses.lookahead.front() - senses.believed.position).norm();
  QVERIFY2(distance > wanted - 0.1 && distance < wanted + 0.15,
           qPrintable(QString::number(distance)));
  double toPath = 10.0;
  for (const Vec2& point : world->frame().robotPaths.at(0)) {
    toPath = std::min(toPath, (point - senses.lookahead.front()).norm());
  }
  QVERIFY(toPath < 0.06);  // between two poses of the path
}

void Nav2ViewTest::costs_fallWithTheDistanceAsNav2Says() {
  const auto world = driven(QStringLiteral("rpp"), 40);
  const sim2d::CostGridPtr grid = sensesOf(*world).globalCosts;
  QVERIFY(grid != nullptr && sensesOf(*world).localCosts != nullptr);
  QCOMPARE(sensesOf(*world).localCosts->columns, 120);  // 6 m of 5 cm
  QCOMPARE(grid->costs.size(), static_cast<std::size_t>(grid->columns * grid->rows));
  std::vector<Vec2> lethal;
  const auto cost = [&](int column, int row) {
    return int(grid->costs[static_cast<std::size_t>(row * grid->columns + column)]);
  };
  for (int row = 0; row < grid->rows; ++row) {
    for (int column = 0; column < grid->columns; ++column) {
      if (cost(column, row) == 254) {
        lethal.emplace_back(column, row);
      }
    }
  }
  QVERIFY(lethal.size() > 100);
  // A 16-gon of 0.35 m, each coordinate padded by 0.01 m: its edges are 0.353 m away at least.
  int checked = 0;
  for (int row = 2; row < grid->rows; row += 7) {
    for (int column = 2; column < grid->columns; column += 5) {
      double least = 1e9;
      for (const Vec2& cell : lethal) {
        least = std::min(least, (cell - Vec2(column, row)).norm());
      }
      const double distance = grid->resolution * least;  // [m]
      if (distance < 0.4 || distance > 0.75 || cost(column, row) == 255) {
        continue;
      }
      const double wanted = 252.0 * std::exp(-3.0 * (distance - 0.353));
      QVERIFY2(std::abs(cost(column, row) - wanted) < 3.5,
               qPrintable(QStringLiteral("%1 %2 at %3 %4 of %5 x %6")
                              .arg(cost(column, row))
                              .arg(wanted)
                              .arg(column)
                              .arg(row)
                              .arg(grid->columns)
                              .arg(grid->rows)));
      ++checked;
    }
  }
  QVERIFY(checked > 20);
}

/// Three cells: unknown or without effect, 25, 50.
void Nav2ViewTest::masks_effectsInPercent() {
  using namespace sim2d::nav2;
  const sim2d::OccupancyGrid cells(3, 1, 0.5, {{-1.0, 2.0}, 0.0}, {-1, 25, 50});
  FilterMasks masks;
  masks["keepout"] = {cells};
  masks["percent"] = {cells, 100.0, -1.0, true};  // 75 % and 50 %
  masks["speed"] = {cells, 0.0, 0.01, false};     // 0.25 m/s and 0.5 m/s
  masks["lights"] = {cells};
  masks["off"] = {cells};
  KeepoutFilterParameters disabled;
  disabled.enabled = false;
  BinaryFilterParameters binary;
  binary.flipThreshold = 30.0;
  CostmapSettings costmap;
  costmap.filters = {filterNamed("keepout", KeepoutFilterParameters()),
                     filterNamed("percent", SpeedFilterParameters()),
                     filterNamed("speed", SpeedFilterParameters()),
                     filterNamed("lights", binary),
                     filterNamed("off", disabled),
                     filterNamed("without a mask", KeepoutFilterParameters())};
  const std::vector<MaskGrid> grids = bt::maskGrids(costmap, masks, 2.0);
  using Costs = std::vector<std::uint8_t>;
  const std::vector<std::pair<MaskGrid::Kind, Costs>> wanted = {
      {MaskGrid::Kind::Keepout, {0, 25, 50}},
      {MaskGrid::Kind::Speed, {0, 75, 50}},
      {MaskGrid::Kind::Speed, {0, 13, 25}},  // 12.5 % of 2 m/s
      {MaskGrid::Kind::Switch, {0, 0, 100}}};
  QCOMPARE(grids.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    QVERIFY(grids[i].kind == wanted[i].first);
    QVERIFY(grids[i].grid->costs == wanted[i].second);
    QVERIFY(grids[i].grid->origin == Vec2(-1.0, 2.0));
  }
}

void Nav2ViewTest::masks_rotated_coverTheSameGround() {
  using namespace sim2d::nav2;
  const sim2d::OccupancyGrid cells(4, 2, 0.5, {{1.0, 1.0}, 0.5 * base::kPi},
                                   {100, 0, 0, 0, 0, 0, 0, 40});
  CostmapSettings costmap;
  costmap.filters = {filterNamed("zones", KeepoutFilterParameters())};
  const std::vector<MaskGrid> grids = bt::maskGrids(costmap, {{"zones", {cells}}}, 1.0);
  const sim2d::CostGrid& grid = *grids.front().grid;
  const auto at = [&](const Vec2& place) {
    const Vec2 cell = (place - grid.origin) / grid.resolution;
    return int(grid.costs[static_cast<std::size_t>(int(cell.y()) * grid.columns + int(cell.x()))]);
  };
  QCOMPARE(at({0.75, 1.25}), 100);  // the first cell, to the left of the origin
  QCOMPARE(at({0.25, 2.75}), 40);   // the last one
  QCOMPARE(at({0.75, 1.75}), 0);
}

QTEST_GUILESS_MAIN(Nav2ViewTest)
#include "tst_Nav2View.moc"
