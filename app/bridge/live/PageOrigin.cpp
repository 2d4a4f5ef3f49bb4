#include "app/bridge/live/PageOrigin.h"

#include <algorithm>
#include <optional>

#include "sim2d/base/Text.h"

namespace live {

namespace {

/// The host of "http://localhost:8080". Nothing for other schemes and for text after the port.
std::optional<std::string> webHostOf(std::string_view origin) {
  for (const std::string_view scheme :
       {std::string_view("http://"), std::string_view("https://")}) {
    if (origin.substr(0, scheme.size()) == scheme) {
      std::string_view host = origin.substr(scheme.size());
      const std::size_t port =
          host.find(':', host.find(']') == std::string_view::npos ? 0 : host.find(']'));
      const std::string_view digits =
          port == std::string_view::npos ? std::string_view("0") : host.substr(port + 1);
      if (digits.empty() || !std::all_of(digits.begin(), digits.end(), base::isDigit)) {
        return std::nullopt;
      }
      return std::string(host.substr(0, port));
    }
  }
  return std::nullopt;
}

}  // namespace

bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more) {
  const auto same = [&](std::string_view other) { return origin == other; };
  if (same("https://app.foxglove.dev") || same("https://studio.foxglove.dev") || same("file://") ||
      std::any_of(more.begin(), more.end(), same)) {
    return true;
  }
  const std::optional<std::string> host = webHostOf(origin);
  return host && (*host == "localhost" || *host == "127.0.0.1" || *host == "[::1]");
}

}  // namespace live
