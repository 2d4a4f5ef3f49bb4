#include "bt/human/TreeLoader.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "bt/human/GeneratedStyle.h"
#include "bt/human/HumanContext.h"
#include "bt/human/TreeGenerator.h"
#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeUse.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Variation.h"

namespace bt {

using base::Diagnostics;
using sim2d::ResolvedHuman;

namespace {

constexpr std::size_t kMostKnown = 1000;  // trees kept for later runs

/// The value of a placeholder of HuNavSim 1.5.
std::optional<Value> placeholderValue(const std::string& key, const ResolvedHuman& human) {
  if (key == "once") {
    return Value::of(human.reactionOnce);
  }
  const std::map<std::string, double> numbers = {
      {"dist", human.noticeDistance},       {"duration", human.reactionDuration},
      {"maxvel", human.reactionSpeed},      {"forcefactor", human.otherFactor},
      {"stopdist", human.stopDistance},     {"frontdist", human.frontDistance},
      {"safe_distance", human.safeDistance}};
  const auto found = numbers.find(key);
  return found == numbers.end() ? std::nullopt : std::optional<Value>(Value::of(found->second));
}

CompileOptions optionsFor(const std::vector<std::string>& placeholders) {
  CompileOptions options;
  for (const std::string& key : placeholders) {
    options.hostEntries.push_back({key, key == "once" ? PortType::Bool : PortType::Double});
  }
  return options;
}

bool isMissingRegularNav(const Include& include, const std::string& treePath) {
  const std::filesystem::path wanted(include.path);
  const std::filesystem::path place = std::filesystem::path(treePath).parent_path() / wanted;
  std::error_code ignored;
  return wanted.filename() == kRegularNavFile && include.rosPackage.empty() &&
         !std::filesystem::exists(place, ignored);
}

/// Cache key: equal for generated trees with the same behaviour.
std::string generatedTreeKey(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeFile file;
  file.mainTree = table.mainTree;
  file.trees = {table.entries.at(table.mainTree).tree};
  file.order = {FilePart::Tree};
  return writeTree(file, catalogue);
}

Diagnostics renamed(Diagnostics found, const std::string& from, const std::string& to) {
  for (base::Diagnostic& diagnostic : found) {
    diagnostic.file = diagnostic.file == from ? to : diagnostic.file;
  }
  return found;
}

/// Adds the person to diagnostics of a tree without a file.
Diagnostics attributedToAgent(const sim2d::Human& human, Diagnostics found) {
  for (base::Diagnostic& diagnostic : found) {
    diagnostic = base::withContext("tree of " + human.name, std::move(diagnostic));
    diagnostic.entity = human.key;
  }
  return found;
}

/// Path that a tree of this folder would have if it were saved.
std::string unsavedTreePath(const std::string& folder) {
  return (std::filesystem::path(folder) / "own.xml").string();
}

TreeTable generatedTable(const sim2d::Scenario& scenario, const sim2d::Human& human,
                         const sim2d::Compatibility& quirks) {
  const sim2d::DesktopSettings& settings = scenario.desktop;
  sim2d::Human drawn = human;
  drawn.goals = sim2d::firstGoalOf(settings.variation, human, settings.seed.value_or(1)).goals;
  return makeGeneratedTable(scenario, drawn, quirks);
}

TreeSource sourceOf(const sim2d::Human& human, const TreeFiles& files) {
  const auto file = files.find(human.name);
  return file == files.end() ? TreeSource() : file->second;
}

/// Base path of relative includes.
std::string includeBasePath(const TreeSource& source) {
  return source.path.empty() && !source.folder.empty() ? unsavedTreePath(source.folder)
                                                       : source.path;
}

const sim2d::Human* prototypeOf(const sim2d::Scenario& scenario, const sim2d::Area& area) {
  const bool isSource = area.kind == sim2d::AreaKind::Source && area.listed && area.like;
  return isSource ? scenario.human(*area.like) : nullptr;
}

}  // namespace

TreeState AgentProgram::start(const ResolvedHuman& human) const {
  TreeState state(program);
  state.set(program->hostSlot(0), human.id);
  state.set(program->hostSlot(1), 0.0);
  for (std::size_t i = 0; i < placeholders.size(); ++i) {
    if (const std::optional<Value> value = placeholderValue(placeholders[i], human)) {
      state.set(program->hostSlot(static_cast<int>(i) + 2), *value);
    }
  }
  return state;
}

const AgentPrograms::Entry* AgentPrograms::find(const ResolvedHuman& person) const {
  const auto own = std::lower_bound(byAgentId.begin(), byAgentId.end(), person.id,
                                    [](const auto& each, int id) { return each.first < id; });
  if (own != byAgentId.end() && own->first == person.id) {
    return &own->second;
  }
  // Names of people from a source end in "_" and a number.
  const auto source = bySourceArea.find(person.name.substr(0, person.name.rfind('_')));
  return source != bySourceArea.end() ? &source->second : nullptr;
}

base::Result<TreeTable> loadAgentTrees(base::Result<TreeFile> file) {
  if (!file) {
    return file.diagnostics();
  }
  const std::string& path = file->path;
  Diagnostics warnings = file.diagnostics();
  std::vector<Include>& includes = file->includes;
  const auto missing =
      std::find_if(includes.begin(), includes.end(),
                   [&path](const Include& include) { return isMissingRegularNav(include, path); });
  const bool isMissing = missing != includes.end();
  if (isMissing) {
    if (!path.empty()) {
      warnings.push_back(
          base::warning("tree.regular-nav-missing", {missing->path}, path, missing->line));
    }
    includes.erase(missing);
  }
  base::Result<TreeTable> table = resolveIncludes(*file);
  base::append(warnings, table.diagnostics());
  if (!table) {
    return warnings;
  }
  if (isMissing) {
    TreeSpec regular = regularNavTree();
    const std::string id = regular.id;
    table->entries.emplace(id, TreeTable::Entry{std::move(regular), kRegularNavFile});
  }
  return {*std::move(table), std::move(warnings)};
}

base::Result<TreeTable> treeOf(const sim2d::Human& human, const TreeFiles& files,
                               const sim2d::Scenario& scenario,
                               const sim2d::Compatibility& quirks) {
  const TreeSource source = sourceOf(human, files);
  if (source.isGenerated()) {
    return generatedTable(scenario, human, quirks);
  }
  return loadAgentTrees(source.text ? readTreeText(*source.text, includeBasePath(source))
                                    : readTree(source.path));
}

std::shared_ptr<TreeCache> makeTreeCache() {
  return std::make_shared<TreeCache>();
}

void TreeCache::limit() {
  if (texts.size() + generated.size() > kMostKnown) {
    texts.clear();
    generated.clear();
  }
}

TreeLoader::TreeLoader(const sim2d::Scenario& scenario, const sim2d::Compatibility& quirks,
                       std::shared_ptr<TreeCache> known)
    : scenario_(scenario),
      quirks_(quirks),
      library_(humanNodes()),
      cache_(known ? std::move(known) : makeTreeCache()) {
  cache_->limit();
}

std::shared_ptr<const AgentProgram> TreeLoader::load(const sim2d::Human& human,
                                                     const TreeSource& source,
                                                     Diagnostics& diagnostics) {
  if (!source.isGenerated()) {
    return loadFromSource(human, source, diagnostics);
  }
  const TreeTable table = generatedTable(scenario_, human, quirks_);
  std::shared_ptr<const AgentProgram>& program =
      cache_->generated[generatedTreeKey(table, library_.catalogue())];
  if (!program) {
    // Missing elements are reported by the check of the scenario.
    program = compileTable(table, diagnostics);
  }
  return program;
}

std::shared_ptr<const AgentProgram> TreeLoader::loadFromSource(const sim2d::Human& human,
                                                               const TreeSource& source,
                                                               Diagnostics& diagnostics) {
  const std::string& path = source.path;
  const std::string* text = source.text ? &*source.text : nullptr;
  if (text == nullptr) {
    auto file = files_.find(path);
    const bool isNew = file == files_.end();
    if (isNew) {
      file = files_.emplace(path, base::readTextFile(path)).first;
    }
    if (!file->second) {
      base::append(diagnostics, isNew ? file->second.diagnostics() : Diagnostics());
      return nullptr;
    }
    text = &*file->second;
  }
  const LoadedTree& loaded = look(*text, includeBasePath(source));
  if (path.empty()) {
    base::append(diagnostics, attributedToAgent(human, renamed(loaded.found, loaded.path, path)));
  } else if (reportedPaths_.insert(path).second) {
    base::append(diagnostics, renamed(loaded.found, loaded.path, path));
  }
  if (loaded.program) {
    base::append(diagnostics,
                 renamed(checkAgentTree(loaded.table, human, scenario_, library_.catalogue()),
                         loaded.path, path));
  }
  return loaded.program;
}

const LoadedTree& TreeLoader::look(const std::string& text, const std::string& path) {
  const auto [place, isNew] =
      cache_->texts.try_emplace({std::filesystem::path(path).parent_path().string(), text});
  LoadedTree& loaded = place->second;
  if (isNew) {
    loaded.path = path;
    base::Result<TreeFile> file = readTreeText(text, path);
    if (const auto problem = file ? wrongTreeUse(*file, TreeUse::Person) : std::nullopt) {
      loaded.found = {*problem};
      return loaded;
    }
    base::Result<TreeTable> table = loadAgentTrees(std::move(file));
    loaded.found = table.diagnostics();
    if (table) {
      loaded.table = *std::move(table);
      loaded.program = compileTable(loaded.table, loaded.found);
    }
  }
  return loaded;
}

/// A file in one of the generator's styles, as the window saves it, is no custom tree.
AgentPrograms::Entry TreeLoader::entryOf(const sim2d::Human& human, const TreeFiles& files,
                                         Diagnostics& diagnostics) {
  const TreeSource source = sourceOf(human, files);
  AgentPrograms::Entry entry{load(human, source, diagnostics)};
  if (entry.program != nullptr && !source.isGenerated()) {
    const std::string& text = source.text ? *source.text : *files_.at(source.path);
    entry.isCustom = !generatedStyle(text, scenario_, human, library_.catalogue());
  }
  return entry;
}

AgentPrograms TreeLoader::loadAll(const TreeFiles& files, Diagnostics& diagnostics) {
  AgentPrograms result;
  std::map<std::string, AgentPrograms::Entry> patterns;  // of sources, by name
  for (const sim2d::Area& area : scenario_.areas) {
    if (const sim2d::Human* like = prototypeOf(scenario_, area)) {
      patterns.emplace(like->name, AgentPrograms::Entry());
    }
  }
  result.byAgentId.reserve(scenario_.humans.size());
  for (const sim2d::Human& human : scenario_.humans) {
    const auto pattern = patterns.find(human.name);
    if (!human.listed && pattern == patterns.end()) {
      continue;
    }
    const AgentPrograms::Entry entry = entryOf(human, files, diagnostics);
    if (human.listed) {
      result.byAgentId.emplace_back(human.id, entry);
    }
    if (pattern != patterns.end()) {
      pattern->second = entry;
    }
  }
  std::stable_sort(result.byAgentId.begin(), result.byAgentId.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const sim2d::Area& area : scenario_.areas) {
    if (const sim2d::Human* like = prototypeOf(scenario_, area)) {
      result.bySourceArea[area.name] = patterns.at(like->name);
    }
  }
  return result;
}

std::shared_ptr<const AgentProgram> TreeLoader::compileTable(const TreeTable& table,
                                                             Diagnostics& diagnostics) const {
  auto made = std::make_shared<AgentProgram>();
  made->placeholders = legacyPlaceholders(table);
  if (!made->placeholders.empty()) {
    const std::string list = "{" + base::join(made->placeholders, "}, {") + "}";
    diagnostics.push_back(base::warning("tree.placeholders-filled", {list}, table.file));
  }
  base::Result<std::shared_ptr<const Program>> program =
      compile(table, library_, optionsFor(made->placeholders));
  base::append(diagnostics, program.diagnostics());
  if (!program) {
    return nullptr;
  }
  made->program = *std::move(program);
  return made;
}

namespace {

struct CollectedNode {
  const NodeSpec* node;
  const std::string* file;
};

/// Collects the nodes of the main tree and of the trees it calls, each tree once.
class NodeCollector {
 public:
  explicit NodeCollector(const TreeTable& table) : table_(table) { enter(table.mainTree); }
  std::vector<CollectedNode> take() { return std::move(found_); }

 private:
  void enter(const std::string& treeId) {
    const TreeTable::Entry* entry = table_.find(treeId);
    if (entry && seen_.insert(treeId).second) {
      visit(entry->tree.root, entry->file);
    }
  }
  void visit(const NodeSpec& node, const std::string& file) {
    found_.push_back({&node, &file});
    for (const NodeSpec& child : node.children) {
      visit(child, file);
    }
    if (node.isSubTree()) {
      enter(node.subTree);
    }
  }

  const TreeTable& table_;
  std::set<std::string> seen_;
  std::vector<CollectedNode> found_;
};

struct Problem {
  std::string_view code;
  base::ProblemValues values;
};

/// Checks a constant of a port that is not a list.
std::optional<Problem> problemOf(const NodeSpec& node, const Attribute& port,
                                 const sim2d::Scenario& scenario) {
  if (port.name == "goal_id") {
    const std::optional<int> id = intFromText(port.text);
    return id && !scenario.goal(*id) ? std::optional<Problem>({"tree.no-goal", {*id}})
                                     : std::nullopt;
  }
  if (port.name == "area") {
    const auto isIt = [&port](const sim2d::Area& area) { return area.name == port.text; };
    const bool exists = std::any_of(scenario.areas.begin(), scenario.areas.end(), isIt);
    return exists || port.text.empty() ? std::nullopt
                                       : std::optional<Problem>({"tree.no-area", {port.text}});
  }
  if (port.name != "weights") {
    return std::nullopt;
  }
  const std::optional<std::vector<double>> weights = parseWeights(port.text);
  if (!weights) {
    return Problem{"tree.weights-not-numbers", {port.text}};
  }
  return weights->size() == node.children.size()
             ? std::nullopt
             : std::optional<Problem>(
                   {"tree.weights-count", {node.children.size(), weights->size()}});
}

std::vector<Problem> problemsOf(const NodeSpec& node, const NodeManifest& manifest,
                                const sim2d::Scenario& scenario) {
  std::vector<Problem> problems;
  for (const Attribute& port : node.ports) {
    const PortSpec* spec = manifest.port(port.name);
    if (!spec || spec->direction != PortDirection::Input || referencedKey(port.text, port.name)) {
      continue;
    }
    if (std::optional<Problem> problem = problemOf(node, port, scenario)) {
      problems.push_back(*std::move(problem));
    }
    const bool hasIds = isAgentPort(port.name);
    for (const int id :
         hasIds ? parseIds(port.text).value_or(std::vector<int>{}) : std::vector<int>{}) {
      if (!scenario.humanById(id)) {
        problems.push_back({"tree.no-person", {id}});
      }
    }
  }
  return problems;
}

std::string listText(const std::vector<int>& ids) {
  std::vector<std::string> words;
  words.reserve(ids.size());
  for (const int id : ids) {
    words.push_back(std::to_string(id));
  }
  return "[" + base::join(words, ", ") + "]";
}

/// Goals with equal positions count as equal.
bool haveSamePositions(const std::vector<int>& a, const std::vector<int>& b,
                       const sim2d::Scenario& scenario) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&scenario](int one, int other) {
    const sim2d::GlobalGoal* const first = scenario.goal(one);
    const sim2d::GlobalGoal* const second = scenario.goal(other);
    return one == other || (first && second && first->position == second->position);
  });
}

}  // namespace

std::vector<int> treeGoals(const TreeTable& table) {
  std::vector<int> goals;
  for (const auto& [node, file] : NodeCollector(table).take()) {
    const std::string* text =
        node->id == "SetGoal" ? findAttribute(node->ports, "goal_id") : nullptr;
    const std::optional<int> id = text ? intFromText(*text) : std::nullopt;
    if (id) {
      goals.push_back(*id);
    }
  }
  return goals;
}

Diagnostics checkAgentTree(const TreeTable& table, const sim2d::Human& human,
                           const sim2d::Scenario& scenario, const NodeCatalogue& catalogue) {
  Diagnostics found;
  for (const auto& [node, file] : NodeCollector(table).take()) {
    const NodeManifest* manifest = catalogue.find(node->id);
    if (!manifest || manifest->origin == NodeOrigin::BehaviorTreeCpp) {
      continue;
    }
    for (Problem& problem : problemsOf(*node, *manifest, scenario)) {
      found.push_back(base::withContext(
          node->label(),
          base::warning(problem.code, std::move(problem.values), *file, node->line)));
    }
  }
  const std::vector<int> goals = treeGoals(table);
  if (!goals.empty() && !haveSamePositions(goals, human.goals, scenario)) {
    found.push_back(base::warning(
        "tree.other-goals", {human.name, listText(goals), listText(human.goals)}, table.file));
  }
  for (base::Diagnostic& diagnostic : found) {
    diagnostic.entity = human.key;
  }
  return found;
}

}  // namespace bt
