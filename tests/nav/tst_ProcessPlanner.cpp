#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <limits>
#include <memory>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <QtTest>

#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/external/ExternalPlanner.h"
#include "sim2d/nav/external/ExternalProcess.h"
#include "tests/nav/ExternalScene.h"
#include "tests/nav/PlannerFunctions.h"

using namespace external;
using Clock = std::chrono::steady_clock;

namespace {

const char* const kReady = "read -r line; echo '{\"ready\":true}'\n";
const char* const kAnswerAll =
    "while read -r line; do echo '{\"linear\":0.5,\"angular\":0}'; done\n";

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Fields of /proc/<id>/stat from the state on; empty: no such process, or only its exit code.
QList<QByteArray> statOf(const QByteArray& id) {
  const QByteArray stat = contentOf(QStringLiteral("/proc/%1/stat").arg(QString::fromLatin1(id)));
  const QList<QByteArray> fields = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
  return fields.size() < 2 ? QList<QByteArray>() : fields;
}

bool isAlive(const QByteArray& id) {
  const QList<QByteArray> fields = statOf(id);
  return !fields.isEmpty() && fields[0] != "Z" && fields[0] != "X";
}

/// Children of this process, those that are dead but not reaped as well.
QStringList childProcesses() {
  QStringList all;
  const QByteArray self = QByteArray::number(::getpid());
  for (const QString& id :
       QDir(QStringLiteral("/proc")).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QList<QByteArray> fields = statOf(id.toLatin1());
    if (!fields.isEmpty() && fields[1] == self) {
      all.append(id);
    }
  }
  return all;
}

int entriesIn(const char* folder) {
  return QDir(QString::fromLatin1(folder)).entryList(QDir::AllEntries | QDir::System).size();
}

/// Somebody at a socket: takes one peer and answers each line by `answer`; empty: hangs up.
class SocketPeer {
 public:
  SocketPeer(const QString& path, std::function<std::string(const std::string&)> answer)
      : answer_(std::move(answer)), listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    path.toStdString().copy(address.sun_path, sizeof address.sun_path - 1);
    if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
        ::listen(listener_, 1) != 0) {
      qFatal("cannot listen");
    }
    thread_ = std::thread([this] { serve(); });
  }
  ~SocketPeer() {
    isOver_ = true;
    thread_.join();
    ::close(listener_);
  }
  SocketPeer(const SocketPeer&) = delete;
  SocketPeer& operator=(const SocketPeer&) = delete;
  SocketPeer(SocketPeer&&) = delete;
  SocketPeer& operator=(SocketPeer&&) = delete;

  std::string lastLine() const { return last_; }  // when nobody is connected any more
  bool isConnected() const { return isConnected_; }

 private:
  bool waitFor(int descriptor) const {
    pollfd waiting{descriptor, POLLIN, 0};
    while (!isOver_ && ::poll(&waiting, 1, 20) <= 0) {
    }
    return !isOver_;
  }
  void serve() {
    if (!waitFor(listener_)) {
      return;
    }
    const int peer = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    std::string line;
    char c = 0;
    while (waitFor(peer) && ::read(peer, &c, 1) == 1) {
      line += c;
      if (c != '\n') {
        continue;
      }
      last_ = line;
      const std::string answer = answer_(line);
      line.clear();
      if (answer.empty()) {
        break;
      }
      if (::send(peer, answer.data(), answer.size(), MSG_NOSIGNAL) < 0) {
        break;
      }
    }
    ::close(peer);
    isConnected_ = false;
  }

  std::function<std::string(const std::string&)> answer_;
  int listener_;
  std::atomic<bool> isOver_{false}, isConnected_{true};
  std::string last_;
  std::thread thread_;
};

std::string usualAnswer(const std::string& line) {
  return line.rfind("{\"hunavsim\"", 0) == 0 ? "{\"ready\":true,\"name\":\"peer\"}\n"
                                             : "{\"linear\":0.25,\"angular\":-0.5}\n";
}

}  // namespace

class ProcessPlannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// After every test.
  void cleanup() {
    QVERIFY2(childProcesses().isEmpty(), childProcesses().join(QLatin1Char(' ')).toLatin1());
  }

  void words_quotes_areCutAsAShellDoes_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QStringList>("words");
    const auto row = [](const char* command, const QStringList& words) {
      QTest::newRow(command) << QString::fromLatin1(command) << words;
    };
    const auto word = [](const char* text) { return QString::fromLatin1(text); };
    row("python3 follow.py", {word("python3"), word("follow.py")});
    row("  a\t b\n", {word("a"), word("b")});
    row("'a b'c\"d e\"", {word("a bcd e")});
    row("a '' \"\"", {word("a"), QString::fromLatin1(""), QString::fromLatin1("")});
    row("a\\ b \\'", {word("a b"), word("'")});
    row("'a\\b' \"a\\b\" \"\\\"\\\\\\$\"", {word("a\\b"), word("a\\b"), word("\"\\$")});
    row("a; b | c > $HOME *",
        {word("a;"), word("b"), word("|"), word("c"), word(">"), word("$HOME"), word("*")});
  }

  void words_quotes_areCutAsAShellDoes() {
    QFETCH(QString, command);
    QFETCH(QStringList, words);
    const auto cut = splitCommandLine(command.toStdString());
    QVERIFY(cut);
    QStringList found;
    for (const std::string& each : *cut) {
      found.append(QString::fromStdString(each));
    }
    QCOMPARE(found, words);
  }

  void words_openQuotes_areErrors() {
    for (const char* command : {"a 'b", "a \"b", "a \"b\\\"", "a \\"}) {
      QCOMPARE(codeOf(splitCommandLine(command).diagnostics()), std::string("external.open-quote"));
    }
    for (const char* command : {"", "  ", "''"}) {
      QCOMPARE(codeOf(splitCommandLine(command).diagnostics()), std::string("external.no-command"));
    }
  }

  void make_withoutPermission_startsNothing() {
    const std::string command = script("touch '" + path("was-here").toUtf8() + "'\n");
    const auto made = makeExternalPlanner(refusedSetup(), {command});
    QCOMPARE(codeOf(made.diagnostics()), std::string("external.not-allowed"));
    QVERIFY(messageOf(made.diagnostics()).contains("--allow-code"));
    const auto socket = makeExternalPlanner(refusedSetup(), {"unix:/nowhere"});
    QCOMPARE(codeOf(socket.diagnostics()), std::string("external.not-allowed"));
    QTest::qWait(200);
    QVERIFY(!QFile::exists(path("was-here")));
  }

  void make_badCommand_tellsWhy_data() {
    QTest::addColumn<QByteArray>("command");
    QTest::addColumn<QByteArray>("code");
    QTest::addColumn<QByteArray>("part");
    const auto row = [](const char* name, const char* command, const char* code, const char* part) {
      QTest::newRow(name) << QByteArray(command) << QByteArray(code) << QByteArray(part);
    };
    row("none", " ", "external.no-command", "needs a 'command'");
    row("not in PATH", "no-such-program-here", "external.not-started", "No such file");
    row("no such file", "/no/such/program", "external.not-started", "No such file");
    row("a folder", "/tmp", "external.not-started", "Is a directory");
    row("no program", "/etc/passwd", "external.not-started", "Permission denied");
    row("open quote", "sh -c 'x", "external.open-quote", "quote");
    row("no socket", "unix:/no/such/socket", "external.not-connected", "No such file");
    row("socket without a path", "unix:", "external.not-connected", "No such file");
  }

  void make_badCommand_tellsWhy() {
    QFETCH(QByteArray, command);
    QFETCH(QByteArray, code);
    QFETCH(QByteArray, part);
    const auto made = makeExternalPlanner(setupOf(), {command.toStdString()});
    QCOMPARE(codeOf(made.diagnostics()), code.toStdString());
    QVERIFY2(messageOf(made.diagnostics()).contains(part), messageOf(made.diagnostics()));
    QVERIFY(messageOf(made.diagnostics()).startsWith("robot 'amy': "));
  }

  void make_fromRegistry_takesItsTexts() {
    PlannerRegistry registry;
    addExternal(registry);
    const auto* entry = registry.find("external");
    QVERIFY(entry != nullptr);
    QCOMPARE(entry->parameters.size(), std::size_t{1});
    PlannerSetup setup = setupOf();
    setup.command = script(QByteArray(kReady) + "sleep 60\n");
    setup.parameters = {{"timeout", 0.3}};
    {
      const auto made = entry->make(setup);
      QVERIFY(made);
      const auto problems = drive(**made, 1).problems;
      QCOMPARE(codeOf(problems), std::string("external.too-slow"));
      QVERIFY2(messageOf(problems).contains("0.3 s"), messageOf(problems));
    }
    setup.code = ExternalCodePolicy::Refused;
    QCOMPARE(codeOf(entry->make(setup).diagnostics()), std::string("external.not-allowed"));
  }

  /// Nothing is started; what can be told of the command is.
  void make_codeLeftOut_standsAndTells() {
    PlannerRegistry registry;
    addExternal(registry);
    const auto* entry = registry.find("external");
    PlannerSetup setup = setupOf();
    setup.code = ExternalCodePolicy::Skipped;
    setup.command = script("touch '" + path("was-here").toUtf8() + "'\n");
    const auto made = entry->make(setup);
    QVERIFY(made);
    const Drive driven = drive(**made, 2);
    QVERIFY(driven.problems.empty());
    QCOMPARE(driven.commands, (std::vector<double>(6, 0.0)));
    QVERIFY(!QFile::exists(path("was-here")));
    const std::pair<const char*, const char*> wrong[] = {
        {"no-such-program-here", "external.not-started"}, {"sh -c 'x", "external.open-quote"}};
    for (const auto& [command, code] : wrong) {
      setup.command = command;
      QCOMPARE(codeOf(entry->make(setup).diagnostics()), std::string(code));
    }
  }

  void make_badTimeout_isRefused() {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double seconds : {0.0, -1.0, infinity, std::nan(""), 3601.0}) {
      const auto made = makeExternalPlanner(setupOf(), {"true", seconds});
      QCOMPARE(codeOf(made.diagnostics()), std::string("external.bad-timeout"));
    }
  }

  void command_linesSent_areThoseOfTheProtocol() {
    const QByteArray keep =
        "keep() { printf '%s\\n' \"$line\" >> '" + path("lines").toUtf8() + "'; }\n";
    const auto made = planner(keep +
                              "read -r line; keep; echo '{\"ready\":true}'\n"
                              "while read -r line; do keep; "
                              "echo '{\"linear\":0.5,\"angular\":-1e-1,\"lateral\":2,\"more\":[],"
                              "\"path\":[[0,0],[1,2.5]]}'; done\n");
    QVERIFY(made);
    Scene scene;
    LaserScan scan;
    scan.distances = {1.0, 2.0};
    const auto step = [&](double time) {
      scene.observation.time = time;
      return made->command(scene.observation);
    };
    const auto first = step(0.0);
    QVERIFY2(first, messageOf(first.diagnostics()));
    QVERIFY((*first == BodyTwist{0.5, -0.1, 2.0}));
    QVERIFY((made->path() == std::vector<Vec2>{{0.0, 0.0}, {1.0, 2.5}}));
    scene.setDoor(false);
    scene.observation.scan = &scan;
    QVERIFY(step(0.05));
    QVERIFY(step(0.10));  // the same scan, the same door
    scan.time = 0.1;
    QVERIFY(step(0.15));
    QFile file(path("lines"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QList<QJsonObject> lines;
    while (!file.atEnd()) {
      lines.append(QJsonDocument::fromJson(file.readLine()).object());
    }
    QCOMPARE(lines.size(), 5);
    QCOMPARE(lines[0][QLatin1String("hunavsim")].toInt(), 1);
    QCOMPARE(lines[0][QLatin1String("walls")].toArray().size(), 2);
    const QJsonObject robot = lines[0][QLatin1String("robot")].toObject();
    QCOMPARE(robot[QLatin1String("name")].toString(), QStringLiteral("amy"));
    const bool walls[] = {false, true, false, false};
    const bool scans[] = {false, true, false, true};
    for (int i = 0; i < 4; ++i) {
      const QJsonObject& line = lines[i + 1];
      QCOMPARE(line[QLatin1String("time")].toDouble(), 0.05 * i);
      QCOMPARE(line.contains(QLatin1String("walls")), walls[i]);
      QCOMPARE(line.contains(QLatin1String("scan")), scans[i]);
    }
    QCOMPARE(lines[2][QLatin1String("walls")].toArray().size(), 1);
  }

  void command_carriageReturns_areTaken() {
    const auto made = planner(
        "read -r line; printf '{\"ready\":true}\\r\\n'\n"
        "while read -r line; do printf '{\"linear\":0.5,\"angular\":0}\\r\\n'; done\n");
    const Drive result = drive(*made, 3);
    QVERIFY2(result.problems.empty(), messageOf(result.problems));
    QCOMPARE(result.commands.size(), std::size_t{9});
  }

  void command_misbehaviour_endsClearly_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("code");
    QTest::addColumn<QByteArray>("part");  // of the message
    QTest::addColumn<int>("steps");        // that go well
    const auto row = [](const char* name, const QByteArray& text, const char* code,
                        const char* part, int steps = 0) {
      QTest::newRow(name) << text << QByteArray(code) << QByteArray(part) << steps;
    };
    const QByteArray ready = kReady;
    const QByteArray one = ready + "read -r line; echo '{\"linear\":0.5,\"angular\":0}'\n";
    row("dies before ready", "echo oops >&2; echo why >&2; exit 3\n", "external.died",
        "with exit code 3 without an answer; its error output: oops / why");
    row("dies of a signal", "read -r line; kill -9 $$\n", "external.died", "by signal 9 (Killed)");
    row("dies later", one + "read -r line; exit 4\n", "external.died", "exit code 4", 1);
    row("dies, its output stays open", ready + "read -r line; sleep 60 & exit 5\n", "external.died",
        "exit code 5");
    row("closes its output", ready + "exec >&-; sleep 60\n", "external.closed", "its output");
    row("closes its input", "read -r line; exec <&-; echo '{\"ready\":true}'; sleep 60\n",
        "external.closed", "its input");
    row("hangs", "echo slow >&2\n" + ready + "sleep 60\n", "external.too-slow",
        "within 1 s; its error output: slow");
    row("half a line", ready + "read -r line; printf '{\"linear\":'; sleep 60\n",
        "external.too-slow", "within 1 s");
    row("floods a line", ready + "read -r line; exec cat /dev/zero\n", "external.line-too-long",
        "1048576");
    row("floods lines", ready + "read -r line; exec yes\n", "external.unasked",
        "more than one line");
    row("floods errors", "yes >&2 &\n" + ready + "sleep 60\n", "external.too-slow",
        "its error output: ");
    row("says ready twice",
        "read -r line; printf '{\"ready\":true}\\n{\"ready\":true}\\n'; sleep 60\n",
        "external.unasked", "more than one line");
    row("is not ready", "read -r line; echo '{\"linear\":0}'; sleep 60\n", "external.not-ready",
        "\"ready\": true");
    row("nonsense", ready + "read -r line; echo hello; sleep 60\n", "external.not-json", "'hello'");
    row("empty line", ready + "read -r line; echo; sleep 60\n", "external.not-json", "''");
    row("no number", one + "read -r line; echo '{\"linear\":\"1\",\"angular\":0}'; sleep 60\n",
        "external.no-number", "\"linear\"", 1);
    row("NaN", ready + "read -r line; echo '{\"linear\":NaN,\"angular\":0}'; sleep 60\n",
        "external.not-json", "NaN");
    row("complains", ready + "read -r line; echo '{\"error\":\"lost\"}'; sleep 60\n",
        "external.complaint", "lost");
  }

  void command_misbehaviour_endsClearly() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, code);
    QFETCH(QByteArray, part);
    QFETCH(int, steps);
    const bool isSlow = code == "external.too-slow";
    const auto made = planner(text, isSlow ? 1.0 : 20.0);
    QVERIFY(made);
    const Drive result = drive(*made, 5);
    QCOMPARE(codeOf(result.problems), code.toStdString());
    QVERIFY2(messageOf(result.problems).contains(part), messageOf(result.problems));
    QVERIFY(messageOf(result.problems).startsWith("robot 'amy': "));
    QCOMPARE(static_cast<int>(result.commands.size()), 3 * steps);
    QVERIFY(childProcesses().isEmpty());  // although the planner is still there
    const base::Diagnostics again = drive(*made, 1).problems;
    QCOMPARE(messageOf(again), messageOf(result.problems));
  }

  /// What is sent is larger than a pipe, and nobody takes it.
  void command_notReading_endsInTime() {
    const auto made = planner("sleep 60\n", 0.5);
    Scene scene;
    scene.observation.bodies.resize(5000, scene.observation.bodies[0]);
    Obstacles obstacles;
    obstacles.add({circleOutline(Vec2(0.0, 9.0), 3.0, 20000)});
    obstacles.build();
    scene.observation.obstacles = &obstacles;
    const auto start = Clock::now();
    const auto answer = made->command(scene.observation);
    QCOMPARE(codeOf(answer.diagnostics()), std::string("external.not-reading"));
    QVERIFY(secondsSince(start) < 20.0);
  }

  void command_lineBeforeTheGreeting_isUnasked() {
    const auto made = planner("echo 'Hello from a library'; touch '" + path("greeted").toUtf8() +
                              "'\n" + kReady + kAnswerAll);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("greeted")), 20000);
    const base::Diagnostics problems = drive(*made, 3).problems;
    QCOMPARE(codeOf(problems), std::string("external.unasked"));
    QVERIFY2(messageOf(problems).contains("'Hello from a library?'"), messageOf(problems));
  }

  void command_extraLineLater_isUnasked() {
    const auto made = planner(QByteArray(kReady) +
                              "read -r line; echo '{\"linear\":0.5,\"angular\":0}'; sleep 0.1\n"
                              "echo '{\"linear\":0.5,\"angular\":0}'; touch '" +
                              path("said").toUtf8() + "'; sleep 60\n");
    Scene scene;
    QVERIFY(made->command(scene.observation));
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("said")), 20000);
    const auto answer = made->command(scene.observation);
    QCOMPARE(codeOf(answer.diagnostics()), std::string("external.unasked"));
    QVERIFY(messageOf(answer.diagnostics())
                .endsWith("as an answer: '{\"linear\":0.5,\"angular\":0}?'"));
  }

  void command_grandchild_diesToo() {
    const QString note = path("grandchild");
    auto made = planner("sleep 300 &\necho $! > '" + note.toUtf8() + "'\n" + kReady + kAnswerAll);
    QVERIFY(drive(*made, 2).problems.empty());
    const QByteArray id = contentOf(note).trimmed();
    QVERIFY(!id.isEmpty() && isAlive(id));
    made.reset();
    QTRY_VERIFY(!isAlive(id));
  }

  void command_ignoringTheEnd_isKilled() {
    auto made = planner("trap '' TERM\n" + QByteArray(kReady) + kAnswerAll +
                        "while true; do sleep 0.2; done\n");
    QVERIFY(drive(*made, 2).problems.empty());
    QCOMPARE(childProcesses().size(), 1);
    const auto start = Clock::now();
    made.reset();
    QVERIFY(childProcesses().isEmpty());
    const double seconds = secondsSince(start);
    QVERIFY(seconds > 1.4 && seconds < 15.0);  // 1 s to go by itself, 0.5 s after SIGTERM
  }

  void end_ofThePlanner_isTold() {
    auto made = planner(QByteArray(kReady) +
                        "read -r line; echo '{\"linear\":0.5,\"angular\":0}'\nread -r line\n"
                        "read -r more || printf '%s' \"$line\" > '" +
                        path("end").toUtf8() + "'\n");
    QVERIFY(drive(*made, 1).problems.empty());
    made.reset();
    QCOMPARE(contentOf(path("end")), QByteArray("{\"end\":true,\"reason\":\"over\"}"));
  }

  void start_child_inheritsNothing() {
    const int open = ::open("/dev/null", O_RDONLY);  // without O_CLOEXEC
    const int high = ::fcntl(open, F_DUPFD, 300);
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    sigset_t blocked;
    sigset_t old;
    ::sigemptyset(&blocked);
    ::sigaddset(&blocked, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &blocked, &old);
    const auto made = process(
        "sh -c 'read -r line; echo $(ls /proc/self/fd; grep -E \"Sig(Blk|Ign)\" "
        "/proc/self/status); "
        "read -r line; exit 0'");
    ::pthread_sigmask(SIG_SETMASK, &old, nullptr);
    std::signal(SIGPIPE, before);
    const auto answer = made->ask("go", 20.0);
    QVERIFY2(answer, messageOf(answer.diagnostics()));
    QCOMPARE(QString::fromStdString(*answer),  // 3: of ls, for the folder
             QStringLiteral("0 1 2 3 SigBlk: 0000000000000000 SigIgn: 0000000000000000"));
    ::close(open);
    ::close(high);
  }

  /// The kernel's signal at the parent's death goes by the thread that started the child.
  void start_inAThreadThatEnds_lives() {
    std::unique_ptr<ExternalProcess> made;
    std::thread([&made] {
      made = process("sh -c 'read -r line; echo $line; read -r line'");
    }).join();
    QTest::qWait(200);
    const auto answer = made->ask("alive", 20.0);
    QVERIFY2(answer, messageOf(answer.diagnostics()));
    QCOMPARE(*answer, std::string("alive"));
  }

  void start_often_leaksNothing() {
    process("true");
    const int files = entriesIn("/proc/self/fd");
    const int threads = entriesIn("/proc/self/task");
    for (int i = 0; i < 200; ++i) {
      if (i % 4 == 0) {
        QVERIFY(process("/no/such/program") == nullptr);
      } else {
        const auto made = process("true");
        QVERIFY(made != nullptr);
        if (i % 4 == 1) {
          QCOMPARE(codeOf(made->ask("x", 20.0).diagnostics()), std::string("external.died"));
        }
      }
    }
    QCOMPARE(entriesIn("/proc/self/fd"), files);
    QCOMPARE(entriesIn("/proc/self/task"), threads);
    QVERIFY(childProcesses().isEmpty());
  }

  void ask_stopFlag_endsTheWait() {
    double best = 1e9;  // of a few: the machine may be busy
    for (int i = 0; i < 20 && best > 0.1; ++i) {
      const auto flag = std::make_shared<base::StopFlag>();
      auto made = ExternalProcess::start("sleep 60", flag);
      QVERIFY(made);
      Clock::time_point stopped;
      std::thread stopper([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stopped = Clock::now();
        flag->stop();
      });
      bool isThrown = false;
      try {
        static_cast<void>((*made)->ask("x", 20.0));
      } catch (const base::Stopped&) {
        isThrown = true;
      }
      const auto now = Clock::now();
      stopper.join();
      QVERIFY(isThrown);
      QVERIFY(childProcesses().isEmpty());
      best = std::min(best, std::chrono::duration<double>(now - stopped).count());
    }
    QVERIFY2(best < 0.1, QByteArray::number(best));
  }

  void kill_ofTheSimulator_endsTheChild() {
#ifdef __SANITIZE_THREAD__
    QSKIP("its threads do not survive a fork");
#endif
    int ends[2];
    QVERIFY(::pipe2(ends, O_CLOEXEC) == 0);
    const pid_t simulator = ::fork();
    if (simulator == 0) {
      const auto made = process("sleep 300");
      const pid_t id = made ? made->childId() : -1;
      if (::write(ends[1], &id, sizeof id) != static_cast<ssize_t>(sizeof id)) {
        ::_exit(1);
      }
      while (true) {
        ::pause();
      }
    }
    pid_t id = -1;
    const ssize_t count = ::read(ends[0], &id, sizeof id);
    const QByteArray name = QByteArray::number(id);
    const bool wasAlive = isAlive(name);
    ::kill(simulator, SIGKILL);
    ::waitpid(simulator, nullptr, 0);
    ::close(ends[0]);
    ::close(ends[1]);
    QCOMPARE(count, static_cast<ssize_t>(sizeof id));
    QVERIFY(id > 0 && wasAlive);
    QTRY_VERIFY(!isAlive(name));
  }

  void socket_peer_drives() {
    SocketPeer peer(path("socket"), usualAnswer);
    auto made = makeExternalPlanner(setupOf(), {"unix:" + path("socket").toStdString()});
    QVERIFY2(made, messageOf(made.diagnostics()));
    const Drive result = drive(**made, 4);
    QVERIFY2(result.problems.empty(), messageOf(result.problems));
    QCOMPARE(result.commands.size(), std::size_t{12});
    QCOMPARE(result.commands[9], 0.25);
    QCOMPARE(result.commands[10], -0.5);
    *made = nullptr;
    QTRY_VERIFY(!peer.isConnected());
    QCOMPARE(peer.lastLine(), std::string("{\"end\":true,\"reason\":\"over\"}\n"));
  }

  void socket_trouble_endsClearly() {
    const auto problems = [this](const char* name,
                                 const std::function<std::string(const std::string&)>& answer) {
      SocketPeer peer(path(name), answer);
      const auto made = makeExternalPlanner(
          setupOf(),
          {"unix:" + path(name).toStdString(), name == std::string("c") ? 1.0 : 20.0, 20.0});
      return made ? drive(**made, 3).problems : made.diagnostics();
    };
    const auto later = [](const std::string& then) {
      return [then](const std::string& line) {
        return line.rfind("{\"hunavsim\"", 0) == 0 ? usualAnswer(line) : then;
      };
    };
    const auto closed = problems("a", [](const std::string&) { return std::string(); });
    QCOMPARE(codeOf(closed), std::string("external.closed"));
    QVERIFY2(messageOf(closed).contains("its connection"), messageOf(closed));
    QCOMPARE(codeOf(problems("b", later(""))), std::string("external.closed"));
    QCOMPARE(codeOf(problems("c", later("{\"linear\":1"))), std::string("external.too-slow"));
    QCOMPARE(codeOf(problems("d", later("x\ny\n"))), std::string("external.unasked"));
    QCOMPARE(codeOf(problems("e", later(std::string(1200000, 'x')))),
             std::string("external.line-too-long"));
    const auto tooLong = makeExternalPlanner(setupOf(), {"unix:/" + std::string(200, 'x')});
    QCOMPARE(codeOf(tooLong.diagnostics()), std::string("external.not-connected"));
  }

  void examples_drivingTwice_giveEqualBytes_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("argument");
    QTest::newRow("Python") << QStandardPaths::findExecutable(QStringLiteral("python3"))
                            << QStringLiteral(SOURCE_DIR "/resources/planners/follow.py");
    const QString built = QStringLiteral(EXAMPLE_PLANNERS "/follow");
    QTest::newRow("C++") << (QFile::exists(built) ? built : QString()) << QString();
  }

  void examples_drivingTwice_giveEqualBytes() {
    QFETCH(QString, program);
    QFETCH(QString, argument);
    if (program.isEmpty()) {
      QSKIP("python3, or the compiled example, is not there");
    }
    const std::string command = "'" + program.toStdString() + "' '" + argument.toStdString() + "'";
    checkDrivesTwice([&] { return makeExternalPlanner(setupOf(), {command, 20.0, 60.0}); });
  }

 private:
  std::string script(const QByteArray& text) {
    const QString name = path("script.sh");
    QFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      qFatal("cannot write");
    }
    return "/bin/sh '" + name.toStdString() + "'";
  }
  QString path(const char* name) const {
    return folder_.filePath(QString::fromLatin1(name));
  }
  std::shared_ptr<Planner> planner(const QByteArray& text, double timeout = 20.0) {
    const auto made = makeExternalPlanner(setupOf(), {script(text), timeout, timeout});
    return made ? *made : nullptr;
  }
  static std::unique_ptr<ExternalProcess> process(const std::string& command) {
    auto made = ExternalProcess::start(command, std::make_shared<const base::StopFlag>());
    return made ? *std::move(made) : nullptr;
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ProcessPlannerTest)
#include "tst_ProcessPlanner.moc"
