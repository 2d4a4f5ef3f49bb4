#include "app/bridge/messages/TypeTable.h"

#include <algorithm>

#include "app/bridge/messages/AllMessages.h"
#include "app/bridge/messages/Definition.h"

namespace bridge {
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
