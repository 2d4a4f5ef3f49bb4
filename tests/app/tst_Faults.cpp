#include <set>

#include <QApplication>
#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/ScenarioDocument.h"
#include "tests/app/FaultTrials.h"
#include "tests/app/Nav2Yard.h"
#include "tests/app/StudyFiles.h"
#include "tests/support/Sanitizers.h"

using faults::Kind;
using faults::Known;
using faults::Operation;
using faults::Outcome;
using namespace outside;

/// The program killed, the power gone, the disk full or broken, at calls to the system that are
/// counted: nothing of the user's is lost, nothing half-made is taken for whole, what failed is
/// told, and doing it again ends as if nothing had been.
///
/// HUNAV_FAULTS="OPERATION KIND FIRST LAST" makes those only, such as "run-over plug 10 20".
class FaultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void faults_anywhere_nothingIsLostOrHalf_data();
  void faults_anywhere_nothingIsLostOrHalf();
  void fault_ofOldAtItsCall_isOver_data();
  void fault_ofOldAtItsCall_isOver();
};

namespace {

constexpr int kFirst = -1;

/// What was wrong once, at a call of this name and file.
struct Finding {
  const char* name;
  const char* operation;
  Kind kind;
  const char* call;  // @ is the folder
  int later = 0;     // calls of this name that follow; kFirst: all but this
};

constexpr Finding kFindings[] = {
    {"files of a former run stay when its manifest cannot be read", "run-over", Kind::ReadError,
     "read @/r/manifest.json$"},
    {"equal files go when the new manifest cannot be read", "run-same", Kind::ReadError,
     "read @/r/.hunavsim-commit/manifest.json$"},
    {"a folder that cannot be looked at counts as empty", "run-new", Kind::ReadError,
     "open @/o/.hunavsim-commit$"},
    {"a staging folder that cannot be looked at ends the program", "run-new", Kind::ReadError,
     "open @/o/.hunavsim-new-\\d+$", 2},
    {"an input that cannot be read again is passed over", "run-new", Kind::ReadError,
     "read @/s/yard.yaml$"},
    {"an input without a checksum keeps a batch from going on", "batch", Kind::ReadError,
     "read @/s/yard.yaml$"},
    {"a report on a table that no manifest lists", "batch", Kind::Kill,
     "rename @/n/manifest.json$"},
    {"runs of a former batch stay", "batch-over", Kind::KillAll, "(remove|unlinkat) @/b/runs/2"},
    {"runs of a former batch that cannot be looked at stay", "batch-over", Kind::ReadError,
     "open @/b/runs/2$"},
    {"copied runs are not on the disk", "merge", Kind::Plug, "rename @/m/manifest.json$"},
    {"copied runs that cannot be looked at are left out", "merge", Kind::ReadError,
     "open @/q/runs$"},
    {"beginnings of files stay beside a saved scenario", "save", Kind::Kill,
     "rename @/d/two_workers_agents.yaml$"},
    {"a report that lacks a run is told to be fine", "report", Kind::ReadError,
     "read @/b/runs/1/trace.json$"},
    {"a report lacks the checksum of its table", "report", Kind::ReadError,
     "open @/b/results.csv$"},
    {"a run of a batch lacks the checksum of an input", "batch-two-jobs", Kind::ReadError,
     "open @/s/yard.yaml$"},
    {"an empty folder stays in a finished run", "batch-over", Kind::ReadError,
     "open @/b/runs/1/.hunavsim-commit$"},
    {"an image that breaks off has no name", "convert", Kind::ReadError,
     "read @/s/two_workers.pgm$", kFirst},
    {"a journal stays beside new results", "batch-two-jobs", Kind::WriteError,
     "unlink @/n/.hunavsim-new-results.sqlite-journal$"},
    {"a report without the words of an experiment that cannot be read", "report", Kind::ReadError,
     "open @/s/earlier.yaml$"},
    {"a run without the goal radius of Nav2's file", "run-nav2", Kind::ReadError,
     "read @/n/params_jazzy.yaml$", 1},
    {"a run that does not list the tree of Nav2", "run-nav2", Kind::ReadError,
     "read @/n/params_jazzy.yaml$", kFirst},
    {"the lock of a finished run stays when it cannot be removed", "batch-resumed",
     Kind::WriteError, R"(unlink @/h/runs/\d+/.hunavsim-lock$)"},
};

/// A tenth of them lies at the end, where what is complete is put in its place.
std::vector<int> spread(int count, int wanted) {
  std::set<int> numbers;
  for (int k = 0; k < std::min(count, wanted / 4); ++k) {
    numbers.insert(count - k);
  }
  for (int k = 0; k < wanted; ++k) {
    numbers.insert(1 + k * (count - 1) / std::max(1, wanted - 1));
  }
  for (int number = 1; number <= count && static_cast<int>(numbers.size()) < wanted; ++number) {
    numbers.insert(number);
  }
  return {numbers.begin(), numbers.end()};
}

using Trials = std::vector<std::pair<Kind, int>>;

Trials trialsOf(const Operation& operation, const Known& known) {
  const QStringList given = qEnvironmentVariable("HUNAV_FAULTS").split(QLatin1Char(' '));
  constexpr int kKills = 16, kFaults = 13;
  Trials trials;
  for (const Kind kind :
       {Kind::Kill, Kind::KillAll, Kind::Plug, Kind::NoSpace, Kind::WriteError, Kind::ReadError}) {
    const int calls = kind == Kind::ReadError ? known.reads : known.changes;
    const bool isKill = kind == Kind::Kill || kind == Kind::KillAll || kind == Kind::Plug;
    if (given.size() == 4 && given[1] == faults::nameOf(kind)) {
      for (int at = given[2].toInt(); at <= std::min(calls, given[3].toInt()); ++at) {
        trials.emplace_back(kind, at);
      }
    } else if (given.size() != 4 && (kind != Kind::KillAll || faults::isBatch(operation))) {
      for (const int at : spread(calls, isKill ? kKills : kFaults)) {
        trials.emplace_back(kind, at);
      }
    }
  }
  return trials;
}

/// Keeps what was found after a fault, to be looked at.
QString kept(const Operation& operation, Kind kind, int at) {
  QString folder = text(TEST_OUTPUT_DIR "/faults/%1-%2-%3")
                       .arg(text(operation.name), faults::nameOf(kind))
                       .arg(at);
  QDir(folder).removeRecursively();
  copyFolder(faults::work(), folder);
  return folder;
}

/// The other process: a window's document that is changed in all its files and saved.
int saveChanged(int argc, char** argv) {
  const QApplication application(argc, argv);
  editor::ScenarioDocument document;
  const QString path = QString::fromLocal8Bit(argv[2]);
  base::Diagnostics problems = document.open(path);
  if (problems.empty()) {  // else it would be saved without what could not be read
    editor::pushChange<editor::ScenarioSettings>(
        document, editor::kSettingsId, text("Seed"),
        [](editor::ScenarioSettings& settings) { settings.desktop.seed = 77; });
    editor::MapStroke stroke(document.map());
    stroke.paint({1.0, 1.0}, {1.5, 1.0}, 0.2, editor::MapPaint::Occupied);
    editor::pushStroke(document, stroke, text("Wall"));
    problems = document.save(path);
  }
  for (const base::Diagnostic& problem : problems) {
    qWarning("%s", problem.text().c_str());
  }
  return problems.empty() ? 0 : 2;
}

void make(const char* words) {
  const Finished found = runProgram(faults::wordsIn(words));
  if (found.exitCode != 0) {
    qFatal("%s: %s", words, qPrintable(found.err));
  }
}

void writeScenarios(const QString& folder) {
  writeText(folder + text("/yard.yaml"), kYardText);
  const QByteArray head =
      "hunavsim_experiment: 1\nscenarios: [yard.yaml]\nduration: 0.2\n"
      "values:\n  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n";
  writeText(folder + text("/plain.yaml"), head + "seeds: 3\nrecord: metrics\n");
  writeText(folder + text("/kept.yaml"), head + "seeds: 2\nrecord: all\n");
  writeText(folder + text("/earlier.yaml"), head + "seeds: 3\nrecord: all\ndt: 0.1\n");
  for (const char* file :
       {"two_workers_agents.yaml", "two_workers.yaml", "two_workers.pgm",
        "two_workers_agents__agent_1_bt.xml", "two_workers_agents__agent_2_bt.xml"}) {
    writeText(folder + QLatin1Char('/') + text(file),
              bytesOf(text(SOURCE_DIR "/maps/two_workers/") + text(file)));
  }
}

}  // namespace

/// Made where it is used, so that no path in it differs.
void FaultsTest::initTestCase() {
  if (kIsSanitized) {
    QSKIP("a sanitizer has to be the first library of a program");
  }
  writeScenarios(faults::work() + text("/s"));
  writeScenarios(faults::work() + text("/d"));
  writeNav2Yard(faults::work() + text("/n"));
  QDir().mkpath(faults::scratch());
  make("run @/s/yard.yaml -q --duration 0.3 --seed 1 --counterfactual -o @/r");
  make("batch @/s/earlier.yaml -q -o @/b");
  make("batch @/s/kept.yaml -q --shard 1/2 -o @/p");
  make("batch @/s/kept.yaml -q --shard 2/2 -o @/q");
  make("convert @/s/two_workers_agents.yaml --target webots -q -o @/c");
  make("evaluate @/r -q --metrics path_length -o @/e");
  make("trees @/s/two_workers_agents.yaml -q --style hunav2 -o @/t");
  const QStringList words = faults::wordsIn("batch @/s/kept.yaml -q --jobs 1 -o @/h");
  const int calls = faults::faulty(words, Kind::Count, 0).changes;
  QDir(faults::work() + text("/h")).removeRecursively();
  QVERIFY(faults::faulty(words, Kind::KillAll, calls / 2).isKilled);
  for (const char* folder : {"r", "b", "b/runs", "h", "c", "e", "t", "d"}) {
    writeText(faults::work() + QLatin1Char('/') + text(folder) + text("/mine.txt"), "by hand\n");
  }
  QVERIFY(QDir().rename(faults::work(), faults::corpus()));
}

void FaultsTest::faults_anywhere_nothingIsLostOrHalf_data() {
  QTest::addColumn<int>("operation");
  for (int k = 0; k < static_cast<int>(std::size(faults::kOperations)); ++k) {
    QTest::newRow(faults::kOperations[k].name) << k;
  }
}

void FaultsTest::faults_anywhere_nothingIsLostOrHalf() {
  QFETCH(int, operation);
  const Operation& what = faults::kOperations[operation];
  const QString given = qEnvironmentVariable("HUNAV_FAULTS");
  if (!given.isEmpty() && given.section(QLatin1Char(' '), 0, 0) != text(what.name)) {
    QSKIP("not asked for");
  }
  const Known known = faults::learn(what);
  const Trials trials = trialsOf(what, known);
  const bool isLong = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") || !given.isEmpty();
  const std::size_t stride = isLong ? 1 : trials.size() / 3;
  int wrong = 0, kills = 0, faults = 0;
  for (std::size_t k = isLong ? 0 : static_cast<std::size_t>(operation) * 5 % stride;
       k < trials.size() && wrong < 20; k += stride) {
    const auto& [kind, at] = trials[k];
    Outcome outcome;
    const QString fault = faults::faultOf(what, known, kind, at, outcome);
    ++(kind == Kind::Kill || kind == Kind::KillAll || kind == Kind::Plug ? kills : faults);
    if (!fault.isEmpty()) {
      ++wrong;
      qWarning("%s %s %d (%s): %s\n  left in %s\n%s", what.name, qPrintable(faults::nameOf(kind)),
               at, qPrintable(outcome.struck), qPrintable(fault), qPrintable(kept(what, kind, at)),
               qPrintable(outcome.err.left(1000)));
    }
  }
  qInfo("%d calls that change, %d that read; %d kills, %d faults", known.changes, known.reads,
        kills, faults);
  QCOMPARE(wrong, 0);
}

void FaultsTest::fault_ofOldAtItsCall_isOver_data() {
  QTest::addColumn<int>("finding");
  for (int k = 0; k < static_cast<int>(std::size(kFindings)); ++k) {
    QTest::newRow(kFindings[k].name) << k;
  }
}

void FaultsTest::fault_ofOldAtItsCall_isOver() {
  QFETCH(int, finding);
  const Finding& what = kFindings[finding];
  const Operation& operation = *std::find_if(
      std::begin(faults::kOperations), std::end(faults::kOperations),
      [&what](const Operation& each) { return qstrcmp(each.name, what.operation) == 0; });
  const Known known = faults::learn(operation);
  const QRegularExpression call(
      text("^") +
      text(what.call).replace(QLatin1Char('@'), QRegularExpression::escape(faults::work())));
  const QList<faults::PlacedCall> calls =
      faults::callsLike(faults::scratch(), what.kind, call, faults::work());
  QVERIFY2(calls.size() > std::max(what.later, 0), "there is no such call any more");
  const auto [watched, at] =
      what.later == kFirst ? calls.first() : calls[calls.size() - 1 - what.later];
  constexpr int kTrials = 60;  // two jobs make their calls in another order each time
  Outcome outcome;
  QString fault;
  for (int trial = 0; trial < kTrials && !call.match(outcome.struck).hasMatch(); ++trial) {
    const int beside = (trial % 2 == 0 ? 1 : -1) * ((trial + 1) / 2);
    fault =
        faults::faultOf(operation, known, what.kind, std::max(1, at + beside), outcome, watched);
  }
  QVERIFY2(call.match(outcome.struck).hasMatch(), qPrintable(outcome.struck));
  QVERIFY2(fault.isEmpty(), qPrintable(fault + QLatin1Char('\n') + outcome.err));
}

int main(int argc, char** argv) {
  if (argc == 3 && qstrcmp(argv[1], "--save") == 0) {
    return saveChanged(argc, argv);
  }
  const QCoreApplication application(argc, argv);
  FaultsTest test;
  QTEST_SET_MAIN_SOURCE_PATH
  return QTest::qExec(&test, argc, argv);
}
#include "tst_Faults.moc"
