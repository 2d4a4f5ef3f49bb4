#include <algorithm>
#include <map>
#include <set>

#include <QTemporaryDir>
#include <QtTest>

#include "app/studies/FailureScenario.h"
#include "app/studies/SearchStudy.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

using app::Candidate;
using app::Experiment;
using app::ResultRow;
using app::RunRequest;
using app::SearchPlan;
using app::SearchSpace;

namespace {

using Rows = base::Result<std::vector<ResultRow>>;

const std::string kCrossing = SOURCE_DIR "/maps/planners/crossing_agents.yaml";

Experiment experimentOf(const std::string& values, const std::string& seeds = "3") {
  const base::Result<Experiment> read =
      app::parseExperiment("hunavsim_experiment: 1\nscenarios: [crossing_agents]\nseeds: " + seeds +
                               "\nvalues:\n" + values,
                           "study.yaml");
  if (!read) {
    qFatal("%s", read.diagnostics().front().text().c_str());
  }
  return *read;
}

/// The value of a path in the request.
std::string valueOf(const RunRequest& request, const std::string& path) {
  for (const std::string& setting : request.spec.set) {
    if (base::startsWith(setting, path + "=")) {
      return setting.substr(path.size() + 1);
    }
  }
  return {};
}

double numberIn(const RunRequest& request, const std::string& path) {
  return base::parseDouble(valueOf(request, path)).value_or(0.0);
}

ResultRow rowOf(bool isFailure, double gap, const char* bearing = "1.5") {
  ResultRow row;
  row.ok = true;
  row.reason = isFailure ? "collision: robot1 with p01" : "arrived";
  row.simulated = "10";
  row.fields = {{"success", isFailure ? "False" : "True"},
                {"minimum_distance_to_people", base::formatDouble(gap)},
                {"time_not_moving", "0"},
                {"total_time", "10"},
                {"final_bearing_to_person", bearing},
                {"final_distance_to_person", isFailure ? "0" : "2"},
                {"final_person_speed", "1"},
                {"final_people_near", "2"}};
  return row;
}

/// A narrow valley: fails within 0.03 of (0.82, 0.27), which is 0.3 % of the area; the gap shows
/// the distance.
Rows valley(const std::vector<RunRequest>& requests) {
  std::vector<ResultRow> rows;
  for (const RunRequest& request : requests) {
    const double x = numberIn(request, "robot1.max_vel") - 0.82;
    const double y = numberIn(request, "p01.max_vel") - 0.27;
    const double distance = std::sqrt(x * x + y * y);
    rows.push_back(rowOf(distance < 0.03, 5.0 * distance));
  }
  return rows;
}

const char* const kTwoValues =
    "  robot1.max_vel: {uniform: [0.001, 1.0]}\n"
    "  p01.max_vel: {uniform: [0.001, 1.0]}\n";

constexpr const char* kRing = "T/ring";  // of nested nodes

/// A tree of a root, nodes in rings around (0.82, 0.27), each 0.6 times as large as the one before
/// and reached within it, and a last one that the structure excludes.
ResultRow rowOfRings(double x, double y, int rings) {
  const double distance = std::fabs(x - 0.82) + std::fabs(y - 0.27);
  ResultRow row = rowOf(false, 1.0);
  app::TreeRow tree;
  tree.owners = "p01";
  tree.paths = "T";
  tree.returned = "2";
  double radius = 0.5;
  for (int ring = 0; ring < rings; ++ring, radius *= 0.6) {
    tree.paths += std::string("\n") + kRing + std::to_string(ring);
    tree.returned += distance < radius ? '2' : '0';
  }
  tree.paths += "\nT/never";
  tree.returned += 'u';
  row.trees.push_back(tree);
  return row;
}

std::string textOf(const app::SearchResult& result) {
  std::string text;
  for (const app::SearchedRun& run : result.runs) {
    for (const double x : run.candidate.point) {
      text += base::formatDouble(x) + " ";
    }
    text += base::formatDouble(run.fitness) + "\n";
  }
  return text;
}

}  // namespace

/// The search for failures, on functions in place of runs.
class SearchTest : public QObject {
  Q_OBJECT

 private:
  static void addSeeds() {
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 5; ++seed) {
      QTest::addRow("seed %d", seed) << seed;
    }
  }

 private Q_SLOTS:
  void space_forms_areContinuousOrCategories() {
    const Experiment experiment = experimentOf(
        "  p01.max_vel: {range: [0.5, 1.0, 0.25]}\n"
        "  p02.max_vel: {normal: [1.0, 0.2, 0.6, 1.4]}\n"
        "  robot1.max_vel: {uniform: [0.3, 1.1]}\n"
        "  robot1.planner: [pursuit, orca]\n"
        "  p01.behavior.type: {choice: [Regular, Impassive, Scared]}\n");
    const SearchSpace space(experiment);
    QCOMPARE(space.dimensions(), std::size_t{3});
    QCOMPARE(space.optionCounts(), (std::vector<std::size_t>{1, 3, 2, 3}));
    QCOMPARE(space.combinations(), std::size_t{18});
    const RunRequest low = space.requestOf({{0.0, 0.0, 0.0}, {0, 0, 0, 0}});
    const RunRequest high = space.requestOf({{1.0, 1.0, 1.0}, {0, 2, 1, 2}});
    QCOMPARE(low.spec.set,
             (std::vector<std::string>{"p01.max_vel=0.5", "p02.max_vel=0.6", "robot1.max_vel=0.3",
                                       "robot1.planner=pursuit", "p01.behavior.type=Regular"}));
    QCOMPARE(high.spec.set,
             (std::vector<std::string>{"p01.max_vel=1", "p02.max_vel=1.4", "robot1.max_vel=1.1",
                                       "robot1.planner=orca", "p01.behavior.type=Scared"}));
    QCOMPARE(high.seed, 3LL);
    QCOMPARE(valueOf(space.requestOf({{0.5, 0.5, 0.12345678}, {0, 0, 0, 0}}), "robot1.max_vel"),
             std::string("0.39877"));  // of 0.398765424, to 1e-5
    QVERIFY(high.spec.stopOnCollision == "any");
    QVERIFY(high.spec.stuckAfter == 20.0);
  }

  void mutate_choices_changesOneCategory() {
    const Experiment experiment = experimentOf("  robot1.planner: [pursuit, orca, dwa]\n");
    const SearchSpace space(experiment);
    app::SearchRandom random(7);
    std::set<std::vector<std::size_t>> seen;
    for (int k = 0; k < 200; ++k) {
      std::vector<std::size_t> choices = {0, 1, 2};
      space.mutate(choices, random);
      QCOMPARE(choices[0], std::size_t{0});  // one scenario
      QVERIFY((choices[1] == 1) != (choices[2] == 2));
      QVERIFY(choices[1] < 3 && choices[2] < 3);
      seen.insert(choices);
    }
    QCOMPARE(seen.size(), std::size_t{4});
  }

  void balancedChoices_options_areEquallyFrequent() {
    const Experiment experiment =
        experimentOf("  robot1.planner: [pursuit, orca, dwa]\n  p01.max_vel: [0.8, 1.0]\n", "1");
    app::SearchRandom random(7);
    const auto all = SearchSpace(experiment).balancedChoices(12, random);
    std::map<std::size_t, int> planners, speeds;
    std::set<std::vector<std::size_t>> combinations;
    for (const std::vector<std::size_t>& choices : all) {
      QCOMPARE(choices.size(), std::size_t{4});
      ++planners[choices[2]];
      ++speeds[choices[3]];
      combinations.insert(choices);
    }
    QCOMPARE(planners, (std::map<std::size_t, int>{{0, 4}, {1, 4}, {2, 4}}));
    QCOMPARE(speeds, (std::map<std::size_t, int>{{0, 6}, {1, 6}}));
    QVERIFY(combinations.size() > 3);  // not always the same pairs
  }

  void narrowFailure_isFoundByTheGap_data() { addSeeds(); }
  void narrowFailure_isFoundByTheGap() {
    QFETCH(int, seed);
    const Experiment experiment = experimentOf(kTwoValues, "1");
    SearchPlan plan;
    plan.runs = 500;
    plan.seed = static_cast<std::uint64_t>(seed);
    const auto result = app::search(SearchSpace(experiment), plan, valley);
    QVERIFY(bool(result));
    QCOMPARE(result->failures.size(), std::size_t{1});
    QVERIFY(result->runs.size() < 500);
    QCOMPARE(result->failures[0].kind.name(), std::string("contact-left-moving"));
    QVERIFY(result->runs[result->failures[0].run].kind.has_value());
  }

  void equalPlans_giveEqualSearches_otherSeedsOthers() {
    const Experiment experiment = experimentOf(kTwoValues, "1");
    const SearchSpace space(experiment);
    SearchPlan plan;
    plan.runs = 120;
    plan.failures = 5;
    const auto first = app::search(space, plan, valley);
    const auto second = app::search(space, plan, valley);
    QCOMPARE(textOf(*first), textOf(*second));
    QCOMPARE(first->runs.size(), std::size_t{120});
    plan.seed = 2;
    QVERIFY(textOf(*app::search(space, plan, valley)) != textOf(*first));
  }

  void worst_metric_isMadeWorseInItsDirection_data() {
    QTest::addColumn<QString>("metric");
    QTest::addColumn<int>("direction");
    QTest::addColumn<double>("worst");
    QTest::newRow("higher is better") << "minimum_distance_to_people" << -1 << 0.0;
    QTest::newRow("lower is better") << "time_to_reach_goal" << 1 << 0.9;
  }
  void worst_metric_isMadeWorseInItsDirection() {
    QFETCH(QString, metric);
    QFETCH(int, direction);
    QFETCH(double, worst);
    SearchPlan plan;
    plan.worst = metric.toStdString();
    plan.runs = 300;
    QCOMPARE(app::worseDirection(plan.worst), direction);
    const Experiment experiment = experimentOf(kTwoValues, "1");
    const auto result =
        app::search(SearchSpace(experiment), plan, [&](const std::vector<RunRequest>& requests) {
          std::vector<ResultRow> rows;
          for (const RunRequest& request : requests) {
            ResultRow row = rowOf(false, 1.0);
            const double x = numberIn(request, "robot1.max_vel") - 0.3;
            const double y = numberIn(request, "p01.max_vel") - 0.6;
            const double value = x * x + y * y;
            row.fields[1] = {plan.worst, base::formatDouble(direction < 0 ? value : 0.9 - value)};
            rows.push_back(row);
          }
          return Rows(rows);
        });
    QVERIFY(result && result->worst);
    QCOMPARE(result->runs.size(), std::size_t{300});
    QVERIFY(std::fabs(result->runs[result->worst->run].value - worst) < 1e-3);
  }

  void worseDirection_metricsWithoutOne_isZero() {
    QCOMPARE(app::worseDirection("final_people_near"), 0);
    QCOMPARE(app::worseDirection("no_such_metric"), 0);
    QCOMPARE(app::worseDirection("ended_by_contact"), 1);
  }

  void unavoidableContacts_doNotCount() {
    const Experiment experiment = experimentOf("  p01.behavior.type: [Regular, Scared]\n", "4");
    SearchPlan plan;
    plan.failures = 2;
    std::size_t asked = 0;
    plan.countsAgainstRobot = [&asked](const RunRequest& request) {
      ++asked;
      return base::Result<bool>(request.seed == 3);
    };
    const auto result =
        app::search(SearchSpace(experiment), plan, [](const std::vector<RunRequest>& requests) {
          std::vector<ResultRow> rows(requests.size(), rowOf(true, 0.0));
          return Rows(rows);
        });
    QVERIFY(bool(result));
    QCOMPARE(result->runs.size(), std::size_t{8});  // every combination once
    QCOMPARE(result->failures.size(), std::size_t{1});
    QCOMPARE(result->failures[0].request.seed, 3LL);
    const auto excused = std::count_if(result->runs.begin(), result->runs.end(),
                                       [](const auto& run) { return run.isUnavoidable; });
    QCOMPARE(static_cast<std::size_t>(excused) + 1, asked);
  }

  void runsThatCannotStart_areCountedAndNoFailures() {
    const Experiment experiment = experimentOf("  p01.behavior.type: [Regular, Scared]\n", "2");
    const auto result = app::search(SearchSpace(experiment), SearchPlan(),
                                    [](const std::vector<RunRequest>& requests) {
                                      ResultRow row;
                                      row.reason = "p01 stands in a wall";
                                      return Rows(std::vector<ResultRow>(requests.size(), row));
                                    });
    QVERIFY(bool(result));
    QVERIFY(result->failures.empty());
    QVERIFY(result->archive.isEmpty());
    QCOMPARE(result->notSimulated, std::size_t{4});
    QCOMPARE(result->firstProblem, std::string("p01 stands in a wall"));
  }

  /// The innermost ring has 0.04 % of the area, in which random points would need 2500 runs.
  void cover_rareNodes_areReachedThroughLessRareOnes_data() { addSeeds(); }
  void cover_rareNodes_areReachedThroughLessRareOnes() {
    QFETCH(int, seed);
    const Experiment experiment = experimentOf(kTwoValues, "1");
    SearchPlan plan;
    plan.covers = true;
    plan.seed = static_cast<std::uint64_t>(seed);
    const auto result =
        app::search(SearchSpace(experiment, SearchSpace::RunsEnd::AsInScenario), plan,
                    [](const std::vector<RunRequest>& requests) {
                      std::vector<ResultRow> rows;
                      for (const RunRequest& request : requests) {
                        rows.push_back(rowOfRings(numberIn(request, "robot1.max_vel"),
                                                  numberIn(request, "p01.max_vel"), 8));
                      }
                      return Rows(rows);
                    });
    QVERIFY(bool(result));
    QVERIFY2(result->coverage.isComplete(), std::to_string(result->runs.size()).c_str());
    QVERIFY(result->runs.size() < 500);
    const app::SearchedTree& tree = result->coverage.trees().front();
    QCOMPARE(tree.unreachable(), std::size_t{1});
    QCOMPARE(tree.counts.executedNodes(), std::size_t{9});
    QVERIFY(!tree.isReached(9) && !tree.isMissing(9));
    std::size_t found = 0;
    for (const std::size_t run : result->coveringRuns()) {
      found += result->runs[run].newNodes;
    }
    QCOMPARE(found, std::size_t{9});
    QVERIFY(result->failures.empty());
  }

  void cover_requests_runToTheirEnd() {
    const Experiment experiment = experimentOf(kTwoValues, "1");
    const SearchSpace space(experiment, SearchSpace::RunsEnd::AsInScenario);
    const RunRequest request = space.requestOf({{0.5, 0.5}, {0, 0}});
    QVERIFY(!request.spec.stopOnCollision && !request.spec.stuckAfter);
  }

  /// Every option occurs before the search may end, so no tree is left out.
  void cover_options_allOccurFirst() {
    const Experiment experiment =
        experimentOf("  p01.behavior.type: [Regular, Impassive, Scared, Curious]\n", "3");
    SearchPlan plan;
    plan.covers = true;
    std::set<std::string> seen;
    const auto result = app::search(
        SearchSpace(experiment), plan, [&seen](const std::vector<RunRequest>& requests) {
          std::vector<ResultRow> rows;
          for (const RunRequest& request : requests) {
            const std::string type = valueOf(request, "p01.behavior.type");
            seen.insert(type);
            rows.push_back(rowOf(false, 1.0));
            rows.back().trees = {{"p01", type, "2"}};
          }
          return Rows(rows);
        });
    QVERIFY(bool(result));
    QCOMPARE(seen.size(), std::size_t{4});
    QVERIFY(result->coverage.isComplete());
    QCOMPARE(result->coverage.trees().size(), std::size_t{4});
    QVERIFY(result->runs.size() < 12);  // not all combinations
  }

  /// Two runs of one tree and one of another: counts, first runs and rarities by hand.
  void coverage_ofRuns_countsNodesOfAllScenarios() {
    app::SearchCoverage coverage;
    QVERIFY(!coverage.isComplete());
    QCOMPARE(coverage.add(0, "a", {{"p01", "T\nT/x\nT/y\nT/z", "210u"}}), std::size_t{2});
    QCOMPARE(coverage.add(1, "b", {{"p02", "T\nT/x\nT/y\nT/z", "280u"}, {"p03", "U", "4"}}),
             std::size_t{1});  // SKIPPED is not executed
    QCOMPARE(coverage.trees().size(), std::size_t{2});
    QCOMPARE(coverage.byScenario().size(), std::size_t{3});
    const app::SearchedTree& tree = coverage.trees()[0];
    QCOMPARE(tree.counts.owners, std::string("p01, p02"));
    QCOMPARE(tree.scenarios, (std::vector<std::string>{"a", "b"}));
    QCOMPARE(tree.missing(), std::size_t{1});
    QVERIFY(tree.firstRuns[1] == std::optional<std::size_t>(0) && tree.isMissing(2));
    // 1/2 for T, 1 for T/x; 1/2 for T, nothing for U, which is complete
    QCOMPARE(coverage.rarities(), (std::vector<double>{1.5, 0.5}));
    QCOMPARE(coverage.add(2, "a", {{"p01", "T\nT/x\nT/y\nT/z", "222u"}}), std::size_t{1});
    QVERIFY(coverage.isComplete());
    QCOMPARE(coverage.add(3, "a", {{"p01", "T\nT/x\nT/y\nT/z", "2220"}}), std::size_t{0});
    QVERIFY(!coverage.isComplete());  // not every tree of these paths excludes T/z
  }

  void error_ofTheRuns_endsTheSearch() {
    const Experiment experiment = experimentOf(kTwoValues, "1");
    const auto result = app::search(SearchSpace(experiment), SearchPlan(),
                                    [](const std::vector<RunRequest>& /*requests*/) -> Rows {
                                      return base::error("study.stopped", {0});
                                    });
    QVERIFY(!result);
    QCOMPARE(result.diagnostics().front().code, std::string_view("study.stopped"));
  }

  void shrinking_keepsWhatTheFailureNeeds() {
    RunRequest failing;
    failing.scenario = kCrossing;
    failing.seed = 5;
    failing.spec.set = {"robot1.planner=orca", "p03.max_vel=1.3", "p07.max_vel=0.9",
                        "robot1.max_vel=0.8"};
    const app::FailureKind kind = *app::failureKindOf(rowOf(true, 0.0));
    // Fails while person 7 is there and robot1 is slow.
    const auto run = [](const std::vector<RunRequest>& requests) {
      std::vector<ResultRow> rows;
      for (const RunRequest& request : requests) {
        const std::string agents = valueOf(request, "agents");
        const bool isThere = agents.empty() || agents.find("p07") != std::string::npos;
        rows.push_back(rowOf(isThere && !valueOf(request, "robot1.max_vel").empty(), 0.0));
      }
      return Rows(rows);
    };
    const auto shrunk = app::shrunkFailure(failing, rowOf(true, 0.0), kind, 400, run);
    QVERIFY2(bool(shrunk), shrunk ? "" : shrunk.diagnostics().front().text().c_str());
    QCOMPARE(shrunk->request.spec.set,
             (std::vector<std::string>{"agents=[p07]", "obstacles=[]", "robot1.planner=orca",
                                       "robot1.max_vel=0.8", "variation.preset=none"}));
    QCOMPARE(shrunk->request.spec.duration, std::optional(10.05));  // a step after its end
    QCOMPARE(shrunk->peopleBefore, std::size_t{12});
    QCOMPARE(shrunk->people, std::size_t{1});
    QCOMPARE(shrunk->removed.size(), std::size_t{12});  // eleven people and the hall
    QCOMPARE(shrunk->reset,
             (std::vector<std::string>{"p03.max_vel", "p07.max_vel", "variation.preset"}));
    QVERIFY(shrunk->isMinimal);
    QVERIFY(shrunk->runs < 200);
  }

  void shrinking_contactsStayAvoidable() {
    RunRequest failing;
    failing.scenario = kCrossing;
    const auto run = [](const std::vector<RunRequest>& requests) {
      return Rows(std::vector<ResultRow>(requests.size(), rowOf(true, 0.0)));
    };
    // The contact could have been avoided only while persons 2 and 9 are there.
    const auto judge = [](const RunRequest& request) {
      const std::string agents = valueOf(request, "agents");
      const bool hasBoth =
          agents.find("p02") != std::string::npos && agents.find("p09") != std::string::npos;
      return base::Result<bool>(agents.empty() || hasBoth);
    };
    const app::FailureKind kind = *app::failureKindOf(rowOf(true, 0.0));
    const auto shrunk = app::shrunkFailure(failing, rowOf(true, 0.0), kind, 400, run, judge);
    QVERIFY(bool(shrunk));
    QCOMPARE(valueOf(shrunk->request, "agents"), std::string("[p02, p09]"));
  }

  void shrinking_limitOfRuns_isKept() {
    RunRequest failing;
    failing.scenario = kCrossing;
    std::size_t executed = 0;
    const auto run = [&executed](const std::vector<RunRequest>& requests) {
      executed += requests.size();
      return Rows(std::vector<ResultRow>(requests.size(), rowOf(false, 1.0)));
    };
    const app::FailureKind kind = *app::failureKindOf(rowOf(true, 0.0));
    const auto shrunk = app::shrunkFailure(failing, rowOf(true, 0.0), kind, 6, run);
    QVERIFY(bool(shrunk));
    QVERIFY(!shrunk->isMinimal);
    QVERIFY(executed <= 7);  // one more for the duration
    QVERIFY(shrunk->removed.empty());
  }

  void standaloneScenario_repeatsTheRun() {
    QTemporaryDir folder;
    const auto pool = app::RunPool::open({});
    RunRequest request;
    request.scenario = SOURCE_DIR "/maps/two_workers/two_workers_agents.yaml";  // map and trees
    request.seed = 4;
    request.spec.duration = 6.0;
    request.spec.set = {"robot1.max_vel=0.7"};
    const sim2d::Scenario original = sim2d::readScenario(request.scenario).scenario;
    request.spec.set.push_back("agents=[" + original.humans.front().name + "]");
    const Rows rows = (*pool)->run({request});
    QVERIFY(rows && rows->front().ok);
    const std::string path = folder.filePath(QStringLiteral("small.yaml")).toStdString();
    const auto scenario = app::standaloneScenario(request, path, {});
    QVERIFY(bool(scenario));
    QCOMPARE(scenario->humans.size(), std::size_t{1});
    const std::string text = sim2d::writeScenario(*scenario);
    const auto repeated = app::runOfScenarioText(text, path, request, {});
    QVERIFY(bool(repeated));
    QVERIFY2(repeated->ok, repeated->reason.c_str());
    QVERIFY(app::areEqualRuns(*repeated, rows->front()));
    RunRequest other = request;
    other.seed = 5;
    QVERIFY(!app::areEqualRuns(*repeated, (*pool)->run({other})->front()));
  }
};

QTEST_APPLESS_MAIN(SearchTest)
#include "tst_Search.moc"
