#include <algorithm>
#include <cmath>
#include <memory>

#include <QTemporaryDir>
#include <QtTest>

#include "app/studies/Tune.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace {

constexpr double kNone = statistics::kUndefined;

app::TuneOutcome outcome(bool isSuccess, double simulated, std::vector<double> values) {
  return {isSuccess, simulated, std::move(values)};
}

std::vector<app::TuneObjective> timeAndSpace() {
  return {*app::tuneObjective("time_to_reach_goal"),
          *app::tuneObjective("intimate_space_intrusions")};
}

/// The lines of two texts that differ.
std::size_t changedLines(const std::string& a, const std::string& b) {
  const std::vector<std::string> first = base::split(a, '\n'), second = base::split(b, '\n');
  std::size_t count = first.size() == second.size() ? 0 : 1000;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
    count += first[k] != second[k] ? 1 : 0;
  }
  return count;
}

}  // namespace

/// Tuning: lists of parameters, files, scores, and small searches.
class TuneTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> folder_;

  std::string at(const char* name) const {
    return folder_->filePath(QString::fromUtf8(name)).toStdString();
  }
  std::string written(const char* name, const std::string& text) const {
    base::writeFileAtomically(at(name), text);
    return at(name);
  }
  static std::string text(const std::string& file) { return *base::readTextFile(file); }

  /// A robot on an empty plane that drives 6 m with planner pursuit; the seed moves its start.
  std::string scene(const std::string& parameters) const {
    return written("scene.yaml",
                   "hunav_loader:\n  ros__parameters:\n    map: none\n    agents: []\n"
                   "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    map_file: none\n"
                   "    duration: 20.0\n    robots: [robot1]\n"
                   "    robot1:\n      start: {x: 0.0, y: 0.0, h: 1.2}\n"
                   "      goal: {x: 6.0, y: 2.0}\n      planner: pursuit\n" +
                       parameters);
  }
  /// A list with one parameter of pursuit.
  app::TuningList list() const {
    return *app::readTuningList(written("list.yaml",
                                        "hunavsim_tuning: 1\nplanners:\n  pursuit:\n"
                                        "    lookahead: {range: [0.1, 3.0], scale: log}\n"));
  }
  app::TuningList threeParameters() const {
    return *app::readTuningList(written("three.yaml",
                                        "hunavsim_tuning: 1\nplanners:\n  pursuit:\n"
                                        "    lookahead: {range: [0.1, 3.0], scale: log}\n"
                                        "    slow_distance: {range: [0.5, 4.0], scale: log}\n"
                                        "    stop_distance: {range: [0.2, 1.5], scale: log}\n"));
  }
  app::TuneOptions options(const std::string& scenario) const {
    app::TuneOptions options;
    options.scenarios = options.heldOut = {scenario};
    options.objectives = {*app::tuneObjective("path_length")};
    options.seeds = 2;
    options.heldOutSeeds = 2;
    options.runs = 90;
    return options;
  }
  static app::TuneSubject subject(const std::string& path, const app::TuningList& list) {
    app::RunSpec spec;
    spec.metrics = "path_length,success,completed";
    return *app::TuneSubject::open(path, list, {path}, spec);
  }
  static std::unique_ptr<app::RunPool> pool(int jobs, const std::string& journal = {},
                                            std::function<bool()> wantsStop = {}) {
    app::RunPoolOptions of;
    of.jobs = jobs;
    of.journal = journal;
    of.wantsStop = std::move(wantsStop);
    return *app::RunPool::open(std::move(of));
  }
  static std::string summary(const app::TuneResult& result) {
    std::string text = std::to_string(static_cast<int>(result.verdict)) + "\n";
    for (const app::TuneCandidate& candidate : result.candidates) {
      text += base::join(candidate.values, " ") + " " + base::formatDouble(candidate.score.total) +
              "\n";
    }
    return text + base::join(result.chosen.value_or(app::TunedValues()), " ");
  }

 private Q_SLOTS:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void list_shipped_isValid() {
    const auto list = app::readTuningList(SOURCE_DIR "/resources/tuning/parameters.yaml");
    QVERIFY(list && list.diagnostics().empty());
    QCOMPARE(list->controllers.size(), std::size_t{4});
    QVERIFY(list->planners.size() >= 6);
  }

  void list_mistakes_areReportedTogether() {
    const auto list =
        app::readTuningList(written("bad.yaml",
                                    "hunavsim_tuning: 1\nplanners:\n  pursuit:\n"
                                    "    lookahead: {range: [3.0, 0.1]}\n"
                                    "    slow_distance: {range: [0.0, 1.0], scale: log}\n"
                                    "    stop_distance: {range: [0.1, 1.0], scale: cubic}\n"
                                    "    more: {range: [0.1, 1.0], step: 2}\n"
                                    "others: {}\n"));
    QVERIFY(!list);
    QCOMPARE(list.diagnostics().size(), std::size_t{5});
    QVERIFY(base::endsWith(list.diagnostics().front().file, "bad.yaml"));
    QCOMPARE(list.diagnostics().front().line, 4);
    const auto other = app::readTuningList(written("other.yaml", "a: 1\n"));
    QVERIFY(!other && other.diagnostics().front().code == "tune.no-list");
  }

  void parameter_sharesAndTexts_areInverse() {
    const app::TunedParameter log = app::tunedParameter({"a", 0.1, 10.0, true}, 1.0, false);
    QCOMPARE(log.textAt(0.5), std::string("1.0"));
    QCOMPARE(log.textAt(0.25), std::string("0.316"));  // 10^-0.5
    QCOMPARE(log.shareOf(1.0), 0.5);
    const app::TunedParameter linear = app::tunedParameter({"b", 0.0, 40.0, false}, 3.0, true);
    QCOMPARE(linear.textAt(0.5), std::string("20"));
    QCOMPARE(linear.shareOf(10.0), 0.25);
    // The range is extended to the current value.
    const app::TunedParameter outside = app::tunedParameter({"c", 1.0, 2.0, false}, 4.0, false);
    QCOMPARE(outside.textAt(1.0), std::string("4.0"));
  }

  void nav2File_changedValues_differInTheirLinesOnly_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("controller");
    QTest::newRow("MPPI") << "resources/nav2_params/generic.yaml"
                          << "nav2_mppi_controller::MPPIController";
    QTest::newRow("DWB") << "maps/planners/nav2_dwb.yaml"
                         << "dwb_core::DWBLocalPlanner";
    QTest::newRow("RPP") << "maps/planners/nav2_rpp.yaml"
                         << "nav2_regulated_pure_pursuit_controller::"
                            "RegulatedPurePursuitController";
  }
  void nav2File_changedValues_differInTheirLinesOnly() {
    QFETCH(QString, file);
    QFETCH(QString, controller);
    const std::string path = SOURCE_DIR "/" + file.toStdString();
    const std::string scenario = SOURCE_DIR "/maps/planners/crossing_agents.yaml";
    const auto list = app::readTuningList(SOURCE_DIR "/resources/tuning/parameters.yaml");
    const auto tuned = app::TuneSubject::open(path, *list, {scenario}, app::RunSpec());
    QVERIFY2(bool(tuned),
             tuned.diagnostics().empty() ? "" : tuned.diagnostics().front().text().c_str());
    QCOMPARE(tuned->controller(), controller.toStdString());
    QVERIFY(tuned->parameters().size() >= 6);
    QCOMPARE(*tuned->textWith(tuned->present()), text(path));
    // Two values: two lines, which hold them; the runs get them too.
    app::TunedValues values = tuned->present();
    std::size_t given = 0;
    for (std::size_t k = 0; k < values.size() && given < 2; ++k) {
      if (changedLines(text(path), *tuned->textWith([&] {
            app::TunedValues one = tuned->present();
            one[k] = tuned->parameters()[k].textAt(0.37);
            return one;
          }())) == 1) {
        values[k] = tuned->parameters()[k].textAt(0.37);
        ++given;
      }
    }
    QCOMPARE(given, std::size_t{2});
    QCOMPARE(changedLines(text(path), *tuned->textWith(values)), std::size_t{2});
    const app::RunRequest request = tuned->request(scenario, 7, values);
    QCOMPARE(request.spec.nav2Params.size(), std::size_t{3});
    QCOMPARE(*request.spec.planner, std::string("nav2"));
    QCOMPARE(request.seed, 7LL);
  }

  void subject_unknownController_isReported() {
    const std::string path =
        written("nav2.yaml",
                "controller_server:\n  ros__parameters:\n    controller_plugins: [\"FollowPath\"]\n"
                "    FollowPath:\n      plugin: \"mine::Controller\"\n");
    const auto list = app::readTuningList(SOURCE_DIR "/resources/tuning/parameters.yaml");
    const auto tuned = app::TuneSubject::open(
        path, *list, {SOURCE_DIR "/maps/planners/crossing_agents.yaml"}, app::RunSpec());
    QVERIFY(!tuned);
    QCOMPARE(tuned.diagnostics().back().code, std::string_view("tune.unknown-controller"));
  }

  /// A file that does not have the parameter yet.
  void scenarioFile_newParameter_isReadAgain_data() {
    QTest::addColumn<QString>("parameters");
    QTest::addColumn<bool>("keepsLayout");
    QTest::newRow("no map") << "      max_vel: 0.8  # slow\n" << true;
    QTest::newRow("block map") << "      planner_parameters:\n        stop_distance: 0.4  # far\n"
                               << true;
    QTest::newRow("flow map") << "      planner_parameters: {stop_distance: 0.4}\n" << false;
  }
  void scenarioFile_newParameter_isReadAgain() {
    QFETCH(QString, parameters);
    QFETCH(bool, keepsLayout);
    const std::string path = scene(parameters.toStdString());
    const std::string changed = *subject(path, list()).textWith({"0.9"});
    const sim2d::ScenarioReading reading = sim2d::readScenarioText(changed, "scene.yaml");
    QVERIFY(reading.ok());
    const sim2d::ParameterTexts& now = reading.scenario.robots.front().plannerParameters;
    const std::pair<std::string, std::string> expected("lookahead", "0.9");
    QVERIFY(std::find(now.begin(), now.end(), expected) != now.end());
    if (keepsLayout) {
      const std::string before = text(path);
      const std::size_t comment = before.find("  #");
      QVERIFY(changed.find(before.substr(comment, 7)) != std::string::npos);
      QVERIFY(changed.size() < before.size() + 60);
    }
  }

  void objective_texts() {
    QCOMPARE(app::tuneObjective("success=3")->sign, -1.0);
    QCOMPARE(app::tuneObjective("success=3")->weight, 3.0);
    QCOMPARE(app::tuneObjective("time_to_reach_gaol").diagnostics().front().code,
             std::string_view("tune.unknown-objective"));
    QCOMPARE(app::tuneObjective("avg_robot_linear_speed").diagnostics().front().code,
             std::string_view("tune.neutral-objective"));
    QCOMPARE(app::tuneObjective("success=-1").diagnostics().front().code,
             std::string_view("tune.bad-weight"));
  }

  /// By hand: times 10 and 20 become 9 and 18 (-10 %); shares 10 and 30 become 12 and 24 (-10 %).
  void score_isTheMeanOfTheRatios() {
    const app::TuneOutcomes before = {outcome(true, 10.0, {10.0, 10.0}),
                                      outcome(true, 20.0, {20.0, 30.0})};
    const app::TuneScoring scoring(timeAndSpace(), 0.05, before);
    const app::TuneScore score =
        scoring.score({outcome(true, 9.0, {9.0, 12.0}), outcome(true, 18.0, {18.0, 24.0})}, before);
    QVERIFY(std::abs(score.ratios[0] - 0.9) < 1e-12);
    QVERIFY(std::abs(score.ratios[1] - 0.9) < 1e-12);
    QVERIFY(std::abs(score.total - 0.9) < 1e-12);
    QVERIFY(score.isAcceptable(0.0));
    QCOMPARE(scoring.score(before, before).total, 1.0);
  }

  /// By hand: the undefined time counts as the 40 s of the run (more than 20 s of the other one and
  /// than twice the mean of 15 s), so the times change by 0 and 20 s: ratio 1 + 10/15. The failure
  /// has severity 1 in one of two runs. Standard errors of (0, x): x / 2, so that neither the loss
  /// nor the failure exceeds its own.
  void score_failureAndUndefinedTime_count() {
    const app::TuneOutcomes before = {outcome(true, 10.0, {10.0}), outcome(true, 20.0, {20.0})};
    const app::TuneScoring scoring({*app::tuneObjective("time_to_reach_goal")}, 0.05, before);
    const app::TuneScore score =
        scoring.score({outcome(true, 10.0, {10.0}), outcome(false, 40.0, {kNone})}, before);
    QVERIFY(std::abs(score.ratios[0] - (1.0 + 10.0 / 15.0)) < 1e-12);
    QVERIFY(std::abs(score.failureError - 0.5) < 1e-12);
    QVERIFY(std::abs(score.total - (1.0 + 10.0 / 15.0 + 0.5)) < 1e-12);
    QVERIFY(std::abs(score.error - (20.0 / 15.0 + 1.0) / 2.0) < 1e-12);
    QVERIFY(!score.isAcceptable(0.05));
  }

  /// By hand: all four runs take 20 % longer, without spread: 0.15 beyond the accepted loss. All
  /// fail in the second case: 3 times the increase by 1, and severity 1.
  void score_certainLosses_arePenalised() {
    const app::TuneOutcomes before(4, outcome(true, 10.0, {10.0}));
    const app::TuneScoring scoring({*app::tuneObjective("time_to_reach_goal")}, 0.05, before);
    const app::TuneScore slow =
        scoring.score(app::TuneOutcomes(4, outcome(true, 12.0, {12.0})), before);
    QVERIFY(std::abs(slow.total - (1.2 + 5.0 * 0.15)) < 1e-12);
    const app::TuneScore failed =
        scoring.score(app::TuneOutcomes(4, outcome(false, 5.0, {kNone})), before);
    QVERIFY(std::abs(failed.total - (2.0 + 5.0 * 0.95 + 1.0 + 3.0)) < 1e-12);
  }

  /// By hand: no run arrives, but the share of the distance that is left is 0.2 instead of 1:
  /// severities 0.6 and 1.
  void score_failuresNearerToTheGoal_areBetter() {
    app::TuneOutcome far = outcome(false, 60.0, {kNone}), near = far;
    near.remaining = 0.2;
    const app::TuneOutcomes before(3, far);
    const app::TuneScoring scoring({*app::tuneObjective("time_to_reach_goal")}, 0.05, before);
    QVERIFY(std::abs(scoring.score(app::TuneOutcomes(3, near), before).total - 0.6) < 1e-12);
    QVERIFY(scoring.score(app::TuneOutcomes(3, outcome(true, 20.0, {20.0})), before).total < 0.3);
  }

  void outcome_ofAFailedRun_isUndefined() {
    app::ResultRow row;
    row.ok = true;
    row.simulated = "12.5";
    row.fields = {{"success", "False"},
                  {"intimate_space_intrusions", "3.0"},
                  {"goal_traversal_ratio", "0.25"}};
    const std::vector<app::TuneObjective> of = {*app::tuneObjective("intimate_space_intrusions"),
                                                *app::tuneObjective("success")};
    const app::TuneOutcome failed = app::outcomeOf(row, of);
    QVERIFY(!failed.isSuccess && std::isnan(failed.values[0]));
    QCOMPARE(failed.values[1], 0.0);
    QCOMPARE(failed.simulated, 12.5);
    QCOMPARE(failed.severity(), 0.625);
    row.fields[0].second = "True";
    QCOMPARE(app::outcomeOf(row, of).values[0], 3.0);
    QCOMPARE(app::outcomeOf(row, of).severity(), 0.0);
  }

  void improvement_needsConfidence() {
    const std::vector<app::TuneObjective> objectives = timeAndSpace();
    app::TuneEvaluation made;
    made.success = {0.9, 0.9, 0.0, {-0.1, 0.1}, 50};
    made.objectives = {{20.0, 18.0, -2.0, {-3.0, -1.0}, 45}, {10.0, 10.2, 0.2, {-1.0, 1.4}, 45}};
    QVERIFY(app::isImprovement(made, objectives, 0.05));
    made.objectives[1].difference = 1.0;  // 10 % worse
    QVERIFY(!app::isImprovement(made, objectives, 0.05));
    QVERIFY(app::isImprovement(made, objectives, 0.1));
    made.objectives[1].difference = 0.2;
    made.objectives[0].interval = {-4.1, 0.1};
    QVERIFY(!app::isImprovement(made, objectives, 0.05));
    made.success = {0.5, 0.9, 0.4, {0.2, 0.6}, 50};  // the robot arrives more often
    QVERIFY(app::isImprovement(made, objectives, 0.05));
    made.success = {0.9, 0.5, -0.4, {-0.6, -0.2}, 50};
    made.objectives[0].interval = {-3.0, -1.0};
    QVERIFY(!app::isImprovement(made, objectives, 0.05));
  }

  /// With a lookahead of 0.2 m the robot oscillates about its path.
  void search_sabotagedValue_recovers() {
    const std::string scenario =
        scene("      planner_parameters:\n        lookahead: 0.2  # short\n");
    const app::TuneSubject tuned = subject(scenario, list());
    const auto result = app::tune(options(scenario), tuned, *pool(2));
    QVERIFY(bool(result));
    QVERIFY(result->chosen.has_value());
    QVERIFY2(*base::parseDouble(result->chosen->front()) > 0.3, result->chosen->front().c_str());
    QVERIFY(result->verdict == app::TuneVerdict::Improved);
    QVERIFY(result->evaluation->objectives[0].difference < 0.0);
    QCOMPARE(result->effects.size(), std::size_t{1});
    QVERIFY(result->searchRuns <= 90);
    QCOMPARE(result->evaluationRuns, std::size_t{4});
    const std::string changed = *tuned.textWith(*result->chosen);
    QCOMPARE(changedLines(text(scenario), changed), std::size_t{1});
    QVERIFY(changed.find("  # short") != std::string::npos);
  }

  /// The default is among the first candidates; the list has two parameters that do not matter.
  void search_singleBadLine_isFoundByItsDefault() {
    const std::string scenario = scene(
        "      planner_parameters:\n        lookahead: 3.0  # far\n"
        "        slow_distance: 0.6\n");
    app::TuneOptions of = options(scenario);
    of.objectives = {*app::tuneObjective("path_length")};
    of.maxChanges = 1;
    const app::TuneSubject tuned = subject(scenario, threeParameters());
    QCOMPARE(*tuned.parameters()[0].fallback, 0.6);
    const auto result = app::tune(of, tuned, *pool(2));
    QVERIFY(bool(result));
    QVERIFY(!result->probes.empty());
    QCOMPARE(result->probes.front().from, std::string("3.0"));
    QCOMPARE(result->probes.front().to, std::string("0.6"));
    QVERIFY(result->chosen.has_value());
    QCOMPARE(changedLines(text(scenario), *tuned.textWith(*result->chosen)), std::size_t{1});
  }

  /// The limit of the runs is kept whatever it is.
  void search_limitOfRuns_isKept_data() {
    QTest::addColumn<int>("runs");
    for (const int runs : {24, 40, 70, 130}) {
      QTest::newRow(std::to_string(runs).c_str()) << runs;
    }
  }
  void search_limitOfRuns_isKept() {
    QFETCH(int, runs);
    const std::string scenario = scene("      planner_parameters:\n        lookahead: 0.2\n");
    app::TuneOptions of = options(scenario);
    of.seeds = 1;
    of.runs = static_cast<std::size_t>(runs);
    const auto result = app::tune(of, subject(scenario, threeParameters()), *pool(2));
    QVERIFY(bool(result));
    QVERIFY2(result->searchRuns <= of.runs, std::to_string(result->searchRuns).c_str());
    QVERIFY(result->chosen.has_value());
  }

  void search_anyJobs_andResumed_areEqual() {
    const std::string scenario = scene("      planner_parameters:\n        lookahead: 0.2\n");
    const app::TuneSubject tuned = subject(scenario, list());
    const std::string one = summary(*app::tune(options(scenario), tuned, *pool(1)));
    int asked = 0;
    const auto stopped =
        app::tune(options(scenario), tuned, *pool(2, at("journal"), [&] { return ++asked > 60; }));
    QVERIFY(!stopped);
    const std::unique_ptr<app::RunPool> resumed = pool(2, at("journal"));
    QCOMPARE(summary(*app::tune(options(scenario), tuned, *resumed)), one);
    QVERIFY(resumed->executed() < resumed->requested());
  }

  /// The parameter does not matter: the robot starts at its goal.
  void search_nothingToGain_saysSo() {
    const std::string scenario = written("still.yaml", text(scene("")));
    std::string still = text(scenario);
    const std::string goal = "goal: {x: 6.0, y: 2.0}";
    still.replace(still.find(goal), goal.size(), "goal: {x: 0.05, y: 0.0}");
    base::writeFileAtomically(scenario, still);
    app::TuneOptions of = options(scenario);
    of.runs = 30;
    const auto result = app::tune(of, subject(scenario, list()), *pool(2));
    QVERIFY(bool(result));
    QVERIFY(result->verdict == app::TuneVerdict::NoCandidate);
    QVERIFY(!result->chosen && !result->evaluation);
  }
};

QTEST_APPLESS_MAIN(TuneTest)
#include "tst_Tune.moc"
