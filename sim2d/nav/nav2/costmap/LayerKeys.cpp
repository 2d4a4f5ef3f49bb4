#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

/// Keys of layers that few robots have.
namespace sim2d::nav2 {
namespace {

constexpr char kEnabled[] = "Whether the layer takes part.";

}  // namespace

const std::vector<Nav2Key<LegacyInflationLayerParameters>>& legacyInflationLayerKeys() {
  using P = LegacyInflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", static_cast<bool P::*>(&P::enabled), "", kEnabled, kSinceLyrical},
      {"inflation_radius", static_cast<double P::*>(&P::inflationRadius), "m",
       "Range of costs round obstacles.", kSinceLyrical},
      {"cost_scaling_factor", static_cast<double P::*>(&P::costScalingFactor), "1/m",
       "How fast they fall off.", kSinceLyrical},
      {"inflate_unknown", static_cast<bool P::*>(&P::inflateUnknown), "",
       "Whether costs go into unknown cells.", kSinceLyrical},
      {"inflate_around_unknown", static_cast<bool P::*>(&P::inflateAroundUnknown), "",
       "Whether unknown cells count as obstacles.", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<AsymmetricInflationLayerParameters>>& asymmetricInflationLayerKeys() {
  using P = AsymmetricInflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled, kSinceLyrical},
      {"inflation_radius", &P::inflationRadius, "m", "Range of costs round obstacles.",
       kSinceLyrical},
      {"cost_scaling_factor_left", &P::costScalingFactorLeft, "1/m",
       "How fast they fall off to the left of the path.", kSinceLyrical},
      {"cost_scaling_factor_right", &P::costScalingFactorRight, "1/m",
       "How fast they fall off to the right of the path.", kSinceLyrical},
      {"goal_distance_threshold", &P::goalDistanceThreshold, "m",
       "Nearer to the end of the path both sides fall off with the greater of the two.",
       kSinceLyrical},
      {"inflate_unknown", &P::inflateUnknown, "", "Whether costs go into unknown cells.",
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
       "Smaller groups of obstacle cells are removed; up to 1: none are."},
      {"group_connectivity_type", &P::groupConnectivityType, "",
       "Neighbours that form a group: 4 or 8."},
  };
  return kKeys;
}

const std::vector<Nav2Key<RangeSensorLayerParameters>>& rangeSensorLayerKeys() {
  using P = RangeSensorLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled},
      {"phi", &P::phi, "m", "Distance at which a reading counts half."},
      {"inflate_cone", &P::inflateCone, "",
       "How far cells beyond the sensor's cone are updated; 1: all in the box around it."},
      {"no_readings_timeout", &P::noReadingsTimeout, "s",
       "The costmap is stale after so long without a reading; 0: never."},
      {"clear_threshold", &P::clearThreshold, "", "Cells of a lower probability are free."},
      {"mark_threshold", &P::markThreshold, "", "Cells of a higher probability are obstacles."},
      {"clear_on_max_reading", &P::clearOnMaxReading, "",
       "Whether a sensor that sees nothing frees its cone."},
      {"input_sensor_type", &P::inputSensorType, "",
       "VARIABLE, FIXED or ALL; the sensors here measure distances (VARIABLE)."},
      {"topics", &P::topics, "",
       "Names of the sensors; each looks ahead, or to the side that its name contains."},
  };
  return kKeys;
}

const std::vector<Nav2Key<DecaySource>>& decaySourceKeys() {
  using P = DecaySource;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"topic", &P::topic, "", "Topic of the points: here always the robot's lidar."},
      {"enabled", &P::enabled, "", "Whether the source takes part."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether voxels decay faster in its field of view."},
      {"inf_is_valid", &P::infIsValid, "", "Beams that meet nothing have no points here."},
      {"observation_persistence", &P::observationPersistence, "s",
       "For how long a scan counts; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "The costmap is stale when a scan is older; 0: never."},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are dropped."},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are dropped."},
      {"obstacle_range", &P::obstacleRange, "m", "Farther points do not mark."},
      {"min_z", &P::minZ, "m", "Begin of the field of view."},
      {"max_z", &P::maxZ, "m", "End of the field of view."},
      {"horizontal_fov_angle", &P::horizontalFieldOfView, "rad", "Its angle."},
      {"decay_acceleration", &P::decayAcceleration, "1/s^2",
       "How much faster voxels decay in the field of view."},
      {"model_type", &P::modelType, "", "0: depth camera, 1: lidar."},
  };
  return kKeys;
}

const std::vector<Nav2Key<DecayLayerParameters>>& decayLayerKeys() {
  using P = DecayLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled},
      {"voxel_decay", &P::voxelDecay, "s", "How long a voxel stays marked."},
      {"decay_model", &P::decayModel, "", "0: linear, 1: exponential, -1: voxels do not decay."},
      {"voxel_size", &P::voxelSize, "m", "Side of a voxel."},
      {"combination_method", &P::combinationMethod, "",
       "0: overwrites what lies below; 1: the higher cost."},
      {"update_footprint_enabled", &P::updateFootprintEnabled, "",
       "Whether the cells under the robot are free."},
      {"observation_sources", &P::observationSources, "",
       "Names of the sources, with blanks between them."},
  };
  return kKeys;
}

const std::vector<Nav2Key<ContainerLayerParameters>>& containerLayerKeys() {
  using P = ContainerLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", kEnabled, kSinceJazzy},
      {"combination_method", &P::combinationMethod, "",
       "0: overwrites what lies below; 1: the higher cost; 2: the same where costs are known.",
       kSinceJazzy},
      {"plugins", &P::plugins, "", "Names of its layers, in the order of the update.", kSinceJazzy},
  };
  return kKeys;
}

const std::vector<Nav2Key<BinaryFilterParameters>>& binaryFilterKeys() {
  using P = BinaryFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter takes part."},
      {"default_state", &P::defaultState, "", "The state where the mask is below the threshold."},
      {"flip_threshold", &P::flipThreshold, "",
       "Where the mask is above it, the state is the other one."},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask counts."},
      {"mask_file", &P::maskFile, "",
       "The mask, a map's YAML beside this file. A key of this program, instead of the topic."},
      {"mask_base", &P::maskBase, "",
       "Value where the mask is 0 to 100: base + multiplier * value. A key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", "See mask_base. A key of this program."},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleDecayKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"mark_threshold", "there is one layer of voxels here"},
      {"track_unknown_space", "that of the costmap counts"},
      {"origin_z", "there is one layer of voxels here"},
      {"max_obstacle_height", "those of the sources count"},
      {"unknown_threshold", "there is one layer of voxels here"},
      {"mapping_mode", "maps are not saved"},
      {"map_save_duration", "maps are not saved"},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleDecaySourceKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"sensor_frame", "the lidar knows where it is"},
      {"data_type", "the points are those of the lidar"},
      {"vertical_fov_angle", "there is one layer of voxels here"},
      {"vertical_fov_padding", "there is one layer of voxels here"},
      {"filter", "each point counts here"},
      {"voxel_filter", "each point counts here"},
      {"voxel_min_points", "each point counts here"},
      {"clear_after_reading", "a scan counts once"},
      {"obstacle_min_range", "not a key of this layer"},
      {"raytrace_range", "voxels are not cleared by rays"},
      {"raytrace_max_range", "voxels are not cleared by rays"},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
