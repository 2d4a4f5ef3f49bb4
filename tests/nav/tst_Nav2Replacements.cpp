#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

namespace {

std::string controllerOf(const std::string& plugin, const std::string& keys) {
  return "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
         "    FollowPath: {plugin: \"" +
         plugin + "\"" + (keys.empty() ? "" : ", ") + keys + "}\n";
}

template <class T>
T valueAt(const Nav2ReadResult& reading, const std::string& key) {
  return controllerValue(reading.parameters, key, T());
}

int countOf(const base::Diagnostics& problems, const std::string& code) {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(),
                    [&](const base::Diagnostic& each) { return each.code == code; }));
}

}  // namespace

/// Plugins of other packages, names of older branches, words of launch files.
class Nav2ReplacementsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void controller_ofAnotherPackage_isTheNearestOne_data() {
    QTest::addColumn<QString>("plugin");
    QTest::addColumn<QString>("keys");
    QTest::addColumn<QString>("is");
    QTest::addColumn<QString>("speedKey");
    QTest::addColumn<double>("speed");
    QTest::addColumn<QString>("turnKey");
    QTest::addColumn<double>("turn");
    const char* const mppi = "nav2_mppi_controller::MPPIController";
    const char* const dwb = "dwb_core::DWBLocalPlanner";
    const char* const pursuit =
        "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";
    QTest::newRow("TEB") << "teb_local_planner::TebLocalPlannerROS"
                         << "max_vel_x: 0.4, max_vel_theta: 0.7, weight_kinematics_nh: 1000.0"
                         << mppi << "vx_max" << 0.4 << "wz_max" << 0.7;
    QTest::newRow("vector pursuit")
        << "vector_pursuit_controller::VectorPursuitController"
        << "desired_linear_vel: 0.35, rotate_to_heading_angular_vel: 1.1, k: 8.0" << pursuit
        << "desired_linear_vel" << 0.35 << "rotate_to_heading_angular_vel" << 1.1;
    QTest::newRow("pure pursuit of a tutorial")
        << "nav2_pure_pursuit_controller::PurePursuitController"
        << "desired_linear_vel: 0.2, max_angular_vel: 1.0" << pursuit << "desired_linear_vel" << 0.2
        << "rotate_to_heading_angular_vel" << 0.0;
    QTest::newRow("anything") << "my_robot/Follower"
                              << "v_linear_max: 0.6, max_angular_velocity: 0.9" << dwb
                              << "max_vel_x" << 0.6 << "max_vel_theta" << 0.9;
    QTest::newRow("a fork of DWB") << "our_dwb::OurDWBPlanner"
                                   << "max_vel_x: 0.33, max_vel_theta: 0.5, critics: [PathDist]"
                                   << dwb << "max_vel_x" << 0.33 << "max_vel_theta" << 0.5;
    QTest::newRow("a value of a wrong type")
        << "my_robot/Follower"
        << "max_vel_x: fast, acc_lim_x: 1" << dwb << "max_vel_x" << 0.5 << "max_vel_theta" << 1.0;
  }

  void controller_ofAnotherPackage_isTheNearestOne() {
    QFETCH(QString, plugin);
    QFETCH(QString, keys);
    QFETCH(QString, is);
    QFETCH(QString, speedKey);
    QFETCH(double, speed);
    QFETCH(QString, turnKey);
    QFETCH(double, turn);
    for (const Distro distro : kDistros) {
      const Nav2ReadResult reading =
          readOf(controllerOf(plugin.toStdString(), keys.toStdString()), distro);
      QVERIFY2(reading.ok(), texts(reading.problems).c_str());
      QCOMPARE(countOf(reading.problems, "nav2.treated-as"), 1);
      QVERIFY2(!problemOf(reading.problems, "nav2.unknown-key"), texts(reading.problems).c_str());
      const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.treated-as");
      QCOMPARE(problem->line, 4);
      QCOMPARE(problem->value("found"), plugin.toStdString());
      QCOMPARE(valueAt<std::string>(reading, "FollowPath.plugin"), is.toStdString());
      QCOMPARE(valueAt<double>(reading, "FollowPath." + speedKey.toStdString()), speed);
      QCOMPARE(valueAt<double>(reading, "FollowPath." + turnKey.toStdString()), turn);
      QCOMPARE(noteOf(reading, "controller_server.FollowPath.plugin")->value, plugin.toStdString());
    }
  }

  void controller_withoutLimits_hasThoseOfTheSmoother() {
    const Nav2ReadResult reading = readOf(controllerOf("my_robot/Follower", "") +
                                          "velocity_smoother:\n  ros__parameters:\n"
                                          "    max_velocity: [0.8, 0.0, 1.7]\n"
                                          "    min_velocity: [-0.8, 0.0, -1.7]\n");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(valueAt<double>(reading, "FollowPath.max_vel_x"), 0.8);
    QCOMPARE(valueAt<double>(reading, "FollowPath.max_vel_theta"), 1.7);
  }

  /// 8 Hz: steps of 0.125 s, 22 of which are 2.75 s.
  void controller_mppiSteps_areNotShorterThanThePeriod() {
    const Nav2ReadResult reading =
        readOf(controllerOf("teb_local_planner::TebLocalPlannerROS", "min_turning_radius: 0.6") +
               "    controller_frequency: 8.0\n");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(valueAt<double>(reading, "FollowPath.model_dt"), 0.125);
    QCOMPARE(valueAt<int>(reading, "FollowPath.time_steps"), 22);
    QCOMPARE(valueAt<std::string>(reading, "FollowPath.motion_model"), std::string("Ackermann"));
    QCOMPARE(valueAt<double>(reading, "FollowPath.AckermannConstraints.min_turning_r"), 0.6);
  }

  /// DWB only rotates within its tolerance of the goal.
  void controller_dwb_hasTheToleranceOfTheGoalChecker() {
    const std::string text = controllerOf("my_robot/Follower", "max_vel_x: 0.3");
    QCOMPARE(valueAt<double>(readOf(text), "FollowPath.xy_goal_tolerance"), 0.25);
    const std::string fine = text +
                             "    goal_checker_plugins: [fine]\n"
                             "    fine: {plugin: \"nav2_controller::SimpleGoalChecker\", "
                             "xy_goal_tolerance: 0.05}\n";
    QCOMPARE(valueAt<double>(readOf(fine), "FollowPath.xy_goal_tolerance"), 0.05);
  }

  /// Problems of these values name the file and the line of the class.
  void controller_suppliedValues_haveThePositionOfTheClass() {
    const Nav2ReadResult reading =
        readOf(controllerOf("teb_local_planner::TebLocalPlannerROS", "max_vel_x: 0.4"));
    const KeyUsage* const speed = noteOf(reading, "controller_server.FollowPath.vx_max");
    QVERIFY(speed != nullptr);
    QCOMPARE(speed->file, std::string("p.yaml"));
    QCOMPARE(speed->line, 4);
    const Nav2ReadResult foxy =
        readOf("controller_server:\n  ros__parameters: {goal_checker_plugin: c}\n", Distro::Humble);
    const KeyUsage* const checkers = noteOf(foxy, "controller_server.goal_checker_plugins");
    QVERIFY(checkers != nullptr);
    QCOMPARE(checkers->file, std::string("p.yaml"));
  }

  void controller_valueFromOutside_counts() {
    ParameterFile file = parsed(controllerOf("my_robot/Follower", "max_vel_x: 0.3"));
    const Nav2ReadResult before = readNav2Parameters(file, {Distro::Jazzy, {}});
    QVERIFY(setNav2Value(file, before, "FollowPath.sim_time", "1.2").empty());
    const Nav2ReadResult after = readNav2Parameters(file, {Distro::Jazzy, {}});
    QCOMPARE(valueAt<double>(before, "FollowPath.sim_time"), 1.7);
    QCOMPARE(valueAt<double>(after, "FollowPath.sim_time"), 1.2);
    QCOMPARE(valueAt<double>(after, "FollowPath.max_vel_x"), 0.3);
  }

  void controller_belowAShim_isReplaced() {
    const std::string shim = "nav2_rotation_shim_controller::RotationShimController";
    const Nav2ReadResult flat =
        readOf(controllerOf(shim,
                            "primary_controller: \"teb_local_planner::TebLocalPlannerROS\", "
                            "max_vel_x: 0.4, angular_dist_threshold: 0.9"));
    QVERIFY2(flat.ok(), texts(flat.problems).c_str());
    QCOMPARE(countOf(flat.problems, "nav2.treated-as"), 1);
    QCOMPARE(valueAt<double>(flat, "FollowPath.vx_max"), 0.4);
    QCOMPARE(valueAt<double>(flat, "FollowPath.angular_dist_threshold"), 0.9);
    const Nav2ReadResult nested = readOf(
        controllerOf(shim,
                     "primary_controller: {plugin: \"teb_local_planner::TebLocalPlannerROS\", "
                     "max_vel_x: 0.4}, angular_dist_threshold: 0.9"),
        Distro::Main);
    QVERIFY2(nested.ok(), texts(nested.problems).c_str());
    QCOMPARE(valueAt<double>(nested, "FollowPath.primary_controller.vx_max"), 0.4);
    QCOMPARE(valueAt<double>(nested, "FollowPath.angular_dist_threshold"), 0.9);
  }

  void controller_misspelt_isAnError_data() {
    QTest::addColumn<QString>("plugin");
    QTest::newRow("class") << "dwb_core::DWBLocalPlaner";
    QTest::newRow("package") << "dwb_cor::DWBLocalPlanner";
    QTest::newRow("other class of a known package") << "nav2_mppi_controller::Controller";
  }

  void controller_misspelt_isAnError() {
    QFETCH(QString, plugin);
    const Nav2ReadResult reading = readOf(controllerOf(plugin.toStdString(), ""));
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unknown-plugin");
    QVERIFY2(problem != nullptr && !reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(problem->line, 4);
  }

  void checker_ofAnotherPackage_isTheSimpleOne() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(    goal_checker_plugins: [goal]
    progress_checker_plugins: [moves]
    goal: {plugin: "my_robot::PatientGoalChecker", xy_goal_tolerance: 0.15, patience: 3}
    moves: {plugin: "my_robot::Watch", movement_time_allowance: 4.0}
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(countOf(reading.problems, "nav2.treated-as"), 2);
    QCOMPARE(reading.problems.size(), std::size_t{2});
    QCOMPARE(xyGoalTolerance(reading.parameters), 0.15);
    QCOMPARE(valueAt<std::string>(reading, "moves.plugin"),
             std::string("nav2_controller::SimpleProgressChecker"));
    QCOMPARE(valueAt<double>(reading, "moves.movement_time_allowance"), 4.0);
  }

  void planner_ofAnotherPackage_isTheNearestOne_data() {
    QTest::addColumn<QString>("plugin");
    QTest::addColumn<int>("index");  // of GlobalPlannerParameters
    QTest::newRow("straight line") << "nav2_straightline_planner/StraightLine" << 0;
    QTest::newRow("anything") << "my_robot::RRTStar" << 0;
    QTest::newRow("a fork of Theta*") << "lazy_theta_star_p_planner/LazyThetaStar" << 1;
    QTest::newRow("a fork of Hybrid-A*") << "our_smac/SmacPlannerHybridPlus" << 3;
  }

  void planner_ofAnotherPackage_isTheNearestOne() {
    QFETCH(QString, plugin);
    QFETCH(int, index);
    const Nav2ReadResult reading =
        readOf(kPursuit +
               "planner_server:\n  ros__parameters:\n    planner_plugins: [GridBased]\n"
               "    GridBased: {plugin: \"" +
               plugin.toStdString() + "\", allow_unknown: false, tolerance: 1, ways: [a, b]}\n");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(reading.problems.size(), std::size_t{1});
    QCOMPARE(countOf(reading.problems, "nav2.treated-as"), 1);
    const GlobalPlannerParameters& planner = reading.parameters.planners.front().second;
    QCOMPARE(static_cast<int>(planner.index()), index);
    QVERIFY(!std::visit([](const auto& held) { return held.allowUnknown; }, planner));
  }

  void smootherAndBehavior_ofAnotherPackage() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(smoother_server:
  ros__parameters:
    smoother_plugins: [smooth]
    smooth: {plugin: "my_robot::BSpline", tolerance: 1.0e-9}
behavior_server:
  ros__parameters:
    behavior_plugins: [spin, dance]
    spin: {plugin: "nav2_behaviors::Spin"}
    dance: {plugin: "my_robot::Dance", turns: 3}
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(countOf(reading.problems, "nav2.treated-as"), 1);
    QCOMPARE(countOf(reading.problems, "nav2.left-out"), 1);
    QCOMPARE(reading.problems.size(), std::size_t{2});
    QVERIFY(reading.parameters.behaviors.hasSpin);
    QCOMPARE(
        std::get<SimpleSmootherParameters>(reading.parameters.smoothers.front().second).tolerance,
        1e-9);
  }

  void critics_ofOtherPackages_areLeftOut() {
    const Nav2ReadResult dwb =
        readOf(controllerOf("dwb_core::DWBLocalPlanner",
                            "max_vel_x: 0.3, max_vel_theta: 1.0, critics: [PathDist, "
                            "\"social_critics::PersonalSpace\"], "
                            "trajectory_generator_name: \"our_dwb::Generator\""));
    QVERIFY2(dwb.ok(), texts(dwb.problems).c_str());
    QCOMPARE(countOf(dwb.problems, "nav2.left-out"), 1);
    QCOMPARE(countOf(dwb.problems, "nav2.treated-as"), 1);
    const Nav2ReadResult mppi =
        readOf(controllerOf("nav2_mppi_controller::MPPIController",
                            "critics: [CostCritic, SocialCritic, PathFollowCritic]"));
    QVERIFY2(mppi.ok(), texts(mppi.problems).c_str());
    QCOMPARE(countOf(mppi.problems, "nav2.left-out"), 1);
    const Nav2ReadResult wrong = readOf(controllerOf("nav2_mppi_controller::MPPIController",
                                                     "critics: [CostCritc, PathFollowCritic]"));
    QVERIFY(!wrong.ok());
  }

  void oldNames_areTheirNewerNames() {
    const Nav2ReadResult reading = readOf(R"(controller_server:
  ros__parameters:
    controller_plugins: [FollowPath]
    goal_checker_plugin: "checker"
    checker: {plugin: "nav2_controller::StoppedGoalChecker", xy_goal_tolerance: 0.12}
    FollowPath:
      plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController"
local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [seen]
      seen: {plugin: "nav2_costmap_2d::ObstacleLayer", observation_sources: scan,
             scan: {topic: /scan, obstacle_range: 4.0, raytrace_range: 6.0}}
recoveries_server:
  ros__parameters:
    recovery_plugins: ["spin"]
    spin: {plugin: "nav2_recoveries/Spin"}
)",
                                          Distro::Humble);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(countOf(reading.problems, "nav2.older-branch"), 3);
    QVERIFY2(!problemOf(reading.problems, "nav2.unknown-key"), texts(reading.problems).c_str());
    QCOMPARE(xyGoalTolerance(reading.parameters), 0.12);
    QVERIFY(reading.parameters.behaviors.hasSpin && !reading.parameters.behaviors.hasWait);
    const auto& seen =
        std::get<ObstacleLayerParameters>(reading.parameters.localCostmap.plugins[0].parameters);
    QCOMPARE(seen.sources[0].obstacleMaxRange, 4.0);
    QCOMPARE(seen.sources[0].raytraceMaxRange, 6.0);
  }

  void oldNames_ofTrees_areTheirNewerNames_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("tree");
    QTest::addColumn<QString>("read");
    QTest::newRow("Foxy") << "default_bt_xml_filename"
                          << "/opt/ros/foxy/share/nav2_bt_navigator/behavior_trees/"
                             "navigate_w_replanning_and_recovery.xml"
                          << "navigate_to_pose_w_replanning_and_recovery.xml";
    QTest::newRow("Eloquent") << "bt_xml_filename"
                              << "trees/mine.xml"
                              << "trees/mine.xml";
  }

  void oldNames_ofTrees_areTheirNewerNames() {
    QFETCH(QString, key);
    QFETCH(QString, tree);
    QFETCH(QString, read);
    const std::string text =
        kPursuit + "bt_navigator:\n  ros__parameters: {" + key.toStdString() + ": \"" +
        tree.toStdString() +
        "\"}\nrecoveries_server:\n  ros__parameters: {use_sim_time: true}\n"
        "local_costmap:\n  local_costmap_client:\n    ros__parameters: {use_sim_time: true}\n"
        "global_costmap:\n  global_costmap_client:\n    ros__parameters: {use_sim_time: true}\n";
    const Nav2ReadResult reading = readOf(text, Distro::Humble);
    QCOMPARE(QString::fromStdString(reading.parameters.btNavigator.defaultNavToPoseBtXml), read);
    QCOMPARE(reading.problems.size(), std::size_t{1});
    QCOMPARE(countOf(reading.problems, "nav2.older-branch"), 1);
    // Since Humble the key has no effect.
    const Nav2ReadResult humble =
        readOf(kPursuit + "bt_navigator:\n  ros__parameters: {default_bt_xml_filename: a.xml}\n",
               Distro::Humble);
    QCOMPARE(humble.parameters.btNavigator.defaultNavToPoseBtXml, std::string());
  }

  void oldNames_ofEloquent_nameClassesInLists() {
    const Nav2ReadResult reading = readOf(R"(controller_server:
  ros__parameters:
    controller_plugin_types: ["dwb_core::DWBLocalPlanner"]
    controller_plugin_ids: ["Drive"]
    Drive.max_vel_x: 0.31
    Drive.max_vel_theta: 1.0
    Drive.critics: [PathDist]
planner_server:
  ros__parameters:
    planner_plugin_types: ["nav2_navfn_planner/NavfnPlanner"]
    planner_plugin_ids: ["GridBased"]
    GridBased.tolerance: 2.0
global_costmap:
  global_costmap:
    ros__parameters:
      plugin_names: ["map", "inflation"]
      plugin_types: ["nav2_costmap_2d::StaticLayer", "nav2_costmap_2d::InflationLayer"]
      inflation.cost_scaling_factor: 3.5
)",
                                          Distro::Humble);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(valueAt<double>(reading, "Drive.max_vel_x"), 0.31);
    QCOMPARE(reading.parameters.planners.front().first, std::string("GridBased"));
    QCOMPARE(std::get<NavfnParameters>(reading.parameters.planners.front().second).tolerance, 2.0);
    const auto& layers = reading.parameters.globalCostmap.plugins;
    QCOMPARE(layers.size(), std::size_t{2});
    QCOMPARE(std::get<InflationLayerParameters>(layers[1].parameters).costScalingFactor, 3.5);
  }

  /// Iron's file has the keys of Jazzy, but the corners as numbers.
  void points_ofIron_areReadAsText() {
    const std::string text = kPursuit +
                             "collision_monitor:\n  ros__parameters:\n    polygons: [Stop]\n"
                             "    Stop:\n      {type: polygon, action_type: stop, min_points: 4,\n"
                             "       points: [0.4, 0.35, 0.4, -0.3, -0.2, 0.0]}\n";
    const Nav2ReadResult jazzy = readOf(text, Distro::Jazzy);
    QVERIFY2(jazzy.ok(), texts(jazzy.problems).c_str());
    QCOMPARE(jazzy.problems.size(), std::size_t{1});
    const base::Diagnostic& problem = jazzy.problems.front();
    QCOMPARE(problem.code, std::string_view("nav2.points-of-iron"));
    QCOMPARE(problem.file, std::string("p.yaml"));
    QCOMPARE(problem.line, 10);
    QCOMPARE(jazzy.parameters.collisionMonitor->shapes.at(0).points,
             std::string("[[0.4, 0.35], [0.4, -0.3], [-0.2, 0.0]]"));
    const Nav2ReadResult humble = readOf(text, Distro::Humble);
    QCOMPARE(humble.parameters.collisionMonitor->shapes.at(0).pointList.size(), std::size_t{6});
    QVERIFY(!problemOf(humble.problems, "nav2.points-of-iron"));
    const std::string whole = text.substr(0, text.find("0.4, 0.35")) + "1, 0, 0, 1, 1, 1]}\n";
    QVERIFY(!readOf(whole, Distro::Jazzy).ok());
  }

  void placeholder_isAbsent() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(    controller_frequency: TO_BE_OVERRIDDEN
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.placeholder");
    QVERIFY(problem != nullptr);
    QCOMPARE(problem->line, 5);
    QCOMPARE(controllerValue(reading.parameters, "controller_frequency", 20.0), 20.0);
  }

  void placeholder_ofLaunchFiles_isAbsent() {
    const Nav2ReadResult reading = readOf(kPursuit + R"yaml(    controller_frequency: $(var rate)
local_costmap:
  local_costmap:
    ros__parameters:
      robot_radius: $(var radius)
      footprint: "$(var footprint)"
      plugins: $(var layers)
)yaml");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(countOf(reading.problems, "nav2.placeholder"), 4);
    QCOMPARE(reading.parameters.localCostmap.parameters.robotRadius, 0.1);
    QCOMPARE(reading.parameters.localCostmap.parameters.footprint, std::string("[]"));
  }

  void placeholder_listHasItsBlocks() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: TO_BE_OVERRIDDEN
      filters: [TO_BE_OVERRIDDEN]
      grown: {plugin: "nav2_costmap_2d::InflationLayer"}
      map: {plugin: "nav2_costmap_2d::StaticLayer"}
      slow: {plugin: "nav2_costmap_2d::SpeedFilter"}
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(countOf(reading.problems, "nav2.list-placeholder"), 2);
    const CostmapSettings& costmap = reading.parameters.localCostmap;
    QCOMPARE(costmap.plugins.size(), std::size_t{2});
    QCOMPARE(costmap.plugins[0].name, std::string("map"));  // the inflation comes last
    QCOMPARE(costmap.plugins[1].name, std::string("grown"));
    QCOMPARE(costmap.filters.size(), std::size_t{1});
  }

  void emptyList_ofPlanners_isAbsent() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(planner_server:
  ros__parameters:
    planner_plugins: [""]
)");
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QVERIFY(problemOf(reading.problems, "nav2.empty-list"));
    QCOMPARE(reading.parameters.planners.size(), std::size_t{1});
  }
};

QTEST_GUILESS_MAIN(Nav2ReplacementsTest)
#include "tst_Nav2Replacements.moc"
