#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/nav2/Costmap.h"

/// Graphs of nav2_route: nodes at places, directed edges between them, what is known of both, and
/// what is to be done there.
namespace sim2d::nav2 {

/// What a graph file says of a node, an edge or an operation, by key. Lists and objects in it are
/// not kept: no scorer or operation here reads them.
class RouteMetadata {
 public:
  using Value = std::variant<bool, double, std::string>;

  void set(const std::string& key, Value value) { values_[key] = std::move(value); }
  bool has(const std::string& key) const { return values_.count(key) != 0; }
  /// None: the key is absent, or its value is of another type.
  std::optional<double> number(const std::string& key) const;
  std::optional<std::string> text(const std::string& key) const;

 private:
  std::map<std::string, Value> values_;
};

/// Something that is to be done at a node, or where an edge begins or ends.
struct RouteOperation {
  enum class Trigger : std::uint8_t { Node, OnEnter, OnExit };
  std::string type;  // name of the plugin of the route server
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
  std::size_t from = 0, to = 0;  // nodes by index
  double cost = 0.0;             // counts when scorers must not change it, or when there are none
  bool overridable = true;       // scorers find the cost
  RouteMetadata metadata;
  std::vector<RouteOperation> operations;
};

struct RouteGraph {
  std::vector<RouteNode> nodes;
  std::vector<RouteEdge> edges;
  std::vector<std::vector<std::size_t>> outgoing;  // edges by index, of each node, in file order
  std::map<std::uint32_t, std::size_t> indexOf;    // nodes by id

  bool isEmpty() const { return nodes.empty(); }
  std::optional<std::size_t> nodeOf(std::uint32_t id) const;  // none: there is no such node
  double lengthOf(const RouteEdge& edge) const {              // [m]
    return (nodes[edge.to].place - nodes[edge.from].place).norm();
  }
};

/// A graph as a GeoJSON text (RFC 7946) has it: a FeatureCollection whose Point features are nodes
/// (properties id, metadata, operations) and whose MultiLineString features are edges (properties
/// id, startid, endid, cost, overridable, metadata, operations). Other features are left out, as in
/// Nav2's GeoJsonGraphFileLoader. Places are those of the map frame [m]; another `frame` of a node
/// is a warning. Errors, all at once with line and column: no JSON, no features, a wrong type, two
/// nodes of one id, an edge without its nodes, no node or no edge at all. `file` is named in them.
base::Result<RouteGraph> readRouteGraph(const std::string& text, const std::string& file);

}  // namespace sim2d::nav2
