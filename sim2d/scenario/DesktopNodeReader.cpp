#include <algorithm>
#include <map>
#include <type_traits>

#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

template <class T>
bool isWordOf(const YamlNode* kind, const FieldTables& tables) {
  const std::vector<std::string>& words = fieldOf<T>("kind", tables)->spec.choices;
  return kind != nullptr && std::find(words.begin(), words.end(), kind->text) != words.end();
}

template <class T>
void readEntity(YamlMap& view, T& to, const FieldTables& tables) {
  if constexpr (std::is_same_v<T, Obstacle>) {
    if (!view.requireKey("kind") ||
        !view.choice("kind", fieldOf<T>("kind", tables)->spec.choices)) {
      return;  // reported; without a valid kind its keys have no meaning
    }
  }
  readObject(view, to, tables);
}

/// Reads the whole block. Entities are maps next to the keys, so the keys are read first.
class DesktopNodeReader {
 public:
  DesktopNodeReader(const YamlNode& parameters, LoaderReading& reading)
      : reading_(reading),
        scenario_(reading.scenario),
        view_(&parameters, "", {base::EntityKind::Scenario, 0}, reading.report) {}

  void read() {
    readFormat();
    readFields(view_, scenario_.desktop, reading_.tables);
    readObject(view_.map("metrics"), scenario_.desktop.metrics, reading_.tables);
    std::map<base::EntityKind, std::vector<std::string>> names;
    forEachEntityList(scenario_, [&](const char* key, base::EntityKind kind, const auto& /*list*/) {
      names[kind] = view_.names(key);
    });
    readPeople();
    forEachEntityList(scenario_, [&](const char* key, base::EntityKind kind, const auto& /*list*/) {
      readListed(key, names[kind], kind);
    });
    readUnlisted();
    scenario_.desktop.unknown = view_.takeUnknownKeys();
  }

 private:
  void readFormat() {
    const auto format = view_.integer("format", 1);
    if (view_.node().find("format") == nullptr) {
      view_.error("format", "scenario.format-missing", {kDesktopNode});
    } else if (format && *format > kDesktopFormat) {
      view_.error("format", "scenario.format-newer", {*format, kDesktopFormat});
    }
  }

  void readPeople() {
    for (Human& human : scenario_.humans) {
      const YamlNode* node = view_.node().find(human.name);
      if (node != nullptr && view_.isKnown(human.name)) {
        view_.error(human.name, "scenario.person-is-key");
      } else if (node != nullptr) {
        view_.markKnown(human.name);
        readObject({node, human.name, human.key, reading_.report}, human.ours, reading_.tables);
      } else {
        registerPersonKeys(human.name);
      }
    }
  }

  /// Registers the keys of agents without a map here, for `--set`.
  void registerPersonKeys(const std::string& name) {
    for (const auto& field : fieldsOf<PersonExtension>(reading_.tables)) {
      reading_.report.knownPaths.insert(name + "." + field.spec.key);
    }
  }

  void readListed(const std::string& list, const std::vector<std::string>& names,
                  base::EntityKind kind) {
    for (const std::string& name : names) {
      const YamlNode* node = view_.node().find(name);
      if (view_.isKnown(name) || scenario_.human(name) != nullptr || name == "map") {
        view_.error(list, "scenario.name-taken", {name});
      } else if (node == nullptr) {
        view_.error(list, "scenario.listed-without-map", {name});
      } else if (!isEntityName(name)) {
        view_.markKnown(name);
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
    if (isWordOf<Dock>(kind, reading_.tables)) {
      return base::EntityKind::Dock;
    }
    if (node.find("x1") != nullptr && node.find("x2") != nullptr) {
      return base::EntityKind::Door;
    }
    return node.find("start") != nullptr ? base::EntityKind::Robot : base::EntityKind::None;
  }

  void addEntity(const YamlNode& node, base::EntityKind kind, bool isListed) {
    view_.markKnown(node.key);
    const EntityId entity = reading_.newEntity(kind, node);
    YamlMap view(&node, node.key, entity, reading_.report);
    forEachEntityList(scenario_, [&](const char* /*key*/, base::EntityKind each, auto& to) {
      if (each == kind) {
        NamedEntity& named = to.emplace_back();
        named.key = entity;
        named.name = node.key;
        named.listed = isListed;
        readEntity(view, to.back(), reading_.tables);
      }
    });
  }

  LoaderReading& reading_;
  Scenario& scenario_;
  YamlMap view_;
};

}  // namespace

Vec2 readPoint(YamlMap& view) {
  return {view.required("x", base::kCoordinateRange), view.required("y", base::kCoordinateRange)};
}

ParameterTexts readParameters(YamlMap& view, const std::string& key) {
  ParameterTexts texts;
  YamlMap parameters = view.map(key);
  for (const YamlNode& item : parameters.node().items) {
    parameters.markKnown(item.key);
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

/// Warns about unknown keys of a map that cannot keep them.
void warnUnknownKeys(YamlMap& view) {
  for (const UnknownKey& key : view.takeUnknownKeys()) {
    view.warning(key.key, "scenario.key-is-lost");
  }
}

void readDesktopNode(const YamlNode& parameters, LoaderReading& reading) {
  DesktopNodeReader(parameters, reading).read();
}

}  // namespace sim2d
