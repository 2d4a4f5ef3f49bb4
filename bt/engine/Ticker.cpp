#include "bt/engine/Ticker.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace bt {

std::pair<const BuiltinNode*, const BuiltinNode*> Ticker::builtins() {
  constexpr Status kFails = Status::Failure;
  constexpr Status kSucceeds = Status::Success;
  constexpr NodeHalter kForgetBranch = &forget<std::int32_t>;  // also for a count
  constexpr NodeHalter kStopLoop = &clearRunningFlag<LoopMemory>;
  static constexpr BuiltinNode kNodes[] = {
      {"Sequence", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails>>,
       &forget<SequenceMemory>, &instantSequence<kFails>},
      {"Fallback", sizeof(SequenceMemory), &call<&Ticker::sequence<kSucceeds>>,
       &forget<SequenceMemory>, &instantSequence<kSucceeds>},
      {"AsyncSequence", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails, true>>,
       &forget<SequenceMemory>},
      {"AsyncFallback", sizeof(SequenceMemory), &call<&Ticker::sequence<kSucceeds, true>>,
       &forget<SequenceMemory>},
      {"SequenceWithMemory", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails, true, true>>},
      {"ReactiveSequence", 0, &call<&Ticker::reactive<kFails>>, nullptr, &instantSequence<kFails>},
      {"ReactiveFallback", 0, &call<&Ticker::reactive<kSucceeds>>, nullptr,
       &instantSequence<kSucceeds>},
      {"Parallel", sizeof(ParallelMemory), &call<&Ticker::parallel>, &haltParallel, nullptr,
       nullptr, nullptr, true},
      {"ParallelAll", sizeof(ParallelMemory), &call<&Ticker::parallelAll>, &haltParallel, nullptr,
       nullptr, nullptr, true},
      {"IfThenElse", sizeof(std::int32_t), &call<&Ticker::ifThenElse>, kForgetBranch},
      {"WhileDoElse", 0, &call<&Ticker::whileDoElse>},
      {"Switch2", sizeof(std::int32_t), &call<&Ticker::switchCase>, kForgetBranch},
      {"Switch3", sizeof(std::int32_t), &call<&Ticker::switchCase>, kForgetBranch},
      {"Switch4", sizeof(std::int32_t), &call<&Ticker::switchCase>, kForgetBranch},
      {"Switch5", sizeof(std::int32_t), &call<&Ticker::switchCase>, kForgetBranch},
      {"Switch6", sizeof(std::int32_t), &call<&Ticker::switchCase>, kForgetBranch},
      {"TryCatch", sizeof(TryCatchMemory), &call<&Ticker::tryCatch>, &haltTryCatch},
      {"Inverter", 0, &call<&Ticker::inverter>, nullptr, &instantInverter},
      {"ForceSuccess", 0, &call<&Ticker::force<kSucceeds>>, nullptr, &instantForce<kSucceeds>},
      {"ForceFailure", 0, &call<&Ticker::force<kFails>>, nullptr, &instantForce<kFails>},
      {"Repeat", sizeof(std::int32_t), &call<&Ticker::repeat<kSucceeds>>, kForgetBranch},
      {"RetryUntilSuccessful", sizeof(std::int32_t), &call<&Ticker::repeat<kFails>>, kForgetBranch},
      {"KeepRunningUntilFailure", 0, &call<&Ticker::keepRunning>},
      {"Delay", sizeof(TimerMemory), &call<&Ticker::timer<false>>, &forget<TimerMemory>},
      {"Timeout", sizeof(TimerMemory), &call<&Ticker::timer<true>>, &forget<TimerMemory>},
      {"RunOnce", sizeof(Status), &call<&Ticker::runOnce>},
      {"Precondition", sizeof(bool), &call<&Ticker::precondition>, &forget<bool>, nullptr, "if"},
      {"LoopInt", sizeof(LoopMemory), &call<&Ticker::loop>, kStopLoop},
      {"LoopBool", sizeof(LoopMemory), &call<&Ticker::loop>, kStopLoop},
      {"LoopDouble", sizeof(LoopMemory), &call<&Ticker::loop>, kStopLoop},
      {"LoopString", sizeof(LoopMemory), &call<&Ticker::loop>, kStopLoop},
      {"SkipUnlessUpdated", sizeof(UpdateMemory), &call<&Ticker::ifUpdated<Status::Skipped>>,
       &clearRunningFlag<UpdateMemory>, nullptr, nullptr, "entry"},
      {"WaitValueUpdate", sizeof(UpdateMemory), &call<&Ticker::ifUpdated<Status::Running>>,
       &clearRunningFlag<UpdateMemory>, nullptr, nullptr, "entry"},
      {"SubTree", 0, &call<&Ticker::subTree>},
      {"AlwaysSuccess", 0, &always<kSucceeds>},
      {"AlwaysFailure", 0, &always<kFails>},
      {"SetBlackboard", 0, &call<&Ticker::setBlackboard>, nullptr, nullptr, nullptr, "output_key"},
      {"UnsetBlackboard", 0, &call<&Ticker::unsetBlackboard>, nullptr, nullptr, nullptr, "key"},
      {"Script", 0, &call<&Ticker::script>, nullptr, nullptr, "code"},
      {"ScriptCondition", 0, &call<&Ticker::scriptCondition>, nullptr, nullptr, "code"},
      {"Sleep", sizeof(TimerMemory), &call<&Ticker::sleep>, &noteHalt},
      {"WasEntryUpdated", sizeof(UpdateMemory), &call<&Ticker::wasEntryUpdated>, nullptr, nullptr,
       nullptr, "entry"}};
  return {std::begin(kNodes), std::end(kNodes)};
}

const BuiltinNode* Ticker::builtin(std::string_view id) {
  const auto [begin, end] = builtins();
  const BuiltinNode* const place =
      std::find_if(begin, end, [id](const BuiltinNode& node) { return node.id == id; });
  return place == end ? nullptr : place;
}

BuiltinNode Ticker::libraryNode(const NodeFunctions& functions) {
  const auto bytes = static_cast<std::size_t>(functions.memoryBytes);
  switch (functions.kind) {
    case NodeFunctions::Kind::Stateful:
      return {{}, bytes, &call<&Ticker::stateful>, &haltStateful};
    case NodeFunctions::Kind::Decorator:
      return {{}, bytes, &call<&Ticker::customDecorator>, &haltParent};
    case NodeFunctions::Kind::Control:
      return {{}, bytes, &call<&Ticker::customControl>, &haltParent};
    case NodeFunctions::Kind::Synchronous:
      break;
  }
  return {{}, bytes, &call<&Ticker::librarySynchronous>};
}

/// Ticking, halting and conditions, common to all nodes.

base::NodeStatus Ticker::tickNode(int node) {
  if (++rounds_ > kMostRounds) {
    return fault(node,
                 "too many nodes ticked in one step: the tree loops and never returns RUNNING");
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

/// Returns IDLE if no condition applies and the node must run.
base::NodeStatus Ticker::preCondition(const Program::Conditions& conditions, int node) {
  const std::pair<int, Status> atStart[] = {{conditions[Program::FailureIf], Status::Failure},
                                            {conditions[Program::SuccessIf], Status::Success},
                                            {conditions[Program::SkipIf], Status::Skipped}};
  bool truth = false;
  if (stored(node) == Status::Idle) {
    for (const auto& [script, result] : atStart) {
      if (script >= 0 && !evaluateCondition(node, script, truth)) {
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
  if (!evaluateCondition(node, conditions[Program::While], truth)) {
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
  if (nodes_[node].hasOnlyInstantChildren) {
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

/// Marks the child as not running; the rest of the memory is kept.
template <class T>
void Ticker::clearRunningFlag(Ticker& ticker, int node) {
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

/// Library decorators and controls are notified after their children are halted.
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
  return fault(child, std::string("the node returned ") + base::nodeStatusName(status));
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

/// Instant nodes: synchronous functions of the library, and nodes that combine only instant nodes,
/// all without conditions. They are never RUNNING and never SKIPPED, so they keep no state between
/// ticks and need no halt. Most of a tick is spent here, as a tree evaluates its conditions in
/// every step.

/// Sequences (`stop` = FAILURE) and fallbacks (SUCCESS), reactive or not.
template <base::NodeStatus stop>
base::NodeStatus Ticker::instantSequence(Ticker& ticker, int node) {
  const Program::Node* here = ticker.nodes_ + node + 1;
  const Program::Node* const end = ticker.nodes_ + ticker.nodes_[node].end;
  while (here < end) {
    Status status;
    if (here->tick) {
      ticker.leaf_.switchToNode(*here);
      status = here->tick(ticker.leaf_);
      if (status == kContinueStatus<stop> && !ticker.isFaulty_) {
        ticker.setReturned(here->index, status);
        ++here;
        continue;
      }
      if (status != stop || ticker.isFaulty_) {
        return ticker.unexpected(here->index, status);
      }
    } else {
      status = here->run(ticker, here->index);
    }
    if (status == kFault) {
      return status;
    }
    ticker.setReturned(here->index, status);
    if (status == stop) {
      return status;
    }
    here = ticker.nodes_ + here->end;
  }
  return kContinueStatus<stop>;
}

base::NodeStatus Ticker::instantInverter(Ticker& ticker, int node) {
  const Status status = ticker.tickInstant(ticker.nodes_[node + 1], node + 1);
  return status == kFault ? kFault : status == Status::Success ? Status::Failure : Status::Success;
}

template <base::NodeStatus result>
base::NodeStatus Ticker::instantForce(Ticker& ticker, int node) {
  return ticker.tickInstant(ticker.nodes_[node + 1], node + 1) == kFault ? kFault : result;
}

}  // namespace bt
