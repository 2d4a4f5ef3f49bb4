#include "app/bridge/messages/Definition.h"

namespace bridge {
namespace {

constexpr std::size_t kLineOfEquals = 80;

}  // namespace

std::size_t Definitions::begin(const std::string& name) {
  const bool isKnown = std::any_of(sections_.begin(), sections_.end(),
                                   [&](const Section& section) { return section.name == name; });
  if (isKnown) {
    return kKnown;
  }
  sections_.push_back({name, {}});
  return sections_.size() - 1;
}

std::string Definitions::text() const {
  std::string text;
  for (const Section& section : sections_) {
    if (!text.empty()) {
      text += std::string(kLineOfEquals, '=') + "\nMSG: " + section.name + "\n";
    }
    text += section.lines;
  }
  return text;
}

}  // namespace bridge
