#include <algorithm>
#include <cmath>
#include <ctime>

#include <QtTest>

#include "sim2d/trace/Recording.h"

using namespace sim2d;

/// A run of 10 minutes with 100 people whose trees have 20 nodes, in processor time: the way to any
/// state and to the trees at any step (limit: 1 ms, in memory and on the disk), what it costs to
/// record a step, to read the states one after the other, and the memory of a second.
class RecordingBench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void jump_data();
  void jump();
  void append();
};

namespace {

constexpr int kPeople = 100, kNodes = 20;
constexpr std::int64_t kSteps = 12000;  // of 0.05 s

Frame frameAt(std::int64_t step, const TreeChanges::Paths& names) {
  Frame frame;
  frame.step = step;
  frame.time = 0.05 * static_cast<double>(step);
  HumanColumns& humans = frame.humans;
  for (int id = 1; id <= kPeople; ++id) {
    const double phase = 0.01 * static_cast<double>(step) + id;
    humans.id.push_back(id);
    humans.x.push_back(std::cos(phase));
    humans.y.push_back(std::sin(phase));
    humans.heading.push_back(phase);
    humans.vx.push_back(-std::sin(phase));
    humans.vy.push_back(std::cos(phase));
    humans.omega.push_back(0.2);
    humans.group.push_back(-1);
    humans.state.push_back(0);
    humans.goal.push_back(1);
    for (std::vector<Vec2>* forces :
         {&frame.forces.goal, &frame.forces.social, &frame.forces.obstacle, &frame.forces.group}) {
      forces->emplace_back(phase, -phase);
    }
    for (int node = 0; node < kNodes; ++node) {
      if (step == 1 || (step + 7 * id + node) % 40 == 0) {
        const auto status = static_cast<base::NodeStatus>((step / 40 + node) % 4);
        frame.treeChanges.add(id, names, node, status);
      }
    }
  }
  return frame;
}

}  // namespace

void RecordingBench::jump_data() {
  QTest::addColumn<qulonglong>("memory");
  QTest::newRow("memory") << (qulonglong{1} << 32);
  QTest::newRow("disk") << qulonglong{0};
}

void RecordingBench::jump() {
  QFETCH(qulonglong, memory);
  Recording recording(1, memory);
  const auto names = std::make_shared<const std::vector<std::string>>(kNodes, "Main");
  for (std::int64_t step = 0; step <= kSteps; ++step) {
    recording.append(frameAt(step, names));
  }
  std::size_t people = 0, jumps = 0;
  double slowest = 0.0, total = 0.0;
  for (std::size_t index = 0; jumps < 2000; index = (index + 7919) % recording.size(), ++jumps) {
    const std::clock_t begin = std::clock();
    people += recording.frame(index)->humans.size();
    people += recording.treesAt(recording.stepOf(index)).size();
    const double taken = 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    slowest = std::max(slowest, taken);
    total += taken;
  }
  QVERIFY(people > 0);
  qInfo("%.3f ms per jump, slowest %.3f ms", total / static_cast<double>(jumps), slowest);
  QTest::setBenchmarkResult(total / static_cast<double>(jumps), QTest::WalltimeMilliseconds);
}

void RecordingBench::append() {
  Recording recording(1, std::size_t{1} << 32U);
  const auto names = std::make_shared<const std::vector<std::string>>(kNodes, "Main");
  std::clock_t taken = 0;
  for (std::int64_t step = 0; step <= kSteps; ++step) {
    const Frame frame = frameAt(step, names);
    const std::clock_t begin = std::clock();
    recording.append(frame);
    taken += std::clock() - begin;
  }
  const auto perState = [](std::clock_t time) {
    return 1e6 * static_cast<double>(time) / static_cast<double>(CLOCKS_PER_SEC * (kSteps + 1));
  };
  std::size_t people = 0;
  const std::clock_t begin = std::clock();
  for (std::size_t index = 0; index < recording.size(); ++index) {
    people += recording.frame(index)->humans.size();
  }
  QVERIFY(people > 0);
  qInfo("%.1f us to record a step, %.1f us to read the next state, %.3f MB per simulated second",
        perState(taken), perState(std::clock() - begin),
        static_cast<double>(recording.history().memory()) / 600.0 / 1048576.0);
  QTest::setBenchmarkResult(0.001 * perState(taken), QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(RecordingBench)
#include "bench_Recording.moc"
