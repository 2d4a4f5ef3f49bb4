#include <cstdlib>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QCryptographicHash>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>

#include "tests/app/ForkedProgram.h"
#include "tests/app/Nav2Yard.h"
#include "tests/support/Mutator.h"
#include "tests/support/Sanitizers.h"

using namespace outside;

// Findings of the sanitizers are told apart from what the program says. The names are theirs.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {
  return "exitcode=99:hard_rss_limit_mb=6000";
}
extern "C" const char* __ubsan_default_options() {
  return "print_stacktrace=1";
}
// NOLINTEND(bugprone-reserved-identifier)

/// Files with damage in them, handed to every command that reads such files. Whatever they hold:
/// nothing crashes, hangs or takes all memory, each refusal says what is wrong in words that a
/// terminal can show, and what was read stays as it was.
///
/// With HUNAV_ALL_TESTS they take 20 minutes of a processor, shared by up to four. Others than the
/// usual are made by HUNAV_MUTATIONS="FIRST COUNT".
class MutationsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void damaged_isReadOrRefused();
};

namespace {

/// Files that belong together, one of which gets damaged, and what reads them.
struct Kind {
  const char* file;                 // that is damaged
  std::vector<QStringList> usual;   // commands
  std::vector<QStringList> seldom;  // costly ones
};

QStringList words(const char* line) {
  return text(line).split(QLatin1Char(' '));
}

const std::vector<Kind>& kinds() {  // NOLINT(readability-function-size): a table
  static const QStringList kRun = words("run s/two_workers_agents.yaml -q -o o --duration 0.3");
  static const QStringList kCheck = words("check s/two_workers_agents.yaml");
  static const QStringList kWindow =
      words("s/two_workers_agents.yaml --screenshot p.png --size 640x400");
  static const QStringList kEvaluate = words("evaluate r -q -o o");
  static const QStringList kPlay = words("render r -o p.html");
  static const QStringList kReplay = words("r --screenshot p.png --size 640x400 --at 0.5");
  static const QStringList kFutures = words("futures r@0.3 -q --seeds 2 --horizon 0.3 --json");
  static const std::vector<QStringList> kAgain = {
      words("run --from r@0.3 -q --duration 0.6 -o o"),
      words("run --from r@0.3 -q --seed 7 --duration 0.5")};
  static const std::vector<QStringList> kDrawn = {
      words("render r -q -o p.svg --strip 2"), words("render r -q -o p.svg --strip 0.1,0.4"),
      words("render r -q -o p.svg --plot avg_robot_linear_speed"),
      words("render r -q -o p.svg --overlay contacts,density --time-marks 0.2")};
  static const QStringList kHumble = words(
      "run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_humble.yaml --nav2-distro "
      "humble");
  static const QStringList kJazzy =
      words("run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_jazzy.yaml");
  static const QStringList kMain = words(
      "run n/yard.yaml -q -o o --duration 0.6 --nav2-params n/params_main.yaml --nav2-distro "
      "main");
  static const std::vector<Kind> kKinds = {
      {"s/two_workers_agents.yaml",
       {kRun, kCheck, words("trees s/two_workers_agents.yaml -o o"),
        words("convert s/two_workers_agents.yaml --target isaac -o o"),
        words("check --json s/two_workers_agents.yaml")},
       {kWindow}},
      {"s/corner_cafe_agents.yaml",
       {words("run s/corner_cafe_agents.yaml -q -o o --duration 0.2"),
        words("check s/corner_cafe_agents.yaml"),
        words("convert s/corner_cafe_agents.yaml --target webots -o o")},
       {words("s/corner_cafe_agents.yaml --screenshot p.png --size 640x400")}},
      {"s/two_workers_agents__agent_1_bt.xml",
       {kRun, kCheck, words("check s/two_workers_agents__agent_1_bt.xml"),
        words("trees --play s/two_workers_agents__agent_1_bt.xml --ticks 50")},
       {kWindow}},
      {"s/two_workers.yaml", {kRun, kCheck, words("check s/two_workers.yaml")}, {kWindow}},
      {"s/two_workers.pgm", {kRun, kCheck}, {kWindow}},
      {"m.yaml",
       {words("evaluate r -q -o o --metrics m.yaml"),
        words("run s/two_workers_agents.yaml -q --duration 0.1 --metrics m.yaml")},
       {}},
      {"e.yaml",
       {words("check e.yaml")},
       {words("batch e.yaml --shard 1/1000 --time-limit 5 -q -o o")}},
      {"r/trajectory.csv", {kEvaluate, kPlay}, {kReplay}},
      {"r/events.csv", {kEvaluate, kPlay}, {kReplay}},
      {"r/trace.json", {kEvaluate, kPlay}, {kReplay}},
      {"r/trees.csv", {kPlay}, {kReplay}},
      {"r/manifest.json", {kEvaluate, kPlay, words("run s/two_workers_agents.yaml -q -o r")}, {}},
      {"b/results.csv", {words("report b --no-pdf -q")}, {}},
      {"b/manifest.json", {words("report b --no-pdf -q"), words("merge b -o o")}, {}},
      {"b/results.sqlite", {words("batch e.yaml -q -o b --resume"), words("merge b -o o")}, {}},
      {"t.csv", {words("evaluate t.csv -q -o o")}, {}},
      {"r/trajectory.csv", kAgain, {words("r --screenshot p.png --size 640x400 --at 0.3")}},
      {"r/trace.json", kAgain, {kFutures}},
      {"r/manifest.json", kAgain, {kFutures}},
      {"r/metrics.json", kDrawn, {}},
      {"r/steps.csv", kDrawn, {}},
      {"r/trajectory.csv", kDrawn, {words("render r -q -o p.gif --fps 2 --width 100")}},
      {"n/params_humble.yaml", {kHumble, kHumble, words("check n/params_humble.yaml")}, {}},
      {"n/params_jazzy.yaml", {kJazzy, kJazzy, words("check --json n/params_jazzy.yaml")}, {}},
      {"n/params_main.yaml", {kMain, kMain, words("check n/params_main.yaml")}, {}},
      {"n/tree.xml", {kHumble, kJazzy, words("check n/tree.xml")}, {}},
      {"n/yard.yaml",
       {words("run n/yard.yaml -q -o o --duration 0.6"), words("check n/yard.yaml")},
       {}},
      {"n/study.yaml",
       {words("check n/study.yaml")},
       {words("batch n/study.yaml --shard 1/1000 --time-limit 5 -q -o o")}},
      {"obsmat.txt",
       {words("evaluate obsmat.txt -q -o o"), words("evaluate obsmat.txt --format eth -q -o o")},
       {}},
  };
  return kKinds;
}

QTemporaryDir& corpus() {
  static QTemporaryDir folder;
  return folder;
}

/// Why the end of a command is none that users should see; empty: it is fine.
QString faultOf(const Ended& ended, bool wantsJson) {
  if (QString signal = signalOf(ended); !signal.isEmpty()) {
    return signal;
  }
  const int code = WEXITSTATUS(ended.status);
  if (code > 2) {
    return text("exit code %1").arg(code);
  }
  for (const char* word :
       {"std::", "not enough memory", "basic_string", "vector::", "::at", "stoi"}) {
    if (ended.err.contains(text(word))) {
      return text("tells of its inside: ") + text(word);
    }
  }
  const bool isJson = !QJsonDocument::fromJson(ended.out.toUtf8()).isNull();
  if (wantsJson && !isJson) {
    return text("writes no JSON");
  }
  if (code == 2 && !(wantsJson ? ended.out : ended.err).contains(text("error"))) {
    return text("refuses without a reason");
  }
  for (const QChar c : ended.err + ended.out) {
    if ((c < QLatin1Char(' ') && c != QLatin1Char('\n') && c != QLatin1Char('\t')) ||
        c == QChar(QChar::ReplacementCharacter)) {
      return text("control character %1 on the terminal").arg(c.unicode());
    }
  }
  return {};
}

/// A damaged file of a run is found out by its checksum: now and then the manifest is not there, or
/// was made by who damaged it.
void adaptManifest(const QString& folder, const char* file, std::size_t way) {
  const QString name = QFileInfo(text(file)).fileName();
  const QString manifest = folder + text("/r/manifest.json");
  if (!text(file).startsWith(text("r/")) || name == text("manifest.json") || way == 0) {
    return;
  }
  if (way == 1) {
    QFile::remove(manifest);
    return;
  }
  QJsonObject whole = QJsonDocument::fromJson(bytesOf(manifest)).object();
  QJsonArray outputs = whole.value(text("outputs")).toArray();
  for (auto&& each : outputs) {
    QJsonObject output = each.toObject();
    if (output.value(text("path")).toString() == name) {
      const QByteArray bytes = bytesOf(folder + text("/r/") + name);
      output.insert(
          text("sha256"),
          QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex()));
      each = output;
    }
  }
  whole.insert(text("outputs"), outputs);
  writeText(manifest, QJsonDocument(whole).toJson());
}

/// Nothing: fine.
QString faultOfMutation(std::uint64_t number) {
  Mutator mutator(number);
  const Kind& kind = kinds()[mutator.pick(kinds().size())];
  const bool isSeldom = !kind.seldom.empty() && mutator.pick(kIsSanitized ? 100 : 25) == 0;
  const std::vector<QStringList>& commands = isSeldom ? kind.seldom : kind.usual;
  const QStringList command = commands[mutator.pick(commands.size())];
  QTemporaryDir place;
  const QString folder = place.filePath(text("w"));
  copyFolder(corpus().path(), folder);
  const QString damaged = folder + QLatin1Char('/') + text(kind.file);
  const std::string whole = bytesOf(damaged).toStdString();
  const bool isByNumbers = mutator.pick(text(kind.file).startsWith(text("n/")) ? 2 : 5) == 0;
  const QByteArray bytes = QByteArray::fromStdString(isByNumbers ? mutator.withOtherNumbers(whole)
                                                                 : mutator.mutated(whole));
  writeText(damaged, bytes);
  adaptManifest(folder, kind.file, mutator.pick(3));
  const Ended ended = runForked(folder, command, kIsSanitized ? 120 : 30);
  QString fault = faultOf(ended, command.contains(text("--json")));
  const bool isOutput = command.contains(text("--resume")) || command.endsWith(text("r"));
  if (fault.isEmpty() && !isOutput && bytesOf(damaged) != bytes) {
    fault = text("what it read has changed");
  }
  if (fault.isEmpty()) {
    return {};
  }
  const QString kept = text(TEST_OUTPUT_DIR "/mutations/%1").arg(number);
  QDir(kept).removeRecursively();
  copyFolder(folder, kept);
  return text("mutation %1 (%2): %3\n  hunavsim %4\n  in %5\n%6")
      .arg(number)
      .arg(text(kind.file), fault, command.join(QLatin1Char(' ')), kept, ended.err.left(1500));
}

/// Of every `step`-th mutation; tells the first faults.
bool standAll(std::uint64_t first, std::uint64_t end, std::uint64_t step) {
  int faults = 0;
  for (std::uint64_t number = first; number < end && faults < 20; number += step) {
    const QString fault = faultOfMutation(number);
    if (!fault.isEmpty()) {
      ++faults;
      qWarning("%s", qPrintable(fault));
    }
  }
  return faults == 0;
}

/// A robot of Nav2 that sets out at once, with all that its files can say.
void writeNav2Study(const QString& folder) {
  writeNav2Yard(folder);
  writeText(folder + text("/study.yaml"),
            "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nseeds: 1\nduration: 0.2\n"
            "record: metrics\nvalues:\n  robot1.nav2.FollowPath.batch_size: [100, 200]\n"
            "");
}

}  // namespace

void MutationsTest::initTestCase() {
  const QString folder = corpus().path();
  for (const char* file :
       {"two_workers/two_workers_agents.yaml", "two_workers/two_workers.yaml",
        "two_workers/two_workers.pgm", "two_workers/two_workers_agents__agent_1_bt.xml",
        "two_workers/two_workers_agents__agent_2_bt.xml", "corner_cafe/corner_cafe_agents.yaml",
        "corner_cafe/corner_cafe.yaml", "corner_cafe/corner_cafe.pgm"}) {
    const QByteArray bytes = bytesOf(text(SOURCE_DIR "/maps/") + text(file));
    QVERIFY2(!bytes.isEmpty(), file);
    writeText(folder + text("/s/") + QFileInfo(text(file)).fileName(), bytes);
  }
  writeText(folder + text("/m.yaml"),
            "use_all: false\nmetrics:\n  time_to_reach_goal: true\n  path_length: true\n"
            "frequency: 0\nwindow: {from: begin, until: end}\n");
  writeText(folder + text("/e.yaml"),
            "hunavsim_experiment: 1\nscenarios: [s/two_workers_agents.yaml]\nseeds: 2\n"
            "duration: 0.2\nrecord: metrics\nvalues:\n"
            "  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n  dt: [0.05, 0.1]\n");
  writeText(folder + text("/t.csv"),
            "time,id,x,y\n0,1,0,0\n0.4,1,0.5,0\n0.8,1,1,0.1\n"
            "0,2,3,3\n0.4,2,3,2.5\n0.8,2,3,2\n");
  writeText(folder + text("/obsmat.txt"),
            bytesOf(text(TEST_DATA_DIR "/interop/trajectories/own/obsmat.txt")));
  writeNav2Study(folder + text("/n"));
  for (const char* command : {"run s/corner_cafe_agents.yaml -q -o r --duration 1 --record-every 4",
                              "batch e.yaml -q -o b --jobs 1"}) {
    const Ended ended = runForked(folder, words(command), 300);
    QVERIFY2(WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0, qPrintable(ended.err));
  }
}

void MutationsTest::damaged_isReadOrRefused() {
  const QStringList given = qEnvironmentVariable("HUNAV_MUTATIONS").split(QLatin1Char(' '));
  const bool isLong = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
  const std::uint64_t first = given.size() == 2 ? given[0].toULongLong() : 1;
  const std::uint64_t count = given.size() == 2 ? given[1].toULongLong() : (isLong ? 20000 : 200);
  constexpr int kMostWorkers = 4;
  const auto workers =
      static_cast<std::uint64_t>(isLong ? std::min(QThread::idealThreadCount(), kMostWorkers) : 1);
  std::vector<pid_t> others;
  for (std::uint64_t worker = 1; worker < workers; ++worker) {
    const pid_t other = ::fork();
    if (other == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::_exit(standAll(first + worker, first + count, workers) ? 0 : 1);
    }
    QVERIFY(other > 0);
    others.push_back(other);
  }
  bool stands = standAll(first, first + count, workers);
  for (const pid_t other : others) {
    int status = 0;
    stands = ::waitpid(other, &status, 0) == other && status == 0 && stands;
  }
  QVERIFY(stands);
}

QTEST_APPLESS_MAIN(MutationsTest)
#include "tst_Mutations.moc"
