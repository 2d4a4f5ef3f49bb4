#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

/// Key tables of less common layers.
namespace sim2d::nav2 {
namespace {

constexpr char kEnabled[] = "Whether the layer is enabled.";

}  // namespace

const std::vector<Nav2Key<LegacyInflationLayerParameters>>& legacyInflationLayerKeys() {
  using P = LegacyInflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", static_cast<bool P::*>(&P::enabled), "", kEnabled, kSinceLyrical},
      {"inflation_radius", static_cast<double P::*>(&P::inflationRadius), "m",
       "Radius of the inflation around obstacles.", kSinceLyrical},
      {"cost_scaling_factor", static_cast<double P::*>(&P::costScalingFactor), "1/m",
       "Rate of the exponential decay of the costs.", kSinceLyrical},
      {"inflate_unknown", static_cast<bool P::*>(&P::inflateUnknown), "",
       "Whether unknown cells are inflated.", kSinceLyrical},
      {"inflate_around_unknown", static_cast<bool P::*>(&P::inflateAroundUnknown), "",
       "Whether unknown cells count as obstacles.", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<AsymmetricInflationLayerParameters>>& asymmetricInflationLayerKeys() {
  using P = AsymmetricInflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled, kSinceLyrical},
      {"inflation_radius", &P::inflationRadius, "m", "Radius of the inflation around obstacles.",
       kSinceLyrical},
      {"cost_scaling_factor_left", &P::costScalingFactorLeft, "1/m",
       "Rate of the exponential decay of the costs to the left of the path.", kSinceLyrical},
      {"cost_scaling_factor_right", &P::costScalingFactorRight, "1/m",
       "Rate of the exponential decay of the costs to the right of the path.", kSinceLyrical},
      {"goal_distance_threshold", &P::goalDistanceThreshold, "m",
       "Distance to the end of the path within which both sides use the greater of the two rates.",
       kSinceLyrical},
      {"inflate_unknown", &P::inflateUnknown, "", "Whether unknown cells are inflated.",
       kSinceLyrical},
      {"inflate_around_unknown", &P::inflateAroundUnknown, "",
       "Whether unknown cells count as obstacles.", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<DenoiseLayerParameters>>& denoiseLayerKeys() {
  using P = DenoiseLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled},
      {"minimal_group_size", &P::minimalGroupSize, "",
       "Smaller groups of obstacle cells are removed; up to 1: no groups."},
      {"group_connectivity_type", &P::groupConnectivityType, "",
       "Neighbours that form a group: 4 or 8."},
  };
  return kKeys;
}

const std::vector<Nav2Key<RangeSensorLayerParameters>>& rangeSensorLayerKeys() {
  using P = RangeSensorLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
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
  return kKeys;
}

const std::vector<Nav2Key<SpatioTemporalVoxelSource>>& spatioTemporalVoxelSourceKeys() {
  using P = SpatioTemporalVoxelSource;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"topic", &P::topic, "", "Topic of the points: here always the robot's lidar."},
      {"enabled", &P::enabled, "", "Whether the source is enabled."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether voxels decay faster in its field of view."},
      {"inf_is_valid", &P::infIsValid, "", "Beams without a hit have no points in this program."},
      {"observation_persistence", &P::observationPersistence, "s",
       "Time for which a scan is used; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "Age of a scan from which the costmap is stale; 0: never."},
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
  return kKeys;
}

const std::vector<Nav2Key<SpatioTemporalVoxelLayerParameters>>& spatioTemporalVoxelLayerKeys() {
  using P = SpatioTemporalVoxelLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled},
      {"voxel_decay", &P::voxelDecay, "s", "Time for which a voxel stays marked."},
      {"decay_model", &P::decayModel, "", "0: linear, 1: exponential, -1: voxels do not decay."},
      {"voxel_size", &P::voxelSize, "m", "Side length of a voxel."},
      {"combination_method", &P::combinationMethod, "",
       "0: overwrites the costs of the layers below; 1: maximum of both costs."},
      {"update_footprint_enabled", &P::updateFootprintEnabled, "",
       "Whether the cells under the robot are set free."},
      {"observation_sources", &P::observationSources, "",
       "Names of the sources, separated by blanks."},
  };
  return kKeys;
}

const std::vector<Nav2Key<PluginContainerLayerParameters>>& pluginContainerLayerKeys() {
  using P = PluginContainerLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled, kSinceJazzy},
      {"combination_method", &P::combinationMethod, "",
       "0: overwrites the costs of the layers below; 1: maximum of both costs; 2: maximum where "
       "the costs are known.",
       kSinceJazzy},
      {"plugins", &P::plugins, "", "Names of its layers, in the order of the update.", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<BinaryFilterParameters>>& binaryFilterKeys() {
  using P = BinaryFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"default_state", &P::defaultState, "", "State where the mask is below the threshold."},
      {"flip_threshold", &P::flipThreshold, "",
       "Mask value above which the state is the opposite one."},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask is used."},
      {"mask_file", &P::maskFile, "",
       "Mask: YAML file of a map beside this file. Key of this program that replaces the topic."},
      {"mask_base", &P::maskBase, "",
       "Value for mask values from 0 to 100: base + multiplier * value. Key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", "See mask_base. Key of this program."},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredSpatioTemporalVoxelKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"mark_threshold", "this program uses a single layer of voxels"},
      {"track_unknown_space", "that of the costmap is used"},
      {"origin_z", "this program uses a single layer of voxels"},
      {"max_obstacle_height", "those of the sources are used"},
      {"unknown_threshold", "this program uses a single layer of voxels"},
      {"mapping_mode", "maps are not saved"},
      {"map_save_duration", "maps are not saved"},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredSpatioTemporalVoxelSourceKeys() {
  static const std::vector<IgnoredKey> kKeys = {
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
  return kKeys;
}

}  // namespace sim2d::nav2
