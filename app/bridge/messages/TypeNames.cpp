#include "app/bridge/messages/TypeNames.h"

namespace bridge {

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

std::string shortTypeName(std::string_view type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  if (first == std::string_view::npos) {
    return std::string(type);
  }
  return std::string(type.substr(0, first)) + std::string(type.substr(last));
}

}  // namespace bridge
