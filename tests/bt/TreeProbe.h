#pragma once

#include <QtTest/QtTest>
#include <memory>
#include <string>
#include <vector>

#include "bt/engine/TreeState.h"
#include "bt/tree/TreeXml.h"

/// Small leaves that write down when they are called, and a tree made of XML text.
namespace probe {

using base::NodeStatus;

struct Log {
  std::vector<std::string> calls;
};

inline NodeStatus note(bt::LeafContext& leaf, const std::string& what, NodeStatus status) {
  leaf.host<Log>().calls.push_back(what);
  return status;
}

struct CountedMemory {
  int run;
};
struct DelayMemory {
  std::int64_t startStep;
  bool started;
};

inline bt::NodeManifest manifest(const char* id, std::vector<bt::PortSpec> ports = {}) {
  bt::NodeManifest result;
  result.id = id;
  result.ports = std::move(ports);
  return result;
}

inline bt::PortSpec port(const char* name, bt::PortType type) {
  bt::PortSpec result;
  result.key = name;
  result.portType = type;
  return result;
}

inline bt::PortSpec port(const char* name, bt::PortType type, const char* defaultText) {
  bt::PortSpec result = port(name, type);
  result.fallback = std::string(defaultText);
  return result;
}

inline void addSynchronousLeaves(bt::NodeLibrary& library) {
  library.add(manifest("S"), bt::synchronous([](bt::LeafContext& leaf) {
                return note(leaf, leaf.label(), NodeStatus::Success);
              }));
  library.add(manifest("F"), bt::synchronous([](bt::LeafContext& leaf) {
                return note(leaf, leaf.label(), NodeStatus::Failure);
              }));
  bt::PortSpec output = port("value", bt::PortType::Int);
  output.direction = bt::PortDirection::Output;
  library.add(manifest("Put", {output, port("number", bt::PortType::Int, "1")}),
              bt::synchronous([](bt::LeafContext& leaf) {
                const bool done = leaf.set(0, leaf.require<int>(1));
                return done ? NodeStatus::Success : NodeStatus::Failure;
              }));
  library.add(manifest("ReadInt", {port("value", bt::PortType::Int)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                return note(leaf, std::to_string(leaf.require<int>(0)), NodeStatus::Success);
              }));
  library.add(manifest("ReadDouble", {port("value", bt::PortType::Double)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                return note(leaf, bt::Value::of(leaf.require<double>(0)).toText(),
                            NodeStatus::Success);
              }));
  library.add(manifest("ReadText", {port("value", bt::PortType::String)}),
              bt::synchronous([](bt::LeafContext& leaf) {
                return note(leaf, std::string(leaf.require<std::string_view>(0)),
                            NodeStatus::Success);
              }));
}

/// St: RUNNING at first, `result` in the `runs`-th onRunning.
inline void addStatefulLeaf(bt::NodeLibrary& library) {
  bt::StatefulFunctions stateful;
  stateful.onStart = [](bt::LeafContext& leaf) {
    leaf.memory<CountedMemory>().run = 0;
    return note(leaf, "start", NodeStatus::Running);
  };
  stateful.onRunning = [](bt::LeafContext& leaf) {
    const int run = ++leaf.memory<CountedMemory>().run;
    const bool ends = run >= leaf.require<int>(0);
    return note(leaf, "run" + std::to_string(run),
                ends ? leaf.require<NodeStatus>(1) : NodeStatus::Running);
  };
  stateful.onHalted = [](bt::LeafContext& leaf) { note(leaf, "halt", NodeStatus::Idle); };
  library.add(manifest("St", {port("runs", bt::PortType::Int, "1"),
                              port("result", bt::PortType::Status, "SUCCESS")}),
              bt::stateful<CountedMemory>(stateful));
}

/// TD: FAILURE until the delay is over, never armed again after it was.
inline void addDelayDecorator(bt::NodeLibrary& library) {
  bt::ParentFunctions functions;
  functions.tick = [](bt::ParentContext& node) {
    auto& own = node.memory<DelayMemory>();
    if (!own.started) {
      own = {node.step(), true};
    }
    return node.hasElapsed(own.startStep, node.require<double>(0)) ? node.tickChild()
                                                                   : NodeStatus::Failure;
  };
  functions.onHalted = [](bt::ParentContext& node) { node.memory<DelayMemory>() = {}; };
  library.add(manifest("TD", {port("delay", bt::PortType::Double, "0.3")}),
              bt::decorator<DelayMemory>(functions));
}

inline bt::NodeLibrary library() {
  bt::NodeLibrary result;
  addSynchronousLeaves(result);
  addStatefulLeaf(result);
  addDelayDecorator(result);
  return result;
}

inline std::string textOf(const base::Diagnostics& diagnostics) {
  std::string text;
  for (const base::Diagnostic& diagnostic : diagnostics) {
    text += diagnostic.text() + "\n";
  }
  return text;
}

/// The body of one tree, or, when it begins with "<root", a whole file.
inline std::string fileOf(const std::string& xml) {
  if (xml.rfind("<root", 0) == 0) {
    return xml;
  }
  return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" + xml + "</BehaviorTree></root>";
}

inline base::Result<std::shared_ptr<const bt::Program>> compiled(
    const std::string& xml, const bt::NodeLibrary& nodes = library()) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(fileOf(xml), "t.xml");
  if (!file) {
    return file.diagnostics();
  }
  return bt::compile(*file, nodes);
}

/// One running tree at 0.1 s per step.
class Run {
 public:
  explicit Run(const std::string& xml, const bt::NodeLibrary& nodes = library()) {
    const auto program = compiled(xml, nodes);
    problems = textOf(program.diagnostics());
    if (program) {
      state = std::make_unique<bt::TreeState>(*program);
    }
  }

  NodeStatus tick() {
    log.calls.clear();
    before.assign(state->statuses().begin(), state->statuses().end());
    return state->tickOnce(nextInput());
  }
  /// "a start -> RUNNING"
  std::string trace() {
    const NodeStatus status = tick();
    std::string text;
    for (const std::string& call : log.calls) {
      text += call + " ";
    }
    return text + "-> " + base::nodeStatusName(status);
  }
  void halt() {
    log.calls.clear();
    state->halt(input());
  }
  std::string entry(const char* key) const {
    const int slot = state->program().findSlot(key);
    return slot < 0 ? "?" : state->get(slot).toText();
  }

  Log log;
  std::string problems;
  std::unique_ptr<bt::TreeState> state;
  std::vector<NodeStatus> before;  // of the tick before the last
  std::int64_t step = 0;
  double dt = 0.1;

 private:
  bt::TickInput input() {
    bt::TickInput result;
    result.step = step;
    result.dt = dt;
    result.host = &log;
    return result;
  }
  bt::TickInput nextInput() {
    ++step;
    return input();
  }
};

}  // namespace probe
