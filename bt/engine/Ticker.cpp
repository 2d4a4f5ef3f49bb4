#include "bt/engine/Ticker.h"

#include <utility>

/// Ticking, halting and conditions, common to all nodes.
namespace bt {

base::NodeStatus Ticker::tickNode(int node) {
  if (++rounds_ > kMostRounds) {
    return fault(node, "so many children in one step: it goes round and never returns RUNNING");
  }
  return tickChild(node);
}

base::NodeStatus Ticker::tickWithConditions(int node) {
  const Program::Conditions& conditions = conditionsOf(nodes_[node]);
  Status status = preCondition(conditions, node);
  if (status == Status::Idle) {
    status = nodes_[node].run(*this, node);
  }
  if (isDone(status)) {
    postConditions(conditions, node, status);
  }
  return isFaulty() ? kFault : status;
}

/// Idle = nothing fired, the node is to be run.
base::NodeStatus Ticker::preCondition(const Program::Conditions& conditions, int node) {
  const std::pair<int, Status> atStart[] = {{conditions[Program::FailureIf], Status::Failure},
                                            {conditions[Program::SuccessIf], Status::Success},
                                            {conditions[Program::SkipIf], Status::Skipped}};
  bool truth = false;
  if (stored(node) == Status::Idle) {
    for (const auto& [script, result] : atStart) {
      if (script >= 0 && !truthOf(node, script, truth)) {
        return kFault;
      }
      if (script >= 0 && truth) {
        return result;
      }
    }
  }
  const bool asked = stored(node) == Status::Idle || stored(node) == Status::Running;
  if (conditions[Program::While] < 0 || !asked) {
    return Status::Idle;
  }
  if (!truthOf(node, conditions[Program::While], truth)) {
    return kFault;
  }
  if (truth) {
    return Status::Idle;
  }
  resetChild(node);
  return Status::Skipped;
}

void Ticker::postConditions(const Program::Conditions& conditions, int node, Status status) {
  const int own =
      status == Status::Success ? conditions[Program::OnSuccess] : conditions[Program::OnFailure];
  if (own >= 0 && !runScript(node, own)) {
    return;
  }
  if (conditions[Program::Post] >= 0) {
    runScript(node, conditions[Program::Post]);
  }
}

void Ticker::resetChild(int node) {
  if (stored(node) == Status::Running) {
    halt(node);
  }
  stored(node) = Status::Idle;
}

void Ticker::resetChildren(int node) {
  resetFrom(node + 1, node);
}

void Ticker::resetFrom(int first, int node) {
  if (nodes_[node].hasOnlyInstants) {
    return;
  }
  const int end = endOf(node);
  for (int child = first; child < end; child = endOf(child)) {
    resetChild(child);
  }
}

void Ticker::halt(int node) {
  const Program::Node& here = program_.node(node);
  if (here.halt) {
    here.halt(*this, node);
  } else {
    resetChildren(node);
  }
  if (here.conditions >= 0) {
    const int script = conditionsOf(here)[Program::OnHalted];
    if (script >= 0) {
      runScript(node, script);
    }
  }
}

template <class T>
void Ticker::forget(Ticker& ticker, int node) {
  ticker.memory<T>(node) = T();
  ticker.resetChildren(node);
}

/// The child does not run any more; the rest of the memory stays.
template <class T>
void Ticker::stopChild(Ticker& ticker, int node) {
  ticker.memory<T>(node).running = false;
  ticker.resetChildren(node);
}

void Ticker::noteHalt(Ticker& ticker, int node) {
  ticker.note(node, LeafEvent::Kind::Halted);
}

void Ticker::haltStateful(Ticker& ticker, int node) {
  if (const HaltFunction onHalted = ticker.functionsOf(node).stateful.onHalted) {
    LeafContext context(ticker, ticker.input_, node);
    onHalted(context);
  }
  noteHalt(ticker, node);
}

/// Decorators and controls of the library hear of it after their children.
void Ticker::haltParent(Ticker& ticker, int node) {
  ticker.resetChildren(node);
  if (const ParentHaltFunction onHalted = ticker.functionsOf(node).parent.onHalted) {
    ParentContext context(ticker, ticker.input_, node);
    onHalted(context);
  }
}

base::NodeStatus Ticker::unexpected(int child, Status status) {
  if (status == kFault || isFaulty()) {
    return kFault;
  }
  return fault(child, std::string("it returned ") + base::nodeStatusName(status));
}

base::NodeStatus Ticker::fault(int node, std::string message) {
  isFaulty_ = true;
  if (!state_.fault_) {
    state_.fault_ =
        std::make_unique<TreeFault>(TreeFault{node, program_.path(node), std::move(message)});
  }
  return kFault;
}

bool Ticker::runScript(int node, int script, bool* truth) {
  const Script& code = program_.scripts()[static_cast<std::size_t>(script)];
  ScriptRunner runner(code, slots());
  if (!runner.run()) {
    fault(node, "script '" + code.source + "': " + runner.error());
    return false;
  }
  if (!truth) {
    return true;
  }
  const std::optional<bool> result = runner.truth();
  if (!result) {
    const Value& given = runner.result();
    const std::string what = given.type == ValueType::String  ? "text"
                             : given.type == ValueType::Unset ? "no value"
                                                              : given.toText();
    fault(node,
          "script '" + code.source + "' gives " + what + ", not true or false (compare: 'n != 0')");
    return false;
  }
  *truth = *result;
  return true;
}

const Value* Ticker::portValue(int node, int port) const {
  const PortBinding& binding = nodes_[node].ports[port];
  const bool isEntry = binding.kind == PortBinding::Kind::Entry;
  const Slot* const column = isEntry ? state_.slots_.get() : program_.constants().data();
  const Value& value = boundSlot(column, binding).value;
  return value.type == ValueType::Unset ? nullptr : &value;
}

bool Ticker::hasElapsed(const TimerMemory& timer, std::int64_t milliseconds) const {
  const double elapsed = static_cast<double>(input_.step - timer.startStep) * input_.dt;
  return elapsed >= static_cast<double>(milliseconds) / 1000.0 - kTimeTolerance;
}

}  // namespace bt
