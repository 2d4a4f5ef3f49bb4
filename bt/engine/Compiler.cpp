#include "bt/engine/Compiler.h"

#include <utility>

#include "bt/engine/Ticker.h"
#include "bt/tree/TreeXml.h"

namespace bt {

Compiler::Compiler(const TreeTable& table, const NodeLibrary& library)
    : table_(table), library_(library) {
  for (const XmlBlock& model : table.subTreeModels) {
    if (const std::string* const id = findText(model.attributes, "ID")) {
      subTreeModels_[*id] = &model;
    }
  }
}

void Compiler::error(const NodeSpec& spec, const Place& place, base::Diagnostic problem) {
  problem.file = place.tree->file;
  problem.line = spec.line;
  problems_.push_back(base::within(place.tree->tree.id + ": " + spec.label(), std::move(problem)));
}

void Compiler::addHostEntries(const std::vector<HostEntry>& entries) {
  for (const HostEntry& entry : entries) {
    const int slot = scopes_.slotOf(0, entry.key);
    scopes_.slot(slot).type = entry.type;
    scopes_.slot(slot).exists = true;
    scopes_.use(slot).written = true;
    scopes_.use(slot).firstTyped = "the program";
    program_->hostSlots_.push_back(slot);
  }
}

/// The number of an entry of `list`; `known` says where those are that it has already.
template <class T>
int Compiler::numberOf(const std::string& id, const T& entry, std::vector<T>& list,
                       std::map<std::string, int>& known) {
  const auto [place, isNew] = known.emplace(id, static_cast<int>(list.size()));
  if (isNew) {
    list.push_back(entry);
  }
  return place->second;
}

int Compiler::addNode(const NodeSpec& spec, const std::string& path, const Place& place) {
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
  noteNode(spec, place);
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
  node.hasOnlyInstants = true;
  for (int child = index + 1; child < node.end; child = program_->node(child).end) {
    node.hasOnlyInstants = node.hasOnlyInstants && program_->node(child).isInstant;
  }
  if (node.tick || (instant && node.conditions < 0 && node.hasOnlyInstants)) {
    node.isInstant = true;
    node.run = instant;
  }
}

void Compiler::addChildren(const NodeSpec& spec, int node, const Place& place) {
  const std::vector<std::string> names = siblingNames(spec.children);
  Place below = place;
  ++below.depth;
  for (std::size_t i = 0; i < spec.children.size() && !full_; ++i) {
    addNode(spec.children[i], paths_[static_cast<std::size_t>(node)] + "/" + names[i], below);
  }
}

void Compiler::addSubTree(const NodeSpec& spec, int node, const Place& place) {
  Place below;
  below.tree = table_.find(spec.subTree);
  below.scope = scopeOfSubTree(spec, node, place);
  below.depth = place.depth + 1;
  const NodeSpec& root = below.tree->tree.root;
  addNode(root, paths_[static_cast<std::size_t>(node)] + "/" + root.label(), below);
}

int Compiler::scopeOfSubTree(const NodeSpec& spec, int node, const Place& place) {
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

void Compiler::applyModel(const NodeSpec& spec, Attributes& mapping, const Place& place) {
  const auto model = subTreeModels_.find(spec.subTree);
  if (model == subTreeModels_.end()) {
    return;
  }
  for (const XmlBlock& port : model->second->children) {
    const std::string* const name = findText(port.attributes, "name");
    if (!name || findText(mapping, *name)) {
      continue;
    }
    if (const std::string* const text = findText(port.attributes, "default")) {
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
      how.hasChildBits ? parallelBytes(node.children) : wholeWords(how.memory);
  if (const NodeFunctions* const functions = library_.functions(spec.id)) {
    node.detail = numberOf(spec.id, *functions, program_->functions_, functions_);
    node.isStateful = functions->kind == NodeFunctions::Kind::Stateful;
    const bool isPlain = functions->kind == NodeFunctions::Kind::Synchronous;
    node.tick = isPlain && spec.conditions.empty() ? functions->tick : nullptr;
  }
}

void Compiler::warnUnwritten() {
  for (const Scopes::Use& use : scopes_.uses()) {
    if (use.read && !use.written) {
      problems_.push_back(base::warning("tree.never-written", {use.firstRead}, use.file, use.line));
    }
  }
}

void Compiler::takeOver() {
  for (std::size_t i = 0; i < firstPorts_.size(); ++i) {
    program_->nodes_[i].ports = program_->bindings_.data() + firstPorts_[i];
  }
  program_->initialSlots_ = scopes_.slots();
  program_->entries_ = scopes_.entries();
  program_->aliases_ = scopes_.aliases();
  if (!program_->keysInEntries_.empty()) {
    program_->scopes_ = scopes_.take();
  }
  program_->paths_ = std::make_shared<const std::vector<std::string>>(std::move(paths_));
}

base::Result<std::shared_ptr<const Program>> Compiler::run(const CompileOptions& options) {
  notesOnOriginal_ = options.notesOnOriginal;
  addHostEntries(options.hostEntries);
  Place place;
  place.tree = table_.find(options.mainTree);
  const NodeSpec& root = place.tree->tree.root;
  addNode(root, root.label(), place);
  warnUnwritten();
  noteEntries();
  if (base::hasErrors(problems_)) {
    return problems_;
  }
  takeOver();
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
  if (std::optional<base::Diagnostic> problem = problemOfMainTree(table, chosen.mainTree)) {
    problems.push_back(*std::move(problem));
  }
  for (const TreeTable::TemplateText& text : table.templates) {
    problems.push_back(base::warning("tree.template-ignored", {}, text.file, text.line));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return after(std::move(problems), Compiler(table, library).run(chosen));
}

base::Result<std::shared_ptr<const Program>> compile(const TreeFile& file,
                                                     const NodeLibrary& library,
                                                     const CompileOptions& options) {
  const base::Result<TreeTable> table = resolveIncludes(file);
  if (!table) {
    return table.diagnostics();
  }
  return after(table.diagnostics(), compile(*table, library, options));
}

}  // namespace bt
