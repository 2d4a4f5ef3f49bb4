#include "sim2d/trace/Frame.h"

#include <array>

namespace sim2d {

namespace {

constexpr std::array<const char*, kEventKinds> kEventNames = {
    "enter",  "leave",      "goal",  "arrived", "contact", "say",  "heard",
    "action", "action_end", "group", "replan",  "stuck",   "door", "stop"};

}  // namespace

const char* eventKindName(EventKind kind) {
  return kEventNames[static_cast<std::size_t>(kind)];
}

std::optional<EventKind> eventKindOf(std::string_view name) {
  for (std::size_t k = 0; k < kEventNames.size(); ++k) {
    if (name == kEventNames[k]) {
      return static_cast<EventKind>(k);
    }
  }
  return std::nullopt;
}

}  // namespace sim2d
