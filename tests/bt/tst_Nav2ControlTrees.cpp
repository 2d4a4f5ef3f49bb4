#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "tests/bt/Nav2ControlTrees.h"
#include "tests/bt/RandomTrees.h"
#include "tests/bt/ScriptedNavigator.h"
#include "tests/bt/TreeProbe.h"

namespace {

using namespace navigator;

/// The results of the leaves, one letter for each tick; the last one repeats.
class Answers {
 public:
  explicit Answers(const std::map<std::string, std::string>& all) : all_(all) {}
  char next(const std::string& leaf) {
    const std::string& letters = all_.at(leaf);
    return letters[std::min(calls_[leaf]++, letters.size() - 1)];
  }

 private:
  const std::map<std::string, std::string>& all_;
  std::map<std::string, std::size_t> calls_;
};

struct ControlHost : Scripted {
  ControlHost(Distro distro, const std::map<std::string, std::string>& all)
      : Scripted(distro), answers(all) {}
  Answers answers;
  std::vector<std::string> calls;
};

/// A tree twice: as XML and as nodes of the second implementation.
class DrawnTree {
 public:
  DrawnTree(std::uint64_t seed, Distro distro) : draw_(seed), distro_(distro) {
    root = node(3, xml);
  }

  std::string xml;
  std::map<std::string, std::string> answers;
  std::vector<std::string> log;
  std::function<char(const std::string&)> answer;  // of the second implementation
  std::unique_ptr<controltrees::Node> root;

 private:
  bool hasNew() const { return distro_ >= Distro::Lyrical; }

  std::unique_ptr<controltrees::Node> node(int depth, std::string& text) {
    if (depth == 0 || (depth < 3 && draw_.chance(35))) {
      return leaf(text);
    }
    const int kind = draw_.below(hasNew() ? 4 : 3);
    if (kind == 1) {
      const int retries = draw_.below(4);
      text += "<RecoveryNode number_of_retries=\"" + std::to_string(retries) + "\">";
      return filled(std::make_unique<controltrees::Recovery>(retries), 2, depth, "RecoveryNode",
                    text);
    }
    const int count = 1 + draw_.below(4);
    if (kind == 2) {
      const bool wraps = !hasNew() || draw_.chance(50);
      text += hasNew()
                  ? std::string("<RoundRobin wrap_around=\"") + (wraps ? "true" : "false") + "\">"
                  : std::string("<RoundRobin>");
      return filled(std::make_unique<controltrees::RoundRobin>(wraps), count, depth, "RoundRobin",
                    text);
    }
    text += kind == 0 ? "<PipelineSequence>" : "<NonblockingSequence>";
    return kind == 0 ? filled(std::make_unique<controltrees::Pipeline>(), count, depth,
                              "PipelineSequence", text)
                     : filled(std::make_unique<controltrees::Nonblocking>(), count, depth,
                              "NonblockingSequence", text);
  }

  std::unique_ptr<controltrees::Node> filled(std::unique_ptr<controltrees::Control> control,
                                             int count, int depth, const std::string& id,
                                             std::string& text) {
    for (int i = 0; i < count; ++i) {
      control->add(node(depth - 1, text));
    }
    text += "</" + id + ">";
    return control;
  }

  std::unique_ptr<controltrees::Node> leaf(std::string& text) {
    const std::string name = "L" + std::to_string(answers.size());
    std::string letters;
    const bool keeps = draw_.chance(50);
    for (int i = 1 + draw_.below(9); i > 0; --i) {
      letters += keeps ? "RRSSF"[draw_.below(5)] : "SSSSF"[draw_.below(5)];
    }
    answers[name] = letters;
    text += std::string(keeps ? "<Act" : "<Ask") + " name=\"" + name + "\"/>";
    return std::make_unique<controltrees::Leaf>(
        name, keeps, [this](const std::string& which) { return answer(which); }, log);
  }

  page::Draw draw_;
  Distro distro_;
};

NodeStatus answered(bt::LeafContext& leaf) {
  auto& host = leaf.host<ControlHost>();
  const char letter = host.answers.next(leaf.label());
  host.calls.push_back(leaf.label() + ":" + letter);
  return letter == 'R'   ? NodeStatus::Running
         : letter == 'S' ? NodeStatus::Success
                         : NodeStatus::Failure;
}

bt::NodeLibrary controlLibrary() {
  bt::NodeLibrary library = bt::robotNodes();
  library.add(probe::manifest("Act"),
              bt::stateful({answered, answered, [](bt::LeafContext& leaf) {
                              leaf.host<ControlHost>().calls.push_back(leaf.label() + ":H");
                            }}));
  library.add(probe::manifest("Ask"), bt::synchronous(answered));
  return library;
}

std::string wordsOf(const std::vector<std::string>& calls) {
  std::string all;
  for (const std::string& call : calls) {
    all += call + " ";
  }
  return all;
}

std::string titleOf(controltrees::Status status) {
  constexpr NodeStatus kSame[] = {NodeStatus::Idle, NodeStatus::Running, NodeStatus::Success,
                                  NodeStatus::Failure};
  return base::nodeStatusName(kSame[static_cast<int>(status)]);
}

using base::Pose2;
using base::Vec2;
using bt::Nav2Servers;
using sim2d::LaserScan;
using sim2d::Observation;
using namespace sim2d::nav2;

bool isClose(const Vec2& a, const Vec2& b, double tolerance = 1e-12) {
  return (a - b).norm() <= tolerance;
}

/// The shipped file, whose local costmap is in odom, or in the map.
std::unique_ptr<Nav2Servers> servers(const std::string& localFrame = "odom") {
  auto file = ParameterFile::read(SOURCE_DIR "/resources/nav2_params/turtlebot4.yaml");
  file->set("local_costmap", "global_frame", base::scalarNode(localFrame));
  Nav2ReadResult reading = readNav2Parameters(*file);
  return *Nav2Servers::make({reading.parameters, {}, {}, {}, 1, -1});
}

/// A lidar in the robot's middle that meets one thing, `distance` [m] ahead.
LaserScan scanOf(const Observation& robot, double distance) {
  LaserScan scan;
  scan.sensor = robot.pose;
  scan.time = robot.time;
  scan.angleIncrement = 0.01;
  scan.range = 30.0;
  scan.distances = {distance};
  scan.mapToOdom = robot.mapToOdom;
  return scan;
}

Observation observationAt(const Pose2& inOdom, const Pose2& mapToOdom, double time) {
  Observation observation;
  observation.pose = sim2d::toParent(mapToOdom, inOdom);
  observation.mapToOdom = mapToOdom;
  observation.time = time;
  observation.canRelocalize = true;
  return observation;
}

/// Centres of the lethal cells [m].
std::vector<Vec2> lethal(const Costmap& costmap) {
  std::vector<Vec2> places;
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      if (costmap.at({column, row}) == kLethal) {
        places.push_back(costmap.cellToWorld({column, row}));
      }
    }
  }
  return places;
}

}  // namespace

/// Random trees of Nav2's control nodes, ticked by the program and by a second implementation
/// (Nav2ControlTrees.h): the same leaves ticked and halted in the same order, the same result of
/// each tick.
class Nav2ControlTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_randomTrees_areTheSame_data() {
    QTest::addColumn<int>("distro");
    QTest::newRow("humble") << static_cast<int>(Distro::Humble);
    QTest::newRow("jazzy") << static_cast<int>(Distro::Jazzy);
    QTest::newRow("main") << static_cast<int>(Distro::Main);
  }

  void tick_randomTrees_areTheSame() {
    QFETCH(int, distro);
    const bt::NodeLibrary library = controlLibrary();
    const int seeds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 10000 : 500;
    int ticks = 0, halts = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      DrawnTree drawn(static_cast<std::uint64_t>(seed), static_cast<Distro>(distro));
      const auto program = bt::compile(tableOf(drawn.xml), library);
      QVERIFY2(program, drawn.xml.c_str());
      bt::TreeState state(*program);
      ControlHost host(static_cast<Distro>(distro), drawn.answers);
      Answers second(drawn.answers);
      drawn.answer = [&second](const std::string& leaf) { return second.next(leaf); };
      for (int tick = 1; tick <= 20; ++tick, ++ticks) {
        drawn.log.clear();
        const controltrees::Status wanted = drawn.root->execute();
        if (wanted != controltrees::Status::Running) {
          drawn.root->setIdle();
        }
        host.calls.clear();
        const NodeStatus found = state.tickOnce({tick, 0.05, &host});
        const std::string ours = wordsOf(host.calls) + base::nodeStatusName(found);
        const std::string theirs = wordsOf(drawn.log) + titleOf(wanted);
        if (ours != theirs) {
          qWarning("%s", drawn.xml.c_str());
        }
        QCOMPARE(ours, theirs);
        halts += static_cast<int>(std::count_if(
            host.calls.begin(), host.calls.end(),
            [](const std::string& call) { return call.find(":H") != std::string::npos; }));
      }
    }
    QVERIFY2(halts > seeds / 50, qPrintable(QString::number(halts)));
    qInfo("%d trees, %d ticks, %d halts of leaves, no difference", seeds, ticks, halts);
  }

  // What Nav2's servers look at in the frames map and odom, against transforms by hand.

  void odomObservation_isTheOneOfTheMap_whileFramesCoincide() {
    bt::OdomObservation odom;
    const Observation observation = observationAt({{1.0, 2.0}, 0.3}, {}, 0.0);
    QCOMPARE(&odom.of(observation), &observation);
  }

  /// The frame odom lies at (1, 2) of the map and is turned to the left by a right angle: what is
  /// at (x, y) of the map is at (y - 2, 1 - x) of it.
  void odomObservation_isTransformed() {
    Observation observation;
    observation.mapToOdom = {{1.0, 2.0}, base::kPi / 2.0};
    observation.pose = {{0.5, 5.0}, 0.0};
    observation.goal = {4.0, 4.0};
    observation.remainingGoals = {{1.0, 1.0}};
    observation.bodies = {{3, sim2d::BodyKind::Person, {2.0, 2.0}, {1.0, 0.0}, 0.0, 0.3}};
    bt::OdomObservation odom;
    const Observation& found = odom.of(observation);
    QVERIFY(isClose(found.pose.position, {3.0, 0.5}));
    QVERIFY(std::fabs(found.pose.heading + base::kPi / 2.0) < 1e-12);
    QVERIFY(isClose(found.goal, {2.0, -3.0}) && isClose(found.remainingGoals[0], {-1.0, 0.0}));
    QVERIFY(isClose(found.bodies[0].position, {0.0, -1.0}));
    QVERIFY(isClose(found.bodies[0].velocity, {0.0, -1.0}));
    QVERIFY(std::fabs(found.bodies[0].heading + base::kPi / 2.0) < 1e-12);
    QVERIFY(found.frame == observation.mapToOdom);
    QCOMPARE(found.bodies[0].id, 3);
  }

  void odomObservation_scan_isPlacedByTheOdometryOfItsTime() {
    const Observation before = observationAt({{2.0, 1.0}, 0.0}, {{0.5, 0.0}, 0.0}, 1.0);
    const LaserScan scan = scanOf(before, 3.0);
    Observation now = observationAt({{2.2, 1.0}, 0.0}, {{-0.5, 0.25}, 0.0}, 1.2);
    now.scan = &scan;
    bt::OdomObservation odom;
    const Observation& found = odom.of(now);
    QVERIFY(isClose(found.scan->sensor.position, {2.0, 1.0}));
    QVERIFY(isClose(found.pose.position, {2.2, 1.0}));
    QVERIFY(isClose(scan.sensor.position, {2.5, 1.0}));  // in the map, as it was
  }

  /// Two columns and one row, the origin at (1, 0): turned to the left its cells stand above each
  /// other, in the map from (-1, 1) on.
  void costsInMap_turnedByARightAngle_areTheTurnedCells() {
    auto grid = std::make_shared<sim2d::CostGrid>();
    grid->columns = 2;
    grid->rows = 1;
    grid->resolution = 1.0;
    grid->origin = {1.0, 0.0};
    grid->costs = {10, 20};
    const sim2d::CostGridPtr turned = bt::costsInMap({Vec2::Zero(), base::kPi / 2.0}, grid);
    QVERIFY(isClose(turned->origin, {-1.0, 1.0}));
    const auto at = [&](const Vec2& place) {
      const Vec2 cell = (place - turned->origin) / turned->resolution;
      const auto index =
          static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(turned->columns) +
          static_cast<std::size_t>(cell.x());
      return static_cast<int>(turned->costs.at(index));
    };
    QCOMPARE(at({-0.5, 1.5}), 10);
    QCOMPARE(at({-0.5, 2.5}), 20);
    QCOMPARE(bt::costsInMap({}, grid), sim2d::CostGridPtr(grid));
    std::vector<Vec2> points = {{1.0, 0.0}};
    bt::moveToMap({{0.0, 3.0}, base::kPi / 2.0}, points);
    QVERIFY(isClose(points[0], {0.0, 4.0}));
  }

  void jump_localObstaclesStay_globalOnesAreAdded_data() {
    QTest::addColumn<QByteArray>("localFrame");
    QTest::newRow("local costmap in odom") << QByteArray("odom");
    QTest::newRow("local costmap in the map") << QByteArray("map");
  }

  /// Something stands 1 m ahead of a robot that stands too. The correction jumps by 0.4 m ahead. In
  /// odom the new scan meets the same cell. In the map it marks another one, and what was there
  /// goes as the rays of the new scan pass it.
  void jump_localObstaclesStay_globalOnesAreAdded() {
    QFETCH(QByteArray, localFrame);
    const auto nav2 = servers(localFrame.toStdString());
    const bool isInOdom = localFrame == "odom";
    for (const bool hasJumped : {false, true}) {
      const double jump = hasJumped ? 0.4 : 0.0;
      Observation observation = observationAt({}, {{jump, 0.0}, 0.0}, hasJumped ? 1.0 : 0.0);
      const LaserScan scan = scanOf(observation, 1.025);
      observation.scan = &scan;
      nav2->sense(observation);
      const std::vector<Vec2> local = lethal(nav2->localCostmap().costmap());
      QCOMPARE(local.size(), std::size_t{1});
      QVERIFY(isClose(local[0], {1.025 + (isInOdom ? 0.0 : jump), 0.0}, 0.05));
      QVERIFY(nav2->localFrame() == (isInOdom ? observation.mapToOdom : Pose2{}));
      QVERIFY(isClose(nav2->pose().position, {jump, 0.0}));
    }
  }

  /// The path in the map is where it was; in the frame of the local costmap it moves back by the
  /// jump. A robot that stands on its path before is beside it after the jump.
  void controllerCycle_jump_shiftsThePathOnly() {
    const auto nav2 = servers();
    Path path;
    for (int i = 0; i <= 40; ++i) {
      path.push_back({{0.05 * i, 0.0}, 0.0});
    }
    bt::RobotRequest request;
    request.path = nav2->paths().add(path);
    nav2->begin(bt::RobotAction::FollowPath, request);
    for (const double jump : {0.0, 0.3}) {
      Observation observation = observationAt({}, {{0.0, jump}, 0.0}, jump > 0.0 ? 1.0 : 0.0);
      const LaserScan scan = scanOf(observation, 3.0);
      observation.scan = &scan;
      nav2->sense(observation);
      nav2->act();
      const Path& local = nav2->controller()->view().localPlan;
      QVERIFY(!local.empty());
      for (const Pose2& pose : local) {
        QVERIFY(std::fabs(pose.position.y() + jump) < 1e-12);  // in odom
      }
    }
  }

  void clearAround_pose_isThatOfTheCostmapsFrame() {
    const auto nav2 = servers();
    Observation observation = observationAt({}, {{5.0, 0.0}, 0.0}, 0.0);
    const LaserScan scan = scanOf(observation, 1.025);
    observation.scan = &scan;
    nav2->sense(observation);
    QCOMPARE(lethal(nav2->localCostmap().costmap()).size(), std::size_t{1});
    bt::ClearRequest request;
    request.extent = bt::ClearRequest::Extent::AroundPose;
    request.pose = Pose2{{1.0, 0.0}, 0.0};  // of the map: 4 m behind the robot
    QVERIFY(nav2->clear(request));
    Observation later = observationAt({}, {{5.0, 0.0}, 0.0}, 1.0);
    nav2->sense(later);
    QCOMPARE(lethal(nav2->localCostmap().costmap()).size(), std::size_t{1});
  }
};

QTEST_APPLESS_MAIN(Nav2ControlTreesTest)
#include "tst_Nav2ControlTrees.moc"
