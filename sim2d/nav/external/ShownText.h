#pragma once

#include <string>
#include <string_view>

namespace sim2d {

/// What another program wrote, for a message: on one line, characters that cannot be shown as '?',
/// cut to `most` bytes.
std::string shownText(std::string_view text, std::size_t most = 200);

}  // namespace sim2d
