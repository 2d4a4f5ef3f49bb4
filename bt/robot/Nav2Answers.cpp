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

}  // namespace

double Nav2Servers::speed() const {
  const BodyTwist mean = odometry_.mean();
  return std::sqrt(mean.linear * mean.linear + mean.lateral * mean.lateral);
}

bool Nav2Servers::isPathValid(PathId id, int maxCost, bool unknownBlocks) const {
  const Path& path = paths().get(id);
  const base::Vec2 robot = observation_->pose.position;
  const CostmapFootprint& footprint = global_->footprint();
  const Costmap& costmap = global_->costmap();
  const auto nearest =
      std::min_element(path.begin(), path.end(), [&](const base::Pose2& a, const base::Pose2& b) {
        return (a.position - robot).squaredNorm() < (b.position - robot).squaredNorm();
      });
  const auto isBlocked = [&](const base::Pose2& place) {
    const std::uint8_t cost = footprint.isRadius ? placeCost(costmap, place.position)
                                                 : footprintCost(costmap, footprint.corners, place);
    if (cost == kNoInformation) {
      return unknownBlocks;
    }
    return cost == kLethal || (footprint.isRadius && cost == kInscribed) || cost >= maxCost;
  };
  return !path.empty() && std::none_of(nearest, path.end(), isBlocked);
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
    costmap.clearEntirely();
    return true;
  }
  const base::Pose2 inMap = request.pose.value_or(observation_->pose);
  const base::Vec2 place = (request.isLocal ? sim2d::toFrame(localFrame(), inMap) : inMap).position;
  return request.extent == Extent::Except ? costmap.clearExcept(place, request.distance, plugins)
                                          : costmap.clearAround(place, request.distance, plugins);
}

}  // namespace bt
