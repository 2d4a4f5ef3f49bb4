#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace live {

/// Whether a page with this origin may connect. Browsers send the origin of the page that opens a
/// connection, so that other pages can neither watch nor control a run. Allowed are Foxglove's
/// pages (https://app.foxglove.dev, https://studio.foxglove.dev), local files, as used by the
/// desktop app, pages of this machine (localhost, 127.0.0.1, [::1]), and those in `more`. `null` is
/// not allowed, because any page can produce it.
bool isAllowedOrigin(std::string_view origin, const std::vector<std::string>& more = {});

}  // namespace live
