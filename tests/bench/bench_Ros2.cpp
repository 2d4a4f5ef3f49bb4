#include <algorithm>
#include <chrono>
#include <ctime>
#include <poll.h>
#include <unistd.h>
#include <vector>

#include <QCoreApplication>
#include <QProcess>
#include <QtTest>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/nodes/AgentServer.h"
#include "app/bridge/nodes/RunNode.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"

using namespace ros2test;
using hunav_msgs::ComputeAgents;

/// Over the loopback, to another process: the time of a call of `compute_agents` with 30 people
/// (wanted: median below 0.5 ms, 99 of 100 below 2 ms), and what a run with 1000 people takes to
/// publish its states 20 times a second while somebody hears them, in processor time (wanted: 5 %
/// of a core).
class Ros2Bench : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void computeAgents_data();
  void computeAgents();
  void publish();
};

namespace {

constexpr int kDomain = 70;
constexpr int kPeople = 30, kCrowd = 1000, kCalls = 2000;

sim2d::Scenario sceneOf(int people) {
  sim2d::Scenario scenario;
  const int goal = agentstest::addGoal(scenario, 5.0, 90.0);
  for (int id = 1; id <= people; ++id) {
    agentstest::addPerson(scenario, id, 2.0 * (id % 40), 2.0 * (id / 40), {goal});
  }
  return scenario;
}

bool isOver() {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, 0) != 0;
}

int serve(int domain) {
  ServeSettings settings;
  settings.domain = inDomain(domain);
  auto server = AgentServer::create(agentstest::bundleOf(sceneOf(kPeople)), settings,
                                    [](const base::Diagnostic& /*said*/) {});
  while (server && !isOver()) {
    (*server)->spin(Milliseconds(50));
  }
  return server ? 0 : 1;
}

int hear(int domain) {
  const auto listener = participant(inDomain(domain));
  const int node = listener->addNode("/", "listener");
  std::vector<std::unique_ptr<Subscription>> all;
  for (const auto& [topic, type] :
       {std::pair("/human_states", "hunav_msgs/msg/Agents"),
        std::pair("/people", "people_msgs/msg/People"), std::pair("/tf", "tf2_msgs/msg/TFMessage"),
        std::pair("/markers", "visualization_msgs/msg/MarkerArray")}) {
    auto made = listener->subscription(node, topic, type, Qos(), [](const Bytes& /*bytes*/) {});
    all.push_back(made ? *std::move(made) : nullptr);
  }
  while (!isOver()) {
    listener->spin(Milliseconds(50));
  }
  return 0;
}

void startAs(QProcess& process, const char* role, int domain) {
  process.setProcessChannelMode(QProcess::ForwardedChannels);
  process.start(QCoreApplication::applicationFilePath(),
                {QString::fromLatin1(role), QString::number(domain)});
}

void end(QProcess& process) {
  process.closeWriteChannel();
  process.waitForFinished(10000);
}

double processorMs() {
  timespec now = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

void Ros2Bench::computeAgents_data() {
  QTest::addColumn<double>("part");
  QTest::newRow("median") << 0.5;
  QTest::newRow("99 of 100") << 0.99;
}

void Ros2Bench::computeAgents() {
  QFETCH(const double, part);
  QProcess server;
  startAs(server, "serve", kDomain);
  const auto caller = participant(inDomain(kDomain));
  auto client =
      caller->client(caller->addNode("/", "wrapper"), "compute_agents", ComputeAgents::kType);
  QVERIFY(client);
  QVERIFY(caller->spinUntil([&] { return (*client)->isReady(); }, kLong));
  std::vector<agentstest::Agent> people;
  for (int id = 1; id <= kPeople; ++id) {
    people.push_back(agentstest::agentAt(id, 2.0 * (id % 40), 2.0 * (id / 40)));
  }
  std::vector<double> times;  // [ms]
  for (int call = 0; call < kCalls; ++call) {
    const Bytes request = encode(agentstest::requestOf(people, 1.0 + 0.05 * call));
    const auto begin = std::chrono::steady_clock::now();
    const std::optional<Bytes> reply = (*client)->call(request, Milliseconds(2000));
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    const auto read = decode<ComputeAgents::Response>(reply.value_or(Bytes()));
    QVERIFY(read && read->updatedAgents.agents.size() == kPeople);
    people = read->updatedAgents.agents;
    times.push_back(taken.count());
  }
  end(server);
  std::sort(times.begin(), times.end());
  QTest::setBenchmarkResult(times[static_cast<std::size_t>(part * (kCalls - 1))],
                            QTest::WalltimeMilliseconds);
}

void Ros2Bench::publish() {
  constexpr int kStates = 200;  // 10 s
  app::Verdict verdict = app::check(agentstest::bundleOf(sceneOf(kCrowd)));
  QVERIFY(verdict.world);
  RunNodeSettings settings;
  settings.domain = inDomain(kDomain + 1);
  auto node = RunNode::create(verdict.world->header(), {}, settings,
                              [](const base::Diagnostic& /*said*/) {});
  QVERIFY(node);
  QProcess listener;
  startAs(listener, "hear", kDomain + 1);
  QTest::qWait(3000);
  const sim2d::Frame& frame = verdict.world->frame();
  const double begin = processorMs();
  for (int state = 0; state < kStates; ++state) {
    (*node)->publishState(frame);
    QTest::qSleep(50);
  }
  const double each = (processorMs() - begin) / kStates;
  end(listener);
  qInfo("%.1f %% of a core at 20 states a second", each * 20.0 / 10.0);
  QTest::setBenchmarkResult(each, QTest::WalltimeMilliseconds);
}

int main(int argc, char** argv) {
  if (argc == 3 && (QByteArray(argv[1]) == "serve" || QByteArray(argv[1]) == "hear")) {
    return argv[1][0] == 's' ? serve(std::atoi(argv[2])) : hear(std::atoi(argv[2]));
  }
  QCoreApplication application(argc, argv);
  Ros2Bench bench;
  return QTest::qExec(&bench, argc, argv);
}

#include "bench_Ros2.moc"
