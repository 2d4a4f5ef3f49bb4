#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/nav/ParamsFiles.h"

using namespace nav2test;  // NOLINT: this file is about nothing else

/// Plugins of a nav2_params.yaml: which are read, replaced, left out.
class Nav2PluginsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_unknownPlugin_tellsTheNearest() {
    const Nav2ReadResult reading = readOf(R"(planner_server:
  ros__parameters:
    planner_plugins: ["Mine"]
    Mine:
      plugin: "nav2_navfn_planner::NavfnPlaner"
)");
    const base::Diagnostic* const problem = problemOf(reading.problems, "nav2.unknown-plugin");
    QVERIFY2(problem != nullptr, texts(reading.problems).c_str());
    QCOMPARE(problem->line, 5);
    QVERIFY(problem->message.find("NavfnPlanner") != std::string::npos);
  }

  void read_layerThatIsNotHere_refusesNoFile_data() {
    QTest::addColumn<QString>("plugin");
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("as");  // the class that is used; empty: none
    QTest::newRow("voxels without memory") << "nonpersistent_voxel_layer/NonPersistentVoxelLayer"
                                           << "nav2.treated-as"
                                           << "nav2_costmap_2d::ObstacleLayer";
    for (const char* const plugin :
         {"nav2_costmap_2d::ZoneParameterFilter", "my_robot::CarpetMemory",
          "social_costmap_plugins/ProxemicLayer"}) {
      QTest::newRow(plugin) << plugin << "nav2.left-out"
                            << "";
    }
  }

  void read_layerThatIsNotHere_refusesNoFile() {
    QFETCH(QString, plugin);
    QFETCH(QString, code);
    QFETCH(QString, as);
    const auto read = [&](const char* enabled) {
      return readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["it"]
      it: {plugin: )" +
                    "\"" + plugin.toStdString() + "\", some_key: 2, enabled: " + enabled + "}\n");
    };
    const Nav2ReadResult on = read("true");
    QVERIFY2(on.ok(), texts(on.problems).c_str());
    QCOMPARE(on.problems.size(), std::size_t{1});
    QCOMPARE(on.problems.front().code, std::string_view(code.toLatin1().constData()));
    QCOMPARE(on.problems.front().line, 9);
    QVERIFY(noteOf(on, "local_costmap.it.some_key")->use == KeyUse::Ignored);
    const auto& plugins = on.parameters.localCostmap.plugins;
    QCOMPARE(plugins.size(), std::size_t{as.isEmpty() ? 0U : 1U});
    if (!as.isEmpty()) {
      QCOMPARE(plugins.front().parameters.index(), layerOfType(as.toStdString())->index());
    }
    if (as.isEmpty()) {  // switched off it is not missed
      QVERIFY2(read("false").problems.empty(), texts(read("false").problems).c_str());
    }
  }

  /// Each with a value that is not the default.
  void read_rareLayers_readTheirKeys() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["stvl", "sides", "old", "clean", "sonar"]
      filters: ["lights"]
      stvl:
        plugin: "spatio_temporal_voxel_layer/SpatioTemporalVoxelLayer"
        voxel_decay: 15.0
        mark_threshold: 2
        observation_sources: scan
        scan: {topic: /scan, obstacle_range: 4.5, marking: true, clearing: true,
               max_obstacle_height: 2.0, decay_acceleration: 5.0, vertical_fov_angle: 0.8,
               model_type: 1, filter: "passthrough"}
      sides:
        plugin: "nav2_costmap_2d::AsymmetricInflationLayer"
        cost_scaling_factor_left: 2.0
        inflation_radius: 1.5
      old: {plugin: "nav2_costmap_2d::LegacyInflationLayer", cost_scaling_factor: 3.0}
      clean: {plugin: "nav2_costmap_2d::DenoiseLayer", minimal_group_size: 5}
      sonar: {plugin: "nav2_costmap_2d::RangeSensorLayer", topics: ["/sonar"], phi: 1.5}
      lights: {plugin: "nav2_costmap_2d::BinaryFilter", flip_threshold: 20.0}
)",
                                          Distro::Main);
    QVERIFY2(reading.problems.empty(), texts(reading.problems).c_str());
    const auto& plugins = reading.parameters.localCostmap.plugins;
    QCOMPARE(plugins.size(), std::size_t{5});
    const auto& decay = std::get<SpatioTemporalVoxelLayerParameters>(plugins[0].parameters);
    QCOMPARE(decay.voxelDecay, 15.0);
    QCOMPARE(decay.sources.front().obstacleRange, 4.5);
    QCOMPARE(decay.sources.front().decayAcceleration, 5.0);
    QCOMPARE(decay.sources.front().modelType, 1);
    const auto& sided = std::get<AsymmetricInflationLayerParameters>(plugins[1].parameters);
    QCOMPARE(sided.costScalingFactorLeft, 2.0);
    QCOMPARE(sided.inflationRadius, 1.5);
    const auto& legacy = std::get<LegacyInflationLayerParameters>(plugins[2].parameters);
    QCOMPARE(legacy.costScalingFactor, 3.0);
    QCOMPARE(std::get<DenoiseLayerParameters>(plugins[3].parameters).minimalGroupSize, 5);
    QCOMPARE(std::get<RangeSensorLayerParameters>(plugins[4].parameters).phi, 1.5);
    const auto& filters = reading.parameters.localCostmap.filters;
    QCOMPARE(std::get<BinaryFilterParameters>(filters[0].parameters).flipThreshold, 20.0);
  }

  void read_container_holdsItsPlugins() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["both", "inflation_layer"]
      both:
        plugin: "nav2_costmap_2d::PluginContainerLayer"
        combination_method: 0
        plugins: ["one", "two"]
        one: {plugin: "nav2_costmap_2d::StaticLayer"}
        two: {plugin: "nav2_costmap_2d::ObstacleLayer", observation_sources: scan,
              scan: {topic: /scan}}
      inflation_layer: {plugin: "nav2_costmap_2d::InflationLayer"}
)");
    QVERIFY2(reading.problems.empty(), texts(reading.problems).c_str());
    const auto& plugins = reading.parameters.localCostmap.plugins;
    QCOMPARE(plugins.size(), std::size_t{2});
    const auto& container = std::get<PluginContainerLayerParameters>(plugins[0].parameters);
    QCOMPARE(container.combinationMethod, 0);
    QCOMPARE(container.layers.size(), std::size_t{2});
    QCOMPARE(container.layers[1].name, std::string("both.two"));
    const auto& seen = std::get<ObstacleLayerParameters>(container.layers[1].parameters);
    QCOMPARE(seen.sources.size(), std::size_t{1});
  }

  void read_latticeAndConstrainedSmoother_readTheirKeys() {
    const Nav2ReadResult reading = readOf(kPursuit + R"(planner_server:
  ros__parameters:
    planner_plugins: ["GridBased"]
    GridBased: {plugin: "nav2_smac_planner::SmacPlannerLattice", tolerance: 0.5,
                lattice_filepath: "x.json", rotation_penalty: 4.0}
smoother_server:
  ros__parameters:
    smoother_plugins: ["smoother"]
    smoother: {plugin: "nav2_constrained_smoother/ConstrainedSmoother", w_smooth: 30000.0}
)");
    QVERIFY2(reading.problems.empty(), texts(reading.problems).c_str());
    const auto& lattice =
        std::get<SmacLatticeParameters>(reading.parameters.planners.front().second);
    QCOMPARE(lattice.tolerance, 0.5);
    QCOMPARE(lattice.rotationPenalty, 4.0);
    QCOMPARE(lattice.latticeFilepath, std::string("x.json"));
    QCOMPARE(std::get<ConstrainedSmootherParameters>(reading.parameters.smoothers.front().second)
                 .wSmooth,
             30000.0);
  }

  void read_goalChecker_readsItsOwnKeys() {
    const auto use = [](const char* plugin, const char* key) {
      const std::string text = std::string("    goal_checker_plugins: [It]\n    It: {plugin: \"") +
                               plugin + "\", " + key + ": 0.1}\n";
      const Nav2ReadResult reading = readOf(kPursuit + text, Distro::Main);
      const KeyUsage* const note = noteOf(reading, std::string("controller_server.It.") + key);
      return reading.ok() && note != nullptr && note->use == KeyUse::Used;
    };
    QVERIFY(use("nav2_controller::SimpleGoalChecker", "yaw_goal_tolerance"));
    QVERIFY(!use("nav2_controller::SimpleGoalChecker", "rot_stopped_velocity"));
    QVERIFY(use("nav2_controller::StoppedGoalChecker", "rot_stopped_velocity"));
    QVERIFY(!use("nav2_controller::PositionGoalChecker", "yaw_goal_tolerance"));
    QVERIFY(use("nav2_controller::AxisGoalChecker", "along_path_tolerance"));
    QVERIFY(!use("nav2_controller::SimpleGoalChecker", "along_path_tolerance"));
    QVERIFY(use("nav2_controller::AdaptiveToleranceGoalChecker", "fine_xy_goal_tolerance"));
    QVERIFY(use("dwb_plugins::StoppedGoalChecker", "trans_stopped_velocity"));
  }

  void read_wordOfLaunchFiles_switchesAFilterOff() {
    const Nav2ReadResult reading = readOf(R"(global_costmap:
  global_costmap:
    ros__parameters:
      filters: ["keepout_filter"]
      keepout_filter:
        plugin: "nav2_costmap_2d::KeepoutFilter"
        enabled: KEEPOUT_ZONE_ENABLED
)" + kPursuit);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    QVERIFY(problemOf(reading.problems, "nav2.launch-word"));
    QVERIFY(reading.parameters.globalCostmap.filters.empty());
  }

  void read_pluginBlocks_goByTheirNames() {
    const Nav2ReadResult reading = readOf(R"(planner_server:
  ros__parameters:
    planner_plugins: ["Fast", "Far"]
    Fast: {plugin: "nav2_navfn_planner::NavfnPlanner", tolerance: 0.75}
    Far: {plugin: "nav2_theta_star_planner::ThetaStarPlanner", w_euc_cost: 2.5}
    Other: {plugin: "nav2_navfn_planner::NavfnPlanner"}
)" + kPursuit);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const auto& planners = reading.parameters.planners;
    QCOMPARE(planners.size(), std::size_t{2});
    QCOMPARE(planners[0].first, std::string("Fast"));
    QCOMPARE(std::get<NavfnParameters>(planners[0].second).tolerance, 0.75);
    QCOMPARE(std::get<ThetaStarParameters>(planners[1].second).eucCost, 2.5);
  }

  void read_sources_areThoseThatTheLayerNames() {
    const Nav2ReadResult reading = readOf(R"(local_costmap:
  local_costmap:
    ros__parameters:
      plugins: ["obstacle_layer"]
      obstacle_layer:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: front rear
        front: {topic: /f, clearing: true, max_obstacle_height: 2.0, obstacle_max_range: 4.5}
        rear: {topic: /r}
)" + kPursuit);
    QVERIFY2(reading.ok(), texts(reading.problems).c_str());
    const auto& layer =
        std::get<ObstacleLayerParameters>(reading.parameters.localCostmap.plugins[0].parameters);
    QCOMPARE(layer.sources.size(), std::size_t{2});
    QCOMPARE(layer.sources[0].obstacleMaxRange, 4.5);
    QVERIFY(layer.sources[0].clearing && !layer.sources[1].clearing);
    QCOMPARE(layer.sources[1].maxObstacleHeight, 0.0);
  }
};

QTEST_GUILESS_MAIN(Nav2PluginsTest)
#include "tst_Nav2Plugins.moc"
