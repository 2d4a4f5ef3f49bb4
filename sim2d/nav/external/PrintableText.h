#pragma once

#include <string>
#include <string_view>

namespace sim2d {

/// Text of another program, formatted for a message: on one line, control characters replaced by
/// '?', truncated to `most` bytes.
std::string printableText(std::string_view text, std::size_t most = 200);

}  // namespace sim2d
