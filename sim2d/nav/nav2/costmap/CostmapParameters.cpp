#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

namespace sim2d::nav2 {
namespace {

PluginClasses<LayerParameters> layerClasses() {
  return {
      {"nav2_costmap_2d::StaticLayer", StaticLayerParameters{}},
      {"nav2_costmap_2d::ObstacleLayer", ObstacleLayerParameters{}},
      {"nav2_costmap_2d::VoxelLayer", VoxelLayerParameters{}},
      {"nav2_costmap_2d::InflationLayer", InflationLayerParameters{}},
      {"hunavsim::SocialLayer", SocialLayerParameters{}},
      {"nav2_costmap_2d::KeepoutFilter", KeepoutFilterParameters{}},
      {"nav2_costmap_2d::SpeedFilter", SpeedFilterParameters{}},
      {"nav2_costmap_2d::LegacyInflationLayer", LegacyInflationLayerParameters{}},
      {"nav2_costmap_2d::AsymmetricInflationLayer", AsymmetricInflationLayerParameters{}},
      {"nav2_costmap_2d::DenoiseLayer", DenoiseLayerParameters{}},
      {"nav2_costmap_2d::RangeSensorLayer", RangeSensorLayerParameters{}},
      {"spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer",
       SpatioTemporalVoxelLayerParameters{}},
      {"nav2_costmap_2d::PluginContainerLayer", PluginContainerLayerParameters{}},
      {"nav2_costmap_2d::BinaryFilter", BinaryFilterParameters{}},
  };
}

constexpr char kEnabled[] = "Whether the layer is enabled.";
constexpr char kClearsFootprint[] = "Whether the cells under the robot are set free.";
constexpr char kMaskTopic[] = "Topic of the costmap_filter_info_server whose mask is used.";
constexpr char kMaskFile[] =
    "Mask: YAML file of a map beside this file. Key of this program that replaces the topic.";
constexpr char kMultiplier[] = "See mask_base. Key of this program.";
constexpr char kSourceNames[] = "Names of the sources, separated by blanks.";
constexpr char kCombination[] =
    "0: overwrites the costs of the layers below; 1: maximum of both costs; 2: maximum where the "
    "costs are known.";

}  // namespace

std::optional<LayerParameters> layerOfType(std::string_view type) {
  return defaultsOf(layerClasses(), type);
}

std::vector<std::string> layerTypes() {
  return namesOf(layerClasses());
}

Nav2Keys<CostmapParameters> costmapKeys() {
  using P = CostmapParameters;
  return {
      {"update_frequency", &P::updateFrequency, "Hz", "Updates per second."},
      {"publish_frequency", &P::publishFrequency, "Hz",
       "Copies per second for behaviours and smoothers."},
      {"width", &P::width, "m", "Width; a costmap with a map has that of the map."},
      {"height", &P::height, "m", "Height; a costmap with a map has that of the map."},
      {"resolution", &P::resolution, "m",
       "Side length of a cell; a costmap with a map has that of the map."},
      {"origin_x", &P::originX, "m", "Lower left corner of a costmap without a map."},
      {"origin_y", &P::originY, "m", "Lower left corner of a costmap without a map."},
      {"rolling_window", &P::rollingWindow, "", "Whether the costmap moves with the robot."},
      {"global_frame", &P::globalFrame, "",
       "Frame of the costmap. The local costmap uses the odometry frame if its frame differs from "
       "that of the global one."},
      {"track_unknown_space", &P::trackUnknownSpace, "",
       "Whether cells without data are unknown; otherwise they are free."},
      {"robot_radius", &P::robotRadius, "m", "Radius of a robot without a footprint."},
      {"footprint", &P::footprint, "m", "Corners of the robot's footprint: \"[[x, y], …]\"."},
      {"footprint_padding", &P::footprintPadding, "m", "Added to the corners on each axis."},
      {"plugins", &P::plugins, "", "Names of the layers, in the order of the update."},
      {"filters", &P::filters, "", "Names of the filters, applied after the layers."},
      {"unknown_cost_value", &P::unknownCostValue, "", "Occupancy that means unknown."},
      {"lethal_cost_threshold", &P::lethalCostThreshold, "",
       "Minimum occupancy of an obstacle cell."},
      {"trinary_costmap", &P::trinaryCostmap, "",
       "Whether lower occupancies are free; otherwise their costs are proportional."},
      {"inscribed_obstacle_cost_value", &P::inscribedObstacleCostValue, "",
       "Occupancy of a cell within the inscribed radius of an obstacle.", kSinceLyrical},
      {"use_maximum", &P::useMaximum, "",
       "Whether the map only raises the costs of the layers below; otherwise it overwrites them."},
  };
}

Nav2Keys<StaticLayerParameters> keysOf(const StaticLayerParameters&) {
  using P = StaticLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"footprint_clearing_enabled", &P::footprintClearingEnabled, "", kClearsFootprint},
      {"restore_cleared_footprint", &P::restoreClearedFootprint, "",
       "Whether these cells are restored after the robot has left them.", kSinceKilted},
  };
}

Nav2Keys<ObservationSource> observationSourceKeys() {
  using P = ObservationSource;
  return {
      {"topic", &P::topic, "", "Topic of the scans; this program uses the robot's lidar."},
      {"data_type", &P::dataType, "",
       "LaserScan or PointCloud2; this program uses the lidar's scan."},
      {"observation_persistence", &P::observationPersistence, "s",
       "Time for which a scan is used; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "Age of a scan above which the costmap is stale; 0: never."},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are ignored."},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are ignored."},
      {"inf_is_valid", &P::infIsValid, "",
       "Whether beams without a hit clear cells; otherwise they are ignored."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether beams clear the cells that they pass."},
      {"obstacle_max_range", &P::obstacleMaxRange, "m", "Farther points do not mark."},
      {"obstacle_min_range", &P::obstacleMinRange, "m", "Nearer points do not mark."},
      {"raytrace_max_range", &P::raytraceMaxRange, "m",
       "No cells are cleared beyond this distance."},
      {"raytrace_min_range", &P::raytraceMinRange, "m",
       "No cells are cleared within this distance."},
  };
}

Nav2Keys<ObstacleLayerParameters> keysOf(const ObstacleLayerParameters&) {
  using P = ObstacleLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"footprint_clearing_enabled", &P::footprintClearingEnabled, "", kClearsFootprint},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are not marked.",
       kSinceJazzy},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are not marked."},
      {"combination_method", &P::combinationMethod, "", kCombination},
      {"observation_sources", &P::observationSources, "", kSourceNames},
  };
}

Nav2Keys<VoxelLayerParameters> keysOf(const VoxelLayerParameters&) {
  using P = VoxelLayerParameters;
  return joinedKeys<P>(
      keysOf(ObstacleLayerParameters()),
      Nav2Keys<P>{{"origin_z", &P::originZ, "m", "Height of the lowest voxel."},
                  {"z_resolution", &P::zResolution, "m", "Height of a voxel."},
                  {"z_voxels", &P::zVoxels, "", "Number of voxels per column, at most 16."},
                  {"mark_threshold", &P::markThreshold, "",
                   "Columns with more marked voxels are obstacles; with 1 or more, the layer marks "
                   "nothing in this program."}});
}

Nav2Keys<InflationLayerParameters> keysOf(const InflationLayerParameters&) {
  using P = InflationLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"inflation_radius", &P::inflationRadius, "m", "Radius of the inflation around obstacles."},
      {"cost_scaling_factor", &P::costScalingFactor, "1/m",
       "Rate of the exponential decay of the costs."},
      {"inflate_unknown", &P::inflateUnknown, "", "Whether unknown cells are inflated."},
      {"inflate_around_unknown", &P::inflateAroundUnknown, "",
       "Whether unknown cells count as obstacles."},
      {"custom_inscribed_radius", &P::customInscribedRadius, "m",
       "Inscribed radius, within which a collision is certain; negative: that of the footprint.",
       kSinceLyrical},
  };
}

Nav2Keys<SocialLayerParameters> keysOf(const SocialLayerParameters&) {
  using P = SocialLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"amplitude", &P::amplitude, "", "Cost at a person's centre, 0 to 254."},
      {"sigma_per_speed", &P::sigmaPerSpeed, "s",
       "Standard deviation in front of a person per speed."},
      {"sigma_min", &P::sigmaMin, "m", "Minimum standard deviation in front of a person."},
      {"side_ratio", &P::sideRatio, "",
       "Ratio of the standard deviations to the sides and in "
       "front."},
      {"rear_ratio", &P::rearRatio, "", "Ratio of the standard deviations behind and in front."},
      {"cutoff", &P::cutoff, "", "Lower costs are omitted, 1 to 254."},
  };
}

Nav2Keys<KeepoutFilterParameters> keysOf(const KeepoutFilterParameters&) {
  using P = KeepoutFilterParameters;
  return {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"override_lethal_cost", &P::overrideLethalCost, "",
       "Whether a robot in a keep-out zone may drive out of it.", kSinceJazzy},
      {"lethal_override_cost", &P::lethalOverrideCost, "",
       "Cost of the zone while the robot drives out.", kSinceJazzy},
      {"filter_info_topic", &P::filterInfoTopic, "", kMaskTopic},
      {"mask_file", &P::maskFile, "", kMaskFile},
  };
}

Nav2Keys<SpeedFilterParameters> keysOf(const SpeedFilterParameters&) {
  using P = SpeedFilterParameters;
  return {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"filter_info_topic", &P::filterInfoTopic, "", kMaskTopic},
      {"mask_file", &P::maskFile, "", kMaskFile},
      {"mask_base", &P::maskBase, "",
       "Limit for mask values from 0 to 100: base + multiplier * value. Key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", kMultiplier},
      {"mask_is_percentage", &P::maskIsPercentage, "",
       "Whether the limit is in percent of the maximum speed; otherwise it is in m/s. Key of this "
       "program."},
  };
}

IgnoredKeys ignoredCostmapKeys() {
  return {
      {"robot_base_frame", "all base frames of a robot are identical"},
      {"transform_tolerance", "TF is not used"},
      {"initial_transform_timeout", "TF is not used", kSinceJazzy},
      {"always_send_full_costmap", "published costmaps are always complete"},
      {"map_topic", "the map is the scenario's", kUntilJazzy},
      {"map_vis_z", "only used by ROS displays", kSinceJazzy},
      {"observation_sources", "those of the layers are used", kUntilKilted},
      {"subscribe_to_stamped_footprint", "the footprint is constant", kSinceLyrical},
  };
}

IgnoredKeys ignoredLayerKeys() {
  return {
      {"plugin", "it is the type of the layer"},
      {"map_subscribe_transient_local", "the map is the scenario's"},
      {"subscribe_to_updates", "the map is constant"},
      {"map_topic", "the map is the scenario's"},
      {"transform_tolerance", "TF is not used"},
      {"tf_filter_tolerance", "TF is not used", kSinceKilted},
      {"transport_type", "ROS topics are not used", kSinceLyrical},
      {"unknown_threshold", "voxels are not used: treated as 15"},
      {"publish_voxel_map", "only used by ROS displays"},
      {"num_threads", "costs do not depend on it", kSinceLyrical},
      {"mask_topic", "filter_info_topic determines the mask"},
      {"speed_limit_topic", "the costmap passes its limit directly"},
      {"enable_path_lookahead", "not re-implemented: only the cell of the robot is used",
       kSinceLyrical},
      {"max_decel", "not re-implemented: only the cell of the robot is used", kSinceLyrical},
      {"max_lookahead", "not re-implemented: only the cell of the robot is used", kSinceLyrical},
      {"min_lookahead", "not re-implemented: only the cell of the robot is used", kSinceLyrical},
      {"binary_state_topic", "ROS topics are not used: the manifest contains the state"},
      {"plan_topic", "the path is passed directly", kSinceLyrical},
      {"odom_topic", "ROS topics are not used", kSinceLyrical},
      {"path_topic", "ROS topics are not used", kSinceLyrical},
  };
}

IgnoredKeys ignoredSourceKeys() {
  return {
      {"sensor_frame", "the robot's lidar determines the sensor pose"},
      {"transport_type", "ROS topics are not used", kSinceLyrical},
  };
}

Nav2Keys<LegacyInflationLayerParameters> keysOf(const LegacyInflationLayerParameters&) {
  using P = LegacyInflationLayerParameters;
  Nav2Keys<P> keys = joinedKeys<P>(keysOf(InflationLayerParameters()));
  keys.pop_back();  // custom_inscribed_radius
  return onlyIn(kSinceLyrical, keys);
}

Nav2Keys<AsymmetricInflationLayerParameters> keysOf(const AsymmetricInflationLayerParameters&) {
  using P = AsymmetricInflationLayerParameters;
  return onlyIn<Nav2Key<P>>(
      kSinceLyrical,
      {
          {"enabled", &P::enabled, "", kEnabled},
          {"inflation_radius", &P::inflationRadius, "m",
           "Radius of the inflation around obstacles."},
          {"cost_scaling_factor_left", &P::costScalingFactorLeft, "1/m",
           "Rate of the exponential decay of the costs to the left of the path."},
          {"cost_scaling_factor_right", &P::costScalingFactorRight, "1/m",
           "Rate of the exponential decay of the costs to the right of the path."},
          {"goal_distance_threshold", &P::goalDistanceThreshold, "m",
           "Distance to the end of the path within which both sides use the greater of the two "
           "rates."},
          {"inflate_unknown", &P::inflateUnknown, "", "Whether unknown cells are inflated."},
          {"inflate_around_unknown", &P::inflateAroundUnknown, "",
           "Whether unknown cells count as obstacles."},
      });
}

Nav2Keys<DenoiseLayerParameters> keysOf(const DenoiseLayerParameters&) {
  using P = DenoiseLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"minimal_group_size", &P::minimalGroupSize, "",
       "Smaller groups of obstacle cells are removed; at most 1: none."},
      {"group_connectivity_type", &P::groupConnectivityType, "",
       "Neighbours that form a group: 4 or 8."},
  };
}

Nav2Keys<RangeSensorLayerParameters> keysOf(const RangeSensorLayerParameters&) {
  using P = RangeSensorLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"phi", &P::phi, "m", "Distance at which a reading has half its weight."},
      {"inflate_cone", &P::inflateCone, "",
       "Extent of the updated cells beyond the sensor's cone; 1: all in its bounding box."},
      {"no_readings_timeout", &P::noReadingsTimeout, "s",
       "Time without a reading after which the costmap is stale; 0: never."},
      {"clear_threshold", &P::clearThreshold, "", "Cells with a lower probability are free."},
      {"mark_threshold", &P::markThreshold, "", "Cells with a higher probability are obstacles."},
      {"clear_on_max_reading", &P::clearOnMaxReading, "",
       "Whether a reading without a hit clears the sensor's cone."},
      {"input_sensor_type", &P::inputSensorType, "",
       "VARIABLE, FIXED or ALL; the sensors of this program measure distances (VARIABLE)."},
      {"topics", &P::topics, "",
       "Names of the sensors; each faces forward, or in the direction that its name contains."},
  };
}

Nav2Keys<SpatioTemporalVoxelSource> spatioTemporalVoxelSourceKeys() {
  using P = SpatioTemporalVoxelSource;
  return {
      {"topic", &P::topic, "", "Topic of the points; this program uses the robot's lidar."},
      {"enabled", &P::enabled, "", "Whether the source is enabled."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether voxels decay faster in its field of view."},
      {"inf_is_valid", &P::infIsValid, "", "Beams without a hit have no points in this program."},
      {"observation_persistence", &P::observationPersistence, "s",
       "Time for which a scan is used; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "Age of a scan above which the costmap is stale; 0: never."},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are ignored."},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are ignored."},
      {"obstacle_range", &P::obstacleRange, "m", "Farther points do not mark."},
      {"min_z", &P::minZ, "m", "Minimum distance of the field of view."},
      {"max_z", &P::maxZ, "m", "Maximum distance of the field of view."},
      {"horizontal_fov_angle", &P::horizontalFieldOfView, "rad",
       "Horizontal angle of the field of view."},
      {"decay_acceleration", &P::decayAcceleration, "1/s^2",
       "Acceleration of the voxel decay in the field of view."},
      {"model_type", &P::modelType, "", "0: depth camera, 1: lidar."},
  };
}

Nav2Keys<SpatioTemporalVoxelLayerParameters> keysOf(const SpatioTemporalVoxelLayerParameters&) {
  using P = SpatioTemporalVoxelLayerParameters;
  return {
      {"enabled", &P::enabled, "", kEnabled},
      {"voxel_decay", &P::voxelDecay, "s", "Time for which a voxel stays marked."},
      {"decay_model", &P::decayModel, "", "0: linear, 1: exponential, -1: voxels do not decay."},
      {"voxel_size", &P::voxelSize, "m", "Side length of a voxel."},
      {"combination_method", &P::combinationMethod, "",
       "0: overwrites the costs of the layers below; 1: maximum of both costs."},
      {"update_footprint_enabled", &P::updateFootprintEnabled, "", kClearsFootprint},
      {"observation_sources", &P::observationSources, "", kSourceNames},
  };
}

Nav2Keys<PluginContainerLayerParameters> keysOf(const PluginContainerLayerParameters&) {
  using P = PluginContainerLayerParameters;
  return onlyIn<Nav2Key<P>>(
      kSinceJazzy,
      {
          {"enabled", &P::enabled, "", kEnabled},
          {"combination_method", &P::combinationMethod, "", kCombination},
          {"plugins", &P::plugins, "", "Names of its layers, in the order of the update."},
      });
}

Nav2Keys<BinaryFilterParameters> keysOf(const BinaryFilterParameters&) {
  using P = BinaryFilterParameters;
  return {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"default_state", &P::defaultState, "", "State where the mask is below the threshold."},
      {"flip_threshold", &P::flipThreshold, "",
       "Mask value above which the state is the opposite one."},
      {"filter_info_topic", &P::filterInfoTopic, "", kMaskTopic},
      {"mask_file", &P::maskFile, "", kMaskFile},
      {"mask_base", &P::maskBase, "",
       "Value for mask values from 0 to 100: base + multiplier * value. Key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", kMultiplier},
  };
}

IgnoredKeys ignoredSpatioTemporalVoxelKeys() {
  return {
      {"mark_threshold", "this program uses a single layer of voxels"},
      {"track_unknown_space", "that of the costmap is used"},
      {"origin_z", "this program uses a single layer of voxels"},
      {"max_obstacle_height", "those of the sources are used"},
      {"unknown_threshold", "this program uses a single layer of voxels"},
      {"mapping_mode", "maps are not saved"},
      {"map_save_duration", "maps are not saved"},
  };
}

IgnoredKeys ignoredSpatioTemporalVoxelSourceKeys() {
  return {
      {"sensor_frame", "the robot's lidar determines the sensor pose"},
      {"data_type", "the points are those of the lidar"},
      {"vertical_fov_angle", "this program uses a single layer of voxels"},
      {"vertical_fov_padding", "this program uses a single layer of voxels"},
      {"filter", "every point is used"},
      {"voxel_filter", "every point is used"},
      {"voxel_min_points", "every point is used"},
      {"clear_after_reading", "each scan is used once"},
      {"obstacle_min_range", "not a key of this layer"},
      {"raytrace_range", "voxels are not cleared by rays"},
      {"raytrace_max_range", "voxels are not cleared by rays"},
  };
}

}  // namespace sim2d::nav2
