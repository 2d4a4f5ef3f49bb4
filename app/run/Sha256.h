#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// SHA-256 (FIPS 180-4) in lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);
/// Of what stands in a file; nothing when it cannot be read.
std::optional<std::string> sha256OfFile(const std::string& path);

}  // namespace app
