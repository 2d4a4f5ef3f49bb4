#include "app/bridge/messages/Definition.h"

#include <algorithm>

#include "app/bridge/messages/AllMessages.h"

namespace bridge {
namespace {

constexpr std::size_t kSeparatorLength = 80;

}  // namespace

std::size_t Definitions::begin(const std::string& name) {
  const bool isKnown = std::any_of(sections_.begin(), sections_.end(),
                                   [&](const Section& section) { return section.name == name; });
  if (isKnown) {
    return kAlreadyAdded;
  }
  sections_.push_back({name, {}});
  return sections_.size() - 1;
}

std::string Definitions::text() const {
  std::string text;
  for (const Section& section : sections_) {
    if (!text.empty()) {
      text += std::string(kSeparatorLength, '=') + "\nMSG: " + section.name + "\n";
    }
    text += section.lines;
  }
  return text;
}

namespace {

template <class... M>
std::vector<KnownType> typesOf(TypeList<M...> /*list*/) {
  return {{M::kType, definition<M>()}...};
}

}  // namespace

const std::vector<KnownType>& knownTypes() {
  static const std::vector<KnownType> kTypes = typesOf(AllMessages{});
  return kTypes;
}

const KnownType* findType(std::string_view type) {
  const auto found = std::find_if(knownTypes().begin(), knownTypes().end(),
                                  [&](const KnownType& known) { return known.type == type; });
  return found == knownTypes().end() ? nullptr : &*found;
}

}  // namespace bridge
