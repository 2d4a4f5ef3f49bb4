#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bt/engine/Program.h"

/// What the engine keeps per node and agent, and which names it runs itself.
namespace bt {

/// A kind of node and how it is run.
struct BuiltinNode {
  std::string_view id;  // in XML; empty of those that a library runs
  std::size_t memory;   // [bytes] of its struct below
  NodeRunner run;
  NodeHalter halt = nullptr;
  NodeRunner instant = nullptr;      // instead of `run`, when all children are instant
  const char* scriptPort = nullptr;  // its text is the script that `detail` names
  const char* keyPort = nullptr;     // its text names the entry that `detail` is the slot of
  bool hasChildBits = false;         // one bit per child behind its memory
};

inline int wholeWords(std::size_t bytes) {
  return static_cast<int>((bytes + 7) / 8 * 8);
}

/// What nodes keep; all zero in a new tree. IfThenElse and Switch keep the node of the chosen child
/// (0 = none yet), Repeat and Retry a count, RunOnce the result (IDLE = has not run), Precondition
/// whether the child runs.
struct SequenceMemory {
  std::int32_t next = 0;  // node to go on with; 0 = the first child
  std::int32_t skipped = 0;
};
struct TryCatchMemory {
  std::int32_t next = 0;
  std::int32_t skipped = 0;
  bool catching = false;
};
/// Followed by one bit per child: done in this run.
struct ParallelMemory {
  std::int32_t successes = 0;
  std::int32_t failures = 0;
};
/// Of a Parallel with its bits.
inline int parallelBytes(int children) {
  return wholeWords(sizeof(ParallelMemory)) +
         wholeWords((static_cast<std::size_t>(children) + 7) / 8);
}
struct TimerMemory {
  std::int64_t startStep = 0;
  bool started = false;
};
struct LoopMemory {
  std::int32_t taken = 0;  // elements taken of a queue in the file, since it started
  bool running = false;
};
struct UpdateMemory {
  std::uint32_t seen = 0;  // version of the entry plus 1; 0: never read
  bool running = false;
};

}  // namespace bt
