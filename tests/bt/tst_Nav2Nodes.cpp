#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QtTest>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"

/// Every node of Nav2 with its ports, against the tables of this program: kinds, names, directions,
/// and in which branches they exist. The table in tests/data/nav2/nodes.csv was made from Nav2's
/// sources, not by this program.
class Nav2NodesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachNode_hasItsKindAndBranches_data();
  void eachNode_hasItsKindAndBranches();
  void eachNode_hasItsPortsInEachBranch_data();
  void eachNode_hasItsPortsInEachBranch();
  void ownNodes_areOfTheTable();
  void nodesOfAFaultyTable_areFound();
};

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

}  // namespace

void Nav2NodesTest::eachNode_hasItsKindAndBranches_data() {
  addNodes();
}

void Nav2NodesTest::eachNode_hasItsKindAndBranches() {
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

void Nav2NodesTest::eachNode_hasItsPortsInEachBranch_data() {
  addNodes();
}

void Nav2NodesTest::eachNode_hasItsPortsInEachBranch() {
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
void Nav2NodesTest::ownNodes_areOfTheTable() {
  const bt::NodeLibrary library = bt::robotNodes();
  for (const bt::NodeManifest& node : library.catalogue().all()) {
    const bool isKnown = declaredNodes().count(node.id) == 1;
    QVERIFY2(node.category != "Navigation" || isKnown, node.id.c_str());
  }
  QVERIFY(declaredNodes().size() >= 83);
}

/// The comparison above can fail: a port too much, one too few, and one of another branch.
void Nav2NodesTest::nodesOfAFaultyTable_areFound() {
  bt::NodeManifest node = *bt::robotNodes().catalogue().find("Wait");
  QCOMPARE(ownPorts(node, Distro::Main), declaredPorts("Wait", Distro::Main));
  node.ports.pop_back();  // error_msg or another
  QVERIFY(ownPorts(node, Distro::Main) != declaredPorts("Wait", Distro::Main));
  QVERIFY(declaredPorts("Wait", Distro::Jazzy) != declaredPorts("Wait", Distro::Main));
}

QTEST_GUILESS_MAIN(Nav2NodesTest)
#include "tst_Nav2Nodes.moc"
