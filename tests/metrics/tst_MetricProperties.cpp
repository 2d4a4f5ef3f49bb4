#include <algorithm>

#include <QtTest>

#include "MetricCases.h"

using namespace metrics;

namespace {

/// Quarter turns to the left, then a shift by whole cells; exact but for the sums.
struct Motion {
  int quarters = 0;
  Vec2 shift = Vec2::Zero();

  Vec2 turned(Vec2 vector) const {
    for (int k = 0; k < quarters; ++k) {
      vector = Vec2(-vector.y(), vector.x());
    }
    return vector;
  }
  Vec2 moved(const Vec2& point) const { return turned(point) + shift; }
};

sim2d::OccupancyGrid quarterTurned(const sim2d::OccupancyGrid& map) {
  const int width = map.height();
  const int height = map.width();
  std::vector<std::int8_t> cells(static_cast<std::size_t>(width) *
                                 static_cast<std::size_t>(height));
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const int newColumn = map.height() - 1 - row;
      cells[static_cast<std::size_t>(column) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(newColumn)] = map.isWall({column, row}) ? 100 : 0;
    }
  }
  const Vec2 corner = map.origin().position;
  const Vec2 origin(-(corner.y() + map.resolution() * map.height()), corner.x());
  return {width, height, map.resolution(), {origin, 0.0}, std::move(cells)};
}

sim2d::OccupancyGrid movedMap(sim2d::OccupancyGrid map, const Motion& motion) {
  if (map.isEmpty()) {
    return map;
  }
  for (int k = 0; k < motion.quarters; ++k) {
    map = quarterTurned(map);
  }
  std::vector<std::int8_t> cells;
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      cells.push_back(map.isWall({column, row}) ? 100 : 0);
    }
  }
  const Vec2 origin = map.origin().position + motion.shift;
  return {map.width(), map.height(), map.resolution(), {origin, 0.0}, std::move(cells)};
}

template <class Columns>
void moveColumns(Columns& columns, const Motion& motion) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Vec2 position = motion.moved(Vec2(columns.x[k], columns.y[k]));
    const Vec2 velocity = motion.turned(Vec2(columns.vx[k], columns.vy[k]));
    columns.x[k] = position.x();
    columns.y[k] = position.y();
    columns.vx[k] = velocity.x();
    columns.vy[k] = velocity.y();
    columns.heading[k] = base::wrapToPi(columns.heading[k] + motion.quarters * base::kPi / 2.0);
  }
}

/// The whole scene: bodies, goals, map, obstacles and doors.
sim2d::Trace moved(sim2d::Trace trace, const Motion& motion) {
  for (sim2d::Frame& frame : trace.frames) {
    moveColumns(frame.humans, motion);
    moveColumns(frame.robots, motion);
  }
  for (sim2d::TraceRobot& robot : trace.header.robots) {
    for (sim2d::TraceGoal& goal : robot.goals) {
      goal.position = motion.moved(goal.position);
    }
  }
  trace.header.map = movedMap(trace.header.map, motion);
  for (sim2d::TraceObstacle& obstacle : trace.header.obstacles) {
    for (sim2d::Outline& outline : obstacle.outlines) {
      for (Vec2& point : outline.points) {
        point = motion.moved(point);
      }
    }
  }
  return trace;
}

std::vector<MetricResult> resultsOf(const sim2d::Trace& trace, Profile profile) {
  MetricParameters parameters = cases::parametersOf(profile);
  parameters.timeLimit = 9.9;  // within the records, which take 10 s
  return evaluate(trace, Selection{}, parameters)->results;
}

/// All that differs by more than the share, with both values.
std::string differences(const std::vector<MetricResult>& a, const std::vector<MetricResult>& b,
                        double share) {
  std::string text;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double left = a[k].value.value.value_or(std::nan(""));
    const double right = b[k].value.value.value_or(std::nan(""));
    const double limit = share * std::max({std::fabs(left), std::fabs(right), 1.0});
    const bool isSame = left == right || (std::isnan(left) && std::isnan(right)) ||
                        std::fabs(left - right) <= limit;
    if (!isSame) {
      text += a[k].info.key + " " + std::to_string(left) + " " + std::to_string(right) + "; ";
    }
  }
  return text;
}

sim2d::Trace openPlane() {
  sim2d::Trace trace = cases::trace(120, 6, 0.05);
  trace.header.obstacles.clear();
  trace.header.map = {};
  return trace;
}

}  // namespace

/// What must not change any metric.
class MetricPropertiesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void movedScene_withMap_changesNothing_data();
  void movedScene_withMap_changesNothing();
  void movedScene_openPlane_changesNothing_data();
  void movedScene_openPlane_changesNothing();
  void otherIds_changeNothing_data();
  void otherIds_changeNothing();
  void doubleRate_changesLessThanTheBound();
  void idsThatComeAndGo_giveDefinedResults();
};

void MetricPropertiesTest::movedScene_withMap_changesNothing_data() {
  QTest::addColumn<int>("quarters");
  QTest::addColumn<int>("cellsX");
  QTest::addColumn<int>("cellsY");
  QTest::addColumn<bool>("original");
  QTest::newRow("shift") << 0 << 35 << -12 << false;
  QTest::newRow("quarter") << 1 << 0 << 0 << false;
  QTest::newRow("half") << 2 << 10 << 4 << false;
  QTest::newRow("three quarters") << 3 << -7 << 21 << false;
  QTest::newRow("shift, hunav2") << 0 << 35 << -12 << true;
  QTest::newRow("quarter, hunav2") << 1 << 0 << 0 << true;
  QTest::newRow("half, hunav2") << 2 << 10 << 4 << true;
  QTest::newRow("three quarters, hunav2") << 3 << -7 << 21 << true;
}

void MetricPropertiesTest::movedScene_withMap_changesNothing() {
  QFETCH(int, quarters);
  QFETCH(int, cellsX);
  QFETCH(int, cellsY);
  QFETCH(bool, original);
  const Profile profile = original ? Profile::Hunav2 : Profile::Corrected;
  const sim2d::Trace trace = cases::trace(120, 6, 0.05);
  const double cell = trace.header.map.resolution();
  const sim2d::Trace other = moved(trace, {quarters, Vec2(cellsX * cell, cellsY * cell)});
  const std::vector<MetricResult> results = resultsOf(trace, profile);
  const std::string problem = differences(results, resultsOf(other, profile), 1e-9);
  QVERIFY2(problem.empty(), problem.c_str());
  // Somebody sees the robot past the walls of the map.
  QVERIFY(findResult(results, "surprise_visibility_cost")->value.value.value_or(0.0) > 0.0);
}

void MetricPropertiesTest::movedScene_openPlane_changesNothing_data() {
  QTest::addColumn<double>("angle");
  QTest::newRow("shift") << 0.0;
  QTest::newRow("a bit") << 0.7;
  QTest::newRow("much") << -2.9;
}

void MetricPropertiesTest::movedScene_openPlane_changesNothing() {
  QFETCH(double, angle);
  const base::Pose2 frame{Vec2(11.0, -4.0), angle};
  const base::Pose2 turn{Vec2(0.0, 0.0), angle};
  const sim2d::Trace trace = openPlane();
  sim2d::Trace other = trace;
  const auto move = [&](auto& columns) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const Vec2 position = frame.toWorld(Vec2(columns.x[k], columns.y[k]));
      const Vec2 velocity = turn.toWorld(Vec2(columns.vx[k], columns.vy[k]));
      columns.x[k] = position.x();
      columns.y[k] = position.y();
      columns.vx[k] = velocity.x();
      columns.vy[k] = velocity.y();
      columns.heading[k] = base::wrapToPi(columns.heading[k] + angle);
    }
  };
  for (sim2d::Frame& one : other.frames) {
    move(one.humans);
    move(one.robots);
  }
  for (sim2d::TraceGoal& goal : other.header.robots[0].goals) {
    goal.position = frame.toWorld(goal.position);
  }
  for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
    const std::string problem =
        differences(resultsOf(trace, profile), resultsOf(other, profile), 1e-9);
    QVERIFY2(problem.empty(), problem.c_str());
  }
}

void MetricPropertiesTest::otherIds_changeNothing_data() {
  QTest::addColumn<bool>("original");
  QTest::newRow("corrected") << false;
  QTest::newRow("hunav2") << true;
}

void MetricPropertiesTest::otherIds_changeNothing() {
  QFETCH(bool, original);
  const Profile profile = original ? Profile::Hunav2 : Profile::Corrected;
  const sim2d::Trace trace = cases::trace(120, 6, 0.05);
  sim2d::Trace other = trace;
  for (sim2d::TraceHuman& human : other.header.humans) {
    human.id = 1000 - 7 * human.id;
  }
  const auto turn = [](auto& column) { std::reverse(column.begin(), column.end()); };
  for (sim2d::Frame& frame : other.frames) {
    sim2d::HumanColumns& humans = frame.humans;
    for (std::size_t k = 0; k < humans.size(); ++k) {
      humans.id[k] = 1000 - 7 * humans.id[k];
      humans.group[k] = humans.group[k] < 0 ? -1 : humans.group[k] + 30;
    }
    turn(humans.id);
    turn(humans.group);
    turn(humans.state);
    turn(humans.goal);
    for (std::vector<double>* column :
         {&humans.x, &humans.y, &humans.heading, &humans.vx, &humans.vy, &humans.omega}) {
      turn(*column);
    }
  }
  const std::string problem =
      differences(resultsOf(trace, profile), resultsOf(other, profile), 1e-9);
  QVERIFY2(problem.empty(), problem.c_str());
}

void MetricPropertiesTest::doubleRate_changesLessThanTheBound() {
  const auto coarse = resultsOf(cases::trace(200, 6, 0.05), Profile::Corrected);
  const auto fine = resultsOf(cases::trace(400, 6, 0.025), Profile::Corrected);
  std::string problems;
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    const std::optional<double>& left = coarse[k].value.value;
    const std::optional<double>& right = fine[k].value.value;
    const MetricInfo& info = coarse[k].info;
    const double change = left && right ? std::fabs(*left - *right) : 0.0;
    const double size = left && right ? std::max({std::fabs(*left), std::fabs(*right), 0.1}) : 1.0;
    if (left.has_value() != right.has_value() || change > info.rateBound * size) {
      problems += info.key + " " + std::to_string(left.value_or(-1e9)) + " " +
                  std::to_string(right.value_or(-1e9)) + " (" + std::to_string(change / size) +
                  "); ";
    }
  }
  QVERIFY2(problems.empty(), problems.c_str());
}

void MetricPropertiesTest::idsThatComeAndGo_giveDefinedResults() {
  sim2d::Trace trace = cases::trace(60, 4, 0.05);
  for (sim2d::Frame& frame : trace.frames) {
    const int away = static_cast<int>(frame.step / 7 % 5);  // 4: nobody is away, 0: all are
    sim2d::HumanColumns kept;
    const sim2d::HumanColumns& all = frame.humans;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (away == 0 || all.id[k] == away) {
        continue;
      }
      kept.id.push_back(all.id[k]);
      kept.x.push_back(all.x[k]);
      kept.y.push_back(all.y[k]);
      kept.heading.push_back(all.heading[k]);
      kept.vx.push_back(all.vx[k]);
      kept.vy.push_back(all.vy[k]);
      kept.omega.push_back(all.omega[k]);
      kept.group.push_back(all.group[k]);
      kept.state.push_back(all.state[k]);
      kept.goal.push_back(all.goal[k]);
    }
    frame.humans = kept;
  }
  for (const Profile profile : {Profile::Corrected, Profile::Hunav2}) {
    const auto evaluation = evaluate(trace, Selection{}, cases::parametersOf(profile));
    QVERIFY(evaluation);
    for (const MetricResult& result : evaluation->results) {
      const std::optional<double>& value = result.value.value;
      QVERIFY2(value ? !std::isnan(*value) : !result.value.why.empty(), result.info.key.c_str());
    }
  }
}

QTEST_APPLESS_MAIN(MetricPropertiesTest)
#include "tst_MetricProperties.moc"
