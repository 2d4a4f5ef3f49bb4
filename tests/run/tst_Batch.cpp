#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <unistd.h>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "app/run/Batch.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"

namespace {

using Rows = std::map<std::size_t, app::ResultRow>;

/// Runs 0 … count - 1 that say who made them.
app::BatchJob jobOf(std::size_t count, Rows& rows) {
  app::BatchJob job;
  for (std::size_t run = 0; run < count; ++run) {
    job.runs.push_back(run);
  }
  job.execute = [](std::size_t run, const auto& /*met*/) -> base::Result<app::ResultRow> {
    app::ResultRow row;
    row.ok = true;
    row.simulated = std::to_string(run);
    row.fields = {{"worker", std::to_string(::getpid())}};
    return row;
  };
  job.storeRow = [&rows](std::size_t run, const app::ResultRow& row) {
    rows[run] = row;
    return base::Diagnostics();
  };
  job.wantsStop = [] { return false; };
  return job;
}

/// Calls `action` at the beginning of this run.
void actIn(app::BatchJob& job, std::size_t which, const std::function<void()>& action) {
  job.execute = [inner = job.execute, which, action](std::size_t run, const auto& met) {
    if (run == which) {
      action();
    }
    return inner(run, met);
  };
}

std::set<std::string> workersOf(const Rows& rows) {
  std::set<std::string> workers;
  for (const auto& [run, row] : rows) {
    for (const auto& [column, field] : row.fields) {
      workers.insert(field);
    }
  }
  return workers;
}

}  // namespace

/// Many runs in worker processes; here mostly runs that are none.
class BatchTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;
  std::string path(const char* name) const {
    return folder_.filePath(QString::fromLatin1(name)).toStdString();
  }

  /// With a robot, people who react, and draws in the run; 3 s.
  app::Experiment experiment() {
    const std::string file = path("e.yaml");
    const base::Diagnostics problems = base::writeFileAtomically(
        file,
        "hunavsim_experiment: 1\n"
        "scenarios: [" SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml, " SOURCE_DIR
        "/maps/reactions/reaction_scared_agents.yaml]\n"
        "seeds: 4\n"
        "duration: 3.0\n"
        "values:\n"
        "  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n"
        "  \"*.behavior.configuration\": [0, 2]\n");
    return problems.empty() ? *app::readExperiment(file) : app::Experiment();
  }

 private Q_SLOTS:
  void jobs_anyNumber_everyRunOnce_data() {
    QTest::addColumn<int>("jobs");
    for (const int jobs : {1, 2, 5}) {
      QTest::newRow(std::to_string(jobs).c_str()) << jobs;
    }
  }
  void jobs_anyNumber_everyRunOnce() {
    QFETCH(int, jobs);
    Rows rows;
    app::BatchJob job = jobOf(40, rows);
    job.jobs = jobs;
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{40});
    for (const auto& [run, row] : rows) {
      QVERIFY(row.ok);
      QCOMPARE(row.simulated, std::to_string(run));
    }
    QVERIFY(workersOf(rows).size() <= static_cast<std::size_t>(jobs));
    QVERIFY(workersOf(rows).count(std::to_string(::getpid())) == 0);
  }

  void worker_usedUp_isReplaced() {
    Rows rows;
    app::BatchJob job = jobOf(10, rows);
    job.runsPerWorker = 4;
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{10});
    QCOMPARE(workersOf(rows).size(), std::size_t{3});  // 4 + 4 + 2
  }

  void worker_grown_isReplaced() {
    Rows rows;
    app::BatchJob job = jobOf(6, rows);
    job.maxGrowth = std::size_t{32} << 20U;
    job.execute = [inner = job.execute](std::size_t run, const auto& met) {
      static std::string kept;  // grows by 64 MB a run
      kept.resize(kept.size() + (run > 0 ? std::size_t{64} << 20U : 0), 'x');
      return inner(run, met);
    };
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{6});
    QVERIFY(workersOf(rows).size() >= 2);
  }

  /// Twice, then its run has failed; nothing else has.
  void crash_always_isAFailedRow() {
    Rows rows;
    app::BatchJob job = jobOf(8, rows);
    job.jobs = 2;
    actIn(job, 3, [] {
      ::signal(SIGSEGV, SIG_DFL);  // a sanitizer would tell much
      ::raise(SIGSEGV);
    });
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{8});
    for (const auto& [run, row] : rows) {
      QCOMPARE(row.ok, run != 3);
    }
    QCOMPARE(rows[3].reason, std::string("the process crashed (signal 11)"));
    QVERIFY(rows[3].failedBy == app::FailedBy::Run);
  }

  /// Signals that the system, a queue or users send; a run causes none of them.
  void killed_always_isTheMachinesFailure_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("KILL") << SIGKILL;
    QTest::newRow("TERM") << SIGTERM;
    QTest::newRow("XCPU") << SIGXCPU;
  }
  void killed_always_isTheMachinesFailure() {
    QFETCH(const int, signal);
    Rows rows;
    app::BatchJob job = jobOf(4, rows);
    actIn(job, 1, [signal] {
      ::signal(signal, SIG_DFL);  // NOLINT(bugprone-unused-return-value): KILL has no other
      ::raise(signal);
    });
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{4});
    QVERIFY(!rows[1].ok && rows[1].failedBy == app::FailedBy::Machine);
    QCOMPARE(rows[1].reason, "the process was killed (signal " + std::to_string(signal) + ")");
  }

  void noMemory_isTheMachinesFailure() {
    Rows rows;
    app::BatchJob job = jobOf(3, rows);
    actIn(job, 1, [] { throw std::bad_alloc(); });
    QVERIFY(app::runBatch(job).empty());
    QVERIFY(!rows[1].ok && rows[1].failedBy == app::FailedBy::Machine);
    QCOMPARE(rows[1].reason, std::string("not enough memory"));
    QVERIFY(rows[0].ok && rows[2].ok);
  }

  void crash_once_costsNothing() {
    Rows rows;
    app::BatchJob job = jobOf(5, rows);
    const std::string mark = path("mark");
    actIn(job, 2, [mark] {
      if (!QFile::exists(QString::fromStdString(mark))) {
        if (base::writeFileAtomically(mark, "x").empty()) {
          ::kill(::getpid(), SIGKILL);
        }
      }
    });
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{5});
    QVERIFY(std::all_of(rows.begin(), rows.end(), [](const auto& each) { return each.second.ok; }));
  }

  void exception_isTheReason() {
    Rows rows;
    app::BatchJob job = jobOf(3, rows);
    actIn(job, 1, [] { throw std::runtime_error("no memory for this"); });
    QVERIFY(app::runBatch(job).empty());
    QVERIFY(!rows[1].ok);
    QCOMPARE(rows[1].reason, std::string("no memory for this"));
    QVERIFY(rows[1].failedBy == app::FailedBy::Run);
    QVERIFY(rows[0].ok && rows[2].ok);
  }

  void timeLimit_passed_isAFailedRow() {
    Rows rows;
    app::BatchJob job = jobOf(4, rows);
    job.timeLimit = 0.3;
    actIn(job, 1, [] {
      for (;;) {
        ::pause();
      }
    });
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{4});
    QCOMPARE(rows[1].reason, std::string("not finished within 0.3 s"));
    QVERIFY(rows[0].ok && !rows[1].ok && rows[2].ok && rows[3].ok);
  }

  /// A run that has reported its files: the row lists them, however it ends.
  void filesOfRunsWithoutAnswer_areInTheirRows() {
    Rows rows;
    app::BatchJob job = jobOf(4, rows);
    job.timeLimit = 0.5;
    job.execute = [inner = job.execute](std::size_t run, const auto& met) {
      met({{"a.yaml", "1"}, {"b.pgm", std::to_string(run)}});
      if (run == 0) {
        for (;;) {
          ::pause();
        }
      } else if (run == 1) {
        ::signal(SIGSEGV, SIG_DFL);
        ::raise(SIGSEGV);
      } else if (run == 2) {
        throw std::runtime_error("no memory for this");
      }
      return inner(run, met);
    };
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows.size(), std::size_t{4});
    for (const std::size_t run : {0U, 1U, 2U}) {
      QVERIFY(!rows[run].ok);
      QCOMPARE(rows[run].inputs.size(), std::size_t{2});
      QCOMPARE(rows[run].inputs[0].path, std::string("a.yaml"));
      QCOMPARE(rows[run].inputs[1].sha256, std::to_string(run));
    }
    QVERIFY(rows[3].ok && rows[3].inputs.empty());  // its answer is what counts
  }

  void filesThatCannotBeWritten_endTheBatch() {
    Rows rows;
    app::BatchJob job = jobOf(5, rows);
    job.execute = [inner = job.execute](std::size_t run,
                                        const auto& met) -> base::Result<app::ResultRow> {
      return run == 2 ? base::error("file.no-permission", {}, "x/2") : inner(run, met);
    };
    const base::Diagnostics said = app::runBatch(job);
    QCOMPARE(said.size(), std::size_t{1});
    QCOMPARE(said[0].file, std::string("x/2"));
    QVERIFY(said[0].message.find("no permission") != std::string::npos);
    QCOMPARE(rows.size(), std::size_t{2});
  }

  void resultsThatCannotBeKept_endTheBatch() {
    Rows rows;
    app::BatchJob job = jobOf(5, rows);
    job.storeRow = [](std::size_t, const app::ResultRow&) {
      return base::Diagnostics{base::error("file.no-permission", {}, "y")};
    };
    QCOMPARE(app::runBatch(job).size(), std::size_t{1});
  }

  void stop_endsAtOnce() {
    Rows rows;
    app::BatchJob job = jobOf(3, rows);
    job.execute = [](std::size_t, const auto& /*met*/) -> base::Result<app::ResultRow> {
      while (true) {
        ::pause();
      }
    };
    job.wantsStop = [] { return true; };
    QVERIFY(app::runBatch(job).empty());
    QVERIFY(rows.empty());
  }

  void answer_ofMegabytes_arrives() {
    Rows rows;
    app::BatchJob job = jobOf(2, rows);
    job.execute = [](std::size_t run, const auto& /*met*/) -> base::Result<app::ResultRow> {
      app::ResultRow row;
      row.ok = true;
      row.fields = {{"text", std::string(3'000'000, run == 0 ? 'a' : 'b')}};
      return row;
    };
    QVERIFY(app::runBatch(job).empty());
    QCOMPARE(rows[1].fields[0].second, std::string(3'000'000, 'b'));
  }

  /// Whatever names them, alone or together with another value; of code what holds it.
  void inputs_areThoseOfTheRun() {
    const auto write = [this](const char* name, const std::string& text) {
      return base::writeFileAtomically(path(name), text).empty();
    };
    QVERIFY(write("first.xml", "<root/>") && write("own.xml", "<root> </root>"));
    QVERIFY(write("follow.so", "no library") && write("velocities.csv", "t,v,w\n"));
    QVERIFY(write("follow.sh", "exit\n") && write("log.txt", "its own"));
    const std::string trees = path("first.xml") + ", " + path("own.xml") + ", lost.xml";
    const auto robot = [](const std::string& planner) {
      return "    - {start: {x: 1.0, y: 2.0}, goal: {x: 3.0, y: 2.0}, planner: " + planner + "}\n";
    };
    QVERIFY(
        write("i.yaml",
              "hunavsim_experiment: 1\nduration: 0.1\n"
              "scenarios: [" SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml]\n"
              "values:\n  Ana.tree: [" +
                  trees + "]\n  robot1:\n" +
                  robot("library, planner_parameters: {file: " + path("follow.so") + "}") +
                  robot("external, command: /bin/sh " + path("follow.sh") + " " + path("log.txt")) +
                  robot("replay, planner_parameters: {file: " + path("velocities.csv") + "}")));
    const base::Result<app::Experiment> study = app::readExperiment(path("i.yaml"));
    QVERIFY2(study, study.diagnostics().empty() ? "" : study.diagnostics().front().text().c_str());
    app::ExperimentRunner runner(*study, {}, {});
    runner.check();  // that the library is none is told elsewhere
    const auto hashes = [this](const std::vector<app::InputHash>& inputs) {
      std::set<std::string> names;
      for (const char* name : {"first.xml", "own.xml", "lost.xml", "follow.so", "follow.sh",
                               "log.txt", "velocities.csv"}) {
        for (const app::InputHash& input : inputs) {
          if (input.path == path(name) && input.sha256 == app::sha256OfFile(path(name))) {
            names.insert(name);
          }
        }
      }
      return names;
    };
    using Names = std::set<std::string>;
    QVERIFY(hashes(runner.inputs()) == Names({"first.xml", "follow.so"}));
    QVERIFY(hashes(runner.run(0)->inputs) == Names({"first.xml", "follow.so"}));
    QVERIFY(hashes(runner.run(4)->inputs) == Names({"own.xml", "follow.sh"}));
    QVERIFY(hashes(runner.run(8)->inputs) == Names({"velocities.csv"}));  // the tree is lost
  }

  void inputs_changed_areToldTwice() {
    const std::string text =
        *base::readTextFile(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    const auto write = [this](const char* name, const std::string& content) {
      return base::writeFileAtomically(path(name), content).empty();
    };
    QVERIFY(write("cafe_agents.yaml", text));
    QVERIFY(write("c.yaml",
                  "hunavsim_experiment: 1\nscenarios: [cafe_agents.yaml]\nseeds: 2\n"
                  "duration: 0.1\n"));
    const app::Experiment study = *app::readExperiment(path("c.yaml"));
    app::ExperimentRunner runner(study, {}, {});
    runner.check();
    const auto told = [&](std::size_t run) {
      std::vector<std::string> hashes;
      const base::Result<app::ResultRow> row = runner.run(run);
      for (const app::InputHash& input : row->inputs) {
        if (input.path == path("cafe_agents.yaml")) {
          hashes.push_back(input.sha256);
        }
      }
      return hashes;
    };
    const std::string was = app::sha256Of(text), is = app::sha256Of(text + "# more\n");
    QVERIFY(told(0) == std::vector<std::string>{was});
    QVERIFY(write("cafe_agents.yaml", text));  // the same again
    QVERIFY(told(1) == std::vector<std::string>{was});
    QVERIFY(write("cafe_agents.yaml", text + "# more\n"));
    QVERIFY(told(0) == std::vector<std::string>({was, is}));
    QVERIFY(write("cafe_agents.yaml", text));
    QVERIFY(told(1) == std::vector<std::string>{was});
    std::filesystem::remove(path("cafe_agents.yaml"));
    QVERIFY(told(0) == std::vector<std::string>({was, ""}));
  }

  /// What a worker did before leaves no trace: the same rows in any order, in one process or many.
  void rows_orderOfRuns_makesNoDifference() {
    const app::Experiment study = experiment();
    app::ExperimentRunner runner(study, path("runs"), {});
    QVERIFY(runner.check().empty());
    std::map<std::size_t, std::string> texts[4];
    for (std::size_t way = 0; way < std::size(texts); ++way) {
      Rows rows;
      app::BatchJob job = jobOf(study.runCount(), rows);
      job.execute = [&runner](std::size_t run, const auto& met) { return runner.run(run, met); };
      if (way == 1) {
        std::reverse(job.runs.begin(), job.runs.end());
      } else if (way == 2) {  // 5 and 16 have no common divisor: every run once
        for (std::size_t k = 0; k < job.runs.size(); ++k) {
          job.runs[k] = (5 * k + 3) % job.runs.size();
        }
      }
      job.jobs = way == 3 ? 3 : 1;
      job.runsPerWorker = way == 3 ? 2 : job.runsPerWorker;
      QVERIFY(app::runBatch(job).empty());
      for (const auto& [run, row] : rows) {
        QVERIFY2(row.ok, row.reason.c_str());
        texts[way][run] = app::serializeRow(row);
      }
    }
    QCOMPARE(texts[0].size(), std::size_t{16});
    QVERIFY(texts[1] == texts[0]);
    QVERIFY(texts[2] == texts[0]);
    QVERIFY(texts[3] == texts[0]);
    QVERIFY(texts[0][0] != texts[0][1]);  // seeds make one
  }
};

QTEST_APPLESS_MAIN(BatchTest)
#include "tst_Batch.moc"
