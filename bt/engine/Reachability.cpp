#include "bt/engine/Reachability.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace bt {

namespace {

// Sets of results.
using Results = unsigned;
constexpr Results kCanRun = 1, kCanSucceed = 2, kCanFail = 4, kCanSkip = 8;
constexpr Results kResultsOfLeaves = kCanRun | kCanSucceed | kCanFail;
constexpr Results kAnyResult = kResultsOfLeaves | kCanSkip;

bool isSequence(std::string_view id) {
  constexpr std::array<std::string_view, 5> kIds = {
      "Sequence", "SequenceWithMemory", "AsyncSequence", "ReactiveSequence", "PipelineSequence"};
  return std::find(kIds.begin(), kIds.end(), id) != kIds.end();
}

bool isFallback(std::string_view id) {
  return id == "Fallback" || id == "AsyncFallback" || id == "ReactiveFallback";
}

/// Results of a decorator that replaces SUCCESS and FAILURE of its child by these.
Results mapped(Results child, Results success, Results failure) {
  return (child & (kCanRun | kCanSkip)) | ((child & kCanSucceed) != 0 ? success : 0) |
         ((child & kCanFail) != 0 ? failure : 0);
}

class ReachabilityAnalysis {
 public:
  explicit ReachabilityAnalysis(const Program& program)
      : program_(program), results_(static_cast<std::size_t>(program.nodeCount()), kAnyResult) {}

  std::vector<bool> unreachable() {
    for (int node = program_.nodeCount() - 1; node >= 0; --node) {  // children before parents
      results_[static_cast<std::size_t>(node)] = resultsOf(node);
    }
    std::vector<bool> marks(results_.size(), false);
    for (int node = 0; node < program_.nodeCount(); ++node) {  // parents before children
      const bool isParentUnreachable = marks[static_cast<std::size_t>(node)];
      bool canStart = true;
      for (int child = node + 1; child < program_.node(node).end;
           child = program_.node(child).end) {
        canStart = canStart && !isParentUnreachable;
        marks[static_cast<std::size_t>(child)] = !(canStart && canStartAfterFirst(node, child));
        canStart = canStart && (results(child) & continuing(node)) != 0;
      }
    }
    return marks;
  }

 private:
  Results results(int node) const { return results_[static_cast<std::size_t>(node)]; }
  std::string_view idOf(int node) const { return program_.manifest(node).id; }

  /// Results of a child after which the node may start the next one.
  Results continuing(int node) const {
    return isSequence(idOf(node))   ? kCanSucceed | kCanSkip
           : isFallback(idOf(node)) ? kCanFail | kCanSkip
                                    : kAnyResult;
  }

  /// Of nodes that select a child by the result of their first one.
  bool canStartAfterFirst(int node, int child) const {
    const int first = node + 1;
    if (child == first) {
      return true;
    }
    if (idOf(node) == "RecoveryNode") {
      return (results(first) & kCanFail) != 0;
    }
    if (idOf(node) == "IfThenElse" || idOf(node) == "WhileDoElse") {
      const bool isThen = child == program_.node(first).end;
      return (results(first) & (isThen ? kCanSucceed : kCanFail)) != 0;
    }
    return true;
  }

  /// The results that a node can have if it is executed. Those of its children are known.
  Results resultsOf(int node) const {
    const std::string_view id = idOf(node);
    if (program_.node(node).conditions >= 0) {
      return kAnyResult;
    }
    if (id == "AlwaysSuccess" || id == "AlwaysFailure") {
      return id == "AlwaysSuccess" ? kCanSucceed : kCanFail;
    }
    if (isSequence(id) || isFallback(id)) {
      return resultsOfChain(node, isSequence(id) ? kCanFail : kCanSucceed);
    }
    if (id == "Inverter") {
      return mapped(results(node + 1), kCanFail, kCanSucceed);
    }
    if (id == "ForceSuccess") {
      return mapped(results(node + 1), kCanSucceed, kCanSucceed);
    }
    if (id == "ForceFailure") {
      return mapped(results(node + 1), kCanFail, kCanFail);
    }
    if (program_.node(node).children == 0) {
      return kResultsOfLeaves;
    }
    return id == "SubTree" ? results(node + 1) : kAnyResult;
  }

  /// A sequence ends at FAILURE (`stop`) and a Fallback at SUCCESS; both at RUNNING. At most one
  /// child of an asynchronous one starts per tick, after which it is RUNNING.
  Results resultsOfChain(int node, Results stop) const {
    const Results ahead = stop == kCanFail ? kCanSucceed : kCanFail;
    Results possible = idOf(node).substr(0, 5) == "Async" ? kCanRun : 0;
    bool canStart = true, canAllSkip = true, canAnyPass = false;
    for (int child = node + 1; child < program_.node(node).end && canStart;
         child = program_.node(child).end) {
      possible |= results(child) & (kCanRun | stop);
      canAllSkip = canAllSkip && (results(child) & kCanSkip) != 0;
      canAnyPass = canAnyPass || (results(child) & ahead) != 0;
      canStart = (results(child) & (ahead | kCanSkip)) != 0;
    }
    if (canStart) {
      possible |= (canAnyPass ? ahead : 0) | (canAllSkip ? kCanSkip : 0);
    }
    return possible;
  }

  const Program& program_;
  std::vector<Results> results_;
};

}  // namespace

std::vector<bool> unreachableNodes(const Program& program) {
  return ReachabilityAnalysis(program).unreachable();
}

}  // namespace bt
