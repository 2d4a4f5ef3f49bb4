#include <utility>

#include "bt/tree/NodeCatalogue.h"

namespace bt {
namespace {

PortSpec input(std::string name, PortType type, std::string description) {
  return PortSpec(std::move(name), type, "", std::move(description)).needed();
}

PortSpec milliseconds(const std::string& name, std::string description) {
  return PortSpec(name, PortType::Unsigned, "ms", std::move(description)).needed().suggest("1000");
}

NodeManifest builtin(const char* id, NodeKind kind, const char* category, const char* description,
                     std::vector<PortSpec> ports = {}) {
  NodeManifest manifest;
  manifest.id = id;
  manifest.kind = kind;
  manifest.category = category;
  manifest.description = description;
  manifest.ports = std::move(ports);
  manifest.origin = NodeOrigin::BehaviorTreeCpp;
  const bool parent = kind == NodeKind::Control || kind == NodeKind::Decorator;
  manifest.minChildren = parent ? 1 : 0;
  manifest.maxChildren = kind == NodeKind::Control ? -1 : manifest.minChildren;
  return manifest;
}

NodeManifest control(const char* id, const char* description, std::vector<PortSpec> ports = {}) {
  return builtin(id, NodeKind::Control, "Control", description, std::move(ports));
}

NodeManifest decorator(const char* id, const char* description, std::vector<PortSpec> ports = {}) {
  return builtin(id, NodeKind::Decorator, "Decorator", description, std::move(ports));
}

NodeManifest withChildren(NodeManifest manifest, int least, int most) {
  manifest.minChildren = least;
  manifest.maxChildren = most;
  return manifest;
}

void addSequences(NodeCatalogue& to) {
  to.add(control("Sequence",
                 "Runs the children in order until one fails; goes on at the one that "
                 "was running."));
  to.add(control("Fallback",
                 "Tries the children in order until one succeeds; goes on at the one "
                 "that was running."));
  to.add(control("ReactiveSequence",
                 "Starts at the first child in every step, so that conditions are checked again."));
  to.add(control("ReactiveFallback",
                 "Starts at the first child in every step, so that better choices win."));
  to.add(control("SequenceWithMemory",
                 "A sequence that goes on at the child that failed: waits until it succeeds."));
  to.add(control("AsyncSequence", "A sequence that completes at most one child per step."));
  to.add(control("AsyncFallback", "A fallback that completes at most one child per step."));
}

void addSwitches(NodeCatalogue& to) {
  for (int cases = 2; cases <= 6; ++cases) {
    std::vector<PortSpec> ports = {input("variable", PortType::String, "What is compared.")};
    ports.back().required = false;
    for (int i = 1; i <= cases; ++i) {
      ports.push_back(input("case_" + std::to_string(i), PortType::String,
                            "Child " + std::to_string(i) + " is run for this value."));
    }
    const std::string id = "Switch" + std::to_string(cases);
    to.add(withChildren(control(id.c_str(),
                                "Runs the child whose case equals the variable; the "
                                "last child is for all other values.",
                                std::move(ports)),
                        cases + 1, cases + 1));
  }
}

void addControls(NodeCatalogue& to) {
  addSequences(to);
  to.add(control(
      "Parallel", "Runs all children in every step until enough have succeeded or failed.",
      {input("success_count", PortType::Int,
             "Successes that are enough; negative counts from all (-1).")
           .byDefault("-1"),
       input("failure_count", PortType::Int, "Failures that end it; negative counts from all (-1).")
           .byDefault("1")}));
  to.add(control("ParallelAll", "Runs all children and ends when every one of them is done.",
                 {input("max_failures", PortType::Int, "It fails with this many failures or more.")
                      .byDefault("1")}));
  to.add(withChildren(control("IfThenElse",
                              "First child: condition, asked once; second: if it "
                              "succeeds; third: if not."),
                      2, 3));
  to.add(withChildren(control("WhileDoElse",
                              "First child: condition, asked in every step; second: "
                              "while it succeeds; third: while not."),
                      2, 3));
  addSwitches(to);
  to.add(withChildren(
      control("TryCatch", "Runs all but the last child as a sequence; when it fails, the last one.",
              {input("catch_on_halt", PortType::Bool,
                     "The last child also gets one step when it is halted.")
                   .byDefault("false")}),
      2, -1));
}

void addStatusDecorators(NodeCatalogue& to) {
  to.add(decorator("Inverter", "Success becomes failure and the other way round."));
  to.add(decorator("ForceSuccess", "Succeeds however the child ends."));
  to.add(decorator("ForceFailure", "Fails however the child ends."));
  to.add(decorator("KeepRunningUntilFailure", "Runs the child again and again until it fails."));
  to.add(decorator("Repeat", "Runs the child several times, until it fails.",
                   {input("num_cycles", PortType::Int, "How often; -1 = for ever.").suggest("3")}));
  to.add(
      decorator("RetryUntilSuccessful", "Runs the child again when it fails.",
                {input("num_attempts", PortType::Int, "How often; -1 = for ever.").suggest("3")}));
  to.add(decorator("RunOnce", "Runs the child to its end once in the life of the tree.",
                   {input("then_skip", PortType::Bool,
                          "Afterwards: true = skipped, false = the same result again.")
                        .byDefault("true")}));
  to.add(decorator("Delay", "Waits before the child is run.",
                   {milliseconds("delay_msec", "How long, in simulated time.")}));
  to.add(decorator("Timeout", "Fails when the child takes longer.",
                   {milliseconds("msec", "The limit in simulated time; 0 = none.")}));
}

void addDataDecorators(NodeCatalogue& to) {
  to.add(decorator(
      "Precondition", "Runs the child only if a script is true.",
      {input("if", PortType::String, "The script.").suggest("true"),
       input("else", PortType::Status, "Result when it is false.").byDefault("FAILURE")}));
  const auto loop = [&to](const char* id, PortType type) {
    PortSpec value = input("value", type, "The element.").directed(PortDirection::Output);
    value.required = false;
    to.add(
        decorator(id, "Runs the child once for each element of a list.",
                  {input("queue", PortType::Queue, "The elements with ';' between them.")
                       .suggest("1;2;3")
                       .directed(PortDirection::InOut),
                   input("if_empty", PortType::Status, "Result at the end.").byDefault("SUCCESS"),
                   value.suggest("{value}")}));
  };
  loop("LoopInt", PortType::Int);
  loop("LoopBool", PortType::Bool);
  loop("LoopDouble", PortType::Double);
  loop("LoopString", PortType::String);
  to.add(decorator("SkipUnlessUpdated", "Skips the child unless the entry was written.",
                   {input("entry", PortType::Any, "The entry.").suggest("{key}")}));
  to.add(decorator("WaitValueUpdate", "Waits until the entry was written, then runs the child.",
                   {input("entry", PortType::Any, "The entry.").suggest("{key}")}));
}

void addLeaves(NodeCatalogue& to) {
  const auto leaf = [&to](const char* id, NodeKind kind, const char* description,
                          std::vector<PortSpec> ports = {}) {
    to.add(builtin(id, kind, kind == NodeKind::Condition ? "Condition" : "Blackboard", description,
                   std::move(ports)));
  };
  leaf("AlwaysSuccess", NodeKind::Action, "Succeeds.");
  leaf("AlwaysFailure", NodeKind::Action, "Fails.");
  leaf("SetBlackboard", NodeKind::Action, "Writes an entry of the blackboard.",
       {input("value", PortType::Any, "Text, or {key} of the entry to copy.").suggest("1"),
        input("output_key", PortType::Any, "Name of the entry.")
            .suggest("key")
            .directed(PortDirection::InOut)});
  leaf("UnsetBlackboard", NodeKind::Action, "Removes an entry of the blackboard.",
       {input("key", PortType::String, "Name of the entry.").suggest("key")});
  leaf("Script", NodeKind::Action, "Runs a script.",
       {input("code", PortType::String, "The script.").suggest("x := 1")});
  leaf("ScriptCondition", NodeKind::Condition, "Succeeds if a script is true.",
       {input("code", PortType::String, "The script.").suggest("x == 1")});
  leaf("Sleep", NodeKind::Action, "Waits.", {milliseconds("msec", "How long, in simulated time.")});
  leaf("WasEntryUpdated", NodeKind::Condition,
       "Succeeds if the entry was written since last asked.",
       {input("entry", PortType::Any, "The entry.").suggest("{key}")});
}

}  // namespace

NodeCatalogue builtinNodes() {
  NodeCatalogue catalogue;
  addControls(catalogue);
  addStatusDecorators(catalogue);
  addDataDecorators(catalogue);
  catalogue.add(
      builtin("SubTree", NodeKind::SubTree, "SubTree", "Runs another tree in this place."));
  addLeaves(catalogue);
  return catalogue;
}

}  // namespace bt
