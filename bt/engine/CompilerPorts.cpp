#include <utility>

#include "bt/engine/Compiler.h"
#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"

/// The part of the compiler that binds ports, entries and scripts.
namespace bt {
namespace {

PortType elementType(const std::string& loop) {
  return loop == "LoopInt"      ? PortType::Int
         : loop == "LoopDouble" ? PortType::Double
         : loop == "LoopBool"   ? PortType::Bool
                                : PortType::String;
}

bool isStrong(PortType type) {
  return type != PortType::Any;
}

const char* shownType(PortType type) {
  return type == PortType::Any ? "any" : portTypeName(type);
}

/// Nodes that read the text of some ports themselves.
bool isKeyPort(const NodeSpec& spec, const PortSpec& port) {
  return (spec.id == "SetBlackboard" && port.name == "output_key") ||
         (spec.id == "UnsetBlackboard" && port.name == "key") || port.name == "entry";
}

}  // namespace

void Compiler::bindPorts(const NodeSpec& spec, const Place& place) {
  firstPorts_.push_back(program_->bindings_.size());
  if (spec.isSubTree()) {
    return;
  }
  const NodeManifest& manifest = *library_.catalogue().find(spec.id);
  for (const PortSpec& port : manifest.ports) {
    program_->bindings_.push_back(bindPort(spec, port, place));
  }
}

PortBinding Compiler::bindPort(const NodeSpec& spec, const PortSpec& port, const Place& place) {
  const std::string* const given = findText(spec.ports, port.name);
  PortBinding missing;
  missing.type = port.type;
  if (isKeyPort(spec, port) && builtinCode(spec.id)) {
    return missing;
  }
  if (!given && !port.defaultText) {
    return missing;
  }
  const std::string& text = given ? *given : *port.defaultText;
  if (const std::optional<std::string> key = referencedKey(text, port.name)) {
    PortBinding entry = missing;
    entry.kind = PortBinding::Kind::Entry;
    entry.isDefault = !given;
    entry.offset = offsetOf(static_cast<std::size_t>(bindEntry(spec, port, *key, place)));
    return entry;
  }
  if (port.direction == PortDirection::Output) {
    return missing;
  }
  return constantPort(text, port.type, !given);
}

PortBinding Compiler::constantPort(const std::string& text, PortType type, bool isDefault) {
  PortBinding binding;
  binding.kind = PortBinding::Kind::Constant;
  binding.isDefault = isDefault;
  binding.type = type;
  binding.offset = offsetOf(program_->constants_.size());
  const Value written = Value::of(std::string_view(text));
  const std::optional<Value> converted = convertTo(written, type);
  if (!converted) {  // only a default: checkTrees() refuses a given text
    binding.kind = PortBinding::Kind::Missing;
    binding.offset = 0;
    return binding;
  }
  program_->constants_.emplace_back();
  program_->constants_.back().value = *converted;
  return binding;
}

/// A constant of a SubTree is a number until its first reader says which kind of number.
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
                        const Place& place) {
  const int slot = scopes_.slotOf(place.scope, key);
  Slot& entry = scopes_.slot(slot);
  Scopes::Use& use = scopes_.use(slot);
  if (port.direction != PortDirection::Input) {
    use.written = true;
  }
  if (port.direction != PortDirection::Output) {
    noteRead(slot, spec, key, place);
  }
  if (spec.id != "SetBlackboard") {
    entry.exists = true;
  }
  const bool typed = entry.type != PortType::Any;
  if (!isStrong(port.type) || (typed && entry.type == PortType::String)) {
    return slot;
  }
  if (!typed) {
    entry.type = port.type;
    use.firstTyped = spec.label() + "." + port.name;
  } else if (entry.type != port.type && !adaptLiteral(slot, port.type)) {
    error(spec, place,
          base::error("tree.key-type", {port.name, shownType(port.type), "{" + key + "}",
                                        shownType(entry.type), use.firstTyped}));
  }
  return slot;
}

void Compiler::noteRead(int slot, const NodeSpec& spec, const std::string& key,
                        const Place& place) {
  Scopes::Use& use = scopes_.use(slot);
  if (!use.read) {
    use.read = true;
    use.firstRead = "{" + key + "}";
    use.file = place.tree->file;
    use.line = spec.line;
  }
}

int Compiler::addScript(const NodeSpec& spec, const std::string& source, const Place& place) {
  const base::Result<Script> script = compileScript(
      source, [&](const std::string& key) { return scopes_.slotOf(place.scope, key); });
  if (!script) {
    error(spec, place, script.diagnostics().front());
    return -1;
  }
  for (const int slot : script->written) {
    scopes_.use(slot).written = true;
  }
  program_->scripts_.push_back(*script);
  return static_cast<int>(program_->scripts_.size()) - 1;
}

int Compiler::scriptOfPort(const NodeSpec& spec, const char* port, const Place& place) {
  const std::string* const text = findText(spec.ports, port);
  if (!text) {
    return -1;  // a missing port is a fault when it is reached
  }
  if (referencedKey(*text, port)) {
    error(spec, place, base::error("tree.script-not-constant", {port}));
    return -1;
  }
  return addScript(spec, *text, place);
}

int Compiler::bindConditions(const NodeSpec& spec, const Place& place) {
  if (spec.conditions.empty()) {
    return -1;
  }
  const auto script = [&](const char* name) {
    const std::string* const text = findText(spec.conditions, name);
    return text ? addScript(spec, *text, place) : -1;
  };
  Program::Conditions conditions;
  conditions.failureIf = script("_failureIf");
  conditions.successIf = script("_successIf");
  conditions.skipIf = script("_skipIf");
  conditions.whileTrue = script("_while");
  conditions.onSuccess = script("_onSuccess");
  conditions.onFailure = script("_onFailure");
  conditions.post = script("_post");
  conditions.onHalted = script("_onHalted");
  program_->conditions_.push_back(conditions);
  return static_cast<int>(program_->conditions_.size()) - 1;
}

/// The slot that a port names, either plainly or as "{key}".
int Compiler::slotOfKeyPort(const NodeSpec& spec, const char* port, const Place& place,
                            bool written) {
  const std::string* const text = findText(spec.ports, port);
  if (!text || text->empty()) {
    return -1;
  }
  const std::string key = referencedKey(*text, port).value_or(*text);
  const int slot = scopes_.slotOf(place.scope, key);
  if (written) {
    scopes_.use(slot).written = true;
  }
  return slot;
}

void Compiler::checkQueue(const NodeSpec& spec, const Place& place) {
  const std::string* const text = findText(spec.ports, "queue");
  if (!text || text->empty() || referencedKey(*text, "queue")) {
    return;
  }
  const PortType type = elementType(spec.id);
  for (const std::string& element : base::split(*text, ';')) {
    if (!isConvertible(element, type)) {
      error(spec, place, base::error("tree.queue-element", {element, portTypeName(type)}));
    }
  }
}

}  // namespace bt
