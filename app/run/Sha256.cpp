#include "app/run/Sha256.h"

#include <array>
#include <cassert>

#include <openssl/evp.h>

#include "sim2d/base/Text.h"

namespace app {

std::string sha256Of(const std::string& bytes) {
  std::array<unsigned char, 32> digest{};
  [[maybe_unused]] const int isGood =
      EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
  assert(isGood == 1);  // the library always has this hash
  std::string text;
  for (const unsigned char byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

std::optional<std::string> sha256OfFile(const std::string& path) {
  const base::Result<std::string> bytes = base::readTextFile(path);
  return bytes ? std::optional(sha256Of(*bytes)) : std::nullopt;
}

}  // namespace app
