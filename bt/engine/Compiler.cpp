#include "bt/engine/Compiler.h"

#include <algorithm>
#include <utility>

#include "bt/engine/Reachability.h"
#include "bt/engine/Ticker.h"
#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"

namespace bt {

Compiler::Compiler(const TreeTable& table, const NodeLibrary& library)
    : table_(table), library_(library) {
  for (const XmlElement& model : table.subTreeModels) {
    if (const std::string* const id = findAttribute(model.attributes, "ID")) {
      subTreeModels_[*id] = &model;
    }
  }
}

void Compiler::error(const NodeSpec& spec, const CompileContext& place, base::Diagnostic problem) {
  problem.file = place.tree->file;
  problem.line = spec.line;
  problems_.push_back(
      base::withContext(place.tree->tree.id + ": " + spec.label(), std::move(problem)));
}

void Compiler::addHostEntries(const std::vector<HostEntry>& entries) {
  for (const HostEntry& entry : entries) {
    const int slot = scopes_.slotOf(0, entry.key);
    scopes_.slot(slot).type = entry.type;
    scopes_.slot(slot).exists = true;
    scopes_.use(slot).written = true;
    scopes_.use(slot).typeDeclaredBy = "the program";
    program_->hostSlots_.push_back(slot);
  }
}

/// Index of `entry` in `list`, appending it if new. `known` contains the existing indices.
template <class T>
int Compiler::numberOf(const std::string& id, const T& entry, std::vector<T>& list,
                       std::map<std::string, int>& known) {
  const auto [place, isNew] = known.emplace(id, static_cast<int>(list.size()));
  if (isNew) {
    list.push_back(entry);
  }
  return place->second;
}

int Compiler::addNode(const NodeSpec& spec, const std::string& path, const CompileContext& place) {
  pathBytes_ += path.size();
  if (full_ || program_->nodeCount() >= kMaxProgramNodes || place.depth > kMaxProgramDepth ||
      pathBytes_ > kMaxPathBytes) {
    if (!full_) {
      error(spec, place, base::error("tree.too-large"));
    }
    full_ = true;
    return -1;
  }
  const int index = program_->nodeCount();
  Program::Node node;
  node.index = index;
  node.children = spec.isSubTree() ? 1 : static_cast<int>(spec.children.size());
  const NodeManifest& manifest = *library_.catalogue().find(spec.id);
  program_->origins_.push_back({spec.label(), place.tree->tree.id, spec.line,
                                numberOf(spec.id, manifest, program_->manifests_, manifests_)});
  paths_.push_back(path);
  const NodeFunctions* const functions = library_.functions(spec.id);
  const BuiltinNode how = functions ? Ticker::libraryNode(*functions) : *Ticker::builtin(spec.id);
  setCode(spec, how, node);
  bindPorts(spec, place);
  if (how.scriptPort) {
    node.detail = scriptOfPort(spec, how.scriptPort, place);
  } else if (how.keyPort) {
    node.detail = slotOfKeyPort(spec, how.keyPort, place);
  } else if (!functions) {
    checkQueue(spec, place);
  }
  node.conditions = bindConditions(spec, place);
  addNodeDifferences(spec, place);
  program_->nodes_.push_back(node);
  if (spec.isSubTree()) {
    addSubTree(spec, index, place);
  } else {
    addChildren(spec, index, place);
  }
  close(index, how.instant);
  return index;
}

void Compiler::close(int index, NodeRunner instant) {
  Program::Node& node = program_->nodes_[static_cast<std::size_t>(index)];
  node.end = program_->nodeCount();
  node.hasOnlyInstantChildren = true;
  for (int child = index + 1; child < node.end; child = program_->node(child).end) {
    node.hasOnlyInstantChildren = node.hasOnlyInstantChildren && program_->node(child).isInstant;
  }
  if (node.tick || (instant && node.conditions < 0 && node.hasOnlyInstantChildren)) {
    node.isInstant = true;
    node.run = instant;
  }
}

void Compiler::addChildren(const NodeSpec& spec, int node, const CompileContext& place) {
  const std::vector<std::string> names = uniqueChildLabels(spec.children);
  CompileContext below = place;
  ++below.depth;
  for (std::size_t i = 0; i < spec.children.size() && !full_; ++i) {
    addNode(spec.children[i], paths_[static_cast<std::size_t>(node)] + "/" + names[i], below);
  }
}

void Compiler::addSubTree(const NodeSpec& spec, int node, const CompileContext& place) {
  CompileContext below;
  below.tree = table_.find(spec.subTree);
  below.scope = scopeOfSubTree(spec, node, place);
  below.depth = place.depth + 1;
  const NodeSpec& root = below.tree->tree.root;
  addNode(root, paths_[static_cast<std::size_t>(node)] + "/" + root.label(), below);
}

int Compiler::scopeOfSubTree(const NodeSpec& spec, int node, const CompileContext& place) {
  Attributes mapping = spec.ports;
  if (!spec.autoRemap) {
    applyModel(spec, mapping, place);
  }
  const int scope =
      scopes_.add(place.scope, spec.autoRemap, paths_[static_cast<std::size_t>(node)]);
  for (const Attribute& entry : mapping) {
    if (const std::optional<std::string> key = referencedKey(entry.text, entry.name)) {
      scopes_.remap(scope, entry.name, *key);
    } else {
      scopes_.setConstant(scope, entry.name, entry.text);
    }
  }
  return scope;
}

void Compiler::applyModel(const NodeSpec& spec, Attributes& mapping, const CompileContext& place) {
  const auto model = subTreeModels_.find(spec.subTree);
  if (model == subTreeModels_.end()) {
    return;
  }
  for (const XmlElement& port : model->second->children) {
    const std::string* const name = findAttribute(port.attributes, "name");
    if (!name || findAttribute(mapping, *name)) {
      continue;
    }
    if (const std::string* const text = findAttribute(port.attributes, "default")) {
      mapping.push_back({*name, *text});
    } else {
      error(spec, place, base::error("tree.model-port-missing", {*name}));
    }
  }
}

void Compiler::setCode(const NodeSpec& spec, const BuiltinNode& how, Program::Node& node) {
  const NodeKind kind = library_.catalogue().find(spec.id)->kind;
  node.run = how.run;
  node.halt = how.halt;
  node.hasOneChild = kind == NodeKind::Decorator || kind == NodeKind::SubTree;
  node.memory = program_->memoryBytes_;
  program_->memoryBytes_ +=
      how.hasChildBits ? parallelBytes(node.children) : roundUpToWord(how.memory);
  if (const NodeFunctions* const functions = library_.functions(spec.id)) {
    node.detail = numberOf(spec.id, *functions, program_->functions_, functions_);
    node.isStateful = functions->kind == NodeFunctions::Kind::Stateful;
    const bool isPlain = functions->kind == NodeFunctions::Kind::Synchronous;
    node.tick = isPlain && spec.conditions.empty() ? functions->tick : nullptr;
  }
}

void Compiler::warnUnwritten() {
  for (const BlackboardScopes::Use& use : scopes_.uses()) {
    if (use.read && !use.written) {
      problems_.push_back(base::warning("tree.never-written", {use.firstRead}, use.file, use.line));
    }
  }
}

void Compiler::moveIntoProgram() {
  for (std::size_t i = 0; i < firstPorts_.size(); ++i) {
    program_->nodes_[i].ports = program_->bindings_.data() + firstPorts_[i];
  }
  program_->initialSlots_ = scopes_.slots();
  program_->entries_ = scopes_.entries();
  program_->aliases_ = scopes_.aliases();
  if (!program_->indirectKeys_.empty()) {
    program_->scopes_ = scopes_.take();
  }
  program_->paths_ = std::make_shared<const std::vector<std::string>>(std::move(paths_));
  program_->unreachable_ = std::make_shared<const std::vector<bool>>(unreachableNodes(*program_));
}

base::Result<std::shared_ptr<const Program>> Compiler::run(const CompileOptions& options) {
  reportsDifferences_ = options.differencesFromBtCpp;
  addHostEntries(options.hostEntries);
  CompileContext place;
  place.tree = table_.find(options.mainTree);
  const NodeSpec& root = place.tree->tree.root;
  addNode(root, root.label(), place);
  warnUnwritten();
  addEntryDifferences();
  if (base::hasErrors(problems_)) {
    return problems_;
  }
  moveIntoProgram();
  return {std::shared_ptr<const Program>(std::move(program_)), std::move(problems_)};
}

std::optional<int> Program::slotOf(int scope, std::string_view key, bool isOwn) const {
  if (!key.empty() && key[0] == '@' && !isOwn) {
    return slotOf(0, key.substr(1), false);
  }
  const Scope& blackboard = scopes_[static_cast<std::size_t>(scope)];
  const auto place = blackboard.slots.find(key);
  if (place != blackboard.slots.end()) {
    const std::vector<int>& own = blackboard.own;
    const bool isIts = std::find(own.begin(), own.end(), place->second) != own.end();
    return isOwn && !isIts ? std::nullopt : std::optional<int>(place->second);
  }
  const auto remapped = blackboard.remaps.find(key);
  const bool isPrivate = !key.empty() && key[0] == '_';
  if (isOwn || blackboard.parent < 0) {
    return std::nullopt;
  }
  if (remapped != blackboard.remaps.end()) {
    return slotOf(blackboard.parent, remapped->second, false);
  }
  return blackboard.autoRemap && !isPrivate ? slotOf(blackboard.parent, key, false) : std::nullopt;
}

base::Result<std::shared_ptr<const Program>> compile(const TreeTable& table,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options) {
  CompileOptions chosen = options;
  if (chosen.mainTree.empty()) {
    chosen.mainTree = table.mainTree;
  }
  base::Diagnostics problems = diagnosticsOf(checkTrees(table, library.catalogue()));
  if (std::optional<base::Diagnostic> problem = mainTreeProblem(table, chosen.mainTree)) {
    problems.push_back(*std::move(problem));
  }
  for (const TreeTable::TemplatePlaceholder& text : table.templates) {
    problems.push_back(base::warning("tree.template-ignored", {}, text.file, text.line));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return prependDiagnostics(std::move(problems), Compiler(table, library).run(chosen));
}

base::Result<std::shared_ptr<const Program>> compile(const TreeFile& file,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options) {
  const base::Result<TreeTable> table = resolveIncludes(file);
  if (!table) {
    return table.diagnostics();
  }
  return prependDiagnostics(table.diagnostics(), compile(*table, library, options));
}

/// The part of the compiler that finds differences from BehaviorTree.CPP 4.10, for users who export
/// a tree. The README contains the list.
namespace {

constexpr std::string_view kPrefix = "tree.there-";

/// Whether a condition keeps something after a failure: a state, or conditions of its own that are
/// evaluated only for idle nodes.
bool keepsState(const NodeSpec& spec, const NodeLibrary& library) {
  static const std::set<std::string_view> kPlain = {
      "AlwaysSuccess",   "AlwaysFailure", "Script",           "ScriptCondition", "SetBlackboard",
      "UnsetBlackboard", "Inverter",      "ForceSuccess",     "ForceFailure",    "RunOnce",
      "WasEntryUpdated", "Repeat",        "ReactiveSequence", "ReactiveFallback"};
  const NodeFunctions* const functions = library.functions(spec.id);
  const bool isPlain =
      functions ? functions->kind == NodeFunctions::Kind::Synchronous : kPlain.count(spec.id) > 0;
  return !isPlain || !spec.conditions.empty() ||
         std::any_of(spec.children.begin(), spec.children.end(),
                     [&](const NodeSpec& child) { return keepsState(child, library); });
}

}  // namespace

base::Diagnostic Compiler::differenceAt(const NodeSpec& spec, const CompileContext& place,
                                        std::string_view code, base::ProblemValues values) const {
  return base::withContext(place.tree->tree.id + ": " + spec.label(),
                           base::warning(code, std::move(values), place.tree->file, spec.line));
}

void Compiler::note(base::Diagnostic remark) {
  if (reportsDifferences_ && seenDifferences_.insert(remark.text()).second) {
    problems_.push_back(std::move(remark));
  }
}

void Compiler::addNodeDifferences(const NodeSpec& spec, const CompileContext& place) {
  if (!reportsDifferences_) {
    return;
  }
  if (spec.id == "IfThenElse" && spec.children.size() == 2 &&
      keepsState(spec.children.front(), library_)) {
    note(differenceAt(spec, place, "tree.there-stale", {}));
  }
  if (spec.id == "Delay" || spec.id == "Timeout" || spec.id == "Sleep") {
    note(base::problem(base::Severity::Info, "tree.there-clock", {}, table_.file));
  }
  const bool sets = spec.id == "SetBlackboard";
  if (!sets && spec.id != "UnsetBlackboard") {
    return;
  }
  const char* const port = sets ? "output_key" : "key";
  const std::string* const key = findAttribute(spec.ports, port);
  const std::string* const value = findAttribute(spec.ports, "value");
  if (!key || key->empty() || referencedKey(*key, port)) {
    return;
  }
  const int slot = scopes_.slotOf(place.scope, *key);
  BlackboardScopes::Use& use = scopes_.use(slot);
  if (!sets) {
    use.removed = differenceAt(spec, place, "tree.there-kept", {*key});
  } else if (value && !referencedKey(*value, "value")) {
    use.textSet = differenceAt(spec, place, "tree.there-emptied", {*key});
  } else if (value) {
    const std::string from = *referencedKey(*value, "value");
    if (scopes_.slot(scopes_.slotOf(place.scope, from)).type == PortType::Queue) {
      note(differenceAt(spec, place, "tree.there-shared", {from}));
    }
  }
}

/// A constant of a SubTree has exactly the type in which it is written.
void Compiler::addConstantDifference(const NodeSpec& spec, const PortSpec& port, int slot,
                                     const std::string& key, const CompileContext& place) {
  const Slot& entry = scopes_.slot(slot);
  const std::string text = entry.value.toText();
  const bool isMended = port.portType == PortType::Double && entry.type == PortType::Int;
  note(differenceAt(spec, place, "tree.there-refused",
                    {port.key, portTypeName(port.portType), "{" + key + "}",
                     portTypeName(entry.type), text, isMended ? text + ".0" : std::string()}));
}

/// Adds the notes that depend on how all nodes use an entry.
void Compiler::addEntryDifferences() {
  const std::vector<Program::Entry> aliases =
      reportsDifferences_ ? scopes_.aliases() : std::vector<Program::Entry>();
  for (std::size_t slot = 0; reportsDifferences_ && slot < scopes_.uses().size(); ++slot) {
    const BlackboardScopes::Use& use = scopes_.uses()[slot];
    if (use.textSet && use.inScript && scopes_.slots()[slot].type == PortType::Any) {
      note(*use.textSet);
    }
    const auto isIt = [slot](const Program::Entry& alias) {
      return alias.slot == static_cast<int>(slot);
    };
    if (use.removed && std::any_of(aliases.begin(), aliases.end(), isIt)) {
      note(*use.removed);
    }
  }
}

base::Diagnostics differencesFromBtCpp(const TreeTable& table, const NodeLibrary& library,
                                       CompileOptions options) {
  options.differencesFromBtCpp = true;
  base::Diagnostics notes = compile(table, library, options).diagnostics();
  notes.erase(std::remove_if(notes.begin(), notes.end(),
                             [](const base::Diagnostic& found) {
                               return !base::startsWith(found.code, kPrefix);
                             }),
              notes.end());
  return notes;
}

}  // namespace bt
