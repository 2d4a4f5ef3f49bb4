#include <algorithm>
#include <type_traits>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

template <class T>
bool isWordOf(const YamlNode* kind, const FieldTables& tables) {
  const std::vector<std::string>& words = fieldOf<T>("kind", tables)->spec.choices;
  return kind != nullptr && std::find(words.begin(), words.end(), kind->text) != words.end();
}

template <class T>
T readEntity(YamlMap& view, const FieldTables& tables) {
  T entity;
  if constexpr (std::is_same_v<T, Obstacle>) {
    const std::vector<std::string>& kinds = fieldOf<T>("kind", tables)->spec.choices;
    if (!view.requiredChoice("kind", kinds)) {
      return entity;  // told; its keys say nothing then
    }
  }
  readFields(view, entity, tables);
  entity.unknown = view.takeUnknown();
  return entity;
}

/// Reads the whole block. Entities are maps beside the keys, so those come first.
class BlockReader {
 public:
  BlockReader(const YamlNode& parameters, LoaderReading& reading)
      : reading_(reading),
        scenario_(reading.scenario),
        view_(&parameters, "", {base::EntityKind::Scenario, 0}, reading.report) {}

  void read() {
    readFormat();
    readSettings();
    const std::vector<std::string> robots = view_.names("robots");
    const std::vector<std::string> obstacles = view_.names("obstacles");
    const std::vector<std::string> doors = view_.names("doors");
    const std::vector<std::string> areas = view_.names("areas");
    readPeople();
    listed("robots", robots, base::EntityKind::Robot);
    listed("obstacles", obstacles, base::EntityKind::Obstacle);
    listed("doors", doors, base::EntityKind::Door);
    listed("areas", areas, base::EntityKind::Area);
    readUnlisted();
    scenario_.desktop.unknown = view_.takeUnknown();
  }

 private:
  void readFormat() {
    const auto format = view_.bigInteger("format", 1);
    if (view_.node().find("format") == nullptr) {
      view_.error("format", "scenario.format-missing", {kBlockNode});
    } else if (format && *format > kBlockFormat) {
      view_.error("format", "scenario.format-newer", {*format, kBlockFormat});
    }
  }

  void readSettings() {
    DesktopSettings& to = scenario_.desktop;
    readFields(view_, to, reading_.tables);
    YamlMap metrics = view_.map("metrics");
    readFields(metrics, to.metrics, reading_.tables);
    to.metrics.unknown = metrics.takeUnknown();
  }

  void readPeople() {
    for (Human& human : scenario_.humans) {
      const YamlNode* node = view_.node().find(human.name);
      if (node != nullptr && view_.isKnown(human.name)) {
        view_.error(human.name, "scenario.person-is-key");
      } else if (node != nullptr) {
        view_.know(human.name);
        YamlMap person(node, human.name, human.key, reading_.report);
        readFields(person, human.ours, reading_.tables);
        human.ours.unknown = person.takeUnknown();
      } else {
        registerPersonKeys(human.name);
      }
    }
  }

  /// So that `--set` knows the keys of people that have no map here yet.
  void registerPersonKeys(const std::string& name) {
    for (const auto& field : fieldsOf<PersonExtension>(reading_.tables)) {
      reading_.report.knownPaths.insert(name + "." + field.spec.key);
    }
  }

  void listed(const std::string& list, const std::vector<std::string>& names,
              base::EntityKind kind) {
    for (const std::string& name : names) {
      const YamlNode* node = view_.node().find(name);
      if (view_.isKnown(name) || scenario_.human(name) != nullptr || name == "map") {
        view_.error(list, "scenario.name-taken", {name});
      } else if (node == nullptr) {
        view_.error(list, "scenario.listed-without-map", {name});
      } else if (!isEntityName(name)) {
        view_.know(name);
        view_.error(list, "scenario.bad-entity-name", {name});
      } else {
        addEntity(*node, kind, true);
      }
    }
  }

  void readUnlisted() {
    for (const YamlNode& item : view_.node().items) {
      if (!view_.isKnown(item.key) && item.isMap()) {
        const base::EntityKind kind = kindOf(item);
        if (kind != base::EntityKind::None && isEntityName(item.key)) {
          addEntity(item, kind, false);
        }
      }
    }
  }

  base::EntityKind kindOf(const YamlNode& node) const {
    const YamlNode* kind = node.find("kind");
    if (isWordOf<Obstacle>(kind, reading_.tables)) {
      return base::EntityKind::Obstacle;
    }
    if (isWordOf<Area>(kind, reading_.tables)) {
      return base::EntityKind::Area;
    }
    if (node.find("x1") != nullptr && node.find("x2") != nullptr) {
      return base::EntityKind::Door;
    }
    return node.find("start") != nullptr ? base::EntityKind::Robot : base::EntityKind::None;
  }

  void addEntity(const YamlNode& node, base::EntityKind kind, bool isListed) {
    view_.know(node.key);
    const EntityId entity = reading_.newEntity(kind, node);
    YamlMap view(&node, node.key, entity, reading_.report);
    const auto keep = [&](auto& to) {
      using Entity = typename std::decay_t<decltype(to)>::value_type;
      to.push_back(readEntity<Entity>(view, reading_.tables));
      to.back().key = entity;
      to.back().name = node.key;
      to.back().listed = isListed;
    };
    switch (kind) {
      case base::EntityKind::Robot:
        return keep(scenario_.robots);
      case base::EntityKind::Obstacle:
        return keep(scenario_.obstacles);
      case base::EntityKind::Door:
        return keep(scenario_.doors);
      default:
        return keep(scenario_.areas);
    }
  }

  LoaderReading& reading_;
  Scenario& scenario_;
  YamlMap view_;
};

}  // namespace

Vec2 readPoint(YamlMap& view) {
  return {view.required("x"), view.required("y")};
}

ParameterTexts readParameters(YamlMap& view, const std::string& key) {
  ParameterTexts texts;
  YamlMap parameters = view.map(key);
  for (const YamlNode& item : parameters.node().items) {
    parameters.know(item.key);
    if (item.isScalar()) {
      texts.emplace_back(item.key, emitYaml(item));
    } else {
      parameters.error(item.key, "scenario.no-single-value");
    }
  }
  return texts;
}

void writeParameters(YamlNode& tree, const std::string& key, const ParameterTexts& parameters) {
  for (const auto& [name, text] : parameters) {
    setUnknown(tree.child(key), {{name, text}});
  }
}

/// Maps inside an entity that have no place for keys of others.
void refuseUnknown(YamlMap& view) {
  for (const UnknownKey& key : view.takeUnknown()) {
    view.warning(key.key, "scenario.key-is-lost");
  }
}

void readBlock(const YamlNode& parameters, LoaderReading& reading) {
  BlockReader(parameters, reading).read();
}

}  // namespace sim2d
