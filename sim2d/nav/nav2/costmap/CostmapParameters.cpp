#include "sim2d/nav/nav2/costmap/CostmapParameters.h"

#include <cstddef>
#include <utility>

namespace sim2d::nav2 {
namespace {

struct LayerType {
  std::string_view name;
  LayerParameters defaults;
};

/// In the order of the alternatives of LayerParameters.
const std::vector<LayerType>& knownLayerTypes() {
  static const std::vector<LayerType> kTypes = {
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
      {"spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer", DecayLayerParameters{}},
      {"nav2_costmap_2d::PluginContainerLayer", ContainerLayerParameters{}},
      {"nav2_costmap_2d::BinaryFilter", BinaryFilterParameters{}},
  };
  return kTypes;
}

/// Of obstacle and voxel layers.
template <class Layer>
std::vector<Nav2Key<Layer>> obstacleRows() {
  return {
      {"enabled", &Layer::enabled, "", "Whether the layer takes part."},
      {"footprint_clearing_enabled", &Layer::footprintClearingEnabled, "",
       "Whether the cells under the robot are free."},
      {"min_obstacle_height", &Layer::minObstacleHeight, "m", "Lower points are not marked.",
       kSinceJazzy},
      {"max_obstacle_height", &Layer::maxObstacleHeight, "m", "Higher points are not marked."},
      {"combination_method", &Layer::combinationMethod, "",
       "0: overwrites what lies below; 1: the higher cost; 2: the same where costs are known."},
      {"observation_sources", &Layer::observationSources, "",
       "Names of the sources, with blanks between them."},
  };
}

}  // namespace

CostmapSettings defaultCostmapSettings() {
  return {CostmapParameters{},
          {{"static_layer", StaticLayerParameters{}},
           {"obstacle_layer", ObstacleLayerParameters{}},
           {"inflation_layer", InflationLayerParameters{}}},
          {}};
}

std::optional<LayerParameters> layerOfType(std::string_view type) {
  for (const LayerType& known : knownLayerTypes()) {
    if (known.name == type) {
      return known.defaults;
    }
  }
  return std::nullopt;
}

std::string_view typeOf(const LayerParameters& parameters) {
  return knownLayerTypes()[parameters.index()].name;
}

std::vector<std::string> layerTypes() {
  std::vector<std::string> names;
  for (const LayerType& known : knownLayerTypes()) {
    names.emplace_back(known.name);
  }
  return names;
}

const std::vector<Nav2Key<CostmapParameters>>& costmapKeys() {
  using P = CostmapParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"update_frequency", &P::updateFrequency, "Hz", "Updates per second."},
      {"publish_frequency", &P::publishFrequency, "Hz",
       "Copies per second for behaviours and smoothers."},
      {"width", &P::width, "m", "Width; a costmap of a map has the map's."},
      {"height", &P::height, "m", "Height; a costmap of a map has the map's."},
      {"resolution", &P::resolution, "m", "Side of a cell; a costmap of a map has the map's."},
      {"origin_x", &P::originX, "m", "Lower left corner of a costmap without a map."},
      {"origin_y", &P::originY, "m", "Lower left corner of a costmap without a map."},
      {"rolling_window", &P::rollingWindow, "", "Whether the costmap moves with the robot."},
      {"global_frame", &P::globalFrame, "",
       "Frame of the costmap. The local one moves with the odometry when it has another frame than "
       "the "
       "global one."},
      {"track_unknown_space", &P::trackUnknownSpace, "",
       "Whether cells that nothing is known of are unknown, else free."},
      {"robot_radius", &P::robotRadius, "m", "Radius of a robot without a footprint."},
      {"footprint", &P::footprint, "m", "Corners of the robot: \"[[x, y], …]\"."},
      {"footprint_padding", &P::footprintPadding, "m", "Added to the corners on each axis."},
      {"plugins", &P::plugins, "", "Names of the layers, in the order of the update."},
      {"filters", &P::filters, "", "Names of the filters, applied after the layers."},
      {"unknown_cost_value", &P::unknownCostValue, "", "Occupancy that means unknown."},
      {"lethal_cost_threshold", &P::lethalCostThreshold, "",
       "Occupancy from which on a cell is an obstacle."},
      {"trinary_costmap", &P::trinaryCostmap, "",
       "Whether lower occupancies are free, else in proportion."},
      {"inscribed_obstacle_cost_value", &P::inscribedObstacleCostValue, "",
       "Occupancy that means a cell beside an obstacle.", kSinceLyrical},
      {"use_maximum", &P::useMaximum, "",
       "Whether the map only raises what lies below, else it overwrites."},
  };
  return kKeys;
}

const std::vector<Nav2Key<StaticLayerParameters>>& staticLayerKeys() {
  using P = StaticLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer takes part."},
      {"footprint_clearing_enabled", &P::footprintClearingEnabled, "",
       "Whether the cells under the robot are free."},
      {"restore_cleared_footprint", &P::restoreClearedFootprint, "",
       "Whether they are as before once the robot has left.", kSinceKilted},
  };
  return kKeys;
}

const std::vector<Nav2Key<ObservationSource>>& observationSourceKeys() {
  using P = ObservationSource;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"topic", &P::topic, "", "Topic of the scans: here always the robot's lidar."},
      {"data_type", &P::dataType, "", "LaserScan or PointCloud2: here always the lidar's scan."},
      {"observation_persistence", &P::observationPersistence, "s",
       "For how long a scan counts; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "The costmap is stale when a scan is older; 0: never."},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are dropped."},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are dropped."},
      {"inf_is_valid", &P::infIsValid, "",
       "Whether beams that meet nothing clear, else they are dropped."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether beams free what they pass."},
      {"obstacle_max_range", &P::obstacleMaxRange, "m", "Farther points do not mark."},
      {"obstacle_min_range", &P::obstacleMinRange, "m", "Nearer points do not mark."},
      {"raytrace_max_range", &P::raytraceMaxRange, "m", "Nothing is cleared beyond it."},
      {"raytrace_min_range", &P::raytraceMinRange, "m", "Nothing is cleared before it."},
  };
  return kKeys;
}

const std::vector<Nav2Key<ObstacleLayerParameters>>& obstacleLayerKeys() {
  static const std::vector<Nav2Key<ObstacleLayerParameters>> kKeys =
      obstacleRows<ObstacleLayerParameters>();
  return kKeys;
}

const std::vector<Nav2Key<VoxelLayerParameters>>& voxelLayerKeys() {
  using P = VoxelLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = [] {
    std::vector<Nav2Key<P>> keys = obstacleRows<P>();
    keys.push_back({"origin_z", &P::originZ, "m", "Height of the lowest voxel."});
    keys.push_back({"z_resolution", &P::zResolution, "m", "Height of a voxel."});
    keys.push_back({"z_voxels", &P::zVoxels, "", "Voxels above each other, 16 at most."});
    keys.push_back({"mark_threshold", &P::markThreshold, "",
                    "A column with more marked voxels is an obstacle: from 1 on none here."});
    return keys;
  }();
  return kKeys;
}

const std::vector<Nav2Key<InflationLayerParameters>>& inflationLayerKeys() {
  using P = InflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer takes part."},
      {"inflation_radius", &P::inflationRadius, "m", "Range of costs round obstacles."},
      {"cost_scaling_factor", &P::costScalingFactor, "1/m", "How fast they fall off."},
      {"inflate_unknown", &P::inflateUnknown, "", "Whether costs go into unknown cells."},
      {"inflate_around_unknown", &P::inflateAroundUnknown, "",
       "Whether unknown cells count as obstacles."},
      {"custom_inscribed_radius", &P::customInscribedRadius, "m",
       "Radius of certain collision; below 0: that of the footprint.", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<SocialLayerParameters>>& socialLayerKeys() {
  using P = SocialLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer takes part."},
      {"amplitude", &P::amplitude, "", "Cost at a person's centre, 0 to 254."},
      {"sigma_per_speed", &P::sigmaPerSpeed, "s", "Deviation ahead of a person per speed."},
      {"sigma_min", &P::sigmaMin, "m", "Deviation ahead of a person, at least."},
      {"side_ratio", &P::sideRatio, "", "Deviation to the sides / ahead."},
      {"rear_ratio", &P::rearRatio, "", "Deviation behind / ahead."},
      {"cutoff", &P::cutoff, "", "Lower costs are left out, 1 to 254."},
  };
  return kKeys;
}

const std::vector<Nav2Key<KeepoutFilterParameters>>& keepoutFilterKeys() {
  using P = KeepoutFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter takes part."},
      {"override_lethal_cost", &P::overrideLethalCost, "",
       "Whether a robot in a keep-out zone may drive out of it.", kSinceJazzy},
      {"lethal_override_cost", &P::lethalOverrideCost, "", "Cost of the zone while it does.",
       kSinceJazzy},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask counts."},
      {"mask_file", &P::maskFile, "",
       "The mask, a map's YAML beside this file. A key of this program, instead of the topic."},
  };
  return kKeys;
}

const std::vector<Nav2Key<SpeedFilterParameters>>& speedFilterKeys() {
  using P = SpeedFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter takes part."},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask counts."},
      {"mask_file", &P::maskFile, "",
       "The mask, a map's YAML beside this file. A key of this program, instead of the topic."},
      {"mask_base", &P::maskBase, "",
       "Limit where the mask is 0 to 100: base + multiplier * value. A key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", "See mask_base. A key of this program."},
      {"mask_is_percentage", &P::maskIsPercentage, "",
       "Whether the limit is in percent of the full speed, else m/s. A key of this program."},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleCostmapKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"robot_base_frame", "the base frames of a robot coincide here"},
      {"transform_tolerance", "no TF here"},
      {"initial_transform_timeout", "no TF here", kSinceJazzy},
      {"always_send_full_costmap", "a published costmap is whole here"},
      {"map_topic", "the map is the scenario's", kUntilJazzy},
      {"map_vis_z", "for displays of ROS", kSinceJazzy},
      {"observation_sources", "those of the layers count", kUntilKilted},
      {"use_sim_time", "time is simulated here"},
      {"introspection_mode", "no services of ROS here"},
      {"subscribe_to_stamped_footprint", "the footprint does not change here", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleLayerKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"plugin", "is the type"},
      {"map_subscribe_transient_local", "the map is the scenario's"},
      {"subscribe_to_updates", "the map does not change here"},
      {"map_topic", "the map is the scenario's"},
      {"transform_tolerance", "no TF here"},
      {"tf_filter_tolerance", "no TF here", kSinceKilted},
      {"transport_type", "no topics here", kSinceLyrical},
      {"unknown_threshold", "no voxels here: it counts as 15"},
      {"publish_voxel_map", "for displays of ROS"},
      {"num_threads", "costs do not depend on it", kSinceLyrical},
      {"mask_topic", "filter_info_topic determines the mask"},
      {"speed_limit_topic", "the costmap passes its limit on"},
      {"enable_path_lookahead", "not re-implemented: only the cell of the robot counts",
       kSinceLyrical},
      {"max_decel", "not re-implemented: only the cell of the robot counts", kSinceLyrical},
      {"max_lookahead", "not re-implemented: only the cell of the robot counts", kSinceLyrical},
      {"min_lookahead", "not re-implemented: only the cell of the robot counts", kSinceLyrical},
      {"binary_state_topic", "no topics here: the manifest has the state"},
      {"plan_topic", "the path is handed over", kSinceLyrical},
      {"odom_topic", "no topics here", kSinceLyrical},
      {"path_topic", "no topics here", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleSourceKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"sensor_frame", "the lidar knows where it is"},
      {"transport_type", "no topics here", kSinceLyrical},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
