#include "app/bridge/nodes/NoPeerCheck.h"

namespace bridge {

std::optional<base::Diagnostic> NoPeerCheck::look(const Participant& participant) {
  if (isOver_ || std::chrono::steady_clock::now() < due_) {
    return std::nullopt;
  }
  isOver_ = true;
  if (participant.hasMetAnyone()) {
    return std::nullopt;
  }
  return base::problem(base::Severity::Warning,
                       settings_.localhostOnly ? "ros2.no-peer-here" : "ros2.no-peer-on-network",
                       {settings_.domain, kNoPeerAfter.count()});
}

}  // namespace bridge
