#include <utility>

#include "bt/engine/Compiler.h"
#include "bt/engine/Ticker.h"
#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Text.h"

/// The part of the compiler that manages blackboards and binds ports, entries and scripts.
namespace bt {
namespace {

std::string shownType(PortType type, PortType element) {
  if (type == PortType::Queue) {
    return std::string("a queue of ") + portTypeName(element);
  }
  return type == PortType::Any ? "any" : portTypeName(type);
}

}  // namespace

int BlackboardScopes::add(int parent, bool autoRemap, const std::string& path) {
  constexpr std::size_t kShownPath = 300;  // of a longer path the end is shown
  Program::Scope scope;
  scope.parent = parent;
  scope.autoRemap = autoRemap;
  scopes_.push_back(std::move(scope));
  paths_.push_back(path.size() > kShownPath ? path.substr(path.size() - kShownPath) : path);
  return static_cast<int>(scopes_.size()) - 1;
}

/// Integers become Int, other numbers Double, anything else text, which declares no type.
void BlackboardScopes::setConstant(int scope, const std::string& key, const std::string& text) {
  const int index = addSlot(scope, key);
  Slot& target = slot(index);
  if (const std::optional<long long> whole = base::parseInt(text); whole && intFromText(text)) {
    target.type = PortType::Int;
    target.value = Value::of(static_cast<int>(*whole));
  } else if (const std::optional<double> number = base::parseDouble(text)) {
    target.type = PortType::Double;
    target.value = Value::of(*number);
  } else {
    target.value = Value::of(std::string_view(text));
  }
  target.exists = true;
  target.version = 1;  // counts as written
  use(index).literal = true;
  use(index).written = true;
}

int BlackboardScopes::addSlot(int scope, const std::string& key) {
  Program::Scope& owner = scopes_[static_cast<std::size_t>(scope)];
  const std::string& path = paths_[static_cast<std::size_t>(scope)];
  const int index = static_cast<int>(slots_.size());
  owner.slots[key] = index;
  owner.own.push_back(index);
  slots_.emplace_back();
  uses_.emplace_back();
  entries_.push_back({path.empty() ? key : path + "/" + key, index});
  return index;
}

std::vector<Program::Entry> BlackboardScopes::aliases() const {
  std::vector<Program::Entry> all;
  for (std::size_t scope = 1; scope < scopes_.size(); ++scope) {
    for (const auto& [key, slot] : scopes_[scope].slots) {
      if (!isOwn(static_cast<int>(scope), slot)) {
        all.push_back({paths_[scope] + "/" + key, slot});
      }
    }
  }
  return all;
}

int BlackboardScopes::slotOf(int scope, const std::string& key) {
  if (!key.empty() && key[0] == '@') {
    return slotOf(0, key.substr(1));
  }
  const Program::Scope& own = scopes_[static_cast<std::size_t>(scope)];
  const auto known = own.slots.find(key);
  if (known != own.slots.end()) {
    return known->second;
  }
  const auto remapped = own.remaps.find(key);
  const bool isPrivate = !key.empty() && key[0] == '_';
  int index = -1;
  if (remapped != own.remaps.end()) {
    index = slotOf(own.parent, remapped->second);
  } else if (own.autoRemap && own.parent >= 0 && !isPrivate) {
    index = slotOf(own.parent, key);
  } else {
    return addSlot(scope, key);
  }
  scopes_[static_cast<std::size_t>(scope)].slots[key] = index;
  return index;
}

void Compiler::bindPorts(const NodeSpec& spec, const CompileContext& place) {
  firstPorts_.push_back(program_->bindings_.size());
  if (spec.isSubTree()) {
    return;
  }
  const NodeManifest& manifest = *library_.catalogue().find(spec.id);
  const BuiltinNode* const builtin = Ticker::builtin(spec.id);
  const char* const keyPort = builtin ? builtin->keyPort : nullptr;
  for (const PortSpec& port : manifest.ports) {
    const bool isKey = keyPort && port.key == keyPort;  // slotOfKeyPort() reads its text
    const PortBinding none = {0, PortBinding::Kind::Missing, false, port.portType};
    program_->bindings_.push_back(isKey ? none : bindPort(spec, port, place));
  }
}

PortBinding Compiler::bindPort(const NodeSpec& spec, const PortSpec& port,
                               const CompileContext& place) {
  const std::string* const given = findAttribute(spec.ports, port.key);
  const PortBinding missing = {0, PortBinding::Kind::Missing, false, port.portType};
  if (!given && !port.fallbackText()) {
    return missing;
  }
  const std::string& text = given ? *given : *port.fallbackText();
  if (const std::optional<std::string> key = referencedKey(text, port.key)) {
    PortBinding entry = missing;
    entry.kind = PortBinding::Kind::Entry;
    entry.isDefault = !given;
    entry.offset = offsetOf(static_cast<std::size_t>(bindEntry(spec, port, *key, place)));
    return entry;
  }
  if (port.direction == PortDirection::Output) {
    return missing;
  }
  return constantPort(text, port.portType, !given);
}

/// The element type of a port that accepts a queue.
PortType Compiler::elementOf(const NodeSpec& spec, const PortSpec& port) const {
  const PortSpec* const value = port.portType == PortType::Queue
                                    ? library_.catalogue().find(spec.id)->port("value")
                                    : nullptr;
  return value ? value->portType : PortType::Any;
}

PortBinding Compiler::constantPort(const std::string& text, PortType type, bool isDefault) {
  PortBinding binding;
  binding.isDefault = isDefault;
  binding.type = type;
  // Only a default may not fit: checkTrees() rejects a given text. A queue stays as written.
  const PortType asType = type == PortType::Queue ? PortType::String : type;
  if (const std::optional<Value> value = convertTo(Value::of(std::string_view(text)), asType)) {
    binding.kind = PortBinding::Kind::Constant;
    binding.offset = offsetOf(program_->constants_.size());
    program_->constants_.emplace_back().value = *value;
  }
  return binding;
}

/// A constant of a SubTree is an untyped number until its first reader declares the type.
bool Compiler::adaptLiteral(int slot, PortType type) {
  Slot& entry = scopes_.slot(slot);
  const bool fits =
      scopes_.use(slot).literal && type != PortType::String && type != PortType::Queue;
  const std::optional<Value> converted = fits ? convertTo(entry.value, type) : std::nullopt;
  if (!converted) {
    return false;
  }
  entry.value = *converted;
  entry.type = type;
  scopes_.use(slot).literal = false;
  return true;
}

int Compiler::bindEntry(const NodeSpec& spec, const PortSpec& port, const std::string& key,
                        const CompileContext& place) {
  const int slot = scopes_.slotOf(place.scope, key);
  BlackboardScopes::Use& use = scopes_.use(slot);
  if (port.direction != PortDirection::Input) {
    use.written = true;
  }
  if (port.direction != PortDirection::Output) {
    noteRead(slot, spec, key, place);
  }
  declare(slot, spec, port, elementOf(spec, port), key, place);
  return slot;
}

/// The first port that names an entry declares its type. Later ports must have the same type,
/// unless one of the two accepts any type or the entry contains text.
void Compiler::declare(int slot, const NodeSpec& spec, const PortSpec& port, PortType element,
                       const std::string& key, const CompileContext& place) {
  Slot& entry = scopes_.slot(slot);
  BlackboardScopes::Use& use = scopes_.use(slot);
  if (!entry.exists) {
    entry.exists = true;
    entry.type = port.portType;
    entry.element = element;
    use.typeDeclaredBy = spec.label() + "." + port.key;
    return;
  }
  const bool isLoose = entry.type == PortType::Any || entry.type == PortType::String ||
                       port.portType == PortType::Any;
  const bool isSame = entry.type == port.portType && entry.element == element;
  if (!isLoose && !isSame && use.literal) {
    addConstantDifference(spec, port, slot, key, place);
  }
  if (!isLoose && !isSame && !adaptLiteral(slot, port.portType)) {
    error(
        spec, place,
        base::error("tree.key-type", {port.key, shownType(port.portType, element), "{" + key + "}",
                                      shownType(entry.type, entry.element), use.typeDeclaredBy}));
  }
}

void Compiler::noteRead(int slot, const NodeSpec& spec, const std::string& key,
                        const CompileContext& place) {
  BlackboardScopes::Use& use = scopes_.use(slot);
  if (!use.read) {
    use.read = true;
    use.firstRead = "{" + key + "}";
    use.file = place.tree->file;
    use.line = spec.line;
  }
}

int Compiler::addScript(const NodeSpec& spec, const std::string& source,
                        const CompileContext& place) {
  const base::Result<Script> script = compileScript(
      source, [&](const std::string& key) { return scopes_.slotOf(place.scope, key); });
  if (!script) {
    error(spec, place, script.diagnostics().front());
    return kMissing;
  }
  if (script->unparsedColumn > 0) {
    error(spec, place, base::warning("tree.script-cut", {source, script->unparsedColumn}));
  }
  for (const int slot : script->written) {
    scopes_.use(slot).written = true;
    scopes_.use(slot).inScript = true;
  }
  program_->scripts_.push_back(*script);
  return static_cast<int>(program_->scripts_.size()) - 1;
}

int Compiler::scriptOfPort(const NodeSpec& spec, const char* port, const CompileContext& place) {
  const std::string* const text = findAttribute(spec.ports, port);
  if (!text) {
    return kMissing;  // a fault at run time
  }
  if (text->empty()) {
    return spec.id == "Script" ? kEmptyScript : kMissing;
  }
  if (referencedKey(*text, port)) {
    error(spec, place, base::error("tree.script-not-constant", {port}));
    return kMissing;
  }
  return addScript(spec, *text, place);
}

int Compiler::bindConditions(const NodeSpec& spec, const CompileContext& place) {
  if (spec.conditions.empty()) {
    return -1;
  }
  Program::Conditions conditions;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::string* const text = findAttribute(spec.conditions, kConditionNames[i]);
    conditions[i] = text ? addScript(spec, *text, place) : kMissing;
  }
  program_->conditions_.push_back(conditions);
  return static_cast<int>(program_->conditions_.size()) - 1;
}

/// The slot of a port that names an entry. "{key}" is equivalent to "key" for nodes that observe an
/// entry; for nodes that write or remove one, "{key}" is the entry that contains the name.
int Compiler::slotOfKeyPort(const NodeSpec& spec, const char* port, const CompileContext& place) {
  const std::string* const text = findAttribute(spec.ports, port);
  if (!text || text->empty()) {
    return kMissing;
  }
  const bool sets = spec.id == "SetBlackboard";
  const bool unsets = spec.id == "UnsetBlackboard";
  const std::optional<std::string> reference = referencedKey(*text, port);
  const int slot = scopes_.slotOf(place.scope, reference.value_or(*text));
  if (reference) {
    const bool isNew = !scopes_.slot(slot).exists;
    const PortSpec& named = *library_.catalogue().find(spec.id)->port(port);
    declare(slot, spec, named, PortType::Any, *reference, place);
    scopes_.slot(slot).isObject = isNew && !sets && !unsets;  // declared as BT::Any
  }
  if (reference && (sets || unsets)) {
    noteRead(slot, spec, *reference, place);
    program_->indirectKeys_.push_back({slot, place.scope});
    return kFirstIndirectKey + 1 - static_cast<int>(program_->indirectKeys_.size());
  }
  if (unsets && (text->front() == '@' || !scopes_.isOwn(place.scope, slot))) {
    return kUnusedEntry;
  }
  if (sets) {
    scopes_.use(slot).written = true;
  }
  return slot;
}

void Compiler::checkQueue(const NodeSpec& spec, const CompileContext& place) {
  const NodeManifest& manifest = *library_.catalogue().find(spec.id);
  const std::string* const text =
      manifest.port("queue") ? findAttribute(spec.ports, "queue") : nullptr;
  if (!text || text->empty() || referencedKey(*text, "queue")) {
    return;
  }
  const PortType type = manifest.port("value")->portType;
  for (const std::string& element : splitQueue(*text)) {
    if (!isConvertible(element, type)) {
      error(spec, place, base::error("tree.queue-element", {element, portTypeName(type)}));
    }
  }
}

}  // namespace bt
