#include "app/run/Sha256.h"

#include <array>
#include <cassert>
#include <fstream>
#include <memory>

#include <openssl/evp.h>

namespace app {

namespace {

class Hash {
 public:
  Hash() { isGood_ = EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1; }
  void add(const char* bytes, std::size_t count) {
    isGood_ = isGood_ && EVP_DigestUpdate(context_.get(), bytes, count) == 1;
  }
  std::string digits() {
    std::array<unsigned char, 32> bytes{};
    isGood_ = isGood_ && EVP_DigestFinal_ex(context_.get(), bytes.data(), nullptr) == 1;
    assert(isGood_);  // the library always has this hash
    std::string text;
    for (const unsigned char byte : bytes) {
      text += "0123456789abcdef"[byte >> 4];
      text += "0123456789abcdef"[byte & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(),
                                                                   &EVP_MD_CTX_free};
  bool isGood_ = false;
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Hash hash;
  hash.add(bytes.data(), bytes.size());
  return hash.digits();
}

std::optional<std::string> sha256OfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Hash hash;
  std::array<char, 1 << 16> bytes{};
  while (file.read(bytes.data(), bytes.size()) || file.gcount() > 0) {
    hash.add(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.eof() ? std::make_optional(hash.digits()) : std::nullopt;
}

}  // namespace app
