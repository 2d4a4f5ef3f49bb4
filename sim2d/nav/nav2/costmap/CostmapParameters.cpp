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
      {"spatio_temporal_voxel_layer::SpatioTemporalVoxelLayer",
       SpatioTemporalVoxelLayerParameters{}},
      {"nav2_costmap_2d::PluginContainerLayer", PluginContainerLayerParameters{}},
      {"nav2_costmap_2d::BinaryFilter", BinaryFilterParameters{}},
  };
  return kTypes;
}

/// Keys shared by obstacle and voxel layers.
template <class Layer>
std::vector<Nav2Key<Layer>> obstacleRows() {
  return {
      {"enabled", &Layer::enabled, "", "Whether the layer is enabled."},
      {"footprint_clearing_enabled", &Layer::footprintClearingEnabled, "",
       "Whether the cells under the robot are set free."},
      {"min_obstacle_height", &Layer::minObstacleHeight, "m", "Lower points are not marked.",
       kSinceJazzy},
      {"max_obstacle_height", &Layer::maxObstacleHeight, "m", "Higher points are not marked."},
      {"combination_method", &Layer::combinationMethod, "",
       "0: overwrites the costs of the layers below; 1: maximum of both costs; 2: maximum where "
       "the costs are known."},
      {"observation_sources", &Layer::observationSources, "",
       "Names of the sources, separated by blanks."},
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
       "Whether cells without data are unknown, else free."},
      {"robot_radius", &P::robotRadius, "m", "Radius of a robot without a footprint."},
      {"footprint", &P::footprint, "m", "Corners of the robot's footprint: \"[[x, y], …]\"."},
      {"footprint_padding", &P::footprintPadding, "m", "Added to the corners on each axis."},
      {"plugins", &P::plugins, "", "Names of the layers, in the order of the update."},
      {"filters", &P::filters, "", "Names of the filters, applied after the layers."},
      {"unknown_cost_value", &P::unknownCostValue, "", "Occupancy that means unknown."},
      {"lethal_cost_threshold", &P::lethalCostThreshold, "",
       "Occupancy from which a cell is an obstacle."},
      {"trinary_costmap", &P::trinaryCostmap, "",
       "Whether lower occupancies are free, else their costs are proportional."},
      {"inscribed_obstacle_cost_value", &P::inscribedObstacleCostValue, "",
       "Occupancy of a cell within the inscribed radius of an obstacle.", kSinceLyrical},
      {"use_maximum", &P::useMaximum, "",
       "Whether the map only raises the costs of the layers below, else it overwrites them."},
  };
  return kKeys;
}

const std::vector<Nav2Key<StaticLayerParameters>>& staticLayerKeys() {
  using P = StaticLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer is enabled."},
      {"footprint_clearing_enabled", &P::footprintClearingEnabled, "",
       "Whether the cells under the robot are set free."},
      {"restore_cleared_footprint", &P::restoreClearedFootprint, "",
       "Whether these cells are restored after the robot has left them.", kSinceKilted},
  };
  return kKeys;
}

const std::vector<Nav2Key<ObservationSource>>& observationSourceKeys() {
  using P = ObservationSource;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"topic", &P::topic, "", "Topic of the scans: here always the robot's lidar."},
      {"data_type", &P::dataType, "", "LaserScan or PointCloud2: here always the lidar's scan."},
      {"observation_persistence", &P::observationPersistence, "s",
       "Time for which a scan is used; 0: until the next one."},
      {"expected_update_rate", &P::expectedUpdateRate, "s",
       "Age of a scan from which the costmap is stale; 0: never."},
      {"min_obstacle_height", &P::minObstacleHeight, "m", "Lower points are ignored."},
      {"max_obstacle_height", &P::maxObstacleHeight, "m", "Higher points are ignored."},
      {"inf_is_valid", &P::infIsValid, "",
       "Whether beams without a hit clear cells, else they are ignored."},
      {"marking", &P::marking, "", "Whether points become obstacles."},
      {"clearing", &P::clearing, "", "Whether beams clear the cells that they pass."},
      {"obstacle_max_range", &P::obstacleMaxRange, "m", "Farther points do not mark."},
      {"obstacle_min_range", &P::obstacleMinRange, "m", "Nearer points do not mark."},
      {"raytrace_max_range", &P::raytraceMaxRange, "m",
       "No cells are cleared beyond this distance."},
      {"raytrace_min_range", &P::raytraceMinRange, "m",
       "No cells are cleared within this distance."},
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
    keys.push_back({"z_voxels", &P::zVoxels, "", "Number of voxels per column, at most 16."});
    keys.push_back({"mark_threshold", &P::markThreshold, "",
                    "A column with more marked voxels is an obstacle; from 1 no column is one in "
                    "this program."});
    return keys;
  }();
  return kKeys;
}

const std::vector<Nav2Key<InflationLayerParameters>>& inflationLayerKeys() {
  using P = InflationLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer is enabled."},
      {"inflation_radius", &P::inflationRadius, "m", "Radius of the inflation around obstacles."},
      {"cost_scaling_factor", &P::costScalingFactor, "1/m",
       "Rate of the exponential decay of the costs."},
      {"inflate_unknown", &P::inflateUnknown, "", "Whether unknown cells are inflated."},
      {"inflate_around_unknown", &P::inflateAroundUnknown, "",
       "Whether unknown cells count as obstacles."},
      {"custom_inscribed_radius", &P::customInscribedRadius, "m",
       "Inscribed radius, within which a collision is certain; below 0: that of the footprint.",
       kSinceLyrical},
  };
  return kKeys;
}

const std::vector<Nav2Key<SocialLayerParameters>>& socialLayerKeys() {
  using P = SocialLayerParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the layer is enabled."},
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
  return kKeys;
}

const std::vector<Nav2Key<KeepoutFilterParameters>>& keepoutFilterKeys() {
  using P = KeepoutFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"override_lethal_cost", &P::overrideLethalCost, "",
       "Whether a robot in a keep-out zone may drive out of it.", kSinceJazzy},
      {"lethal_override_cost", &P::lethalOverrideCost, "",
       "Cost of the zone while the robot drives out.", kSinceJazzy},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask is used."},
      {"mask_file", &P::maskFile, "",
       "Mask: YAML file of a map beside this file. Key of this program that replaces the topic."},
  };
  return kKeys;
}

const std::vector<Nav2Key<SpeedFilterParameters>>& speedFilterKeys() {
  using P = SpeedFilterParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"enabled", &P::enabled, "", "Whether the filter is enabled."},
      {"filter_info_topic", &P::filterInfoTopic, "",
       "Topic of the costmap_filter_info_server whose mask is used."},
      {"mask_file", &P::maskFile, "",
       "Mask: YAML file of a map beside this file. Key of this program that replaces the topic."},
      {"mask_base", &P::maskBase, "",
       "Limit for mask values from 0 to 100: base + multiplier * value. Key of this program."},
      {"mask_multiplier", &P::maskMultiplier, "", "See mask_base. Key of this program."},
      {"mask_is_percentage", &P::maskIsPercentage, "",
       "Whether the limit is in percent of the maximum speed, else in m/s. Key of this program."},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredCostmapKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"robot_base_frame", "all base frames of a robot are identical"},
      {"transform_tolerance", "TF is not used"},
      {"initial_transform_timeout", "TF is not used", kSinceJazzy},
      {"always_send_full_costmap", "published costmaps are always complete"},
      {"map_topic", "the map is the scenario's", kUntilJazzy},
      {"map_vis_z", "only used by ROS displays", kSinceJazzy},
      {"observation_sources", "those of the layers are used", kUntilKilted},
      {"use_sim_time", "time is always simulated"},
      {"introspection_mode", "ROS services are not used"},
      {"subscribe_to_stamped_footprint", "the footprint is constant", kSinceLyrical},
  };
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredLayerKeys() {
  static const std::vector<IgnoredKey> kKeys = {
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
  return kKeys;
}

const std::vector<IgnoredKey>& ignoredSourceKeys() {
  static const std::vector<IgnoredKey> kKeys = {
      {"sensor_frame", "the robot's lidar determines the sensor pose"},
      {"transport_type", "ROS topics are not used", kSinceLyrical},
  };
  return kKeys;
}

}  // namespace sim2d::nav2
