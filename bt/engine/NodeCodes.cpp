#include "bt/engine/NodeCodes.h"

#include <map>

namespace bt {
namespace {

constexpr int kBytesPerWord = 8;

int roundedUp(std::size_t bytes) {
  return static_cast<int>((bytes + kBytesPerWord - 1) / kBytesPerWord) * kBytesPerWord;
}

}  // namespace

std::optional<NodeCode> builtinCode(std::string_view id) {
  static const std::map<std::string_view, NodeCode> kCodes = {
      {"Sequence", NodeCode::Sequence},
      {"Fallback", NodeCode::Fallback},
      {"AsyncSequence", NodeCode::AsyncSequence},
      {"AsyncFallback", NodeCode::AsyncFallback},
      {"SequenceWithMemory", NodeCode::SequenceWithMemory},
      {"ReactiveSequence", NodeCode::ReactiveSequence},
      {"ReactiveFallback", NodeCode::ReactiveFallback},
      {"Parallel", NodeCode::Parallel},
      {"ParallelAll", NodeCode::ParallelAll},
      {"IfThenElse", NodeCode::IfThenElse},
      {"WhileDoElse", NodeCode::WhileDoElse},
      {"Switch2", NodeCode::Switch},
      {"Switch3", NodeCode::Switch},
      {"Switch4", NodeCode::Switch},
      {"Switch5", NodeCode::Switch},
      {"Switch6", NodeCode::Switch},
      {"TryCatch", NodeCode::TryCatch},
      {"Inverter", NodeCode::Inverter},
      {"ForceSuccess", NodeCode::ForceSuccess},
      {"ForceFailure", NodeCode::ForceFailure},
      {"Repeat", NodeCode::Repeat},
      {"RetryUntilSuccessful", NodeCode::RetryUntilSuccessful},
      {"KeepRunningUntilFailure", NodeCode::KeepRunningUntilFailure},
      {"Delay", NodeCode::Delay},
      {"Timeout", NodeCode::Timeout},
      {"RunOnce", NodeCode::RunOnce},
      {"Precondition", NodeCode::Precondition},
      {"LoopInt", NodeCode::Loop},
      {"LoopBool", NodeCode::Loop},
      {"LoopDouble", NodeCode::Loop},
      {"LoopString", NodeCode::Loop},
      {"SkipUnlessUpdated", NodeCode::SkipUnlessUpdated},
      {"WaitValueUpdate", NodeCode::WaitValueUpdate},
      {"SubTree", NodeCode::SubTree},
      {"AlwaysSuccess", NodeCode::AlwaysSuccess},
      {"AlwaysFailure", NodeCode::AlwaysFailure},
      {"SetBlackboard", NodeCode::SetBlackboard},
      {"UnsetBlackboard", NodeCode::UnsetBlackboard},
      {"Script", NodeCode::Script},
      {"ScriptCondition", NodeCode::ScriptCondition},
      {"Sleep", NodeCode::Sleep},
      {"WasEntryUpdated", NodeCode::WasEntryUpdated}};
  const auto place = kCodes.find(id);
  return place == kCodes.end() ? std::nullopt : std::optional<NodeCode>(place->second);
}

int memoryBytesOf(NodeCode code, int children) {
  switch (code) {
    case NodeCode::Sequence:
    case NodeCode::Fallback:
    case NodeCode::AsyncSequence:
    case NodeCode::AsyncFallback:
    case NodeCode::SequenceWithMemory:
      return roundedUp(sizeof(SequenceMemory));
    case NodeCode::Parallel:
    case NodeCode::ParallelAll:
      return roundedUp(sizeof(ParallelMemory)) +
             roundedUp((static_cast<std::size_t>(children) + 7) / 8);
    case NodeCode::IfThenElse:
    case NodeCode::Switch:
      return roundedUp(sizeof(BranchMemory));
    case NodeCode::TryCatch:
      return roundedUp(sizeof(TryCatchMemory));
    case NodeCode::Repeat:
    case NodeCode::RetryUntilSuccessful:
      return roundedUp(sizeof(CountMemory));
    case NodeCode::Delay:
    case NodeCode::Timeout:
    case NodeCode::Sleep:
      return roundedUp(sizeof(TimerMemory));
    case NodeCode::RunOnce:
      return roundedUp(sizeof(RunOnceMemory));
    case NodeCode::Precondition:
      return roundedUp(sizeof(RunningMemory));
    case NodeCode::Loop:
      return roundedUp(sizeof(LoopMemory));
    case NodeCode::SkipUnlessUpdated:
    case NodeCode::WaitValueUpdate:
    case NodeCode::WasEntryUpdated:
      return roundedUp(sizeof(UpdateMemory));
    default:
      return 0;
  }
}

}  // namespace bt
