#pragma once

#include <cstdint>
#include <string>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// FNV-1a over the bytes of trajectory.csv and events.csv.
inline std::uint64_t hashOf(const Trace& trace) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : trajectoryCsv(trace) + eventsCsv(trace)) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace sim2d
