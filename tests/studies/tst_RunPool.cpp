#include <algorithm>
#include <fstream>

#include <QTemporaryDir>
#include <QtTest>

#include "app/studies/RunPool.h"
#include "sim2d/base/Text.h"

namespace {

const std::string kCafe = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";

app::RunRequest requestOf(const std::string& scenario, long long seed,
                          std::vector<std::string> set = {}) {
  app::RunRequest request;
  request.scenario = scenario;
  request.seed = seed;
  request.spec.duration = 1.0;
  request.spec.set = std::move(set);
  return request;
}

std::vector<app::RunRequest> someRequests(const std::string& scenario) {
  std::vector<app::RunRequest> requests;
  for (const long long seed : {1, 2, 3}) {
    requests.push_back(requestOf(scenario, seed));
    requests.push_back(requestOf(scenario, seed, {"robot1.max_vel=0.3"}));
  }
  return requests;
}

std::vector<std::string> textsOf(const std::vector<app::ResultRow>& rows) {
  std::vector<std::string> texts;
  std::transform(rows.begin(), rows.end(), std::back_inserter(texts), app::serializeRow);
  return texts;
}

}  // namespace

/// Runs that a study requests, in worker processes, and the journal of their results.
class RunPoolTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> folder_;

  std::string at(const char* name) const {
    return folder_->filePath(QString::fromUtf8(name)).toStdString();
  }
  app::RunPoolOptions options(int jobs = 1) const {
    app::RunPoolOptions options;
    options.jobs = jobs;
    options.journal = at("journal");
    return options;
  }
  /// A copy of a scenario without map, which may be changed.
  std::string copyOfScenario() const {
    base::writeFileAtomically(
        at("scene.yaml"), *base::readTextFile(SOURCE_DIR "/maps/planners/crossing_agents.yaml"));
    return at("scene.yaml");
  }
  static std::string codeOf(const base::Diagnostics& problems) {
    return problems.empty() ? std::string() : std::string(problems.back().code);
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void results_anyNumberOfJobs_areEqual() {
    app::RunPoolOptions one = options(1), two = options(2);
    one.journal = two.journal = std::string();
    const auto first = app::RunPool::open(one), second = app::RunPool::open(two);
    const auto rows = (*first)->run(someRequests(kCafe));
    const auto others = (*second)->run(someRequests(kCafe));
    QVERIFY(rows && others);
    QCOMPARE(textsOf(*rows), textsOf(*others));
    QVERIFY(std::all_of(rows->begin(), rows->end(), [](const auto& row) { return row.ok; }));
    QVERIFY((*rows)[0].fields != (*rows)[1].fields);  // another speed limit
  }

  void equalRequests_areExecutedOnce() {
    const auto pool = app::RunPool::open(options());
    const app::RunRequest request = requestOf(kCafe, 1);
    const auto rows = (*pool)->run({request, request});
    QVERIFY(bool(rows));
    QCOMPARE(rows->size(), std::size_t{2});
    QVERIFY((*pool)->run({request}));
    QCOMPARE((*pool)->executed(), std::size_t{1});
    QCOMPARE((*pool)->requested(), std::size_t{1});
  }

  void journal_withAllResults_executesNothing() {
    std::vector<std::string> before;
    {
      const auto pool = app::RunPool::open(options(2));
      before = textsOf(*(*pool)->run(someRequests(kCafe)));
      QCOMPARE((*pool)->executed(), std::size_t{6});
    }
    const auto pool = app::RunPool::open(options());
    const auto rows = (*pool)->run(someRequests(kCafe));
    QVERIFY(bool(rows));
    QCOMPARE((*pool)->executed(), std::size_t{0});
    QCOMPARE(textsOf(*rows), before);
  }

  void journal_cutInTheLastLine_repeatsThatRunOnly() {
    {
      const auto pool = app::RunPool::open(options());
      QVERIFY((*pool)->run(someRequests(kCafe)));
    }
    std::string text = *base::readTextFile(at("journal"));
    const std::string whole = text;
    text.resize(text.size() - 40);
    base::writeFileAtomically(at("journal"), text);
    const auto pool = app::RunPool::open(options());
    QVERIFY((*pool)->run(someRequests(kCafe)));
    QCOMPARE((*pool)->executed(), std::size_t{1});
    QCOMPARE(*base::readTextFile(at("journal")), whole);
  }

  void journal_inputsChanged_areExecutedAgain() {
    const std::string scenario = copyOfScenario();
    {
      const auto pool = app::RunPool::open(options());
      QVERIFY((*pool)->run({requestOf(scenario, 1)}));
    }
    std::ofstream(scenario, std::ios::app) << "# changed\n";
    const auto pool = app::RunPool::open(options());
    QVERIFY((*pool)->run({requestOf(scenario, 1)}));
    QCOMPARE((*pool)->executed(), std::size_t{1});
  }

  void journal_ofAnotherProgram_isRefused() {
    base::writeFileAtomically(at("journal"),
                              "{\"hunavsim_journal\":1,\"version\":\"0.1\",\"commit\":\"x\"}\n");
    QCOMPARE(codeOf(app::RunPool::open(options()).diagnostics()),
             std::string("study.other-program"));
    base::writeFileAtomically(at("journal"), "anything else\n");
    QCOMPARE(codeOf(app::RunPool::open(options()).diagnostics()), std::string("study.no-journal"));
  }

  /// JSON that is no header or result: the first is refused, of the others only that run is
  /// executed again.
  void journal_otherJson_isNoHeaderOrResult() {
    std::vector<std::string> results;
    {
      const auto pool = app::RunPool::open(options());
      results = textsOf(*(*pool)->run({requestOf(kCafe, 1), requestOf(kCafe, 2)}));
    }
    const std::vector<std::string> lines = base::split(*base::readTextFile(at("journal")), '\n');
    QVERIFY(lines.size() >= 3);
    const auto write = [&](const std::string& header, const std::string& second) {
      base::writeFileAtomically(at("journal"), header + "\n" + lines[1] + "\n" + second + "\n");
    };
    for (const char* const header :
         {R"({"hunavsim_journal": 1, "version": 5, "commit": "x"})",
          R"({"hunavsim_journal": 1, "version": "1", "commit": null})",
          R"({"hunavsim_journal": 1e999})", R"({"hunavsim_journal": "1"})", "[1]", "null", "{"}) {
      write(header, lines[2]);
      QCOMPARE(codeOf(app::RunPool::open(options()).diagnostics()),
               std::string("study.no-journal"));
    }
    const std::string key = lines[2].substr(0, lines[2].find("\"row\":"));
    for (const char* const row :
         {"{}", "[]", "7", "null", "\"text\"", R"({"ok": "yes"})", "1e999"}) {
      write(lines[0], key + "\"row\":" + row + "}");
      const auto pool = app::RunPool::open(options());
      QVERIFY2(bool(pool), row);
      const auto rows = (*pool)->run({requestOf(kCafe, 1), requestOf(kCafe, 2)});
      QVERIFY2(bool(rows), row);
      QCOMPARE((*pool)->executed(), std::size_t{1});
      QCOMPARE(textsOf(*rows), results);
    }
  }

  void stop_keepsWhatHasEnded_andResumes() {
    std::size_t ended = 0;
    app::RunPoolOptions stopped = options();
    stopped.showProgress = [&](std::size_t finished, std::size_t executed) {
      ended = finished;
      QCOMPARE(executed, finished);
    };
    stopped.wantsStop = [&] { return ended >= 2; };
    {
      const auto pool = app::RunPool::open(stopped);
      const auto rows = (*pool)->run(someRequests(kCafe));
      QVERIFY(!rows);
      QCOMPARE(codeOf(rows.diagnostics()), std::string("study.stopped"));
      QCOMPARE((*pool)->requested(), std::size_t{6});
    }
    std::size_t finished = 0, executed = 0;
    app::RunPoolOptions again = options();
    again.showProgress = [&](std::size_t ofAll, std::size_t now) {
      finished = ofAll;
      executed = now;
    };
    const auto resumed = app::RunPool::open(again);
    const auto rows = (*resumed)->run(someRequests(kCafe));
    QVERIFY((*resumed)->executed() <= 4);
    QCOMPARE(executed, (*resumed)->executed());
    QCOMPARE(finished, std::size_t{6});
    app::RunPoolOptions fresh = options();
    fresh.journal.clear();
    QCOMPARE(textsOf(*rows), textsOf(*(*app::RunPool::open(fresh))->run(someRequests(kCafe))));
  }

  void check_wrongOptions_areReported() {
    const auto pool = app::RunPool::open(options());
    QVERIFY((*pool)->check({requestOf(kCafe, 1)}).empty());
    const base::Diagnostics problems =
        (*pool)->check({requestOf(kCafe, 1, {"no.such.key=1"}), requestOf("/missing.yaml", 1)});
    QVERIFY(problems.size() >= 2);
    QVERIFY(base::hasErrors(problems));
  }
};

QTEST_APPLESS_MAIN(RunPoolTest)
#include "tst_RunPool.moc"
