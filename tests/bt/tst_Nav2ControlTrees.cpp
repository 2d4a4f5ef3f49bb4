#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/bt/Nav2ControlTrees.h"
#include "tests/bt/RandomTrees.h"
#include "tests/bt/ScriptedNavigator.h"
#include "tests/bt/TreeProbe.h"

/// Random trees of Nav2's control nodes, ticked by the program and by a second implementation
/// (Nav2ControlTrees.h): the same leaves ticked and halted in the same order, the same result of
/// each tick.
class Nav2ControlTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tick_randomTrees_areTheSame_data();
  void tick_randomTrees_areTheSame();
};

namespace {

using base::NodeStatus;
using navigator::Distro;

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

struct ControlHost : navigator::Scripted {
  ControlHost(Distro distro, const std::map<std::string, std::string>& all)
      : navigator::Scripted(distro), answers(all) {}
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
  library.addStateful(probe::manifest("Act"),
                      {answered, answered, [](bt::LeafContext& leaf) {
                         leaf.host<ControlHost>().calls.push_back(leaf.label() + ":H");
                       }});
  library.addCondition(probe::manifest("Ask"), answered);
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

}  // namespace

void Nav2ControlTreesTest::tick_randomTrees_areTheSame_data() {
  QTest::addColumn<int>("distro");
  QTest::newRow("humble") << static_cast<int>(Distro::Humble);
  QTest::newRow("jazzy") << static_cast<int>(Distro::Jazzy);
  QTest::newRow("main") << static_cast<int>(Distro::Main);
}

void Nav2ControlTreesTest::tick_randomTrees_areTheSame() {
  QFETCH(int, distro);
  const bt::NodeLibrary library = controlLibrary();
  const int seeds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 10000 : 500;
  int ticks = 0, halts = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    DrawnTree drawn(static_cast<std::uint64_t>(seed), static_cast<Distro>(distro));
    const auto program = bt::compile(navigator::tableOf(drawn.xml), library);
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

QTEST_APPLESS_MAIN(Nav2ControlTreesTest)
#include "tst_Nav2ControlTrees.moc"
