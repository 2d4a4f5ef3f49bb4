#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Costmap.h"

/// Graphs of nav2_route: nodes with positions and directed edges, both with metadata and
/// operations.
namespace sim2d::nav2 {

/// Metadata of a node, edge or operation in a graph file. Lists and objects are dropped: no scorer
/// or operation reads them.
class RouteMetadata {
 public:
  using Value = std::variant<bool, double, std::string>;

  void set(const std::string& key, Value value) { values_[key] = std::move(value); }
  bool has(const std::string& key) const { return values_.count(key) != 0; }
  /// nullopt: the key is absent, or its value has another type.
  std::optional<double> number(const std::string& key) const;
  std::optional<std::string> text(const std::string& key) const;

 private:
  std::map<std::string, Value> values_;
};

/// An operation at a node, or at the beginning or end of an edge.
struct RouteOperation {
  enum class Trigger : std::uint8_t { Node, OnEnter, OnExit };
  std::string type;  // plugin name in the route server
  Trigger trigger = Trigger::Node;
  RouteMetadata metadata;
};

struct RouteNode {
  std::uint32_t id = 0;
  Vec2 place = Vec2::Zero();  // [m]
  RouteMetadata metadata;
  std::vector<RouteOperation> operations;
};

struct RouteEdge {
  std::uint32_t id = 0;
  std::size_t from = 0, to = 0;  // node indices
  double cost = 0.0;             // used if not overridable, or if there are no scorers
  bool overridable = true;       // scorers determine the cost
  RouteMetadata metadata;
  std::vector<RouteOperation> operations;
};

struct RouteGraph {
  std::vector<RouteNode> nodes;
  std::vector<RouteEdge> edges;
  std::vector<std::vector<std::size_t>> outgoing;  // edge indices of each node, in file order
  std::map<std::uint32_t, std::size_t> indexOf;    // node indices by id

  bool isEmpty() const { return nodes.empty(); }
  std::optional<std::size_t> nodeOf(std::uint32_t id) const;  // nullopt: no such node
  double lengthOf(const RouteEdge& edge) const {              // [m]
    return (nodes[edge.to].place - nodes[edge.from].place).norm();
  }
};

/// Reads a graph from GeoJSON (RFC 7946): a FeatureCollection whose Point features are nodes
/// (properties id, metadata, operations) and whose MultiLineString features are edges (properties
/// id, startid, endid, cost, overridable, metadata, operations). Ignores other features, like
/// Nav2's GeoJsonGraphFileLoader. Positions are in the map frame [m]; another `frame` of a node is
/// a warning. Reports all errors with line and column: invalid JSON, no features, wrong types,
/// duplicate node ids, edges with missing nodes, no nodes or no edges. `file` is the file name in
/// messages.
base::Result<RouteGraph> readRouteGraph(const std::string& text, const std::string& file);

/// Why there is no route, with the codes of nav2_msgs/action/ComputeRoute and ComputeAndTrackRoute.
enum class RouteError : std::uint16_t {
  None = 0,
  Unknown = 400,
  TfError = 401,  // not used
  NoValidGraph = 402,
  IndeterminantNodes = 403,
  Timeout = 404,  // the iteration limit is reached
  NoValidRoute = 405,
  OperationFailed = 406,
  InvalidEdgeScorerUse = 407,
};

/// A path through a graph: consecutive edges by index.
struct Route {
  std::size_t start = 0;           // node index
  std::vector<std::size_t> edges;  // empty: the start is the goal
  std::vector<double> costs;       // of each edge
  double cost = 0.0;               // sum of all

  std::size_t endOf(const RouteGraph& graph) const {  // node index
    return edges.empty() ? start : graph.edges[edges.back()].to;
  }
};

struct RouteResult {
  RouteError error = RouteError::None;
  std::string text;  // error message
  Route route;       // if there is no error
};

/// Request of the action.
struct RouteRequest {
  bool usesPoses = false;  // else nodes by id
  Pose2 start, goal;
  std::uint32_t startId = 0, goalId = 0;
};

/// Edge ids.
using BlockedEdges = std::set<std::uint32_t>;

/// The edge that is being followed during rerouting.
struct ContinuedEdge {
  std::optional<std::size_t> edge;  // index
  Vec2 nearest = Vec2::Zero();      // its nearest point to the robot [m]
};

/// Inputs of the route server in a step.
struct RouteScene {
  Pose2 robot;
  const Costmap* global = nullptr;  // null: not available
  const Costmap* local = nullptr;
  double time = 0.0;   // [s]
  Pose2 localFrame{};  // frame of `local`, in the map

  /// The local costmap if the topic contains "local", else the global one, and its frame.
  std::pair<const Costmap*, Pose2> costmapOf(const std::string& topic) const {
    const bool isLocal = topic.find("local") != std::string::npos;
    return {isLocal ? local : global, isLocal ? localFrame : Pose2()};
  }
};

}  // namespace sim2d::nav2
