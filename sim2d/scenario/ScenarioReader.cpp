#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

/// Reads one file: hunav_loader, hunavsim_desktop, other nodes.
class FileReader {
 public:
  FileReader(const YamlNode& root, const std::string& fileName, const FieldTables& tables)
      : root_(root), loader_{result_.file.scenario, report_, tables} {
    report_.file = fileName;
  }

  TreeReading read() {
    if (!root_.isMap()) {
      report_.add(root_,
                  base::error(root_.isNull() ? "scenario.file-empty" : "scenario.no-loader-node"));
    } else {
      const YamlNode* node = loaderNode();
      if (const YamlNode* parameters = node == nullptr ? nullptr : parametersOf(*node)) {
        readLoader(*parameters);
      }
      result_.loaderPaths = std::move(report_.knownPaths);
      report_.knownPaths.clear();
      readDesktop();
      result_.desktopPaths = std::move(report_.knownPaths);
      keepOtherNodes(node);
      scenario() = withoutDefaults(std::move(scenario()), loader_.tables);
    }
    base::Diagnostics& all = report_.diagnostics;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    });
    result_.file.diagnostics = std::move(all);
    result_.file.lines = std::move(report_.lines);
    return std::move(result_);
  }

 private:
  Scenario& scenario() { return result_.file.scenario; }

  /// The map ros__parameters; nullptr and an error if it is missing.
  const YamlNode* parametersOf(const YamlNode& node) {
    const YamlNode* parameters = node.find(kParameters);
    if (parameters != nullptr && parameters->isMap()) {
      return parameters;
    }
    report_.add(node, base::error("scenario.no-parameters", {node.key}));
    return nullptr;
  }

  const YamlNode* loaderNode() {
    if (const YamlNode* node = root_.find(kLoaderNode)) {
      return node;
    }
    const YamlNode* only = nullptr;
    int candidates = 0;
    for (const YamlNode& item : root_.items) {
      if (item.key != kDesktopNode && item.find(kParameters) != nullptr) {
        only = &item;
        ++candidates;
      }
    }
    if (candidates == 1) {
      report_.add(*only, base::warning("scenario.other-node", {only->key}));
      return only;
    }
    report_.add(root_, missingLoader());
    return nullptr;
  }

  /// The error of a file without hunav_loader, which may be a file of another kind.
  base::Diagnostic missingLoader() const {
    if (root_.find("hunavsim_experiment") != nullptr) {
      return base::error("scenario.is-experiment");
    }
    if (root_.find("image") != nullptr) {
      return base::error("scenario.is-map");
    }
    std::vector<std::string> nodes;
    for (const YamlNode& item : root_.items) {
      if (item.find(kParameters) != nullptr) {
        nodes.push_back(item.key);
      }
    }
    return nodes.empty() ? base::error("scenario.no-node")
                         : base::error("scenario.other-nodes", {base::join(nodes, ", ")});
  }

  void readLoader(const YamlNode& parameters) {
    YamlMap view(&parameters, "", {base::EntityKind::Scenario, 0}, report_);
    report_.lines[view.entity()] = parameters.keyLine;
    readFields<ScenarioSettings>(view, scenario(), loader_.tables);
    readGlobalGoals(view);
    readAgents(view);
    scenario().unknown = view.takeUnknownKeys();
    const YamlNode* goals = parameters.find("global_goals");
    if (loader_.hasUndefinedGoal && (goals == nullptr || scenario().goals.empty())) {
      report_.add(
          goals == nullptr ? parameters : *goals,
          base::error(goals == nullptr ? "scenario.goals-missing" : "scenario.goals-empty"));
    }
    reportDialect(parameters);
  }

  void readGlobalGoals(YamlMap& view) {
    YamlMap goals = view.map("global_goals");
    std::set<int> numbers;
    for (const YamlNode& item : goals.node().items) {
      goals.markKnown(item.key);
      const auto id = base::parseInt(item.key);
      if (!id || *id < 1 || *id > 1000000) {
        goals.error(item.key, "scenario.goal-no-number");
        continue;
      }
      if (!numbers.insert(static_cast<int>(*id)).second) {
        goals.error(item.key, "scenario.goal-number-twice");
        continue;
      }
      GlobalGoal goal;
      goal.id = static_cast<int>(*id);
      goal.key = loader_.newEntity(base::EntityKind::Goal, item);
      YamlMap point(&item, goals.pathOf(item.key), goal.key, report_);
      goal.position = readPoint(point);
      point.markKnown("h");  // from older dialects
      if (const YamlNode* heading = item.find("h")) {
        goal.unknown.push_back(unknownKey(*heading));
      }
      for (UnknownKey& key : point.takeUnknownKeys()) {
        goal.unknown.push_back(std::move(key));
      }
      scenario().goals.push_back(std::move(goal));
    }
  }

  std::vector<std::string> agentNames(YamlMap& view) {
    view.markKnown("agents");
    const YamlNode* list = view.node().find("agents");
    if (list != nullptr && list->isNull()) {
      view.warning("agents", "scenario.nobody-listed");
      return {};
    }
    if (list != nullptr && list->isList()) {
      return view.names("agents");
    }
    std::vector<std::string> candidates;
    for (const YamlNode& item : view.node().items) {
      if (looksLikeAgent(item)) {
        candidates.push_back(item.key);
      }
    }
    view.error("agents", list == nullptr ? "scenario.agents-missing" : "scenario.agents-no-list",
               {base::join(candidates, ", ")});
    return {};
  }

  void readAgents(YamlMap& view) {
    std::map<std::string_view, const YamlNode*> blocks;
    for (const YamlNode& item : view.node().items) {
      blocks.emplace(item.key, &item);
    }
    const std::vector<std::string> names = agentNames(view);
    scenario().humans.reserve(names.size());
    for (const std::string& name : names) {
      const auto block = blocks.find(name);
      if (view.isKnown(name)) {
        view.error("agents", "scenario.agent-is-key", {name});
      } else if (block == blocks.end()) {
        view.error("agents", "scenario.agent-without-block", {name});
      } else {
        view.markKnown(name);
        scenario().humans.push_back(readHuman(*block->second, true, loader_));
      }
    }
    for (const YamlNode& item : view.node().items) {
      if (!view.isKnown(item.key) && looksLikeAgent(item)) {
        view.markKnown(item.key);
        scenario().humans.push_back(readHuman(item, false, loader_));
      }
    }
  }

  void reportDialect(const YamlNode& parameters) {
    const std::string stem = std::filesystem::path(report_.file).stem().string();
    const bool isNamed = !stem.empty() && stem != "-";  // "-": standard input
    if (!loader_.hasScalarBehavior && !loader_.hasNumberedType && !loader_.hasNamedGoals) {
      if (scenario().yamlBaseName && isNamed && *scenario().yamlBaseName != stem) {
        report_.add(*parameters.find("yaml_base_name"),
                    base::warning("scenario.base-name", {*scenario().yamlBaseName}));
      }
      return;
    }
    const bool first = loader_.hasScalarBehavior;
    result_.file.dialect = first ? Dialect::A : Dialect::B;
    report_.add(parameters,
                base::problem(base::Severity::Info,
                              first ? "scenario.format-of-first" : "scenario.format-of-second"));
    scenario().yamlBaseName = baseName(scenario(), report_.file);
    if (!scenario().simulator) {
      report_.add(parameters, base::problem(base::Severity::Info, "scenario.no-simulator",
                                            {suggestedSimulator(scenario())}));
    }
  }

  void readDesktop() {
    const YamlNode* node = root_.find(kDesktopNode);
    result_.file.hasDesktopNode = node != nullptr;
    if (node == nullptr) {  // registers the keys for suggestions
      YamlNode block;
      setChild(block, "format", number(kDesktopFormat));
      readDesktopNode(block, loader_);
      return;
    }
    const YamlNode* parameters = parametersOf(*node);
    if (parameters == nullptr) {
      return;
    }
    for (const YamlNode& item : node->items) {
      if (item.key != kParameters) {
        report_.add(item, base::error("scenario.only-parameters", {kDesktopNode}));
      }
    }
    readDesktopNode(*parameters, loader_);
  }

  void keepOtherNodes(const YamlNode* loader) {
    if (loader != nullptr && loader->find(kParameters) != nullptr) {
      for (const YamlNode& item : loader->items) {
        if (item.key != kParameters) {
          report_.add(item, base::warning("scenario.others-lost", {loader->key, item.key}));
        }
      }
    }
    for (const YamlNode& item : root_.items) {
      if (&item != loader && item.key != kDesktopNode) {
        scenario().otherNodes.push_back(unknownKey(item));
      }
    }
  }

  const YamlNode& root_;
  ReadReport report_;
  TreeReading result_;
  LoaderReading loader_;
};

int firstErrorLine(const base::Diagnostics& diagnostics) {
  const auto found = std::find_if(diagnostics.begin(), diagnostics.end(), [](const auto& said) {
    return said.severity == base::Severity::Error && said.line > 0;
  });
  return found == diagnostics.end() ? 0 : found->line;
}

std::string_view firstLines(std::string_view text, int count) {
  std::size_t end = 0;
  for (int line = 0; line < count && end < text.size(); ++line) {
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return text.substr(0, end);
}

/// From 1; after the dashes of list items.
int columnOfKey(const std::string& line) {
  const std::size_t found = line.find_first_not_of(" -");
  return found == std::string::npos ? 1 : static_cast<int>(found) + 1;
}

const YamlNode* findKey(const YamlNode& root, const std::string& dotted) {
  const YamlNode* node = &root;
  for (const std::string& key : base::split(dotted, '.')) {
    node = node == nullptr ? nullptr : node->find(key);
  }
  return node;
}

/// Places of keys in one file; parsed on first use.
class KeyLocations {
 public:
  explicit KeyLocations(const std::string& text) : text_(text) {}

  /// The place of a path below the parameters of either node; null: not found.
  const YamlNode* find(const std::string& dotted) {
    if (!isRead_) {
      base::Diagnostics ignored;  // reported by readScenario
      root_ = parseYaml(text_, {}, ignored);
      isRead_ = true;
    }
    const YamlNode* found = nullptr;
    for (const char* node : {kDesktopNode, kLoaderNode}) {
      const std::string path = std::string(node) + "." + kParameters + "." + dotted;
      found = found == nullptr ? findKey(root_, path) : found;
    }
    return found;
  }

 private:
  const std::string& text_;
  bool isRead_ = false;
  YamlNode root_;
};

/// Sets the place of the entity, or of its key.
void addEntityLocation(base::Diagnostic& problem, const std::map<EntityId, int>& lines,
                       KeyLocations& keys) {
  const auto found = lines.find(problem.entity);
  if (problem.line != 0 || !problem.entity || found == lines.end()) {
    return;
  }
  const std::string where = problem.value("where");  // "robot1.planner_parameters.horizon"
  const YamlNode* const key = where.find('.') == std::string::npos ? nullptr : keys.find(where);
  problem.line = key != nullptr ? key->line : found->second;
  problem.column = key != nullptr ? key->column : problem.column;
}

}  // namespace

TreeReading readTree(const YamlNode& root, const std::string& fileName, const FieldTables& tables) {
  TreeReading reading = FileReader(root, fileName, tables).read();
  if (const YamlNode* const agents = findKey(root, "hunav_loader.ros__parameters.agents")) {
    reading.file.agentsLine = agents->keyLine;
    reading.file.agentsColumn = agents->keyColumn;
  }
  return reading;
}

ScenarioReading readScenarioText(const std::string& text, const std::string& fileName) {
  ScenarioReading reading;
  const YamlNode root = parseYaml(text, fileName, reading.diagnostics);
  if (reading.ok()) {
    reading = readTree(root, fileName).file;
    reading.commentCount = base::countComments(text);
  }
  return reading;
}

ScenarioReading readScenario(const std::string& path) {
  const auto text = base::readTextFile(path);
  if (!text) {
    ScenarioReading reading;
    reading.diagnostics = text.diagnostics();
    return reading;
  }
  return readScenarioText(*text, path);
}

ScenarioReading readValidPart(const std::string& path) {
  constexpr int kMaxTries = 16;
  ScenarioReading reading = readScenario(path);
  const base::Result<std::string> text = base::readTextFile(path);
  if (reading.ok() || !text) {
    return reading;
  }
  int lines = firstErrorLine(reading.diagnostics) - 1;
  for (int attempt = 0; attempt < kMaxTries && lines > 0; ++attempt) {
    base::Diagnostics ignored;  // misleading for a part of the file
    const YamlNode root = parseYaml(firstLines(*text, lines), path, ignored);
    if (!base::hasErrors(ignored)) {
      ScenarioReading part = readTree(root, path).file;
      part.diagnostics = std::move(reading.diagnostics);
      part.commentCount = reading.commentCount;
      return part;
    }
    lines -= 1 << std::min(attempt / 4, 8);
  }
  return reading;
}

namespace {

/// Whether the problem has no file, or one of its values is the file's name.
bool namesFile(const base::Diagnostic& problem) {
  const std::string name = problem.file.substr(problem.file.rfind('/') + 1);
  return name.empty() ||
         std::any_of(problem.values.begin(), problem.values.end(), [&](const auto& value) {
           return value.second.substr(value.second.rfind('/') + 1) == name;
         });
}

}  // namespace

void addLocations(base::Diagnostics& diagnostics, const std::map<EntityId, int>& lines,
                  const std::string& path) {
  if (diagnostics.empty()) {
    return;  // reading a large file takes time
  }
  const base::Result<std::string> text = base::readTextFile(path);  // reported when it was read
  const std::string content = text ? *text : std::string();
  const std::vector<std::string> texts = base::split(content, '\n');
  KeyLocations keys(content);
  for (base::Diagnostic& said : diagnostics) {
    if (said.line > 0 && !said.file.empty() && said.file != path) {
      continue;  // a line of another file
    }
    addEntityLocation(said, lines, keys);
    if (said.line > 0 && said.file != path && !namesFile(said)) {
      const std::string other = said.file;
      said = base::withContext(other, std::move(said));
    }
    said.file = said.line > 0 ? path : said.file;
    const auto line = static_cast<std::size_t>(said.line);
    if (text && said.column == 0 && said.line > 0 && line <= texts.size()) {
      said.column = columnOfKey(texts[line - 1]);
    }
  }
}

void addKeyLocation(base::Diagnostics& diagnostics, const std::string& path,
                    const std::vector<std::string>& keys) {
  const auto isMeant = [&path](const auto& said) { return said.file == path && said.line == 0; };
  if (std::none_of(diagnostics.begin(), diagnostics.end(), isMeant)) {
    return;
  }
  const base::Result<std::string> text = base::readTextFile(path);
  base::Diagnostics ignored;  // reported by readScenario
  const YamlNode root = text ? parseYaml(*text, path, ignored) : YamlNode();
  const YamlNode* found = nullptr;
  for (const std::string& key : keys) {
    found = found == nullptr && !base::hasErrors(ignored) ? findKey(root, key) : found;
  }
  for (base::Diagnostic& said : diagnostics) {
    if (found != nullptr && isMeant(said)) {
      said.line = found->keyLine;
      said.column = found->keyColumn;
    }
  }
}

void addMapLocation(base::Diagnostics& diagnostics, const std::string& path) {
  addKeyLocation(diagnostics, path,
                 {"hunavsim_desktop.ros__parameters.map_file", "hunav_loader.ros__parameters.map",
                  "hunav_loader.ros__parameters"});
}

}  // namespace sim2d
