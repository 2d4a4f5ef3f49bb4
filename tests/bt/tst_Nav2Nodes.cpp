#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QtTest>

#include "bt/robot/Nav2Servers.h"
#include "bt/robot/NavigatorHost.h"
#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"

using bt::ActionFailure;
using bt::RobotAction;
using sim2d::nav2::Distro;

namespace {

using namespace sim2d::nav2;  // NOLINT: branches and their names

struct DeclaredNode {
  std::string kind;
  std::vector<std::string> ports;  // by branch, "in:a out:b"; "-": there is no such node
};

const std::map<std::string, DeclaredNode>& declaredNodes() {
  static const std::map<std::string, DeclaredNode> kNodes = [] {
    std::map<std::string, DeclaredNode> nodes;
    const auto text = base::readTextFile(SOURCE_DIR "/tests/data/nav2/nodes.csv");
    bool isHeader = true;
    for (const std::string& line : base::split(text ? *text : std::string(), '\n')) {
      if (line.empty() || line.front() == '#' || std::exchange(isHeader, false)) {
        continue;
      }
      const std::vector<std::string> cells = base::split(line, ';');
      nodes[cells.at(0)] = {cells.at(1), {cells.begin() + 2, cells.end()}};
    }
    return nodes;
  }();
  return kNodes;
}

/// Where the table, which was made by patterns, misses something that Nav2 has.
struct Deviation {
  std::string_view node, port;
  unsigned distros;
  const char* reason;
};
constexpr std::array<Deviation, 4> kDeviations = {
    {{"", "server_name", kAllDistros, "every action node has it (BtActionNode)"},
     {"", "server_timeout", kAllDistros, "every action and service node has it"},
     {"Spin", "is_recovery", kHumble, "Humble's odometry_calibration.xml uses it"},
     {"TruncatePathLocal", "input_path", kHumble, "without it the node would have no path"}}};

bool isDeviation(const std::string& node, const std::string& port, Distro distro) {
  return std::any_of(kDeviations.begin(), kDeviations.end(), [&](const Deviation& each) {
    return (each.node.empty() || each.node == node) && each.port == port &&
           includesDistro(each.distros, distro);
  });
}

const char* prefixOf(bt::PortDirection direction) {
  static constexpr std::array<const char*, 3> kPrefixes = {"in:", "out:", "inout:"};
  return kPrefixes.at(static_cast<std::size_t>(direction));
}

std::vector<std::string> sorted(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  return words;
}

/// The ports of a node in a branch as the program has them, and as the table does.
std::vector<std::string> ownPorts(const bt::NodeManifest& node, Distro distro) {
  std::vector<std::string> ports;
  for (const bt::PortSpec& port : node.ports) {
    if (includesDistro(bt::distrosOfPort(node.id, port.key), distro) &&
        !isDeviation(node.id, port.key, distro)) {
      ports.push_back(prefixOf(port.direction) + port.key);
    }
  }
  return sorted(std::move(ports));
}

std::vector<std::string> declaredPorts(const std::string& node, Distro distro) {
  std::vector<std::string> ports;
  const std::string& all = declaredNodes().at(node).ports.at(static_cast<std::size_t>(distro));
  for (const std::string& port : base::split(all, ' ')) {
    const std::string name = port.substr(port.find(':') + 1);
    if (!port.empty() && !isDeviation(node, name, distro)) {
      ports.push_back(port);
    }
  }
  return sorted(std::move(ports));
}

void addNodes() {
  QTest::addColumn<QString>("id");
  for (const auto& [id, node] : declaredNodes()) {
    QTest::newRow(id.c_str()) << QString::fromStdString(id);
  }
}

/// The robot at (0.525, 1.525), as it was told to be.
struct Scene {
  std::unique_ptr<bt::Nav2Servers> servers;
  sim2d::Observation observation;
  bt::PathId path = 0;

  explicit Scene(double y = 1.525) {
    constexpr std::size_t kColumns = 200, kRows = 60;
    std::vector<std::int8_t> cells(kColumns * kRows, 0);
    for (std::size_t row = 0; row < kRows; ++row) {
      cells[row * kColumns + 100] = 100;
    }
    const auto file = ParameterFile::read(SOURCE_DIR "/resources/nav2_params/generic.yaml");
    bt::Nav2Servers::Setup setup;
    setup.parameters = readNav2Parameters(*file, {Distro::Jazzy, {}}).parameters;
    setup.map = sim2d::OccupancyGrid(kColumns, kRows, 0.05, {}, std::move(cells));
    auto made = bt::Nav2Servers::make(std::move(setup));
    servers = made ? *std::move(made) : nullptr;
    observation.pose = {{0.525, y}, 0.0};
    observation.dt = 0.05;
    step();
    Path poses;
    for (int i = 0; i < 19; ++i) {
      poses.push_back({{0.525 + 0.5 * i, 1.525}, 0.0});
    }
    path = servers->paths().add(poses);
  }
  void step(double speed = 0.0) {
    observation.motion.linear = speed;
    servers->sense(observation);
    observation.time += observation.dt;
  }
};

}  // namespace

/// Every node of Nav2 with its ports, against the tables of this program: kinds, names, directions,
/// and in which branches they exist. The table in tests/data/nav2/nodes.csv was made from Nav2's
/// sources, not by this program.
class Nav2NodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachNode_hasItsKindAndBranches_data() { addNodes(); }

  void eachNode_hasItsKindAndBranches() {
    QFETCH(QString, id);
    const bt::NodeLibrary library = bt::robotNodes();
    const DeclaredNode& declared = declaredNodes().at(id.toStdString());
    const bt::NodeManifest* const node = library.catalogue().find(id.toStdString());
    QVERIFY2(node != nullptr, "there is no such node");
    QCOMPARE(std::string(bt::nodeKindName(node->kind)), declared.kind);
    for (const Distro distro : kDistros) {
      const bool isThere = declared.ports.at(static_cast<std::size_t>(distro)) != "-";
      QVERIFY2(includesDistro(bt::distrosOfNode(node->id), distro) == isThere, distroTitle(distro));
    }
  }

  void eachNode_hasItsPortsInEachBranch_data() { addNodes(); }

  void eachNode_hasItsPortsInEachBranch() {
    QFETCH(QString, id);
    const bt::NodeLibrary library = bt::robotNodes();
    const bt::NodeManifest* const node = library.catalogue().find(id.toStdString());
    QVERIFY(node != nullptr);
    for (const Distro distro : kDistros) {
      if (includesDistro(bt::distrosOfNode(node->id), distro)) {
        const std::string own = base::join(ownPorts(*node, distro), " ");
        const std::string declared = base::join(declaredPorts(node->id, distro), " ");
        const std::string title = distroTitle(distro);
        QVERIFY2(own == declared,
                 base::join({title, ": '", own, "', not '", declared, "'"}, "").c_str());
      }
    }
  }

  /// No node for navigators is made up.
  void ownNodes_areOfTheTable() {
    const bt::NodeLibrary library = bt::robotNodes();
    for (const bt::NodeManifest& node : library.catalogue().all()) {
      const bool isKnown = declaredNodes().count(node.id) == 1;
      QVERIFY2(node.category != "Navigation" || isKnown, node.id.c_str());
    }
    QVERIFY(declaredNodes().size() >= 83);
  }

  /// The comparison above can fail: a port too much, one too few, and one of another branch.
  void nodesOfAFaultyTable_areFound() {
    bt::NodeManifest node = *bt::robotNodes().catalogue().find("Wait");
    QCOMPARE(ownPorts(node, Distro::Main), declaredPorts("Wait", Distro::Main));
    node.ports.pop_back();  // error_msg or another
    QVERIFY(ownPorts(node, Distro::Main) != declaredPorts("Wait", Distro::Main));
    QVERIFY(declaredPorts("Wait", Distro::Jazzy) != declaredPorts("Wait", Distro::Main));
  }

  // What Nav2's servers answer the nodes of a tree: a plane of 10 m x 3 m with a wall across it,
  // 0.05 m thick, at x = 5 m; the generic robot's file.

  void checkPath_throughTheWall_hasItsCollisions_data() {
    QTest::addColumn<int>("maxCost");
    QTest::addColumn<double>("lookahead");
    QTest::addColumn<QString>("layer");
    QTest::addColumn<QString>("footprint");
    QTest::addColumn<bool>("stops");
    QTest::addColumn<int>("collisions");
    // Poses are 0.5 m apart, one of them, 4.5 m ahead, in the wall. The neighbours are 0.5 m from
    // it, where the cost is 252 exp(-3 (0.5 - 0.353)) = 162.
    QTest::newRow("usual") << 254 << -1.0 << ""
                           << "" << false << 1;
    QTest::newRow("cost") << 160 << -1.0 << ""
                          << "" << false << 3;
    QTest::newRow("cost, first") << 160 << -1.0 << ""
                                 << "" << true << 1;
    QTest::newRow("higher cost") << 165 << -1.0 << ""
                                 << "" << false << 1;
    QTest::newRow("before the wall") << 254 << 4.4 << ""
                                     << "" << false << 0;
    QTest::newRow("up to the wall") << 254 << 4.6 << ""
                                    << "" << false << 1;
    const QString kLong = QStringLiteral("[[0.6, 0.1], [0.6, -0.1], [-0.6, -0.1], [-0.6, 0.1]]");
    // The wall's pose, its neighbours, and both ends of the path, where it reaches off the map.
    QTest::newRow("long footprint") << 254 << -1.0 << "" << kLong << false << 5;
    QTest::newRow("layer without inflation") << 160 << -1.0 << "static_layer"
                                             << "" << false << 1;
  }

  void checkPath_throughTheWall_hasItsCollisions() {
    QFETCH(int, maxCost);
    QFETCH(double, lookahead);
    QFETCH(QString, layer);
    QFETCH(QString, footprint);
    QFETCH(bool, stops);
    QFETCH(int, collisions);
    const Scene scene;
    const bt::PathCheckResult result =
        scene.servers->checkPath({scene.path, maxCost, false, lookahead, layer.toStdString(),
                                  footprint.toStdString(), stops});
    QCOMPARE(static_cast<int>(result.collisions.size()), collisions);
    QCOMPARE(result.isValid, collisions == 0);
  }

  void checkPath_badRequests_areNotValid() {
    const Scene scene;
    bt::PathCheck check;
    QVERIFY(!scene.servers->checkPath(check).isValid);  // no path
    check.path = scene.path;
    check.lookahead = 1.0;
    QVERIFY(scene.servers->checkPath(check).isValid);
    check.layer = "nowhere";
    QVERIFY(!scene.servers->checkPath(check).isValid);
    check.layer.clear();
    check.footprint = "[[0, 0], [1, 1]]";
    QVERIFY(!scene.servers->checkPath(check).isValid);
  }

  void costAt_centreOrFootprint() {
    const Scene scene;
    const auto cost = [&](double x, double y, bool usesFootprint) {
      return scene.servers->costAt(false, {{x, y}, 0.0}, usesFootprint);
    };
    QVERIFY(!cost(-1.0, 1.0, false) && !cost(-1.0, 1.0, true));
    QCOMPARE(static_cast<int>(*cost(5.025, 1.525, false)), 254);
    QCOMPARE(static_cast<int>(*cost(2.025, 1.525, false)), 0);
    QCOMPARE(static_cast<int>(*cost(4.525, 1.525, false)), 162);
    QCOMPARE(static_cast<int>(*cost(4.525, 1.525, true)), 253);  // its edge is 0.14 m from the wall
    QCOMPARE(static_cast<int>(*cost(4.725, 1.525, true)), 254);
  }

  void acceleration_isOfTheLastTwoReadings() {
    Scene scene;
    scene.step(0.6);
    scene.step(0.6);
    QCOMPARE(scene.servers->acceleration(), 0.0);
    scene.step(0.1);
    QVERIFY(std::fabs(scene.servers->acceleration() + 10.0) < 1e-9);
  }

  void tracking_ofFollowPath_hasASide() {
    Scene scene(1.725);
    QCOMPARE(scene.servers->tracking().number, 0);
    bt::RobotRequest request;
    request.path = scene.path;
    scene.servers->begin(bt::RobotAction::FollowPath, request);
    scene.servers->act();
    const TrackingFeedback tracking = scene.servers->tracking();
    QCOMPARE(tracking.number, 1);
    QVERIFY(std::fabs(tracking.positionError - 0.2) < 1e-9);  // on the left
    QVERIFY(std::fabs(tracking.remaining - 9.0) < 1e-9);
  }

  void clear_unknownLayer_isRefused() {
    const Scene scene;
    bt::ClearRequest request;
    request.isLocal = false;
    QVERIFY(scene.servers->clear(request));
    request.plugins = "obstacle_layer";
    QVERIFY(scene.servers->clear(request));
    request.plugins = "nowhere";
    QVERIFY(!scene.servers->clear(request));
  }

  // Names of Nav2's error codes, as its action definitions have them (nav2_msgs/action, Jazzy).

  void reason_hasNameAndCode_data() {
    QTest::addColumn<int>("action");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("reason");
    const auto row = [](RobotAction action, int code, const char* reason) {
      QTest::newRow(reason) << static_cast<int>(action) << code << reason;
    };
    row(RobotAction::FollowPath, 100, "controller UNKNOWN (100)");
    row(RobotAction::FollowPath, 101, "controller INVALID_CONTROLLER (101)");
    row(RobotAction::FollowPath, 103, "controller INVALID_PATH (103)");
    row(RobotAction::FollowPath, 104, "controller PATIENCE_EXCEEDED (104)");
    row(RobotAction::FollowPath, 105, "controller FAILED_TO_MAKE_PROGRESS (105)");
    row(RobotAction::FollowPath, 106, "controller NO_VALID_CONTROL (106)");
    row(RobotAction::FollowPath, 107, "controller CONTROLLER_TIMED_OUT (107)");
    row(RobotAction::ComputePath, 200, "planner UNKNOWN (200)");
    row(RobotAction::ComputePath, 201, "planner INVALID_PLANNER (201)");
    row(RobotAction::ComputePath, 203, "planner START_OUTSIDE_MAP (203)");
    row(RobotAction::ComputePath, 204, "planner GOAL_OUTSIDE_MAP (204)");
    row(RobotAction::ComputePath, 205, "planner START_OCCUPIED (205)");
    row(RobotAction::ComputePath, 206, "planner GOAL_OCCUPIED (206)");
    row(RobotAction::ComputePath, 207, "planner TIMEOUT (207)");
    row(RobotAction::ComputePath, 208, "planner NO_VALID_PATH (208)");
    row(RobotAction::ComputePathThroughPoses, 306, "planner GOAL_OCCUPIED (306)");
    row(RobotAction::ComputePathThroughPoses, 308, "planner NO_VALID_PATH (308)");
    row(RobotAction::ComputePathThroughPoses, 309, "planner NO_VIAPOINTS_GIVEN (309)");
    row(RobotAction::SmoothPath, 501, "smoother INVALID_SMOOTHER (501)");
    row(RobotAction::SmoothPath, 503, "smoother SMOOTHED_PATH_IN_COLLISION (503)");
    row(RobotAction::Spin, 701, "spin TIMEOUT (701)");
    row(RobotAction::Spin, 703, "spin COLLISION_AHEAD (703)");
    row(RobotAction::BackUp, 713, "backup INVALID_INPUT (713)");
    row(RobotAction::BackUp, 714, "backup COLLISION_AHEAD (714)");
    row(RobotAction::DriveOnHeading, 723, "drive_on_heading COLLISION_AHEAD (723)");
    row(RobotAction::DriveOnHeading, 724, "drive_on_heading INVALID_INPUT (724)");
    row(RobotAction::Wait, 741, "wait TIMEOUT (741)");
  }

  void reason_hasNameAndCode() {
    QFETCH(int, action);
    QFETCH(int, code);
    QFETCH(QString, reason);
    const ActionFailure failure{static_cast<RobotAction>(action), code};
    for (const Distro distro : {Distro::Jazzy, Distro::Kilted, Distro::Lyrical, Distro::Main}) {
      QCOMPARE(bt::failureReason(failure, distro), reason.toStdString());
    }
    QVERIFY(!bt::failureMessage(failure).empty());
  }

  /// Its actions have no error codes.
  void reason_ofHumble_hasNoCode() {
    QCOMPARE(bt::failureReason({RobotAction::ComputePath, 208}, Distro::Humble),
             std::string("planner NO_VALID_PATH"));
  }

  void reason_ofWhatIsNotThere_isNamed() {
    QCOMPARE(bt::failureReason({RobotAction::Spin, 0}, Distro::Jazzy),
             std::string("spin NOT_AVAILABLE"));
  }

  void throughPoses_haveCodesOfTheirOwn() {
    QCOMPARE(bt::throughPosesCode(0), 0);
    QCOMPARE(bt::throughPosesCode(208), 308);
    QVERIFY(bt::isPlannerFailure({RobotAction::ComputePathThroughPoses, 308}));
    QVERIFY(!bt::isPlannerFailure({RobotAction::FollowPath, 105}));
  }
};

QTEST_GUILESS_MAIN(Nav2NodesTest)
#include "tst_Nav2Nodes.moc"
