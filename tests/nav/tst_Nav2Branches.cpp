#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

/// Which branch a nav2_params.yaml is for, and which keys and blocks it reads.
class Nav2BranchesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void guess_signs_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("distro");
    QTest::newRow("slash") << "planner_server:\n  ros__parameters:\n    G: {plugin: a/B}\n" << 0;
    QTest::newRow("colons") << "planner_server:\n  ros__parameters:\n    G: {plugin: 'a::B'}\n"
                            << 1;
    QTest::newRow("checker")
        << "controller_server:\n  ros__parameters: {progress_checker_plugin: p}\n"
        << 0;
    QTest::newRow("checkers")
        << "controller_server:\n  ros__parameters: {progress_checker_plugins: [p]}\n"
        << 1;
    QTest::newRow("handlers")
        << "controller_server:\n  ros__parameters: {path_handler_plugins: [p]}\n"
        << 3;
    QTest::newRow("prefixes")
        << "bt_navigator:\n  ros__parameters: {error_code_name_prefixes: [p]}\n"
        << 2;
    QTest::newRow("prefixes and directories")
        << "bt_navigator:\n  ros__parameters: {error_code_name_prefixes: [p], "
           "bt_search_directories: [d]}\n"
        << 3;
    QTest::newRow("code names") << "bt_navigator:\n  ros__parameters: {error_code_names: [p]}\n"
                                << 1;
    QTest::newRow("route server") << "route_server:\n  ros__parameters: {max_iterations: 0}\n" << 1;
    QTest::newRow("enabled monitor") << "collision_monitor:\n  ros__parameters: {enabled: true}\n"
                                     << 3;
    QTest::newRow("monitor")
        << "collision_monitor:\n  ros__parameters: {polygons: [Stop], Stop: {max_points: 3}}\n"
        << 0;
    const auto addKey = [](const char* name, const char* block, int distro) {
      QTest::newRow(name) << block << distro;
    };
    addKey("smoothed odometry", "bt_navigator:\n  ros__parameters: {filter_duration: 0.3}\n", 2);
    addKey("service introspection",
           "planner_server:\n  ros__parameters: {service_introspection_mode: disabled}\n", 2);
    addKey("footprint that is restored",
           "local_costmap:\n  local_costmap:\n    ros__parameters:\n      plugins: [s]\n"
           "      s: {plugin: 'nav2_costmap_2d::StaticLayer', restore_cleared_footprint: true}\n",
           2);
    addKey("goal heading",
           "planner_server:\n  ros__parameters:\n    planner_plugins: [G]\n"
           "    G: {plugin: 'nav2_smac_planner::SmacPlannerHybrid', goal_heading_mode: DEFAULT}\n",
           2);
    addKey("direction of a dock",
           "docking_server:\n  ros__parameters:\n    dock_plugins: [d]\n"
           "    d: {plugin: 'opennav_docking::SimpleChargingDock', dock_direction: forward}\n",
           2);
    addKey("statistics of critics",
           "controller_server:\n  ros__parameters:\n    controller_plugins: [F]\n"
           "    F: {plugin: 'nav2_mppi_controller::MPPIController', critics: [GoalCritic], "
           "publish_critics_stats: true}\n",
           2);
    addKey("introspection", "planner_server:\n  ros__parameters: {introspection_mode: disabled}\n",
           3);
    addKey("partial plans", "planner_server:\n  ros__parameters: {allow_partial_planning: true}\n",
           3);
    addKey("exclusion zones", "collision_monitor:\n  ros__parameters: {exclusion_zones: [z]}\n", 3);
    addKey("stamped footprint",
           "local_costmap:\n  local_costmap:\n    ros__parameters: "
           "{subscribe_to_stamped_footprint: true}\n",
           3);
    addKey("turning decelerations",
           "controller_server:\n  ros__parameters:\n    controller_plugins: [F]\n    F: {plugin: "
           "'nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController', "
           "max_angular_decel: -3.2}\n",
           3);
    addKey("following server", "following_server:\n  ros__parameters: {max_retries: 3}\n", 1);
    QTest::newRow("any monitor") << "collision_monitor:\n  ros__parameters: {polygons: [Stop]}\n"
                                 << 1;
    QTest::newRow("nothing") << "controller_server:\n  ros__parameters: {a: 1}\n" << 1;
  }

  void guess_signs() {
    QFETCH(QString, text);
    QFETCH(int, distro);
    QCOMPARE(static_cast<int>(guessDistro(parsed(text.toStdString())).distro), distro);
  }

  /// Two signs of Jazzy and one of Humble, which is not reported as a reason.
  void guess_reasons_speakForIt() {
    const DistroGuess guess = guessDistro(
        parsed("controller_server:\n  ros__parameters:\n    progress_checker_plugin: p\n"
               "    costmap_update_timeout: 0.3\n    FollowPath: {plugin: "
               "\"nav2_mppi_controller::MPPIController\", critics: [GoalCritic], "
               "ax_max: 3.0}\n"));
    QCOMPARE(static_cast<int>(guess.distro), 1);
    QCOMPARE(guess.reasons, (std::vector<std::string>{"line 4: key costmap_update_timeout",
                                                      "line 5: key ax_max"}));
  }

  /// MPPI, which replaces TEB, has keys that only some branches read.
  void guess_keysOfAReplacement_areNoSigns() {
    const std::string teb =
        "controller_server:\n  ros__parameters:\n    controller_plugins: [FollowPath]\n"
        "    FollowPath: {plugin: \"teb_local_planner::TebLocalPlannerROS\", max_vel_x: 0.4}\n";
    QCOMPARE(guessDistro(parsed(teb)).reasons, std::vector<std::string>());
    const DistroGuess humble = guessDistro(parsed(teb + "    progress_checker_plugin: p\n"));
    QCOMPARE(static_cast<int>(humble.distro), 0);
    QCOMPARE(humble.reasons, std::vector<std::string>{"line 5: key progress_checker_plugin"});
  }

  void read_partialFile_isNotAnError_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("held");
    QTest::newRow("amcl") << "amcl:\n  ros__parameters: {alpha1: 0.2}\n"
                          << "only amcl:";
    QTest::newRow("overlay") << "controller_server:\n  ros__parameters:\n"
                                "    controller_frequency: 10.0\n"
                                "    FollowPath: {desired_linear_vel: 0.3}\n"
                                "velocity_smoother:\n  ros__parameters: {odom_duration: 0.2}\n"
                             << "only controller_server, velocity_smoother:";
  }

  /// Some nodes of a file, or values for the plugins of another one.
  void read_partialFile_isNotAnError() {
    QFETCH(QString, text);
    QFETCH(QString, held);
    const Nav2ReadResult reading = readOf(text.toStdString());
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QCOMPARE(reading.problems.size(), std::size_t{1});
    QCOMPARE(reading.problems.front().code, std::string_view("nav2.partial-file"));
    QVERIFY2(reading.problems.front().message.find(held.toStdString()) != std::string::npos,
             texts(reading.problems).c_str());
    QVERIFY(reading.parameters.isPartial);
    QVERIFY(!readOf(kPursuit).parameters.isPartial);
  }

  void looksLikeNav2_serverAlone_is() {
    for (const char* const node : {"docking_server", "following_server", "route_server",
                                   "waypoint_follower", "planner_server"}) {
      QVERIFY2(looksLikeNav2(std::string(node) + ":\n  ros__parameters: {use_sim_time: true}\n"),
               node);
    }
    QVERIFY(!looksLikeNav2("hunav_loader:\n  ros__parameters: {publish_people: true}\n"));
  }

  void read_disabledMonitor_isKept() {
    const auto file = ParameterFile::read(SOURCE_DIR "/tests/data/nav2/nav2_monitor_disabled.yaml");
    QVERIFY(file);
    const Nav2ReadResult reading = readNav2Parameters(*file);
    QVERIFY2(reading.problems.empty(), texts(reading.problems).c_str());
    QVERIFY(reading.parameters.distro >= Distro::Lyrical);
    QVERIFY(reading.parameters.collisionMonitor && !reading.parameters.collisionMonitor->enabled);
  }

  void read_repeatedKey_driverHasTheLast() {
    const auto file = ParameterFile::read(SOURCE_DIR "/tests/data/nav2/nav2_duplicate_key.yaml");
    QVERIFY(file);
    const Nav2ReadResult reading = readNav2Parameters(*file);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const auto server =
        makeControllerServer(reading.parameters.controllerServer, reading.parameters.distro);
    QVERIFY(server);
    QCOMPARE((*server)->parameters().frequency, 10.0);  // line 8, not 20 Hz of line 3
  }

  void read_exclusionZones_haveAFrame() {
    const std::string text = kPursuit + R"(collision_monitor:
  ros__parameters:
    base_frame_id: "chassis"
    exclusion_zones: ["cart", "dock", "gate", "arm"]
    cart: {enabled: true, points: "[[0.5, 0.2], [0.5, -0.2], [0.3, 0.0]]", frame_id: "chassis"}
    dock: {enabled: true, type: "circle", radius: 0.4, frame_id: "/odom", frame_hold_timeout: 1.0}
    gate: {enabled: true, type: "circle", radius: 0.5, frame_id: "map", visualize: true}
    arm: {enabled: true, type: "circle", radius: 0.5, frame_id: "gripper"}
)";
    const Nav2ReadResult reading = readOf(text, Distro::Lyrical);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const auto& zones = reading.parameters.collisionMonitor->zones;
    QCOMPARE(zones.size(), std::size_t{3});
    QCOMPARE(zones[0].frame, ZoneFrame::Robot);
    QCOMPARE(zones[1].frame, ZoneFrame::Odom);
    QCOMPARE(zones[2].frame, ZoneFrame::Map);
    QCOMPARE(zones[2].radius, 0.5);
    const base::Diagnostic* const left = problemOf(reading.problems, "nav2.left-out");
    QVERIFY2(left != nullptr, texts(reading.problems).c_str());
    QVERIFY(left->message.find("collision_monitor.arm: 'gripper'") != std::string::npos);
    QCOMPARE(left->line, 12);
    const Nav2ReadResult jazzy = readOf(text, Distro::Jazzy);
    QVERIFY(jazzy.parameters.collisionMonitor->zones.empty());
    QCOMPARE(noteOf(jazzy, "collision_monitor.exclusion_zones")->use, KeyUse::OtherDistro);
  }

  void read_criticThatIsNotHere_hasKnownKeys() {
    const Nav2ReadResult reading = readOf(R"(controller_server:
  ros__parameters:
    FollowPath:
      plugin: "nav2_mppi_controller::MPPIController"
      critics: ["CostCritic", "PathAlignLegacyCritic"]
      PathAlignLegacyCritic: {cost_weight: 10.0}
    Drive:
      plugin: "dwb_core::DWBLocalPlanner"
      critics: ["PathDist", "social_critics::Space"]
      social_critics::Space: {scale: 2.0}
    controller_plugins: ["FollowPath", "Drive"]
)",
                                          Distro::Humble);
    QCOMPARE(noteOf(reading, "controller_server.FollowPath.PathAlignLegacyCritic.cost_weight")->use,
             KeyUse::Ignored);
    QCOMPARE(noteOf(reading, "controller_server.Drive.social_critics::Space.scale")->use,
             KeyUse::Ignored);
    QVERIFY(problemOf(reading.problems, "nav2.unnamed-block") == nullptr &&
            problemOf(reading.problems, "nav2.unknown-key") == nullptr);
  }

  void read_keyOfAnotherDistro_isNotUsed() {
    const std::string text = kPursuit + "      use_fixed_curvature_lookahead: true\n";
    const Nav2ReadResult humble = readOf(text, Distro::Humble);
    QCOMPARE(noteOf(humble, "controller_server.FollowPath.use_fixed_curvature_lookahead")->use,
             KeyUse::OtherDistro);
    const Nav2ReadResult jazzy = readOf(text, Distro::Jazzy);
    QCOMPARE(noteOf(jazzy, "controller_server.FollowPath.use_fixed_curvature_lookahead")->use,
             KeyUse::Used);
  }

  /// A key of another plugin is not suggested, however similar its name is.
  void read_unknownKey_isComparedWithItsOwnBlock() {
    const Nav2ReadResult reading = readOf(R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["obstacle_layer", "inflation_layer"]
      obstacle_layer: {plugin: "nav2_costmap_2d::ObstacleLayer", inflation_radiu: 0.5}
      inflation_layer: {plugin: "nav2_costmap_2d::InflationLayer"}
)" + kPursuit);
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unknown-key");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(
        problem->message,
        std::string("unknown key 'local_costmap.obstacle_layer.inflation_radiu': Nav2 Jazzy does "
                    "not read it"));
  }

  void read_blockThatNothingNames_isOneProblem() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["obstacle_layer"]
      obstacle_layer:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: scan
        scan: {topic: /scan}
        camera: {topic: /points, marking: true, clearing: true}
)");
    int count = 0;
    for (const base::Diagnostic& problem : reading.problems) {
      count += problem.code == "nav2.unknown-key" || problem.code == "nav2.unnamed-block" ? 1 : 0;
    }
    QCOMPARE(count, 1);
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unnamed-block");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->line, 13);
    QVERIFY(problem->message.find("obstacle_layer.camera' has no effect (3 keys)") !=
            std::string::npos);
    QCOMPARE(noteOf(reading, "local_costmap.obstacle_layer.camera.marking")->use, KeyUse::Unknown);
  }
};

QTEST_GUILESS_MAIN(Nav2BranchesTest)
#include "tst_Nav2Branches.moc"
