#include <algorithm>
#include <iterator>

#include "bt/engine/Ticker.h"

namespace bt {

const BuiltinNode* Ticker::builtin(std::string_view id) {
  using Code = NodeCode;
  constexpr Status kFails = Status::Failure;
  constexpr Status kSucceeds = Status::Success;
  static constexpr BuiltinNode kNodes[] = {
      {"Sequence", Code::Sequence, sizeof(SequenceMemory), &call<&Ticker::sequence<kFails>>},
      {"Fallback", Code::Fallback, sizeof(SequenceMemory), &call<&Ticker::sequence<kSucceeds>>},
      {"AsyncSequence", Code::AsyncSequence, sizeof(SequenceMemory),
       &call<&Ticker::sequence<kFails, true>>},
      {"AsyncFallback", Code::AsyncFallback, sizeof(SequenceMemory),
       &call<&Ticker::sequence<kSucceeds, true>>},
      {"SequenceWithMemory", Code::SequenceWithMemory, sizeof(SequenceMemory),
       &call<&Ticker::sequence<kFails, true, true>>},
      {"ReactiveSequence", Code::ReactiveSequence, 0, &call<&Ticker::reactive<kFails>>},
      {"ReactiveFallback", Code::ReactiveFallback, 0, &call<&Ticker::reactive<kSucceeds>>},
      {"Parallel", Code::Parallel, sizeof(ParallelMemory), &call<&Ticker::parallel>},
      {"ParallelAll", Code::ParallelAll, sizeof(ParallelMemory), &call<&Ticker::parallelAll>},
      {"IfThenElse", Code::IfThenElse, sizeof(BranchMemory), &call<&Ticker::ifThenElse>},
      {"WhileDoElse", Code::WhileDoElse, 0, &call<&Ticker::whileDoElse>},
      {"Switch2", Code::Switch, sizeof(BranchMemory), &call<&Ticker::switchCase>},
      {"Switch3", Code::Switch, sizeof(BranchMemory), &call<&Ticker::switchCase>},
      {"Switch4", Code::Switch, sizeof(BranchMemory), &call<&Ticker::switchCase>},
      {"Switch5", Code::Switch, sizeof(BranchMemory), &call<&Ticker::switchCase>},
      {"Switch6", Code::Switch, sizeof(BranchMemory), &call<&Ticker::switchCase>},
      {"TryCatch", Code::TryCatch, sizeof(TryCatchMemory), &call<&Ticker::tryCatch>},
      {"Inverter", Code::Inverter, 0, &call<&Ticker::inverter>},
      {"ForceSuccess", Code::ForceSuccess, 0, &call<&Ticker::force<kSucceeds>>},
      {"ForceFailure", Code::ForceFailure, 0, &call<&Ticker::force<kFails>>},
      {"Repeat", Code::Repeat, sizeof(CountMemory), &call<&Ticker::repeat<kSucceeds>>},
      {"RetryUntilSuccessful", Code::RetryUntilSuccessful, sizeof(CountMemory),
       &call<&Ticker::repeat<kFails>>},
      {"KeepRunningUntilFailure", Code::KeepRunningUntilFailure, 0, &call<&Ticker::keepRunning>},
      {"Delay", Code::Delay, sizeof(TimerMemory), &call<&Ticker::delay>},
      {"Timeout", Code::Timeout, sizeof(TimerMemory), &call<&Ticker::timeout>},
      {"RunOnce", Code::RunOnce, sizeof(RunOnceMemory), &call<&Ticker::runOnce>},
      {"Precondition", Code::Precondition, sizeof(RunningMemory), &call<&Ticker::precondition>},
      {"LoopInt", Code::Loop, sizeof(LoopMemory), &call<&Ticker::loop>},
      {"LoopBool", Code::Loop, sizeof(LoopMemory), &call<&Ticker::loop>},
      {"LoopDouble", Code::Loop, sizeof(LoopMemory), &call<&Ticker::loop>},
      {"LoopString", Code::Loop, sizeof(LoopMemory), &call<&Ticker::loop>},
      {"SkipUnlessUpdated", Code::SkipUnlessUpdated, sizeof(UpdateMemory),
       &call<&Ticker::ifUpdated<Status::Skipped>>},
      {"WaitValueUpdate", Code::WaitValueUpdate, sizeof(UpdateMemory),
       &call<&Ticker::ifUpdated<Status::Running>>},
      {"SubTree", Code::SubTree, 0, &call<&Ticker::subTree>},
      {"AlwaysSuccess", Code::AlwaysSuccess, 0, &always<kSucceeds>},
      {"AlwaysFailure", Code::AlwaysFailure, 0, &always<kFails>},
      {"SetBlackboard", Code::SetBlackboard, 0, &call<&Ticker::setBlackboard>},
      {"UnsetBlackboard", Code::UnsetBlackboard, 0, &call<&Ticker::unsetBlackboard>},
      {"Script", Code::Script, 0, &call<&Ticker::script>},
      {"ScriptCondition", Code::ScriptCondition, 0, &call<&Ticker::scriptCondition>},
      {"Sleep", Code::Sleep, sizeof(TimerMemory), &call<&Ticker::sleep>},
      {"WasEntryUpdated", Code::WasEntryUpdated, sizeof(UpdateMemory),
       &call<&Ticker::wasEntryUpdated>}};
  const BuiltinNode* const place =
      std::find_if(std::begin(kNodes), std::end(kNodes),
                   [id](const BuiltinNode& node) { return node.id == id; });
  return place == std::end(kNodes) ? nullptr : place;
}

BuiltinNode Ticker::libraryNode(const NodeFunctions& functions) {
  const auto bytes = static_cast<std::size_t>(functions.memoryBytes);
  switch (functions.kind) {
    case NodeFunctions::Kind::Stateful:
      return {{}, NodeCode::Stateful, bytes, &call<&Ticker::stateful>};
    case NodeFunctions::Kind::Decorator:
      return {{}, NodeCode::Decorator, bytes, &call<&Ticker::customDecorator>};
    case NodeFunctions::Kind::Control:
      return {{}, NodeCode::Control, bytes, &call<&Ticker::customControl>};
    case NodeFunctions::Kind::Synchronous:
      break;
  }
  return {{}, NodeCode::Synchronous, bytes, &call<&Ticker::librarySynchronous>};
}

}  // namespace bt
