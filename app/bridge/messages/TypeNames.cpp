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

std::string shortTypeName(std::string_view type) {
  const std::size_t first = type.find('/');
  const std::size_t last = type.rfind('/');
  if (first == std::string_view::npos) {
    return std::string(type);
  }
  return std::string(type.substr(0, first)) + std::string(type.substr(last));
}

}  // namespace bridge
