#include <csignal>
#include <cstring>
#include <poll.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QProcess>
#include <QtTest>

#include "app/bridge/messages/Codec.h"
#include "app/bridge/nodes/AgentServer.h"
#include "tests/agents/Caller.h"
#include "tests/ros2/Ros2Test.h"
#include "tests/support/Sanitizers.h"

using namespace ros2test;
using hunav_msgs::ComputeAgents;

namespace {

constexpr int kPeople = 10;
constexpr int kCalls = 12;  // of one that comes
constexpr Milliseconds kPatience(10000);

ComputeAgents::Request requestAt(double seconds) {
  std::vector<agentstest::Agent> people;
  for (int id = 1; id <= kPeople; ++id) {
    people.push_back(agentstest::agentAt(id, 2.0 * id, 0.0));
  }
  return agentstest::requestOf(std::move(people), seconds);
}

/// Until its input ends.
int serve(int domain, Rmw rmw) {
  sim2d::Scenario scenario;
  const int goal = agentstest::addGoal(scenario, 5.0, 9.0);
  for (int id = 1; id <= kPeople; ++id) {
    agentstest::addPerson(scenario, id, 2.0 * id, 0.0, {goal});
  }
  ServeSettings settings;
  settings.domain = inDomain(domain, rmw);
  auto server = AgentServer::create(agentstest::bundleOf(std::move(scenario)), settings,
                                    [](const base::Diagnostic& said) {
                                      if (said.severity == base::Severity::Error) {
                                        std::fprintf(stderr, "%s\n", said.message.c_str());
                                      }
                                    });
  if (!server) {
    return 1;
  }
  std::puts("ready");
  std::fflush(stdout);
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  while (::poll(&input, 1, 0) == 0) {
    (*server)->spin(Milliseconds(50));
  }
  return 0;
}

/// A caller in a participant of its own.
struct Caller {
  Caller(int domain, Rmw rmw) : participant(ros2test::participant(inDomain(domain, rmw))) {
    auto made = participant->client(participant->addNode("/", "wrapper"), "compute_agents",
                                    ComputeAgents::kType);
    client = made ? *std::move(made) : nullptr;
  }
  bool isReady() const {
    return participant->spinUntil([this] { return client->isReady(); }, kLong);
  }
  bool isAnswered() {
    seconds += 0.05;
    const std::optional<Bytes> reply = client->call(encode(requestAt(seconds)), kPatience);
    const auto read = decode<ComputeAgents::Response>(reply.value_or(Bytes()));
    return read && read->updatedAgents.agents.size() == kPeople;
  }
  std::unique_ptr<Participant> participant;
  std::unique_ptr<Client> client;
  double seconds = 1.0;
};

/// Returns how many of its calls were in vain; kMoreThanAll: it never met the server.
constexpr int kMoreThanAll = 100;
int come(int domain, Rmw rmw, bool vanishes) {
  Caller caller(domain, rmw);
  if (!caller.isReady()) {
    return kMoreThanAll;
  }
  int lost = 0;
  for (int i = 1; i <= kCalls; ++i) {
    if (!caller.isAnswered()) {
      std::printf("call %d had no answer\n", i);
      ++lost;
    }
  }
  if (vanishes && lost == 0) {
    caller.client->send(encode(requestAt(100.0)));
    ::raise(SIGKILL);
  }
  return lost;
}

const char* wordOf(Rmw rmw) {
  return rmw == Rmw::CycloneDds ? "cyclonedds" : "fastrtps";
}

/// This program in another role.
void startAs(QProcess& process, const char* role, int domain, Rmw rmw) {
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(
      QCoreApplication::applicationFilePath(),
      {QString::fromLatin1(role), QString::number(domain), QString::fromLatin1(wordOf(rmw))});
}

/// [kB] of memory that the process has.
long memoryOf(const QProcess& process) {
  QFile file(QStringLiteral("/proc/%1/status").arg(process.processId()));
  if (file.open(QIODevice::ReadOnly)) {
    for (const QByteArray& line : file.readAll().split('\n')) {
      if (line.startsWith("VmRSS:")) {
        return line.mid(6).simplified().split(' ')[0].toLong();
      }
    }
  }
  return -1;
}

/// One after the other they come; every third is killed.
class Visitors {
 public:
  Visitors(int domain, Rmw rmw) : domain_(domain), rmw_(rmw) {}
  /// Looks after who is there; lets the next come.
  void lookAfter() {
    if (process_ != nullptr && !process_->waitForFinished(0) &&
        process_->state() != QProcess::NotRunning) {
      return;
    }
    count();
    process_ = std::make_unique<QProcess>();
    vanishes_ = ++number_ % 3 == 0;
    startAs(*process_, vanishes_ ? "vanish" : "come", domain_, rmw_);
  }
  void waitForTheLast() {
    if (process_ != nullptr) {
      process_->waitForFinished(150000);
      count();
      process_.reset();
    }
  }
  int gone = 0;
  QStringList troubles;

 private:
  void count() {
    if (process_ == nullptr) {
      return;
    }
    const bool isOver = process_->state() == QProcess::NotRunning;
    const bool isKilled = process_->exitStatus() == QProcess::CrashExit;
    const bool isWell = isOver && (vanishes_ ? isKilled : !isKilled && process_->exitCode() == 0);
    if (!isWell) {
      troubles << QStringLiteral("visitor %1 ended with %2: %3")
                      .arg(number_)
                      .arg(process_->exitCode())
                      .arg(QString::fromLocal8Bit(process_->readAll()));
    }
    ++gone;
  }

  int domain_;
  Rmw rmw_;
  std::unique_ptr<QProcess> process_;
  bool vanishes_ = false;
  int number_ = 0;
};

}  // namespace

/// A server whose clients come and go, orderly or killed within a call, while one stays: each
/// program for itself, as in a system of ROS 2. No call of anybody is lost and memory stays.
///
/// HUNAV_SOAK: seconds for each row instead of some.
class ComeAndGoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void clients_comeAndGo_noAnswerIsLost_data() {
    QTest::addColumn<Rmw>("rmw");
    QTest::addColumn<int>("domain");
    QTest::newRow("fastrtps") << Rmw::FastRtps << 31;
    QTest::newRow("cyclonedds") << Rmw::CycloneDds << 32;
  }

  void clients_comeAndGo_noAnswerIsLost() {
    QFETCH(const Rmw, rmw);
    QFETCH(const int, domain);
    bool isLong = false;
    const int given = qEnvironmentVariableIntValue("HUNAV_SOAK", &isLong);
    const int seconds = isLong ? given : 6;

    QProcess server;
    startAs(server, "serve", domain, rmw);
    QVERIFY(server.waitForReadyRead(30000));
    QCOMPARE(server.readAll(), QByteArray("ready\n"));
    Caller stays(domain, rmw);
    QVERIFY(stays.isReady());
    Visitors visitors(domain, rmw);
    int answered = 0;
    int lost = 0;
    long before = -1;  // [kB], after a third of the time and two visitors
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 1000LL * seconds || visitors.gone < 4) {
      (stays.isAnswered() ? answered : lost) += 1;
      visitors.lookAfter();
      if (before < 0 && visitors.gone >= 2 && clock.elapsed() > 1000LL * seconds / 3) {
        before = memoryOf(server);
      }
      QVERIFY(lost < 3);
      QTest::qSleep(2);
    }
    visitors.waitForTheLast();
    const long after = memoryOf(server);
    server.closeWriteChannel();
    QVERIFY(server.waitForFinished(30000));
    QCOMPARE(server.exitCode(), 0);
    QCOMPARE(server.readAll(), QByteArray());
    qInfo("%d calls of who stays are answered, %d came and went, %ld kB, at last %ld kB", answered,
          visitors.gone, before, after);
    QCOMPARE(lost, 0);
    QVERIFY2(visitors.troubles.isEmpty(), qPrintable(visitors.troubles.join(QLatin1Char('\n'))));
    QVERIFY(visitors.gone > 0 && answered > kCalls);
    QVERIFY(before > 0);
    QVERIFY(kIsSanitized || after - before < 4000);  // there what is freed is kept for a while
  }
};

int main(int argc, char** argv) {
  if (argc == 4) {
    const int domain = std::atoi(argv[2]);
    const Rmw rmw = std::strcmp(argv[3], "cyclonedds") == 0 ? Rmw::CycloneDds : Rmw::FastRtps;
    return std::strcmp(argv[1], "serve") == 0
               ? serve(domain, rmw)
               : come(domain, rmw, std::strcmp(argv[1], "vanish") == 0);
  }
  QCoreApplication application(argc, argv);
  ComeAndGoTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "tst_ComeAndGo.moc"
