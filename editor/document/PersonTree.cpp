#include "editor/document/PersonTree.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "bt/human/GeneratedStyle.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeUse.h"
#include "bt/tree/TreeXml.h"
#include "editor/document/EditCommands.h"
#include "editor/look/CoreText.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr const char* kRegularTree = "RegularNavTree";
constexpr const char* kGoalPort = "goal_id";

/// A file with its includes. Missing includes are left out, except for the one that all generated
/// trees include.
bt::TreeTable tableOf(const ScenarioDocument& document, const bt::TreeFile& file) {
  if (!document.path().isEmpty()) {
    bt::TreeFile placed = file;
    placed.path =
        (std::filesystem::path(treeFolderOf(document.path().toStdString())) / "own.xml").string();
    if (base::Result<bt::TreeTable> table = bt::resolveIncludes(placed)) {
      return *std::move(table);
    }
  }
  bt::TreeTable table;
  table.mainTree = file.mainTree;
  if (table.mainTree.empty() && file.trees.size() == 1) {
    table.mainTree = file.trees.front().id;
  }
  for (const bt::TreeSpec& tree : file.trees) {
    table.entries[tree.id] = {tree, file.path};
  }
  if (table.find(kRegularTree) == nullptr) {
    table.entries[kRegularTree] = {bt::regularNavTree(), bt::kRegularNavFile};
  }
  return table;
}

bool sameTrees(const bt::TreeFile& a, const bt::TreeFile& b) {
  return a.trees == b.trees && a.mainTree == b.mainTree;
}

bt::TreeFile generatedTreeFile(const ScenarioDocument& document, const sim2d::Human& human) {
  return bt::makeTree(document.scenario(), human, treeCatalogue());
}

bt::TreeSpec* mainTreeOf(bt::TreeFile& file) {
  if (bt::TreeSpec* tree = file.find(file.mainTree)) {
    return tree;
  }
  return file.trees.size() == 1 ? &file.trees.front() : nullptr;
}

bool isGeneratedWithBlocks(const ScenarioDocument& document, const sim2d::Human& human,
                           const std::string& own, bt::TreeFile file) {
  bt::TreeSpec* tree = mainTreeOf(file);
  return !bt::hasExtraComments(own, generatedTree(document.scenario(), human)) && tree != nullptr &&
         bt::setBlocks(*tree, {}) && sameTrees(file, generatedTreeFile(document, human));
}

/// None if the tree equals the one generated from behaviour and goals.
std::optional<std::string> customTreeText(const ScenarioDocument& document, EntityId person,
                                          const bt::TreeFile& file) {
  const sim2d::Human* human = document.human(person);
  if (human != nullptr && sameTrees(file, generatedTreeFile(document, *human))) {
    return std::nullopt;
  }
  const std::optional<std::string> own = document.tree(person);
  return own ? bt::rewriteTree(*own, file, treeCatalogue()) : bt::writeTree(file, treeCatalogue());
}

void pushFile(ScenarioDocument& document, EntityId person, const bt::TreeFile& file,
              const QString& text) {
  pushTreeText(document, person, customTreeText(document, person, file), text);
}

/// Whether the node or one below it uses the person's list of goals.
bool usesGoals(const bt::NodeSpec& node) {
  const bt::NodeManifest* const manifest = treeCatalogue().find(node.id);
  return (manifest != nullptr && manifest->usesGoals) ||
         std::any_of(node.children.begin(), node.children.end(), usesGoals);
}

OutlineNode rootOf(const PersonTree& tree, const bt::TreeTable::Entry& entry, int parent) {
  return {&entry.tree.root, parent, entry.tree.id, {}, tree.file.find(entry.tree.id) != nullptr};
}

/// Adds a node and all its descendants.
void addNode(std::vector<OutlineNode>& nodes, const PersonTree& tree, const OutlineNode& node,
             int depth) {
  constexpr int kDeepest = 64;
  constexpr std::size_t kMost = 5000;
  if (depth > kDeepest || nodes.size() >= kMost) {
    return;
  }
  const int self = static_cast<int>(nodes.size());
  nodes.push_back(node);
  if (node.node->isSubTree()) {
    if (const bt::TreeTable::Entry* entry = tree.table.find(node.node->subTree)) {
      addNode(nodes, tree, rootOf(tree, *entry, self), depth + 1);
    }
    return;
  }
  for (std::size_t i = 0; i < node.node->children.size(); ++i) {
    OutlineNode child{&node.node->children[i], self, node.tree, node.path, node.isEditable};
    child.path.push_back(static_cast<int>(i));
    addNode(nodes, tree, child, depth + 1);
  }
}

}  // namespace

bt::TreeSpec* PersonTree::mainTree() {
  return mainTreeOf(file);
}

const bt::TreeSpec* PersonTree::mainTree() const {
  return mainTreeOf(const_cast<bt::TreeFile&>(file));
}

PersonTree personTree(const ScenarioDocument& document, EntityId person) {
  PersonTree result;
  const sim2d::Human* human = document.human(person);
  if (human == nullptr) {
    return result;
  }
  const std::optional<std::string> own = document.tree(person);
  if (!own) {
    result.file = generatedTreeFile(document, *human);
    result.table = tableOf(document, result.file);
    return result;
  }
  result.isCustom = true;
  const base::Result<bt::TreeFile> read = bt::readTreeText(*own, displayName(*human).toStdString());
  result.problems = read.diagnostics();
  if (!read) {
    return result;
  }
  result.file = *read;
  result.table = tableOf(document, result.file);
  if (const auto problem = bt::wrongTreeUse(result.file, bt::TreeUse::Person)) {
    result.problems = {*problem};
    return result;
  }
  result.isGeneratedWithBlocks = isGeneratedWithBlocks(document, *human, *own, result.file);
  base::append(result.problems, bt::diagnosticsOf(bt::checkTrees(result.table, treeCatalogue())));
  base::append(result.problems,
               bt::checkAgentTree(result.table, *human, document.scenario(), treeCatalogue()));
  const bool canSetGoals = result.mainTree() != nullptr && result.mainTree()->root.id == "Fallback";
  result.hasDifferentGoals = canSetGoals && bt::treeGoals(result.table) != human->goals;
  return result;
}

std::vector<int> walkedGoals(const ScenarioDocument& document, const sim2d::Human& human) {
  const std::optional<std::string> text = document.tree(human.key);
  if (!text) {
    return human.goals;
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(*text);
  const auto isUsedIn = [](const bt::TreeSpec& tree) { return usesGoals(tree.root); };
  if (!file || std::any_of(file->trees.begin(), file->trees.end(), isUsedIn)) {
    return human.goals;  // Most trees; the others are read with their includes.
  }
  const PersonTree tree = personTree(document, human.key);
  std::vector<int> goals;
  for (const OutlineNode& node : outlineOf(tree)) {
    const bt::NodeManifest* const manifest = treeCatalogue().find(node.node->id);
    if (manifest != nullptr && manifest->usesGoals) {
      return human.goals;
    }
    const bool isToGoal = manifest != nullptr && manifest->port(kGoalPort) != nullptr;
    const std::string* goal = isToGoal ? bt::findAttribute(node.node->ports, kGoalPort) : nullptr;
    const std::optional<int> id = goal == nullptr ? std::nullopt : bt::intFromText(*goal);
    if (id) {
      goals.push_back(*id);
    }
  }
  return goals;
}

QString treeProblemText(const base::Diagnostic& problem, bool isAtNode) {
  std::vector<std::string> contexts;  // Outermost first: "tree of Ana", "Main/Fallback/Wait".
  std::size_t length = 0;
  for (const auto& [key, value] : problem.values) {
    if (key != "where") {
      break;
    }
    contexts.push_back(value);
    length += value.size() + 2;  // ": "
  }
  std::string message = problem.message;
  message.erase(0, length);  // Contexts precede the text of the problem.
  if (contexts.empty()) {
    return QString::fromStdString(message);
  }
  const std::string path = contexts.back();
  const std::size_t cut = path.find_last_of("/:");
  std::string name = cut == std::string::npos ? path : base::trimmed(path.substr(cut + 1));
  const bool isRepeated = base::startsWith(message, "'" + name + "'");
  contexts.back() = isRepeated || isAtNode ? std::string() : std::move(name);
  std::string text;
  for (std::size_t k = isAtNode ? contexts.size() : 0; k < contexts.size(); ++k) {
    text += contexts[k].empty() ? std::string() : contexts[k] + ": ";
  }
  return QString::fromStdString(text + message);
}

QString problemSummary(const base::Diagnostics& problems) {
  const auto isError = [](const base::Diagnostic& each) {
    return each.severity == base::Severity::Error;
  };
  const auto error = std::find_if(problems.begin(), problems.end(), isError);
  if (problems.empty()) {
    return {};
  }
  const std::size_t more = problems.size() - 1;
  return treeProblemText(error == problems.end() ? problems.front() : *error) +
         (more > 0 ? QObject::tr(" (and %1 more)").arg(more) : QString());
}

bool hasAutoUpdatedTree(const ScenarioDocument& document, EntityId person) {
  const std::optional<std::string> own = document.tree(person);
  const sim2d::Human* human = document.human(person);
  if (!own || human == nullptr) {
    return false;
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(*own);
  return file && isGeneratedWithBlocks(document, *human, *own, *file);
}

std::vector<OutlineNode> outlineOf(const PersonTree& tree) {
  std::vector<OutlineNode> nodes;
  const bt::TreeTable::Entry* main = tree.table.find(tree.table.mainTree);
  if (main == nullptr && !tree.file.trees.empty()) {  // No main tree is set: show the first.
    main = tree.table.find(tree.file.trees.front().id);
  }
  if (main != nullptr && !main->tree.root.id.empty()) {
    addNode(nodes, tree, rootOf(tree, *main, -1), 0);
  }
  return nodes;
}

std::vector<std::string> recordedNames(const std::vector<OutlineNode>& nodes) {
  std::vector<std::string> names;
  for (const OutlineNode& node : nodes) {
    if (node.parent < 0) {
      names.push_back(node.node->label());
      continue;
    }
    const auto parent = static_cast<std::size_t>(node.parent);
    const bt::NodeSpec& above = *nodes[parent].node;
    names.push_back(
        names[parent] + "/" +
        (above.isSubTree()
             ? node.node->label()
             : bt::uniqueChildLabels(above.children)[static_cast<std::size_t>(node.path.back())]));
  }
  return names;
}

void pushTreeText(ScenarioDocument& document, EntityId person, std::optional<std::string> xml,
                  const QString& text) {
  if (document.tree(person) != xml) {
    pushTrees(document, {{person, std::move(xml)}}, text);
  }
}

void pushTreeFile(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::TreeFile& file, const QString& text) {
  std::vector<TreeEdit> edits;
  for (const EntityId person : people) {
    std::optional<std::string> own = customTreeText(document, person, file);
    if (document.human(person) != nullptr && own != document.tree(person)) {
      edits.push_back({person, std::move(own)});
    }
  }
  if (!edits.empty()) {
    pushTrees(document, std::move(edits), text);
  }
}

std::vector<EntityId> peopleWithTreeOf(const ScenarioDocument& document, EntityId person) {
  const std::optional<std::string> own = document.tree(person);
  std::vector<EntityId> people;
  for (const EntityId each : document.entities(EntityKind::Human)) {
    if (each == person || (own && document.tree(each) == own)) {
      people.push_back(each);
    }
  }
  return people;
}

void pushRegeneratedTrees(ScenarioDocument& document, const std::vector<EntityId>& people) {
  std::vector<TreeEdit> edits;
  for (const EntityId person : people) {
    if (document.tree(person)) {
      edits.push_back({person, std::nullopt});
    }
  }
  if (!edits.empty()) {
    pushTrees(document, std::move(edits), QObject::tr("Regenerate tree"));
  }
}

void pushPort(ScenarioDocument& document, EntityId person, const OutlineNode& node,
              const std::string& port, const std::string& text) {
  PersonTree tree = personTree(document, person);
  bt::TreeSpec* spec = tree.file.find(node.tree);
  bt::NodeSpec* found = spec == nullptr ? nullptr : bt::nodeAt(*spec, node.path);
  if (found == nullptr) {
    return;
  }
  text.empty() ? bt::removeAttribute(found->ports, port)
               : bt::setAttribute(found->ports, port, text);
  pushFile(document, person, tree.file,
           QObject::tr("Change %1 of %2")
               .arg(QString::fromStdString(port), QString::fromStdString(found->label())));
}

void pushBlocks(ScenarioDocument& document, EntityId person, const std::vector<bt::Block>& blocks) {
  PersonTree tree = personTree(document, person);
  bt::TreeSpec* spec = tree.mainTree();
  if (spec != nullptr && bt::setBlocks(*spec, blocks)) {
    pushFile(document, person, tree.file, QObject::tr("Change blocks"));
  }
}

void pushAddBlock(ScenarioDocument& document, const std::vector<EntityId>& people,
                  const bt::Block& block) {
  const bt::BlockType* kind = bt::blockType(block.id);
  if (kind == nullptr || people.empty()) {
    return;
  }
  std::vector<TreeEdit> edits;
  for (const EntityId person : people) {
    PersonTree tree = personTree(document, person);
    if (bt::TreeSpec* spec = tree.mainTree()) {
      std::vector<bt::Block> blocks = bt::blocksOf(*spec);
      blocks.push_back(block);
      if (bt::setBlocks(*spec, blocks)) {
        edits.push_back({person, customTreeText(document, person, tree.file)});
      }
    }
  }
  pushTrees(document, std::move(edits), QObject::tr("Add block %1").arg(coreText(kind->title)));
}

void pushGoalsOfRoute(ScenarioDocument& document, EntityId person) {
  PersonTree tree = personTree(document, person);
  const sim2d::Human* human = document.human(person);
  bt::TreeSpec* spec = tree.mainTree();
  if (human != nullptr && spec != nullptr && bt::setTreeGoals(*spec, human->goals)) {
    pushFile(document, person, tree.file, QObject::tr("Copy route to tree"));
  }
}

std::string treeText(const ScenarioDocument& document, EntityId person) {
  const std::optional<std::string> own = document.tree(person);
  const sim2d::Human* human = document.human(person);
  return own || human == nullptr ? own.value_or(std::string())
                                 : generatedTree(document.scenario(), *human);
}

std::optional<std::string> updatedTree(const ScenarioDocument& document,
                                       const sim2d::Human& after) {
  const std::optional<std::string> own = document.tree(after.key);
  const sim2d::Human* before = document.human(after.key);
  if (!own || before == nullptr) {
    return std::nullopt;
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(*own);
  if (!file || !isGeneratedWithBlocks(document, *before, *own, *file)) {
    return std::nullopt;
  }
  bt::TreeFile old = *file;
  bt::TreeFile made = generatedTreeFile(document, after);
  bt::setBlocks(*mainTreeOf(made), bt::blocksOf(*mainTreeOf(old)));
  return sameTrees(made, old) ? std::nullopt : std::optional(bt::writeTree(made, treeCatalogue()));
}

const bt::NodeCatalogue& treeCatalogue() {
  static const bt::NodeLibrary library = bt::humanNodes();
  return library.catalogue();
}

std::string treeFolderOf(const std::string& scenarioPath) {
  const std::filesystem::path folder = std::filesystem::path(scenarioPath).parent_path();
  return folder.filename() == "scenarios" ? (folder.parent_path() / "behavior_trees").string()
                                          : folder.string();
}

std::string generatedTree(const sim2d::Scenario& scenario, const sim2d::Human& human,
                          bt::TreeStyle style) {
  return bt::makeTreeText(scenario, human, style, treeCatalogue());
}

std::optional<bt::TreeStyle> generatedStyle(const std::string& xml, const sim2d::Scenario& scenario,
                                            const sim2d::Human& human) {
  return bt::generatedStyle(xml, scenario, human, treeCatalogue());
}

std::optional<base::FileContent> missingIncludedTree(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / bt::kRegularNavFile).string();
  if (std::filesystem::exists(path)) {
    return std::nullopt;
  }
  return base::FileContent{path, bt::regularNavText(treeCatalogue())};
}

}  // namespace editor
