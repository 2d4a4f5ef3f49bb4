#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/costmap/FootprintCost.h"

// What nodes of the tree ask and get an answer to at once.
namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using sim2d::BodyTwist;

Path::const_iterator nearestPose(const Path& path, const base::Vec2& place) {
  return std::min_element(
      path.begin(), path.end(), [&](const base::Pose2& a, const base::Pose2& b) {
        return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
      });
}

/// The cells of a layer; of the costmap itself for an empty name. Null: it has no such layer.
const Costmap* gridOf(const LayeredCostmap& costmap, const std::string& layer) {
  if (layer.empty()) {
    return &costmap.costmap();
  }
  const CostmapLayer* const found = costmap.layer(layer);
  return found != nullptr ? found->grid() : nullptr;
}

/// Whether a pose of this cost blocks a path; a robot of a radius also where it touches.
bool isBlocked(const PathCheck& check, std::uint8_t cost, bool isRadius) {
  if (cost == kNoInformation) {
    return check.unknownBlocks;
  }
  return cost == kLethal || (isRadius && cost == kInscribed) || cost >= check.maxCost;
}

}  // namespace

double Nav2Servers::speed() const {
  const BodyTwist mean = odometry_.mean();
  return std::sqrt(mean.linear * mean.linear + mean.lateral * mean.lateral);
}

std::optional<std::uint8_t> Nav2Servers::costAt(bool isLocal, const base::Pose2& pose,
                                                bool usesFootprint) const {
  const LayeredCostmap& costmap = isLocal ? *local_ : *global_;
  const auto cell = costmap.costmap().worldToCell(pose.position);
  if (!cell) {
    return std::nullopt;
  }
  return usesFootprint ? footprintCost(costmap.costmap(), costmap.footprint().corners, pose)
                       : costmap.costmap().at(*cell);
}

PathCheckResult Nav2Servers::checkPath(const PathCheck& check) const {
  const Path& path = paths().get(check.path);
  const Costmap* const costmap = gridOf(*global_, check.layer);
  const base::Result<Polygon> given = check.footprint.empty()
                                          ? base::Result<Polygon>(global_->footprint().corners)
                                          : readPolygon(check.footprint);
  if (path.empty() || costmap == nullptr || !given) {
    return {};
  }
  const bool isRadius = global_->footprint().isRadius && check.footprint.empty();
  PathCheckResult result;
  const auto nearest = nearestPose(path, observation_->pose.position);
  double distance = 0.0;  // [m] from the nearest pose
  for (auto pose = nearest; pose != path.end(); ++pose) {
    distance += pose == nearest ? 0.0 : (pose->position - (pose - 1)->position).norm();
    if (check.lookahead >= 0.0 && distance > check.lookahead) {
      break;
    }
    const std::uint8_t cost =
        isRadius ? placeCost(*costmap, pose->position) : footprintCost(*costmap, *given, *pose);
    if (isBlocked(check, cost, isRadius)) {
      result.collisions.push_back(*pose);
      if (check.stopsAtFirst) {
        break;
      }
    }
  }
  result.isValid = result.collisions.empty();
  return result;
}

bool Nav2Servers::relocalize() {
  asksRelocalization_ = asksRelocalization_ || observation_->canRelocalize;
  return observation_->canRelocalize;
}

bool Nav2Servers::clear(const ClearRequest& request) {
  LayeredCostmap& costmap = request.isLocal ? *local_ : *global_;
  ++counts_.clears;
  std::string names = request.plugins;
  std::replace(names.begin(), names.end(), ';', ',');
  std::vector<std::string> plugins;
  for (const std::string& name : base::split(names, ',')) {
    if (!base::trimmed(name).empty()) {
      plugins.push_back(base::trimmed(name));
    }
  }
  using Extent = ClearRequest::Extent;
  if (request.extent == Extent::Entire) {
    return costmap.clearEntirely(plugins);
  }
  const base::Pose2 inMap = request.pose.value_or(observation_->pose);
  const base::Vec2 place = (request.isLocal ? sim2d::toFrame(localFrame(), inMap) : inMap).position;
  return request.extent == Extent::Except ? costmap.clearExcept(place, request.distance, plugins)
                                          : costmap.clearAround(place, request.distance, plugins);
}

}  // namespace bt
