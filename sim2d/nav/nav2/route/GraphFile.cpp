#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "sim2d/nav/nav2/route/PlacedJson.h"
#include "sim2d/nav/nav2/route/RouteGraph.h"

// A graph from its GeoJSON file.
namespace sim2d::nav2 {
namespace {

using Kind = PlacedJson::Kind;

class GraphReader {
 public:
  explicit GraphReader(std::string file) : file_(std::move(file)) {}

  void read(const PlacedJson& root);
  base::Diagnostics takeProblems() { return std::move(problems_); }
  RouteGraph takeGraph() { return std::move(graph_); }

 private:
  void error(const PlacedJson& at, const char* code, base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_, at.line, at.column));
  }
  /// The member of an object; null with an error when it is not there or of another kind.
  const PlacedJson* need(const PlacedJson& object, const char* key, Kind kind);
  const PlacedJson* optional(const PlacedJson& object, const char* key, Kind kind);
  std::optional<std::uint32_t> needId(const PlacedJson& object, const char* key);
  std::optional<Vec2> placeOf(const PlacedJson& coordinates);

  void readNode(const PlacedJson& feature, const PlacedJson& geometry);
  void readEdge(const PlacedJson& feature);
  RouteMetadata metadataOf(const PlacedJson& properties);
  std::vector<RouteOperation> operationsOf(const PlacedJson& properties, bool isNode);

  std::string file_;
  RouteGraph graph_;
  base::Diagnostics problems_;
};

const char* kindName(Kind kind) {
  switch (kind) {
    case Kind::Object:
      return "an object";
    case Kind::List:
      return "a list";
    case Kind::Number:
      return "a number";
    case Kind::Bool:
      return "true or false";
    default:
      return "a text";
  }
}

using Members = std::vector<std::pair<std::string, PlacedJson>>;

const Members& membersOf(const PlacedJson* object) {
  static const Members kNone;
  return object != nullptr ? object->members : kNone;
}

const PlacedJson* GraphReader::optional(const PlacedJson& object, const char* key, Kind kind) {
  const PlacedJson* const member = object.find(key);
  if (member == nullptr || member->kind == Kind::Null) {
    return nullptr;
  }
  if (member->kind != kind) {
    error(*member, "route.kind", {key, kindName(kind)});
    return nullptr;
  }
  return member;
}

const PlacedJson* GraphReader::need(const PlacedJson& object, const char* key, Kind kind) {
  if (object.find(key) == nullptr) {
    error(object, "route.missing", {key});
    return nullptr;
  }
  return optional(object, key, kind);
}

std::optional<std::uint32_t> GraphReader::needId(const PlacedJson& object, const char* key) {
  const PlacedJson* const member = need(object, key, Kind::Number);
  if (member == nullptr) {
    return std::nullopt;
  }
  const bool isId = member->number >= 0.0 && member->number == std::floor(member->number) &&
                    member->number < std::numeric_limits<std::uint32_t>::max();
  if (!isId) {
    error(*member, "route.id", {key});
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(member->number);
}

std::optional<Vec2> GraphReader::placeOf(const PlacedJson& coordinates) {
  const bool isPoint = coordinates.items.size() >= 2 && coordinates.items[0].kind == Kind::Number &&
                       coordinates.items[1].kind == Kind::Number;
  if (!isPoint) {
    error(coordinates, "route.coordinates");
    return std::nullopt;
  }
  return Vec2(coordinates.items[0].number, coordinates.items[1].number);
}

RouteMetadata GraphReader::metadataOf(const PlacedJson& properties) {
  RouteMetadata metadata;
  const PlacedJson* const object = optional(properties, "metadata", Kind::Object);
  for (const auto& [key, value] : membersOf(object)) {
    if (value.kind == Kind::Number) {
      metadata.set(key, value.number);
    } else if (value.kind == Kind::Text) {
      metadata.set(key, value.text);
    } else if (value.kind == Kind::Bool) {
      metadata.set(key, value.isTrue);
    }
  }
  return metadata;
}

std::vector<RouteOperation> GraphReader::operationsOf(const PlacedJson& properties, bool isNode) {
  using Trigger = RouteOperation::Trigger;
  std::vector<RouteOperation> operations;
  const PlacedJson* const object = optional(properties, "operations", Kind::Object);
  for (const auto& [name, value] : membersOf(object)) {
    if (value.kind != Kind::Object) {
      error(value, "route.kind", {name, kindName(Kind::Object)});
      continue;
    }
    RouteOperation operation;
    const PlacedJson* const type = need(value, "type", Kind::Text);
    const PlacedJson* const trigger = optional(value, "trigger", Kind::Text);
    operation.type = type != nullptr ? type->text : std::string();
    operation.metadata = metadataOf(value);
    const std::string word = trigger != nullptr ? trigger->text : isNode ? "NODE" : "";
    if (word == "ON_ENTER" || word == "ON_EXIT") {
      operation.trigger = word == "ON_ENTER" ? Trigger::OnEnter : Trigger::OnExit;
    } else if (word != "NODE") {
      error(trigger != nullptr ? *trigger : value, "route.trigger", {word});
    }
    operations.push_back(std::move(operation));
  }
  return operations;
}

void GraphReader::readNode(const PlacedJson& feature, const PlacedJson& geometry) {
  const PlacedJson* const properties = need(feature, "properties", Kind::Object);
  const PlacedJson* const coordinates = need(geometry, "coordinates", Kind::List);
  const auto place = coordinates != nullptr ? placeOf(*coordinates) : std::nullopt;
  const auto id = properties != nullptr ? needId(*properties, "id") : std::nullopt;
  if (!id || !place) {
    return;
  }
  if (graph_.nodeOf(*id)) {
    error(*properties, "route.node-twice", {static_cast<int>(*id)});
  }
  const PlacedJson* const frame = optional(*properties, "frame", Kind::Text);
  if (frame != nullptr && frame->text != "map") {
    problems_.push_back(
        base::warning("route.frame", {frame->text}, file_, frame->line, frame->column));
  }
  graph_.indexOf.emplace(*id, graph_.nodes.size());
  graph_.nodes.push_back({*id, *place, metadataOf(*properties), operationsOf(*properties, true)});
}

void GraphReader::readEdge(const PlacedJson& feature) {
  const PlacedJson* const properties = need(feature, "properties", Kind::Object);
  if (properties == nullptr) {
    return;
  }
  const auto id = needId(*properties, "id"), from = needId(*properties, "startid"),
             to = needId(*properties, "endid");
  if (!id || !from || !to) {
    return;
  }
  const auto first = graph_.nodeOf(*from), second = graph_.nodeOf(*to);
  for (const auto& [node, key, named] :
       {std::tuple(first, "startid", *from), std::tuple(second, "endid", *to)}) {
    if (!node) {
      error(*properties->find(key), "route.no-node", {key, static_cast<int>(named)});
    }
  }
  RouteEdge edge;
  edge.id = *id;
  if (const PlacedJson* const cost = optional(*properties, "cost", Kind::Number)) {
    edge.cost = cost->number;
  }
  if (const PlacedJson* const overridable = optional(*properties, "overridable", Kind::Bool)) {
    edge.overridable = overridable->isTrue;
  }
  edge.metadata = metadataOf(*properties);
  edge.operations = operationsOf(*properties, false);
  if (first && second) {
    edge.from = *first;
    edge.to = *second;
    graph_.edges.push_back(std::move(edge));
  }
}

void GraphReader::read(const PlacedJson& root) {
  if (root.kind != Kind::Object) {
    error(root, "route.kind", {"the file", kindName(Kind::Object)});
    return;
  }
  const PlacedJson* const features = need(root, "features", Kind::List);
  if (features == nullptr) {
    return;
  }
  std::vector<const PlacedJson*> edges;
  for (const PlacedJson& feature : features->items) {
    const PlacedJson* const geometry =
        feature.kind == Kind::Object ? need(feature, "geometry", Kind::Object) : nullptr;
    const PlacedJson* const type =
        geometry != nullptr ? need(*geometry, "type", Kind::Text) : nullptr;
    if (feature.kind != Kind::Object) {
      error(feature, "route.kind", {"a feature", kindName(Kind::Object)});
    } else if (type != nullptr && type->text == "Point") {
      readNode(feature, *geometry);
    } else if (type != nullptr && type->text == "MultiLineString") {
      edges.push_back(&feature);
    }
  }
  for (const PlacedJson* const edge : edges) {  // once all nodes are there
    readEdge(*edge);
  }
  if (!base::hasErrors(problems_) && (graph_.nodes.empty() || graph_.edges.empty())) {
    error(*features, "route.empty");
  }
  graph_.outgoing.resize(graph_.nodes.size());
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    graph_.outgoing[graph_.edges[i].from].push_back(i);
  }
}

}  // namespace

base::Result<RouteGraph> readRouteGraph(const std::string& text, const std::string& file) {
  base::Diagnostics problems;
  const std::optional<PlacedJson> root = parsePlacedJson(text, file, problems);
  if (!root) {
    return problems;
  }
  GraphReader reader(file);
  reader.read(*root);
  problems = reader.takeProblems();
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {reader.takeGraph(), std::move(problems)};
}

}  // namespace sim2d::nav2
