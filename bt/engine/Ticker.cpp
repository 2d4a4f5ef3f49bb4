#include "bt/engine/Ticker.h"

#include <utility>

/// Ticking, halting and conditions, common to all nodes.
namespace bt {

base::NodeStatus Ticker::tickNode(int node) {
  return tickChild(node);
}

base::NodeStatus Ticker::tickWithConditions(int node) {
  const auto index = static_cast<std::size_t>(program_.node(node).conditions);
  const Program::Conditions& conditions = program_.conditions()[index];
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
  const std::pair<int, Status> atStart[] = {{conditions.failureIf, Status::Failure},
                                            {conditions.successIf, Status::Success},
                                            {conditions.skipIf, Status::Skipped}};
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
  if (conditions.whileTrue < 0 || !asked) {
    return Status::Idle;
  }
  if (!truthOf(node, conditions.whileTrue, truth)) {
    return kFault;
  }
  if (truth) {
    return Status::Idle;
  }
  resetChild(node);
  return Status::Skipped;
}

void Ticker::postConditions(const Program::Conditions& conditions, int node, Status status) {
  const int own = status == Status::Success ? conditions.onSuccess : conditions.onFailure;
  if (own >= 0 && !runScript(node, own)) {
    return;
  }
  if (conditions.post >= 0) {
    runScript(node, conditions.post);
  }
}

void Ticker::resetChild(int node) {
  if (stored(node) == Status::Running) {
    halt(node);
  }
  stored(node) = Status::Idle;
}

void Ticker::resetChildren(int node) {
  if (nodes_[node].hasOnlyInstants) {
    return;
  }
  resetFrom(node + 1, node);
}

void Ticker::resetFrom(int first, int node) {
  const int end = endOf(node);
  for (int child = first; child < end; child = endOf(child)) {
    resetChild(child);
  }
}

void Ticker::halt(int node) {
  haltOwn(node);
  const Program::Node& here = program_.node(node);
  if (hasChildren(here.code)) {
    resetChildren(node);
  }
  tellHalted(node);
  if (here.conditions >= 0) {
    const auto index = static_cast<std::size_t>(here.conditions);
    const int script = program_.conditions()[index].onHalted;
    if (script >= 0) {
      runScript(node, script);
    }
  }
}

/// Decorators and controls of the library hear of it after their children.
void Ticker::tellHalted(int node) {
  const Program::Node& here = program_.node(node);
  if (here.code != NodeCode::Decorator && here.code != NodeCode::Control) {
    return;
  }
  const NodeFunctions& functions = program_.functions(here.detail);
  if (here.code == NodeCode::Decorator && functions.decorator.onHalted) {
    DecoratorContext context(*this, input_, node);
    functions.decorator.onHalted(context);
  }
  if (here.code == NodeCode::Control && functions.control.onHalted) {
    ControlContext context(*this, input_, node);
    functions.control.onHalted(context);
  }
}

/// What the node itself forgets or does when it is halted.
void Ticker::haltOwn(int node) {
  switch (program_.node(node).code) {
    case NodeCode::Sequence:
    case NodeCode::Fallback:
    case NodeCode::AsyncSequence:
    case NodeCode::AsyncFallback:
      memory<SequenceMemory>(node).next = 0;
      break;
    case NodeCode::Parallel:
    case NodeCode::ParallelAll:
      finishParallel(node);
      break;
    case NodeCode::IfThenElse:
    case NodeCode::Switch:
      memory<BranchMemory>(node).branch = 0;
      break;
    case NodeCode::TryCatch:
      haltTryCatch(node);
      break;
    case NodeCode::Repeat:
    case NodeCode::RetryUntilSuccessful:
      memory<CountMemory>(node).count = 0;
      break;
    case NodeCode::Delay:
    case NodeCode::Timeout:
      memory<TimerMemory>(node).started = false;
      break;
    case NodeCode::Precondition:
      memory<RunningMemory>(node).running = false;
      break;
    case NodeCode::Loop:
      memory<LoopMemory>(node).running = false;
      break;
    case NodeCode::SkipUnlessUpdated:
    case NodeCode::WaitValueUpdate:
      memory<UpdateMemory>(node).running = false;
      break;
    case NodeCode::Sleep:
      note(node, LeafEvent::Kind::Halted);
      break;
    case NodeCode::Stateful: {
      const HaltFunction onHalted =
          program_.functions(program_.node(node).detail).stateful.onHalted;
      if (onHalted) {
        LeafContext context(*this, input_, node);
        onHalted(context);
      }
      note(node, LeafEvent::Kind::Halted);
      break;
    }
    default:
      break;
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
  ScriptRunner runner(code, slots(), state_.stack_.get());
  if (!runner.run()) {
    fault(node, "script '" + code.source + "': " + runner.error());
    return false;
  }
  if (!truth) {
    return true;
  }
  const std::optional<bool> result = runner.truth();
  if (!result) {
    fault(node, "script '" + code.source + "' gives text, not true or false");
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
