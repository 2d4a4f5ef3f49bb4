#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

/// What FaultShim.cpp is to do and what it has seen: a file that every process of a program maps,
/// so that their calls are counted together. No allocation, no locks.
namespace faults {

/// Names the file with the State.
constexpr const char* kStateVariable = "HUNAV_FAULT_STATE";

enum class Kind : int {
  Count,       // nothing fails
  Kill,        // SIGKILL for the process that reaches the call, which is not made
  KillAll,     // the same for all processes of the program
  Plug,        // KillAll; who looks afterwards loses what was appended and not synced (`unsynced`)
  NoSpace,     // the disk is full from this call on; the first write is cut in the middle
  WriteError,  // EIO, this call alone
  ReadError,   // the same, of the calls that read
};

/// Names a file that gets a line per call: w(rite) or r(ead), number, process, call, file.
constexpr const char* kLogVariable = "HUNAV_FAULT_LOG";

/// A file that was written, by its place on the disk, which renaming leaves as it is.
struct Inode {
  std::uint64_t device = 0, number = 0;
  std::int64_t syncedSize = 0;  // [B] that are on the disk
};

struct State {
  Kind kind = Kind::Count;
  int at = 0;           // number of the call, from 1 on: of those that read for ReadError
  char folder[1024]{};  // watched with all below; absolute, no links
  std::atomic<int> changes{0}, reads{0};
  std::atomic<int> isFull{0};  // NoSpace has begun
  std::atomic<int> processCount{0};
  std::atomic<int> processes[512]{};
  std::atomic<int> unsyncedCount{0};
  Inode unsynced[8192]{};
  char struck[1200]{};  // name of the call and its file
};

}  // namespace faults
