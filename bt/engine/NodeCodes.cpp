#include <algorithm>
#include <iterator>

#include "bt/engine/Ticker.h"

namespace bt {

std::pair<const BuiltinNode*, const BuiltinNode*> Ticker::builtins() {
  constexpr Status kFails = Status::Failure;
  constexpr Status kSucceeds = Status::Success;
  constexpr NodeHalter kForgetBranch = &forget<std::int32_t>;  // or a count
  constexpr NodeHalter kStopLoop = &stopChild<LoopMemory>;
  static constexpr BuiltinNode kNodes[] = {
      {"Sequence", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails>>,
       &forget<SequenceMemory>, &instants<kFails>},
      {"Fallback", sizeof(SequenceMemory), &call<&Ticker::sequence<kSucceeds>>,
       &forget<SequenceMemory>, &instants<kSucceeds>},
      {"AsyncSequence", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails, true>>,
       &forget<SequenceMemory>},
      {"AsyncFallback", sizeof(SequenceMemory), &call<&Ticker::sequence<kSucceeds, true>>,
       &forget<SequenceMemory>},
      {"SequenceWithMemory", sizeof(SequenceMemory), &call<&Ticker::sequence<kFails, true, true>>},
      {"ReactiveSequence", 0, &call<&Ticker::reactive<kFails>>, nullptr, &instants<kFails>},
      {"ReactiveFallback", 0, &call<&Ticker::reactive<kSucceeds>>, nullptr, &instants<kSucceeds>},
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
       &stopChild<UpdateMemory>, nullptr, nullptr, "entry"},
      {"WaitValueUpdate", sizeof(UpdateMemory), &call<&Ticker::ifUpdated<Status::Running>>,
       &stopChild<UpdateMemory>, nullptr, nullptr, "entry"},
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

}  // namespace bt
