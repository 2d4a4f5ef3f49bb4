#include <QtTest/QtTest>
#include <memory>
#include <string>
#include <vector>

#include "bt/engine/TreeState.h"
#include "bt/tree/TreeXml.h"
#include "tests/bt/RandomTrees.h"
#include "tests/bt/TreeProbe.h"

namespace {

using base::NodeStatus;

constexpr int kTicks = 15;
constexpr double kStep = 0.1;  // [s]

/// The answers of one run of a tree.
class Script {
 public:
  explicit Script(const std::map<std::string, std::string>& answers) : answers_(answers) {}
  char next(const std::string& leaf) {
    const std::string& all = answers_.at(leaf);
    std::size_t& count = calls_[leaf];
    const char answer = all[std::min(count, all.size() - 1)];
    ++count;
    return answer;
  }

 private:
  const std::map<std::string, std::string>& answers_;
  std::map<std::string, std::size_t> calls_;
};

struct Host {
  Script* script = nullptr;
  std::vector<std::string> calls;
};

NodeStatus answer(bt::LeafContext& leaf) {
  auto& host = leaf.host<Host>();
  const char letter = host.script->next(leaf.label());
  host.calls.push_back(leaf.label() + ":" + letter);
  return letter == 'R'   ? NodeStatus::Running
         : letter == 'S' ? NodeStatus::Success
                         : NodeStatus::Failure;
}

bt::PortSpec outputPort(bt::PortType type) {
  bt::PortSpec port = probe::port("out", type);
  port.direction = bt::PortDirection::Output;
  return port;
}

template <class T>
NodeStatus put(bt::LeafContext& leaf) {
  leaf.set(0, leaf.require<T>(1));
  return NodeStatus::Success;
}

void addPorts(bt::NodeLibrary& library) {
  using bt::PortType;
  library.add(probe::manifest("NeedInt", {probe::port("in", PortType::Int)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                const std::optional<int> value = leaf.get<int>(0);
                leaf.require<int>(0);
                if (value) {
                  leaf.host<Host>().calls.push_back("int " + std::to_string(*value));
                }
                return NodeStatus::Success;
              }));
  library.add(probe::manifest("NeedReal", {probe::port("in", PortType::Double)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                const double value = leaf.require<double>(0);
                leaf.host<Host>().calls.push_back("real " + std::to_string(value));
                return NodeStatus::Success;
              }));
  library.add(probe::manifest("NeedText", {probe::port("in", PortType::String)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                const std::string value(leaf.require<std::string_view>(0));
                leaf.host<Host>().calls.push_back("text " + value);
                return NodeStatus::Success;
              }));
  library.add(
      probe::manifest("PutInt", {outputPort(PortType::Int), probe::port("from", PortType::Int)}),
      bt::synchronous(put<int>));
  library.add(probe::manifest(
                  "PutReal", {outputPort(PortType::Double), probe::port("from", PortType::Double)}),
              bt::synchronous(put<double>));
  library.add(probe::manifest(
                  "PutText", {outputPort(PortType::String), probe::port("from", PortType::String)}),
              bt::synchronous(put<std::string_view>));
}

bt::NodeLibrary libraryOfLeaves() {
  bt::NodeLibrary library;
  library.add(probe::manifest("Act"),
              bt::stateful({answer, answer, [](bt::LeafContext& leaf) {
                              leaf.host<Host>().calls.push_back(leaf.label() + ":H");
                            }}));
  library.add(probe::manifest("Ask"), bt::synchronous(answer));
  addPorts(library);
  return library;
}

QString joined(const std::vector<std::string>& calls) {
  QStringList all;
  for (const std::string& call : calls) {
    all << QString::fromStdString(call);
  }
  return all.join(QLatin1Char(' '));
}

/// How far two runs of a tree were compared, and what differs; empty: nothing.
struct Comparison {
  int ticks = 0;
  bool isRefused = false;  // the engine does not load it
  QString unsaid;          // why it ended early
  QString difference;
};

const char* nameOf(page::Status status) {
  constexpr const char* kNames[] = {"IDLE", "RUNNING", "SUCCESS", "FAILURE", "SKIPPED"};
  return kNames[static_cast<int>(status)];
}

/// The entries of the main tree that the start makes.
QString differingEntry(const bt::TreeState& state, page::Board& board) {
  for (const char* key : {"i1", "i2", "d1", "d2", "s1", "s2"}) {
    const int slot = state.program().findSlot(key);
    const page::Entry* const other = board.find(key);
    if (slot < 0 || !other) {
      continue;
    }
    const bt::Value& value = state.get(slot);
    const page::Value& theirs = other->value;
    const bool isSame = theirs.kind == page::Value::Text ? value.text == theirs.text
                        : theirs.kind == page::Value::Number
                            ? value.isNumber() && value.number() == theirs.number
                            : value.type == bt::ValueType::Unset;
    if (!isSame) {
      return QStringLiteral("%1 is %2 here, %3 there")
          .arg(QLatin1String(key), QString::fromStdString(value.toText()),
               theirs.kind == page::Value::Text ? QString::fromStdString(theirs.text)
                                                : QString::number(theirs.number));
    }
  }
  return {};
}

/// Both engines with one tree.
class Pair {
 public:
  Pair(const page::Drawn& drawn, std::shared_ptr<const bt::Program> program)
      : ours_(drawn.answers),
        theirs_(drawn.answers),
        state_(std::move(program)),
        returned_(static_cast<std::size_t>(state_.program().nodeCount())) {
    state_.recordResults(returned_.data());
    host_.script = &ours_;
    stage_.answer = [this](const std::string& leaf) {
      const char letter = theirs_.next(leaf);
      return letter == 'R'   ? page::Status::Running
             : letter == 'S' ? page::Status::Success
                             : page::Status::Failure;
    };
    root_ = page::makeNode(drawn.trees.at("Main"), board_, stage_, drawn.trees);
  }

  /// False: nothing is to be compared after this tick.
  bool tick(int number, Comparison& result) {
    stage_.calls.clear();
    stage_.now = number * kStep;
    QString theirs;
    try {
      const page::Status status = root_->executeTick();
      root_->status = page::isDone(status) ? page::Status::Idle : root_->status;
      theirs = QLatin1String(nameOf(status));
    } catch (const page::Fault& fault) {
      theirs = QStringLiteral("fault (%1)").arg(QString::fromStdString(fault.what));
    } catch (const page::Unsaid& unsaid) {
      result.unsaid = QString::fromStdString(unsaid.what);
      return false;
    }
    host_.calls.clear();
    const NodeStatus status = state_.tickOnce({number, kStep, &host_});
    const bt::TreeFault* const fault = state_.fault();
    const QString ours = fault ? QStringLiteral("fault (%1: %2)")
                                     .arg(QString::fromStdString(fault->path),
                                          QString::fromStdString(fault->message))
                               : QString::fromLatin1(base::nodeStatusName(status));
    const bool areFaults = fault && theirs.startsWith(QLatin1String("fault"));
    if (!areFaults && (ours != theirs || joined(host_.calls) != joined(stage_.calls))) {
      result.difference = QStringLiteral("tick %1\n ours   %2 | %3\n theirs %4 | %5")
                              .arg(number)
                              .arg(ours, joined(host_.calls), theirs, joined(stage_.calls));
    } else if (!areFaults) {
      result.difference = differingEntry(state_, board_);
    }
    ++result.ticks;
    return !areFaults && result.difference.isEmpty();
  }

  /// What each node has returned in all ticks; empty: the same. Nodes that are marked as
  /// unreachable have returned nothing.
  QString differingResult() const {
    for (std::size_t node = 0; node < returned_.size(); ++node) {
      const bool isExecuted = returned_[node] != base::StatusSet();
      if (isExecuted && (*state_.program().unreachable())[node]) {
        return QStringLiteral("%1 is not unreachable")
            .arg(QString::fromStdString(state_.program().path(static_cast<int>(node))));
      }
    }
    std::size_t place = 0;
    const QString found = differingResult(*root_, place);
    return found.isEmpty() && place != returned_.size() ? QStringLiteral("the numbers of nodes")
                                                        : found;
  }

 private:
  /// Of the node at this place of the order of the file, and of those below it.
  QString differingResult(const page::Node& node, std::size_t& place) const {
    const std::size_t own = place++;
    for (const page::Status status : {page::Status::Running, page::Status::Success,
                                      page::Status::Failure, page::Status::Skipped}) {
      const bool isTheirs = node.returned.count(status) > 0;
      if (own >= returned_.size() ||
          isTheirs != base::contains(returned_[own], static_cast<NodeStatus>(status))) {
        return QStringLiteral("%1 has%2 returned %3 there")
            .arg(QString::fromStdString(state_.program().path(static_cast<int>(own))),
                 isTheirs ? QString() : QStringLiteral(" not"), QLatin1String(nameOf(status)));
      }
    }
    for (const auto& child : node.children) {
      QString found = differingResult(*child, place);
      if (!found.isEmpty()) {
        return found;
      }
    }
    return {};
  }

  Script ours_;
  Script theirs_;
  Host host_;
  page::Stage stage_;
  page::Board board_;
  std::unique_ptr<page::Node> root_;
  bt::TreeState state_;
  std::vector<base::StatusSet> returned_;
};

Comparison compare(const page::Drawn& drawn, const bt::NodeLibrary& library) {
  Comparison result;
  const base::Result<bt::TreeFile> file = bt::readTreeText(page::xmlOf(drawn.trees), "drawn.xml");
  const auto program = file ? bt::compile(*file, library)
                            : base::Result<std::shared_ptr<const bt::Program>>(file.diagnostics());
  if (!program) {
    const std::string why = probe::textOf(program.diagnostics());
    result.isRefused =
        why.find(" is ") != std::string::npos && why.find(", but {") != std::string::npos;
    result.difference = result.isRefused ? QString() : QString::fromStdString(why);
    return result;
  }
  Pair pair(drawn, *program);
  int number = 1;
  while (number <= kTicks && pair.tick(number, result)) {
    ++number;
  }
  if (number > kTicks) {  // no fault, nothing that the description leaves open
    result.difference = pair.differingResult();
  }
  return result;
}

}  // namespace

/// Random trees, ticked by the engine and by a second implementation that was made from the
/// description alone (PageTree.h): the same calls in the same order with the same results, the same
/// values of entries and faults in the same tick. What the description leaves open is not compared.
/// With HUNAV_ALL_TESTS 20 times as many.
class RandomTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_randomTree_agreesWithTheDescription_data() {
    QTest::addColumn<int>("grammar");
    QTest::newRow("known") << static_cast<int>(page::Grammar::Known);
    QTest::newRow("wide") << static_cast<int>(page::Grammar::Wide);
    QTest::newRow("ports") << static_cast<int>(page::Grammar::Ports);
  }

  void tick_randomTree_agreesWithTheDescription() {
    QFETCH(int, grammar);
    const bt::NodeLibrary library = libraryOfLeaves();
    const int seeds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 10000 : 500;
    int refused = 0;
    int ticks = 0;
    std::map<QString, int> unsaid;
    QStringList differing;
    for (int seed = 1; seed <= seeds; ++seed) {
      const page::Drawn drawn =
          page::TreeDrawer(static_cast<page::Grammar>(grammar), static_cast<std::uint64_t>(seed))
              .draw();
      const Comparison found = compare(drawn, library);
      refused += found.isRefused ? 1 : 0;
      ticks += found.ticks;
      unsaid[found.unsaid] += found.unsaid.isEmpty() ? 0 : 1;
      if (!found.difference.isEmpty()) {
        differing << QStringLiteral("seed %1, %2").arg(seed).arg(found.difference);
        if (differing.size() <= 3) {
          qWarning("%s\n%s", qPrintable(differing.back()), page::xmlOf(drawn.trees).c_str());
        }
      }
    }
    for (const auto& [why, count] : unsaid) {
      if (count > 0) {
        qInfo("%d trees end early: %s", count, qPrintable(why));
      }
    }
    qInfo("%d trees, %d ticks, %d refused for their types, %d differ", seeds, ticks, refused,
          static_cast<int>(differing.size()));
    QVERIFY2(differing.isEmpty(), qPrintable(differing.mid(0, 20).join(QLatin1Char('\n'))));
    QVERIFY(refused < seeds / 4);
    QVERIFY(ticks > 6 * seeds);
  }
};

QTEST_APPLESS_MAIN(RandomTreesTest)
#include "tst_RandomTrees.moc"
