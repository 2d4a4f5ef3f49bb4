#include "sim2d/nav/nav2/route/RouteGraph.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include <nlohmann/json.hpp>

namespace sim2d::nav2 {
namespace {

template <class T>
std::optional<T> valueOf(const std::map<std::string, RouteMetadata::Value>& values,
                         const std::string& key) {
  const auto found = values.find(key);
  const T* const value = found == values.end() ? nullptr : std::get_if<T>(&found->second);
  return value != nullptr ? std::optional<T>(*value) : std::nullopt;
}

}  // namespace

std::optional<double> RouteMetadata::number(const std::string& key) const {
  return valueOf<double>(values_, key);
}

std::optional<std::string> RouteMetadata::text(const std::string& key) const {
  return valueOf<std::string>(values_, key);
}

std::optional<std::size_t> RouteGraph::nodeOf(std::uint32_t id) const {
  const auto found = indexOf.find(id);
  return found == indexOf.end() ? std::nullopt : std::optional<std::size_t>(found->second);
}

// Reads a graph from its GeoJSON file.
namespace {

/// A JSON value with its position in the text, for messages: its end, or the beginning of an object
/// or list.
struct PositionedJson {
  enum class Kind { Null, Bool, Number, Text, List, Object };
  Kind kind = Kind::Null;
  bool isTrue = false;
  double number = 0.0;
  std::string text;
  std::vector<PositionedJson> items;                            // of a list
  std::vector<std::pair<std::string, PositionedJson>> members;  // of an object, in file order
  int line = 0, column = 0;                                     // from 1

  const PositionedJson* find(const std::string& key) const {  // null: no such member
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&key](const auto& member) { return member.first == key; });
    return found == members.end() ? nullptr : &found->second;
  }
};

constexpr std::size_t kMaxLevels = 64;

struct TextPosition {
  int line = 1, column = 0;              // of the last character read
  int lineBefore = 1, columnBefore = 0;  // of the character before it
};

/// An iterator over a text that counts lines and columns.
class PositionIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  PositionIterator(const char* at, TextPosition* place) : at_(at), place_(place) {}
  reference operator*() const { return *at_; }
  PositionIterator& operator++() {
    place_->lineBefore = place_->line;
    place_->columnBefore = place_->column;
    const bool isEnd = *at_ == '\n';
    place_->line += isEnd ? 1 : 0;
    place_->column = isEnd ? 0 : place_->column + 1;
    ++at_;
    return *this;
  }
  bool operator==(const PositionIterator& other) const { return at_ == other.at_; }
  bool operator!=(const PositionIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  TextPosition* place_;
};

/// Builds the value from the parser's events.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonBuilder(PositionedJson& root, const TextPosition& place) : root_(root), place_(place) {}

  bool null() override { return put(PositionedJson::Kind::Null) != nullptr; }
  bool boolean(bool value) override {
    put(PositionedJson::Kind::Bool)->isTrue = value;
    return true;
  }
  bool number_integer(number_integer_t value) override {
    return putNumber(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return putNumber(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return putNumber(value);
  }
  bool string(string_t& value) override {
    put(PositionedJson::Kind::Text)->text = value;
    return true;
  }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(PositionedJson::Kind::Object); }
  bool start_array(std::size_t /*size*/) override { return open(PositionedJson::Kind::List); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    key_ = name;
    return true;
  }
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*problem*/) override {
    return false;
  }

 private:
  PositionedJson* put(PositionedJson::Kind kind) {
    PositionedJson* made = &root_;
    if (!open_.empty() && open_.back()->kind == PositionedJson::Kind::List) {
      made = &open_.back()->items.emplace_back();
    } else if (!open_.empty()) {
      made = &open_.back()->members.emplace_back(key_, PositionedJson()).second;
    }
    made->kind = kind;
    made->line = place_.line;
    made->column = std::max(place_.column, 1);
    return made;
  }
  bool putNumber(double value) {
    PositionedJson* const made = put(PositionedJson::Kind::Number);
    made->number = value;
    made->line = place_.lineBefore;  // a number ends where the next character begins
    made->column = std::max(place_.columnBefore, 1);
    return true;
  }
  bool open(PositionedJson::Kind kind) {
    if (open_.size() >= kMaxLevels) {
      return false;
    }
    open_.push_back(put(kind));  // valid until it is closed: its siblings are added later
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  PositionedJson& root_;
  const TextPosition& place_;
  std::vector<PositionedJson*> open_;
  std::string key_;
};

/// Returns nullopt with an error with line and column for invalid JSON, or a depth above 64.
std::optional<PositionedJson> parsePositionedJson(const std::string& text, const std::string& file,
                                                  base::Diagnostics& problems) {
  PositionedJson root;
  TextPosition place;
  JsonBuilder builder(root, place);
  const char* const end = text.data() + text.size();
  if (!nlohmann::json::sax_parse(PositionIterator(text.data(), &place),
                                 PositionIterator(end, &place), &builder)) {
    problems.push_back(
        base::error("route.not-json", {}, file, place.line, std::max(place.column, 1)));
    return std::nullopt;
  }
  return root;
}

using Kind = PositionedJson::Kind;

const char* kindName(Kind kind) {
  static constexpr const char* kNames[] = {"nothing", "true or false", "a number",
                                           "a text",  "a list",        "an object"};
  return kNames[static_cast<std::size_t>(kind)];
}

using Members = std::vector<std::pair<std::string, PositionedJson>>;

const Members& membersOf(const PositionedJson* object) {
  static const Members kNone;
  return object != nullptr ? object->members : kNone;
}

class GraphReader {
 public:
  explicit GraphReader(std::string file) : file_(std::move(file)) {}

  void read(const PositionedJson& root) {
    if (root.kind != Kind::Object) {
      error(root, "route.kind", {"the file", kindName(Kind::Object)});
      return;
    }
    const PositionedJson* const features = requiredMember(root, "features", Kind::List);
    if (features == nullptr) {
      return;
    }
    std::vector<const PositionedJson*> edges;
    for (const PositionedJson& feature : features->items) {
      const PositionedJson* const geometry = feature.kind == Kind::Object
                                                 ? requiredMember(feature, "geometry", Kind::Object)
                                                 : nullptr;
      const PositionedJson* const type =
          geometry != nullptr ? requiredMember(*geometry, "type", Kind::Text) : nullptr;
      if (feature.kind != Kind::Object) {
        error(feature, "route.kind", {"a feature", kindName(Kind::Object)});
      } else if (type != nullptr && type->text == "Point") {
        readNode(feature, *geometry);
      } else if (type != nullptr && type->text == "MultiLineString") {
        edges.push_back(&feature);
      }
    }
    for (const PositionedJson* const edge : edges) {  // after all nodes are known
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

  base::Diagnostics takeProblems() { return std::move(problems_); }
  RouteGraph takeGraph() { return std::move(graph_); }

 private:
  void error(const PositionedJson& at, const char* code, base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_, at.line, at.column));
  }

  const PositionedJson* optional(const PositionedJson& object, const char* key, Kind kind) {
    const PositionedJson* const member = object.find(key);
    if (member == nullptr || member->kind == Kind::Null) {
      return nullptr;
    }
    if (member->kind != kind) {
      error(*member, "route.kind", {key, kindName(kind)});
      return nullptr;
    }
    return member;
  }

  /// The member of an object; null with an error if it is absent or of another kind.
  const PositionedJson* requiredMember(const PositionedJson& object, const char* key, Kind kind) {
    if (object.find(key) == nullptr) {
      error(object, "route.missing", {key});
      return nullptr;
    }
    return optional(object, key, kind);
  }

  std::optional<std::uint32_t> requiredId(const PositionedJson& object, const char* key) {
    const PositionedJson* const member = requiredMember(object, key, Kind::Number);
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

  std::optional<Vec2> placeOf(const PositionedJson& coordinates) {
    const bool isPoint = coordinates.items.size() >= 2 &&
                         coordinates.items[0].kind == Kind::Number &&
                         coordinates.items[1].kind == Kind::Number;
    if (!isPoint) {
      error(coordinates, "route.coordinates");
      return std::nullopt;
    }
    return Vec2(coordinates.items[0].number, coordinates.items[1].number);
  }

  RouteMetadata metadataOf(const PositionedJson& properties) {
    RouteMetadata metadata;
    const PositionedJson* const object = optional(properties, "metadata", Kind::Object);
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

  std::vector<RouteOperation> operationsOf(const PositionedJson& properties, bool isNode) {
    using Trigger = RouteOperation::Trigger;
    std::vector<RouteOperation> operations;
    const PositionedJson* const object = optional(properties, "operations", Kind::Object);
    for (const auto& [name, value] : membersOf(object)) {
      if (value.kind != Kind::Object) {
        error(value, "route.kind", {name, kindName(Kind::Object)});
        continue;
      }
      RouteOperation operation;
      const PositionedJson* const type = requiredMember(value, "type", Kind::Text);
      const PositionedJson* const trigger = optional(value, "trigger", Kind::Text);
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

  void readNode(const PositionedJson& feature, const PositionedJson& geometry) {
    const PositionedJson* const properties = requiredMember(feature, "properties", Kind::Object);
    const PositionedJson* const coordinates = requiredMember(geometry, "coordinates", Kind::List);
    const auto place = coordinates != nullptr ? placeOf(*coordinates) : std::nullopt;
    const auto id = properties != nullptr ? requiredId(*properties, "id") : std::nullopt;
    if (!id || !place) {
      return;
    }
    if (graph_.nodeOf(*id)) {
      error(*properties, "route.node-twice", {static_cast<int>(*id)});
    }
    const PositionedJson* const frame = optional(*properties, "frame", Kind::Text);
    if (frame != nullptr && frame->text != "map") {
      problems_.push_back(
          base::warning("route.frame", {frame->text}, file_, frame->line, frame->column));
    }
    graph_.indexOf.emplace(*id, graph_.nodes.size());
    graph_.nodes.push_back({*id, *place, metadataOf(*properties), operationsOf(*properties, true)});
  }

  void readEdge(const PositionedJson& feature) {
    const PositionedJson* const properties = requiredMember(feature, "properties", Kind::Object);
    if (properties == nullptr) {
      return;
    }
    const auto id = requiredId(*properties, "id"), from = requiredId(*properties, "startid"),
               to = requiredId(*properties, "endid");
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
    if (const PositionedJson* const cost = optional(*properties, "cost", Kind::Number)) {
      edge.cost = cost->number;
    }
    if (const PositionedJson* const overridable =
            optional(*properties, "overridable", Kind::Bool)) {
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

  std::string file_;
  RouteGraph graph_;
  base::Diagnostics problems_;
};

}  // namespace

base::Result<RouteGraph> readRouteGraph(const std::string& text, const std::string& file) {
  base::Diagnostics problems;
  const std::optional<PositionedJson> root = parsePositionedJson(text, file, problems);
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
