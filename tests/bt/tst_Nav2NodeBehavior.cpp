#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/bt/NodeBehavior.h"

namespace {

using namespace nodebehavior;
using Names = std::set<std::string>;

std::string fileText(const std::string& path) {
  const auto text = base::readTextFile(SOURCE_DIR + path);
  return text ? *text : std::string();
}

const std::vector<Row>& table() {
  static const std::vector<Row> kRows = rowsIn(fileText("/tests/data/nav2/node_behavior.txt"));
  return kRows;
}

/// The nodes of Nav2 in tests/data/nav2/nodes.csv, with those of their ports that some distribution
/// has: "in:goal".
const std::map<std::string, Names>& declaredNodes() {
  static const std::map<std::string, Names> kNodes = [] {
    std::map<std::string, Names> nodes;
    for (const std::string& line : base::split(fileText("/tests/data/nav2/nodes.csv"), '\n')) {
      const std::vector<std::string> cells = base::split(line, ';');
      if (line.empty() || line.front() == '#' || cells.front() == "node") {
        continue;
      }
      for (std::size_t branch = 2; branch < cells.size(); ++branch) {
        for (const std::string& port : base::split(cells[branch], ' ')) {
          if (!port.empty() && port != "-") {
            nodes[cells.front()].insert(port);
          }
        }
      }
      nodes[cells.front()];
    }
    return nodes;
  }();
  return kNodes;
}

/// The ports of a node that NAV2.md lists as without effect, with a reason: rows "| `port` | nodes
/// | reason |", where the nodes are "all" or a list.
bool isListedAsWithoutEffect(const std::string& node, const std::string& port) {
  static const std::string kText = fileText("/sim2d/nav/nav2/NAV2.md");
  for (const std::string& line : base::split(kText, '\n')) {
    const std::vector<std::string> cells = base::split(line, '|');
    if (cells.size() < 5 || base::trimmed(cells[1]) != "`" + port + "`" ||
        base::trimmed(cells[3]).empty()) {
      continue;
    }
    const std::vector<std::string> nodes = base::split(base::trimmed(cells[2]), ',');
    if (std::any_of(nodes.begin(), nodes.end(), [&](const std::string& each) {
          return base::trimmed(each) == node || each == "all";
        })) {
      return true;
    }
  }
  return false;
}

/// The same in the description of the port.
bool isDescribedAsWithoutEffect(const std::string& node, const std::string& port) {
  static const bt::NodeLibrary kNodes = bt::robotNodes();
  const bt::NodeManifest* const manifest = kNodes.catalogue().find(node);
  const bt::PortSpec* const spec = manifest != nullptr ? manifest->port(port) : nullptr;
  return spec != nullptr &&
         (base::startsWith(spec->help, "No effect") || base::startsWith(spec->help, "Always"));
}

std::string valueOf(const Row& row, const std::string& port) {
  const auto found = std::find_if(row.ports.begin(), row.ports.end(),
                                  [&](const auto& each) { return each.first == port; });
  return found == row.ports.end() ? "(absent)" : found->second;
}

/// The ports of a row except one.
Ports without(const Row& row, const std::string& port) {
  Ports ports = row.ports;
  ports.erase(std::remove_if(ports.begin(), ports.end(),
                             [&](const auto& each) { return each.first == port; }),
              ports.end());
  return ports;
}

/// Whether two rows differ in the value of that port and what comes of it, and in nothing else.
bool showEffect(const Row& a, const Row& b, const std::string& port) {
  const bool isSameCase = a.node == b.node && a.branch == b.branch && a.scene == b.scene &&
                          a.children == b.children && without(a, port) == without(b, port) &&
                          ticksIn(a.expected) == ticksIn(b.expected);
  return isSameCase && valueOf(a, port) != valueOf(b, port) && a.expected != b.expected;
}

/// The value that a row expects at an output: up to the next one, or the end.
std::string outputOf(const Row& row, const std::string& port) {
  const std::size_t begin = row.expected.find(" " + port + "=");
  if (begin == std::string::npos) {
    return "(none)";
  }
  const std::size_t value = begin + port.size() + 2, next = row.expected.find('=', value);
  return next == std::string::npos
             ? row.expected.substr(value)
             : row.expected.substr(value, row.expected.rfind(' ', next) - value);
}

/// Whether the rows of a node give its output two values.
bool hasTwoValues(const std::vector<Row>& rows, const std::string& node, const std::string& port) {
  Names values;
  for (const Row& row : rows) {
    if (row.node == node && valueOf(row, port) != "(absent)") {
      values.insert(outputOf(row, port));
    }
  }
  return values.size() > 1;
}

bool hasEffect(const std::vector<Row>& rows, const std::string& node, const std::string& port) {
  for (const Row& a : rows) {
    if (a.node == node && std::any_of(rows.begin(), rows.end(),
                                      [&](const Row& b) { return showEffect(a, b, port); })) {
      return true;
    }
  }
  return false;
}

/// Nodes without two different answers or effects, and ports without influence, of those tables.
Names gapsIn(const std::vector<Row>& rows, const std::map<std::string, Names>& nodes) {
  Names gaps;
  for (const auto& [node, ports] : nodes) {
    Names answers;
    for (const Row& row : rows) {
      answers.insert(row.node == node ? row.expected : std::string());
    }
    answers.erase("");
    if (answers.size() < 2) {
      gaps.insert(node);
    }
    for (const std::string& declared : ports) {
      const std::size_t colon = declared.find(':');
      const std::string port = declared.substr(colon + 1);
      const bool isOutput = declared.substr(0, colon) == "out";
      const bool isFree = isListedAsWithoutEffect(node, port);
      if (!isFree && !(isOutput ? hasTwoValues(rows, node, port) : hasEffect(rows, node, port))) {
        gaps.insert(node + "." + port);
      }
    }
  }
  return gaps;
}

std::string namesText(const Names& names) {
  return base::join({names.begin(), names.end()}, " ");
}

std::optional<Distro> branchOf(const std::string& name) {
  for (const Distro distro : sim2d::nav2::kDistros) {
    if (name == sim2d::nav2::distroName(distro)) {
      return distro;
    }
  }
  return std::nullopt;
}

/// Ports that a row gives and the node does not have in its branch.
std::string strangersIn(const Row& row, Distro distro) {
  Names strangers;
  for (const auto& [port, value] : row.ports) {
    if (!sim2d::nav2::includesDistro(bt::distrosOfPort(row.node, port), distro)) {
      strangers.insert(port);
    }
  }
  return namesText(strangers);
}

}  // namespace

/// What each node of navigator trees does and how its ports influence it, by a table; and that no
/// node and no port of Nav2 is left out of it.
class Nav2NodeBehaviorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void row_happensAsItSays_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < table().size(); ++i) {
      const Row& row = table()[i];
      QTest::newRow((std::to_string(row.line) + " " + row.node).c_str()) << static_cast<int>(i);
    }
    QVERIFY(table().size() > 300);
  }

  void row_happensAsItSays() {
    QFETCH(int, index);
    const Row& row = table().at(static_cast<std::size_t>(index));
    const std::optional<Distro> distro = branchOf(row.branch);
    QVERIFY(distro);
    QCOMPARE(strangersIn(row, *distro), std::string());
    Trial trial(row, *distro);
    QVERIFY(!base::hasErrors(trial.problems()));  // warnings: entries that only the scene sets
    const std::string outcome = trial.outcome();
    QCOMPARE(trial.mistakes(), std::string());
    QCOMPARE(QString::fromStdString(outcome), QString::fromStdString(row.expected));
  }

  void eachNodeAndPort_isInTheTable() {
    const Names gaps = gapsIn(table(), declaredNodes());
    QVERIFY2(gaps.empty(), namesText(gaps).c_str());
    QVERIFY(declaredNodes().size() >= 83);
  }

  /// The check above can fail: a node without rows, one with a single answer, a port that is never
  /// varied or that changes nothing.
  void gaps_areFound() {
    std::map<std::string, Names> nodes = {{"Wait", {"in:wait_duration", "out:error_msg"}}};
    QVERIFY(gapsIn(table(), nodes).empty());
    nodes["Sing"] = {"in:song"};
    QCOMPARE(namesText(gapsIn(table(), nodes)), std::string("Sing Sing.song"));
    nodes["Sing"] = {};
    std::vector<Row> rows = table();
    rows.push_back({"Sing", "main", "", "", "", "S", {}, 0});
    QCOMPARE(namesText(gapsIn(rows, nodes)), std::string("Sing"));
    nodes["Sing"] = {"in:song", "in:server_name"};
    rows.push_back({"Sing", "main", "", "", "", "S", {{"song", "1"}}, 0});
    rows.push_back({"Sing", "main", "", "now", "", "F", {}, 0});
    QCOMPARE(namesText(gapsIn(rows, nodes)), std::string("Sing.song"));
    rows.push_back({"Sing", "main", "", "", "", "F", {{"song", "2"}}, 0});
    QVERIFY(gapsIn(rows, nodes).empty());
  }

  /// NAV2.md and the descriptions in the editor agree, and no port is excused that has an effect.
  void portsWithoutEffect_areDescribedAsSuch() {
    for (const auto& [node, ports] : declaredNodes()) {
      for (const std::string& declared : ports) {
        const std::string port = declared.substr(declared.find(':') + 1);
        const std::string name = node + "." + port;
        const bool isListed = isListedAsWithoutEffect(node, port);
        QVERIFY2(isListed == isDescribedAsWithoutEffect(node, port), name.c_str());
        QVERIFY2(!isListed || !hasEffect(table(), node, port), name.c_str());
      }
    }
  }
};

QTEST_GUILESS_MAIN(Nav2NodeBehaviorTest)
#include "tst_Nav2NodeBehavior.moc"
