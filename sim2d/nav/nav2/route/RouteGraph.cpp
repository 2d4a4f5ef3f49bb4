#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace sim2d::nav2 {
namespace {

template <class T>
std::optional<T> valueOf(const std::map<std::string, RouteMetadata::Value>& values,
                         const std::string& key) {
  const auto found = values.find(key);
  const T* const value = found == values.end() ? nullptr : std::get_if<T>(&found->second);
  return value != nullptr ? std::optional<T>(*value) : std::nullopt;
}

}  // namespace

std::optional<double> RouteMetadata::number(const std::string& key) const {
  return valueOf<double>(values_, key);
}

std::optional<std::string> RouteMetadata::text(const std::string& key) const {
  return valueOf<std::string>(values_, key);
}

std::optional<std::size_t> RouteGraph::nodeOf(std::uint32_t id) const {
  const auto found = indexOf.find(id);
  return found == indexOf.end() ? std::nullopt : std::optional<std::size_t>(found->second);
}

}  // namespace sim2d::nav2
