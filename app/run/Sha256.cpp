#include "app/run/Sha256.h"

#include <array>
#include <cassert>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

#include <openssl/evp.h>

#include "sim2d/base/Text.h"

namespace app {

namespace {

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new()) {
    [[maybe_unused]] const int isGood = EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
    assert(isGood == 1);  // the library always has this hash
  }
  void add(const char* bytes, std::size_t count) { EVP_DigestUpdate(context_.get(), bytes, count); }
  std::string finish() {
    std::array<unsigned char, 32> digest{};
    EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr);
    std::string text;
    for (const unsigned char byte : digest) {
      text += "0123456789abcdef"[byte >> 4];
      text += "0123456789abcdef"[byte & 15];
    }
    return text;
  }

 private:
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context_;
};

}  // namespace

std::string sha256Of(const std::string& bytes) {
  Sha256 hash;
  hash.add(bytes.data(), bytes.size());
  return hash.finish();
}

std::optional<std::string> sha256OfFile(const std::string& path) {
  if (path == "-") {
    const base::Result<std::string> text = base::readTextFile(path);
    return text ? std::optional(sha256Of(*text)) : std::nullopt;
  }
  constexpr std::size_t kPiece = std::size_t{1} << 16U;  // [B]
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return std::nullopt;  // a pipe would be waited for
  }
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(kPiece);
  Sha256 hash;
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.eof() ? std::optional(hash.finish()) : std::nullopt;
}

}  // namespace app
