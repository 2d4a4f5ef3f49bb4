#include <algorithm>
#include <utility>

#include "bt/engine/Compiler.h"
#include "bt/tree/TextValue.h"

/// The part of the compiler that finds where BehaviorTree.CPP 4.10 treats a tree differently, for
/// users who export it. The README has the list.
namespace bt {
namespace {

constexpr std::string_view kPrefix = "tree.there-";

/// Whether a condition keeps something after its failure: a state, or conditions of its own that
/// are evaluated only for idle nodes.
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

base::Diagnostic Compiler::remarkAt(const NodeSpec& spec, const Place& place, std::string_view code,
                                    base::ProblemValues values) const {
  return base::within(place.tree->tree.id + ": " + spec.label(),
                      base::warning(code, std::move(values), place.tree->file, spec.line));
}

void Compiler::note(base::Diagnostic remark) {
  if (notesOnOriginal_ && notes_.insert(remark.text()).second) {
    problems_.push_back(std::move(remark));
  }
}

void Compiler::noteNode(const NodeSpec& spec, const Place& place) {
  if (!notesOnOriginal_) {
    return;
  }
  if (spec.id == "IfThenElse" && spec.children.size() == 2 &&
      keepsState(spec.children.front(), library_)) {
    note(remarkAt(spec, place, "tree.there-stale", {}));
  }
  if (spec.id == "Delay" || spec.id == "Timeout" || spec.id == "Sleep") {
    note(base::problem(base::Severity::Info, "tree.there-clock", {}, table_.file));
  }
  const bool sets = spec.id == "SetBlackboard";
  if (!sets && spec.id != "UnsetBlackboard") {
    return;
  }
  const char* const port = sets ? "output_key" : "key";
  const std::string* const key = findText(spec.ports, port);
  const std::string* const value = findText(spec.ports, "value");
  if (!key || key->empty() || referencedKey(*key, port)) {
    return;
  }
  const int slot = scopes_.slotOf(place.scope, *key);
  Scopes::Use& use = scopes_.use(slot);
  if (!sets) {
    use.removed = remarkAt(spec, place, "tree.there-kept", {*key});
  } else if (value && !referencedKey(*value, "value")) {
    use.textSet = remarkAt(spec, place, "tree.there-emptied", {*key});
  } else if (value) {
    const std::string from = *referencedKey(*value, "value");
    if (scopes_.slot(scopes_.slotOf(place.scope, from)).type == PortType::Queue) {
      note(remarkAt(spec, place, "tree.there-shared", {from}));
    }
  }
}

/// A constant of a SubTree has the type in which it is written, and no other.
void Compiler::noteConstant(const NodeSpec& spec, const PortSpec& port, int slot,
                            const std::string& key, const Place& place) {
  const Slot& entry = scopes_.slot(slot);
  const std::string text = entry.value.toText();
  const bool isMended = port.portType == PortType::Double && entry.type == PortType::Int;
  note(remarkAt(spec, place, "tree.there-refused",
                {port.key, portTypeName(port.portType), "{" + key + "}", portTypeName(entry.type),
                 text, isMended ? text + ".0" : std::string()}));
}

/// Notes that depend on how all nodes use an entry.
void Compiler::noteEntries() {
  const std::vector<Program::Entry> aliases =
      notesOnOriginal_ ? scopes_.aliases() : std::vector<Program::Entry>();
  for (std::size_t slot = 0; notesOnOriginal_ && slot < scopes_.uses().size(); ++slot) {
    const Scopes::Use& use = scopes_.uses()[slot];
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

base::Diagnostics notesOnOriginal(const TreeTable& table, const NodeLibrary& library,
                                  CompileOptions options) {
  options.notesOnOriginal = true;
  base::Diagnostics notes = compile(table, library, options).diagnostics();
  notes.erase(std::remove_if(notes.begin(), notes.end(),
                             [](const base::Diagnostic& found) {
                               return found.code.compare(0, kPrefix.size(), kPrefix) != 0;
                             }),
              notes.end());
  return notes;
}

}  // namespace bt
