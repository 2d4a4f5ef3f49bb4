#pragma once

#include <optional>
#include <string>

namespace app {

/// SHA-256 (FIPS 180-4) in lower-case hexadecimal digits.
std::string sha256Of(const std::string& bytes);
/// Of what stands in a file, "-" the standard input; nothing when it cannot be read.
std::optional<std::string> sha256OfFile(const std::string& path);

}  // namespace app
