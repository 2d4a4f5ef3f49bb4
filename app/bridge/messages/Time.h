#pragma once

#include <chrono>
#include <cstdint>

#include "app/bridge/messages/builtin_interfaces.h"

/// Time stamps as nanoseconds.
namespace bridge {

inline std::int64_t nanosecondsOf(const builtin_interfaces::Time& stamp) {
  return std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec;
}

inline builtin_interfaces::Time stampOfNanoseconds(std::int64_t all) {
  const std::int64_t rest = (all % 1000000000 + 1000000000) % 1000000000;  // also before the epoch
  return {static_cast<std::int32_t>((all - rest) / 1000000000), static_cast<std::uint32_t>(rest)};
}

/// The system clock.
inline std::int64_t wallClockNanoseconds() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

}  // namespace bridge
