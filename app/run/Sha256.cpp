#include "app/run/Sha256.h"

#include <array>
#include <cassert>
#include <fstream>
#include <memory>

#include <openssl/evp.h>

namespace app {

std::optional<std::string> sha256OfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash(EVP_MD_CTX_new(),
                                                                     &EVP_MD_CTX_free);
  bool isGood = EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr) == 1;
  std::array<char, 1 << 16> bytes{};
  while (file.read(bytes.data(), bytes.size()) || file.gcount() > 0) {
    const auto count = static_cast<std::size_t>(file.gcount());
    isGood = isGood && EVP_DigestUpdate(hash.get(), bytes.data(), count) == 1;
  }
  if (!file.eof()) {
    return std::nullopt;
  }
  std::array<unsigned char, 32> digest{};
  isGood = isGood && EVP_DigestFinal_ex(hash.get(), digest.data(), nullptr) == 1;
  assert(isGood);  // the library always has this hash
  std::string text;
  for (const unsigned char byte : digest) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

}  // namespace app
