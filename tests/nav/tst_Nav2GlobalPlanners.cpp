#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/MetaTypes.h"

using costs::pose;
using namespace sim2d::nav2;

/// A planner, two cluttered maps (side, seed), and the cells (i, i) of start and goal.
struct Repetition {
  GlobalPlannerParameters parameters;
  Distro distro = Distro::Main;
  std::pair<int, std::uint64_t> map, otherMap;
  int from = 0, to = 0;
};
Q_DECLARE_METATYPE(Repetition)

namespace {

template <class Parameters>
std::set<std::string> namesOf(const Parameters& parameters) {
  std::set<std::string> names;
  std::size_t count = ignoredKeysOf(parameters).size();
  for (const auto& key : keysOf(parameters)) {
    names.insert(key.name);
    if (std::string(key.meaning).empty()) {
      return {};
    }
    ++count;
  }
  for (const IgnoredKey& key : ignoredKeysOf(parameters)) {
    names.insert(key.name);
    if (std::string(key.why).empty()) {
      return {};
    }
  }
  return names.size() == count ? names : std::set<std::string>{};  // none twice
}

}  // namespace

/// What there is by name, its keys, and paths through several goals.
class Nav2GlobalPlannersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plugin_bothSpellings_areTheSame_data() {
    QTest::addColumn<QString>("slash");
    QTest::addColumn<QString>("colons");
    QTest::addColumn<int>("which");
    const auto row = [](const char* package, const char* name, int which) {
      QTest::newRow(name) << QStringLiteral("%1/%2").arg(QLatin1String(package),
                                                         QLatin1String(name))
                          << QStringLiteral("%1::%2").arg(QLatin1String(package),
                                                          QLatin1String(name))
                          << which;
    };
    row("nav2_navfn_planner", "NavfnPlanner", 0);
    row("nav2_theta_star_planner", "ThetaStarPlanner", 1);
    row("nav2_smac_planner", "SmacPlanner2D", 2);
    row("nav2_smac_planner", "SmacPlannerHybrid", 3);
  }

  void plugin_bothSpellings_areTheSame() {
    QFETCH(QString, slash);
    QFETCH(QString, colons);
    QFETCH(int, which);
    for (const QString& name : {slash, colons}) {
      const auto answer = globalPlannerPlugin(name.toStdString(), Distro::Jazzy);
      QVERIFY(answer.parameters.has_value());
      QCOMPARE(answer.name, colons.toStdString());
      QCOMPARE(int(answer.parameters->index()), which);
      QVERIFY(answer.why.empty());
    }
  }

  void plugin_oldSmac_saysWhyAndWhatIsNearest() {
    const auto answer = globalPlannerPlugin("nav2_smac_planner/SmacPlanner", Distro::Humble);
    QVERIFY(!answer.parameters.has_value());
    QCOMPARE(answer.name, std::string("nav2_smac_planner::SmacPlannerHybrid"));
    QVERIFY(answer.why.find("before Humble") != std::string::npos);
  }

  void plugin_misspelt_findsTheNearest_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("nearest");
    QTest::newRow("letters") << "nav2_navfn_planer::NavFnPlanner"
                             << "nav2_navfn_planner::NavfnPlanner";
    QTest::newRow("package") << "navfn::NavfnPlanner"
                             << "nav2_navfn_planner::NavfnPlanner";
    QTest::newRow("number") << "nav2_smac_planner/SmacPlanner2d"
                            << "nav2_smac_planner::SmacPlanner2D";
  }

  void plugin_misspelt_findsTheNearest() {
    QFETCH(QString, name);
    QFETCH(QString, nearest);
    const auto answer = globalPlannerPlugin(name.toStdString(), Distro::Jazzy);
    QVERIFY(!answer.parameters.has_value());
    QCOMPARE(answer.name, nearest.toStdString());
  }

  void plugin_nonsense_findsNothing() {
    const auto answer = globalPlannerPlugin("my_robot::BugPlanner", Distro::Jazzy);
    QVERIFY(!answer.parameters.has_value());
    QVERIFY(answer.name.empty() && answer.why.empty());
  }

  void plugin_defaults_areNavs() {
    const auto hybrid = [](Distro distro) {
      return std::get<SmacHybridParameters>(
          *globalPlannerPlugin("nav2_smac_planner::SmacPlannerHybrid", distro).parameters);
    };
    QCOMPARE(hybrid(Distro::Jazzy).allowPrimitiveInterpolation, false);
    QCOMPARE(hybrid(Distro::Main).allowPrimitiveInterpolation, true);
    QCOMPARE(hybrid(Distro::Main).angleQuantizationBins, 72);
    QCOMPARE(hybrid(Distro::Main).minimumTurningRadius, 0.4);
    QCOMPARE(hybrid(Distro::Main).tolerance, 0.25);
    QCOMPARE(hybrid(Distro::Main).maxPlanningTime, 5.0);
    const auto smac = std::get<Smac2DParameters>(
        *globalPlannerPlugin("nav2_smac_planner::SmacPlanner2D", Distro::Jazzy).parameters);
    QCOMPARE(smac.tolerance, 0.125);
    QCOMPARE(smac.maxPlanningTime, 2.0);
    QCOMPARE(smac.smootherRefinementNum, 2);
  }

  void plugin_everyDistro_makesOneThatPlans_data() {
    QTest::addColumn<Distro>("distro");
    QTest::newRow("Humble") << Distro::Humble;
    QTest::newRow("Jazzy") << Distro::Jazzy;
    QTest::newRow("Main") << Distro::Main;
  }

  void plugin_everyDistro_makesOneThatPlans() {
    QFETCH(Distro, distro);
    const Costmap costmap(60, 60, 0.1, Vec2::Zero());
    for (const std::string& name : globalPlannerPluginNames()) {
      const auto parameters = *globalPlannerPlugin(name, distro).parameters;
      QVERIFY(parameterErrors(parameters).empty());
      const auto planner = makeGlobalPlanner(parameters, distro);
      const PlanResult result = planner->plan({costmap, pose(1.04, 1.02), pose(4.52, 4.04)});
      QVERIFY2(result.error == PlanError::None, name.c_str());
      QVERIFY(result.iterations > 0);
      QVERIFY((result.path.front().position - Vec2(1.04, 1.02)).norm() < 0.15);
      QVERIFY((result.path.back().position - Vec2(4.52, 4.04)).norm() < 0.15);
      const double straight = std::hypot(3.48, 3.02);
      QVERIFY(costs::lengthOf(result.path) > straight - 0.15);
      QVERIFY(costs::lengthOf(result.path) < 1.2 * straight);
    }
  }

  void plan_tinyMaps_answersHoldTogether() {
    costs::Numbers numbers(3);
    int found = 0, failed = 0;
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      for (const std::string& name : globalPlannerPluginNames()) {
        const auto planner =
            makeGlobalPlanner(*globalPlannerPlugin(name, distro).parameters, distro);
        for (int i = 0; i < 300; ++i) {
          const int width = 1 + i % 7, height = 1 + (i / 7) % 6;
          Costmap costmap(width, height, 0.3, {-1.0, 2.0});
          for (std::uint8_t& cost : costmap.costs()) {
            const double kind = numbers.next();
            cost = static_cast<std::uint8_t>(kind < 0.6   ? 0
                                             : kind < 0.8 ? 256.0 * numbers.next()
                                                          : 254);
          }
          const auto random = [&] {
            return pose(-1.0 + 0.3 * numbers.between(-0.1, width + 0.1),
                        2.0 + 0.3 * numbers.between(-0.1, height + 0.1),
                        numbers.between(-4.0, 4.0));
          };
          const Pose2 start = random(), goal = random();
          const PlanResult result = planner->plan({costmap, start, goal});
          QCOMPARE(result.error == PlanError::None, !result.path.empty());
          ++(result.path.empty() ? failed : found);
          for (const Pose2& each : result.path) {
            QVERIFY(each.position.allFinite() && std::isfinite(each.heading));
            const Vec2 cells = (each.position - costmap.origin()) / costmap.resolution();
            QVERIFY(cells.x() > -0.51 && cells.y() > -0.51);  // NavFn rounds
            QVERIFY(cells.x() < width + 0.01 && cells.y() < height + 0.01);
          }
          if (!costmap.worldToCell(start.position)) {
            QVERIFY(result.error == PlanError::StartOutsideMap);
          } else if (!costmap.worldToCell(goal.position)) {
            QVERIFY(result.error == PlanError::GoalOutsideMap ||
                    result.error == PlanError::StartOutsideMap);  // rounded off the map
          }
        }
      }
    }
    QVERIFY(found > 300 && failed > 300);
  }

  void plan_again_isTheSame_data() {
    QTest::addColumn<Repetition>("trial");
    SmacHybridParameters reedsShepp;
    reedsShepp.motionModelForSearch = "REEDS_SHEPP";
    reedsShepp.minimumTurningRadius = 0.5;
    reedsShepp.smoothPath = false;
    reedsShepp.maxIterations = 5000;
    QTest::newRow("NavFn") << Repetition{NavfnParameters(), Distro::Jazzy, {80, 3}, {60, 4}, 4, 50};
    QTest::newRow("Theta*") << Repetition{
        ThetaStarParameters(), Distro::Jazzy, {70, 2}, {50, 7}, 3, 44};
    QTest::newRow("Smac 2D") << Repetition{
        Smac2DParameters(), Distro::Main, {70, 2}, {50, 7}, 3, 44};
    QTest::newRow("Smac Hybrid") << Repetition{reedsShepp, Distro::Main, {90, 8}, {60, 5}, 4, 54};
  }

  void plan_again_isTheSame() {
    QFETCH(Repetition, trial);
    const auto planner = makeGlobalPlanner(trial.parameters, trial.distro);
    const Costmap first = costs::cluttered(trial.map.first, trial.map.second);
    const Costmap second = costs::cluttered(trial.otherMap.first, trial.otherMap.second);
    const Pose2 start{first.cellToWorld({trial.from, trial.from}), 0.5};
    const Pose2 goal{first.cellToWorld({trial.to, trial.to}), 1.0};
    const PlanResult one = planner->plan({first, start, goal});
    planner->plan({second, start, goal});
    const PlanResult again = planner->plan({first, start, goal});
    QVERIFY(one.error == PlanError::None);
    QCOMPARE(again.path, one.path);
    QCOMPARE(again.iterations, one.iterations);
  }
  void plan_stopped_throws_data() { plan_again_isTheSame_data(); }

  void plan_stopped_throws() {
    QFETCH(Repetition, trial);
    const Costmap costmap(50, 50, 1.0, Vec2::Zero());
    base::StopFlag stop;
    stop.stop();
    PlanRequest request(costmap, pose(5, 5), pose(40, 40));
    request.stop = &stop;
    const auto planner = makeGlobalPlanner(trial.parameters, trial.distro);
    QVERIFY_EXCEPTION_THROWN(planner->plan(request), base::Stopped);
  }

  void keys_everyComponent_areUniqueAndTold() {
    for (const std::string& name : globalPlannerPluginNames()) {
      const auto parameters = *globalPlannerPlugin(name, Distro::Jazzy).parameters;
      QVERIFY2(std::visit([](const auto& given) { return namesOf(given).size() > 4; }, parameters),
               name.c_str());
    }
    for (const std::string& name : pathSmootherPluginNames()) {
      const auto parameters = *pathSmootherPlugin(name, Distro::Jazzy).parameters;
      QVERIFY2(std::visit([](const auto& given) { return namesOf(given).size() > 4; }, parameters),
               name.c_str());
    }
    QCOMPARE(namesOf(PlannerServerParameters()).count("expected_planner_frequency"),
             std::size_t{1});
    QCOMPARE(namesOf(SmootherServerParameters()).count("smoother_plugins"), std::size_t{1});
  }

  void keys_ofADistro_areFilled() {
    const Nav2ParameterBlock block = {{"tolerance", 0.3},
                                      {"max_iterations", 77},
                                      {"smoother.w_data", 0.1},
                                      {"use_quadratic_cost_penalty", true},
                                      {"goal_heading_mode", std::string("BIDIRECTIONAL")}};
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      base::Diagnostics problems;
      const SmacHybridParameters found = applyBlock(
          SmacHybridParameters(), keysOf(SmacHybridParameters()), block, distro, problems);
      QVERIFY(problems.empty());
      QCOMPARE(found.tolerance, 0.3);
      QCOMPARE(found.maxIterations, 77);
      QCOMPARE(found.smootherWData, 0.1);
      QCOMPARE(found.useQuadraticCostPenalty, distro != Distro::Humble);
      QCOMPARE(found.goalHeadingMode == "BIDIRECTIONAL", distro == Distro::Main);
    }
  }

  void complaints_badValues_nameTheKey() {
    ThetaStarParameters theta;
    theta.howManyCorners = 6;
    QCOMPARE(parameterErrors(GlobalPlannerParameters(theta)),
             (std::vector<std::string>{"how_many_corners is 6, not 4 or 8"}));
    SmacHybridParameters hybrid;
    hybrid.motionModelForSearch = "DUBINS";
    hybrid.analyticExpansionRatio = 0.0;
    const std::vector<std::string> found = parameterErrors(GlobalPlannerParameters(hybrid));
    QCOMPARE(found.size(), std::size_t{2});
    QCOMPARE(found[0],
             std::string("motion_model_for_search is 'DUBINS', not one of DUBIN, REEDS_SHEPP"));
    QCOMPARE(found[1], std::string("analytic_expansion_ratio is 0, not 0.001 to 1000000"));
    NavfnParameters navfn;
    navfn.tolerance = std::nan("");
    QCOMPARE(parameterErrors(GlobalPlannerParameters(navfn)).size(), std::size_t{1});
    SavitzkyGolayParameters golay;
    golay.windowSize = 6;
    QCOMPARE(parameterErrors(PathSmootherParameters(golay)),
             (std::vector<std::string>{"window_size is even"}));
  }

  void smootherPlugin_names_areKnown() {
    const auto simple = pathSmootherPlugin("nav2_smoother/SimpleSmoother", Distro::Humble);
    QVERIFY(simple.parameters.has_value());
    QCOMPARE(simple.name, std::string("nav2_smoother::SimpleSmoother"));
    QVERIFY(pathSmootherPlugin("nav2_smoother::SavitzkyGolaySmoother", Distro::Jazzy).parameters);
    const auto constrained =
        pathSmootherPlugin("nav2_constrained_smoother/ConstrainedSmoother", Distro::Jazzy);
    QVERIFY(std::holds_alternative<ConstrainedSmootherParameters>(*constrained.parameters));
  }

  void planError_names_areThoseOfTheMessage() {
    QCOMPARE(int(PlanError::StartOutsideMap), 203);
    QCOMPARE(int(PlanError::NoValidPath), 208);
    QCOMPARE(QLatin1String(planErrorName(PlanError::GoalOccupied)), QLatin1String("GOAL_OCCUPIED"));
    QCOMPARE(QLatin1String(planErrorMessage(PlanError::None)), QLatin1String(""));
    QCOMPARE(QLatin1String(smoothErrorName(SmoothError::SmoothedPathInCollision)),
             QLatin1String("SMOOTHED_PATH_IN_COLLISION"));
  }

  void throughPoses_legs_areJoined() {
    const Costmap costmap(40, 40, 0.1, Vec2::Zero());
    const auto planner = makeGlobalPlanner(NavfnParameters(), Distro::Jazzy);
    const std::vector<Pose2> goals = {pose(3.0, 1.0), pose(3.0, 3.0, 1.0)};
    const ThroughPosesResult result =
        planThroughPoses(*planner, {costmap, pose(1.0, 1.0), {}}, goals);
    QVERIFY(result.error == PlanError::None);
    QVERIFY(result.isComplete);
    QCOMPARE(result.reached, 1);
    const Path first = planner->plan({costmap, pose(1.0, 1.0), goals[0]}).path;
    const Path second = planner->plan({costmap, goals[0], goals[1]}).path;
    QCOMPARE(result.path.size(), first.size() + second.size());
    QCOMPARE(result.path[first.size() - 1].position, goals[0].position);
    QVERIFY((result.path[first.size()].position - goals[0].position).norm() < 1e-6);
    QCOMPARE(result.path.back(), goals[1]);
  }

  void throughPoses_firstLegEndsBeside_nextStartsThere() {
    Costmap costmap(40, 40, 0.1, Vec2::Zero());
    fillWindow(costmap, {29, 9, 32, 12}, 254);
    const auto planner = makeGlobalPlanner(NavfnParameters(), Distro::Jazzy);
    const ThroughPosesResult result =
        planThroughPoses(*planner, {costmap, pose(1.0, 1.0), {}}, {pose(3.0, 1.0), pose(3.0, 3.0)});
    QVERIFY(result.isComplete);
    const Pose2 beside = planner->plan({costmap, pose(1.0, 1.0), pose(3.0, 1.0)}).path.back();
    QVERIFY((beside.position - Vec2(3.0, 1.0)).norm() > 0.15);
    const Path second = planner->plan({costmap, beside, pose(3.0, 3.0)}).path;
    QCOMPARE(
        Path(result.path.end() - static_cast<std::ptrdiff_t>(second.size()), result.path.end()),
        second);
  }

  void throughPoses_closedGoal_failsOrIsPart() {
    const Costmap costmap = costs::drawn({"......#..", "......#..", "......#..", "......#.."}, 1.0);
    NavfnParameters parameters;
    const auto planner = makeGlobalPlanner(parameters, Distro::Main);
    const PlanRequest request(costmap, pose(1.0, 1.0), {});
    const std::vector<Pose2> goals = {pose(4.0, 2.0), pose(7.0, 1.0), pose(2.0, 1.0)};
    const ThroughPosesResult failed = planThroughPoses(*planner, request, goals);
    QVERIFY(failed.error == PlanError::NoValidPath);
    QVERIFY(failed.path.empty());
    const ThroughPosesResult part = planThroughPoses(*planner, request, goals, true);
    QVERIFY(part.error == PlanError::None);
    QVERIFY(!part.isComplete);
    QCOMPARE(part.reached, 0);
    QCOMPARE(part.path.back(), goals[0]);
    // A first leg that fails leaves nothing.
    QVERIFY(planThroughPoses(*planner, request, {goals[1]}, true).error == PlanError::NoValidPath);
  }

  void throughPoses_noGoals_isNoPath() {
    const Costmap costmap(5, 5, 1.0, Vec2::Zero());
    const auto planner = makeGlobalPlanner(NavfnParameters(), Distro::Main);
    QVERIFY(planThroughPoses(*planner, {costmap, pose(1, 1), {}}, {}).error ==
            PlanError::NoValidPath);
  }
};

QTEST_APPLESS_MAIN(Nav2GlobalPlannersTest)
#include "tst_Nav2GlobalPlanners.moc"
