#include "app/run/ManifestFiles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>
#include <openssl/evp.h>

#include "sim2d/base/Text.h"

namespace app {

namespace {

/// Incremental SHA-256.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new()) {
    [[maybe_unused]] const int isGood = EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr);
    assert(isGood == 1);  // OpenSSL always provides this hash
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
  constexpr std::size_t kBlockSize = std::size_t{1} << 16U;  // [B]
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return std::nullopt;  // reading a pipe could block
  }
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(kBlockSize);
  Sha256 hash;
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    hash.add(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.eof() ? std::optional(hash.finish()) : std::nullopt;
}

namespace fs = std::filesystem;
using OutputListJson = nlohmann::json;

namespace {

fs::file_status statusIn(const std::string& folder, const std::string& name) {
  std::error_code ignored;  // an inaccessible file counts as missing
  return fs::symlink_status(fs::path(folder) / name, ignored);
}

}  // namespace

bool isWithin(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

base::Result<std::string> manifestText(const std::string& folder, const char* name) {
  if (!fs::is_regular_file(statusIn(folder, name))) {
    return std::string("{}");
  }
  base::Result<std::string> text = base::readTextFile((fs::path(folder) / name).string());
  return !text || OutputListJson::parse(*text, nullptr, false).is_object()
             ? text
             : base::Result<std::string>(std::string("{}"));
}

base::Result<FileHashes> manifestFiles(const std::string& folder, const char* name) {
  const base::Result<std::string> text = manifestText(folder, name);
  if (!text) {
    return text.diagnostics();
  }
  const OutputListJson manifest = OutputListJson::parse(*text);
  FileHashes listed;
  const auto outputs = manifest.find("outputs");
  for (const OutputListJson& output :
       outputs != manifest.end() && outputs->is_array() ? *outputs : OutputListJson()) {
    const OutputListJson path =
        output.is_object() ? output.value("path", OutputListJson()) : OutputListJson();
    const OutputListJson hash =
        output.is_object() ? output.value("sha256", OutputListJson()) : OutputListJson();
    if (path.is_string() && hash.is_string() && isWithin(path.get<std::string>())) {
      listed[path.get<std::string>()] = hash.get<std::string>();
    }
  }
  return listed;
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

bool matchesManifest(const std::string& folder, const FileHashes& listed, const std::string& name) {
  const auto found = listed.find(name);
  return found != listed.end() && fs::is_regular_file(statusIn(folder, name)) &&
         sha256OfFile((fs::path(folder) / name).string()) == found->second;
}

base::Diagnostics checkManifestFiles(const std::string& folder,
                                     const std::vector<std::string>& names) {
  const base::Result<std::string> text = manifestText(folder, "manifest.json");
  const base::Result<FileHashes> read = manifestFiles(folder, "manifest.json");
  if (!text || !read) {
    return text ? read.diagnostics() : text.diagnostics();
  }
  const bool hasList = OutputListJson::parse(*text)
                           .value("outputs", OutputListJson())
                           .is_array();  // the list may be empty
  const FileHashes& listed = *read;
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const bool isMeant = listed.count(name) != 0 || fs::exists(statusIn(folder, name));
    if (hasList && isMeant && !matchesManifest(folder, listed, name)) {
      problems.push_back(base::error("trace.other-run", {}, (fs::path(folder) / name).string()));
    }
  }
  return problems;
}

namespace {

auto parts(const std::timespec& time) {
  return std::make_pair(time.tv_sec, time.tv_nsec);
}

}  // namespace

bool InputFingerprints::Stamp::operator==(const Stamp& other) const {
  const auto all = [](const Stamp& stamp) {
    return std::make_tuple(parts(stamp.time), stamp.size, stamp.device, stamp.inode);
  };
  return all(*this) == all(other);
}

std::optional<InputFingerprints::Stamp> InputFingerprints::stampOf(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return Stamp{status.st_ctim, status.st_size, status.st_dev, status.st_ino};
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

std::timespec InputFingerprints::now() {
  std::timespec time = {};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

bool InputFingerprints::anyModifiedSince(const std::vector<std::size_t>& numbers,
                                         const std::timespec& time) const {
  return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t number) {
    return stamps_[number] && parts(stamps_[number]->time) >= parts(time);
  });
}

}  // namespace app
