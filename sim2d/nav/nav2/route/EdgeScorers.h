#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/route/Route.h"
#include "sim2d/nav/nav2/route/RouteParameters.h"

namespace sim2d::nav2 {

/// What DynamicEdgesScorer has been told by its service adjust_edges.
struct DynamicEdges {
  std::set<std::uint32_t> closed;         // edges by id
  std::map<std::uint32_t, double> costs;  // added to those of edges

  /// "close 3 4", "open 3", "cost 3 2.5". False: it is none of these, and nothing changes.
  bool apply(const std::string& text);
};

/// Where an edge lies in a search: it begins at the start, or ends at the goal.
enum class EdgeRole : std::uint8_t { None, Start, End };

/// What scorers look at.
struct ScoringScene {
  const RouteRequest& request;
  const DynamicEdges& dynamicEdges;
  const Costmap* global = nullptr;  // null: none yet, edges cannot be taken
  const Costmap* local = nullptr;
  Pose2 localFrame{};  // the frame of `local`, in the map
};

/// Costs of edges by the plugins of the key edge_cost_functions, whose costs add up (nav2_route,
/// plugins/edge_cost_functions). A plain value.
class EdgeScorers {
 public:
  explicit EdgeScorers(std::vector<std::pair<std::string, EdgeScorerSettings>> settings)
      : settings_(std::move(settings)) {}

  bool isEmpty() const { return settings_.empty(); }
  /// A scorer compares headings with those of poses, so a request by ids cannot be scored.
  bool needsPoses() const;
  /// None: the edge cannot be taken.
  std::optional<double> cost(const RouteGraph& graph, const RouteEdge& edge, EdgeRole role,
                             const ScoringScene& scene) const;

 private:
  std::vector<std::pair<std::string, EdgeScorerSettings>> settings_;
};

}  // namespace sim2d::nav2
