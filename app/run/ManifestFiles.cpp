#include "app/run/ManifestFiles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;
using ManifestFileJson = nlohmann::json;

namespace {

/// Incremental SHA-256.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new()) {
    [[maybe_unused]] const int isGood = EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
    assert(isGood == 1);  // OpenSSL always provides this hash
  }
  void add(std::string_view bytes) { EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()); }
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
  hash.add(bytes);
  return hash.finish();
}

bool readPieces(const std::string& path, const std::function<void(std::string_view)>& take) {
  constexpr std::size_t kPieceSize = std::size_t{1} << 16U;  // [B]
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return false;  // reading a pipe could block
  }
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(kPieceSize);
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    take({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  return file.eof();
}

std::optional<std::string> sha256OfFile(const std::string& path) {
  if (path == "-") {
    const base::Result<std::string> text = base::readTextFile(path);
    return text ? std::optional(sha256Of(*text)) : std::nullopt;
  }
  Sha256 hash;
  const bool isRead = readPieces(path, [&hash](std::string_view piece) { hash.add(piece); });
  return isRead ? std::optional(hash.finish()) : std::nullopt;
}

bool isWithin(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

std::string pathIn(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::string absolutePath(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

fs::file_status statusOf(const std::string& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored);
}

bool entryExists(const std::string& path) {
  return fs::exists(statusOf(path));
}

base::Result<Manifest> readManifest(const std::string& folder, const char* name) {
  const std::string path = pathIn(folder, name);
  Manifest manifest;
  if (!fs::is_regular_file(statusOf(path))) {
    return manifest;
  }
  base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  const ManifestFileJson json = ManifestFileJson::parse(base::shallowJson(*text), nullptr, false);
  if (!json.is_object()) {
    return manifest;
  }
  manifest.text = *std::move(text);
  const auto textOf = [](const ManifestFileJson& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? std::optional(found->get<std::string>())
                                                       : std::nullopt;
  };
  manifest.kind = textOf(json, "kind").value_or("");
  const auto outputs = json.find("outputs");
  manifest.listsOutputs = outputs != json.end() && outputs->is_array();
  for (const ManifestFileJson& output : manifest.listsOutputs ? *outputs : ManifestFileJson()) {
    const std::optional<std::string> file = textOf(output, "path"), hash = textOf(output, "sha256");
    if (file && hash && isWithin(*file)) {
      manifest.outputs[*file] = *hash;
    }
  }
  return manifest;
}

bool Manifest::matches(const std::string& folder, const std::string& name) const {
  const auto found = outputs.find(name);
  const std::string path = pathIn(folder, name);
  return found != outputs.end() && fs::is_regular_file(statusOf(path)) &&
         sha256OfFile(path) == found->second;
}

std::optional<std::string> findInput(const std::string& named, const std::string& runFolder,
                                     const std::string& sha256) {
  if (named.empty() || named == kStandardInput) {
    return std::nullopt;  // reading would block on standard input
  }
  const fs::path folder = runFolder;
  std::error_code none;
  for (const fs::path& path : {fs::path(named), folder / named, folder / ".." / named}) {
    if (sha256OfFile(path.string()) == sha256) {
      return fs::weakly_canonical(path, none).string();
    }
  }
  return std::nullopt;
}

std::vector<std::string> changedInputs(const std::vector<InputHash>& inputs,
                                       const std::string& folder) {
  std::vector<std::string> changed;
  for (const InputHash& input : inputs) {
    if (input.sha256.empty() || input.path == kStandardInput) {
      continue;
    }
    const std::optional<std::string> now = sha256OfFile(pathIn(folder, input.path));
    if (now && *now != input.sha256) {
      changed.push_back(input.path);
    }
  }
  return changed;
}

base::Diagnostics checkManifestFiles(const std::string& folder,
                                     const std::vector<std::string>& names) {
  const base::Result<Manifest> manifest = readManifest(folder);
  if (!manifest) {
    return manifest.diagnostics();
  }
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const std::string path = pathIn(folder, name);
    const bool isMeant = manifest->outputs.count(name) != 0 || entryExists(path);
    if (manifest->listsOutputs && isMeant && !manifest->matches(folder, name)) {
      problems.push_back(base::error("trace.other-run", {}, path));
    }
  }
  return problems;
}

std::optional<InputFingerprints::Stamp> InputFingerprints::stampOf(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    return std::nullopt;
  }
  const Time changed(status.st_ctim.tv_sec, status.st_ctim.tv_nsec);
  return Stamp(changed, status.st_size, status.st_dev, status.st_ino);
}

std::size_t InputFingerprints::add(const std::string& path) {
  const auto [place, isNew] = numbers_.emplace(path, files_.size());
  if (isNew) {
    stamps_.push_back(stampOf(path));  // before reading
    files_.push_back({path, sha256OfFile(path).value_or("")});
  }
  return place->second;
}

std::vector<InputHash> InputFingerprints::withChanges(const std::vector<std::size_t>& numbers) {
  std::vector<InputHash> found;
  found.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    const InputHash& then = files_[number];
    found.push_back(then);
    const std::optional<Stamp> now = stampOf(then.path);
    if (now == stamps_[number]) {
      continue;
    }
    const std::string hash = sha256OfFile(then.path).value_or("");
    if (hash == then.sha256) {
      stamps_[number] = now;  // rewritten with the same content
    } else {
      found.push_back({then.path, hash});
    }
  }
  return found;
}

InputFingerprints::Time InputFingerprints::now() {
  std::timespec time = {};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return {time.tv_sec, time.tv_nsec};
}

bool InputFingerprints::anyModifiedSince(const std::vector<std::size_t>& numbers,
                                         const Time& time) const {
  return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t number) {
    return stamps_[number] && std::get<Time>(*stamps_[number]) >= time;
  });
}

}  // namespace app
