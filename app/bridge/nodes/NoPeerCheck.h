#pragma once

#include <chrono>
#include <optional>

#include "app/bridge/dds/Participant.h"
#include "sim2d/base/Result.h"

namespace bridge {

/// How long to wait for other participants before their absence is reported.
constexpr std::chrono::seconds kNoPeerAfter(5);

/// The warning that no other participant of the domain was discovered in the first seconds. Without
/// it, a program without subscribers looks like one that works.
class NoPeerCheck {
 public:
  explicit NoPeerCheck(const DomainSettings& settings)
      : settings_(settings), due_(std::chrono::steady_clock::now() + kNoPeerAfter) {}

  /// The warning, once, when it is due. Call it repeatedly.
  std::optional<base::Diagnostic> look(const Participant& participant);

 private:
  DomainSettings settings_;
  std::chrono::steady_clock::time_point due_;
  bool isOver_ = false;
};

}  // namespace bridge
