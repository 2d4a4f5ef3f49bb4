#include "app/bridge/messages/TypeNames.h"

#include <algorithm>

#include "app/bridge/messages/AllMessages.h"

namespace bridge {
namespace {

template <class... M>
std::vector<KnownType> typesOf(TypeList<M...> /*list*/) {
  return {{M::kType, M::kDefinition}...};
}

}  // namespace

std::string ddsTypeName(std::string_view type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  if (first == std::string_view::npos || first == last) {
    return std::string(type);
  }
  return std::string(type.substr(0, first)) +
         "::" + std::string(type.substr(first + 1, last - first - 1)) +
         "::dds_::" + std::string(type.substr(last + 1)) + "_";
}

std::string rosTypeName(std::string_view ddsType) {
  constexpr std::string_view kInfix = "::dds_::";
  const std::size_t infix = ddsType.find(kInfix);
  const std::size_t first = ddsType.find("::");
  if (infix == std::string_view::npos || first >= infix || ddsType.back() != '_') {
    return {};
  }
  const std::string_view kind = ddsType.substr(first + 2, infix - first - 2);
  std::string_view name = ddsType.substr(infix + kInfix.size());
  name.remove_suffix(1);
  return std::string(ddsType.substr(0, first)) + "/" + std::string(kind) + "/" + std::string(name);
}

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
