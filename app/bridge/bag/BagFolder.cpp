#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/McapFormat.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/trace/TrackImport.h"

namespace bridge {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDatabaseMagic = "SQLite format 3";
constexpr std::size_t kLongestMagic = 64;  // [B]
constexpr const char* kMetadataFile = "metadata.yaml";

enum class Kind { None, Mcap, Database, Folder, Packed, LfsPointer };

struct CompressionFormat {
  std::string_view magic, name;
};
constexpr CompressionFormat kCompressionFormats[] = {{"\x28\xB5\x2F\xFD", "zstd"},
                                                     {"\x04\x22\x4D\x18", "lz4"},
                                                     {"\x1F\x8B", "gzip"},
                                                     {"BZh", "bzip2"},
                                                     {"\xFD"
                                                      "7zXZ",
                                                      "xz"}};

std::string beginningOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(kLongestMagic, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return begin;
}

/// The name of the compression of the whole file; empty: none known.
std::string_view compressionOf(const std::string& begin) {
  const CompressionFormat* const found = base::findIf(
      kCompressionFormats,
      [&](const CompressionFormat& each) { return base::startsWith(begin, each.magic); });
  return found == nullptr ? std::string_view() : found->name;
}

/// Detects the kind by content; for files that are compressed or stored elsewhere, by name.
Kind kindOfFile(const std::string& path) {
  const std::string begin = beginningOf(path);
  if (base::startsWith(begin, kMcapMagic)) {
    return Kind::Mcap;
  }
  if (base::startsWith(begin, kDatabaseMagic)) {
    return sim2d::isTrajectoryDatabase(path) ? Kind::None : Kind::Database;
  }
  const std::string name = base::toLower(fs::path(path).filename().string());
  const bool isNamed =
      name.find(".mcap") != std::string::npos || name.find(".db3") != std::string::npos;
  if (isNamed && !compressionOf(begin).empty()) {
    return Kind::Packed;
  }
  return isNamed && base::isLfsPointer(begin) ? Kind::LfsPointer : Kind::None;
}

/// Natural order: "bag_2" before "bag_10".
bool isBeforeNaturally(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < a.size() && k < b.size()) {
    if (base::isDigit(a[i]) && base::isDigit(b[k])) {
      const auto endOf = [](const std::string& text, std::size_t from) {
        return std::min(text.find_first_not_of("0123456789", from), text.size());
      };
      const std::string one = a.substr(i, endOf(a, i) - i);
      const std::string two = b.substr(k, endOf(b, k) - k);
      if (one != two) {
        return one.size() != two.size() ? one.size() < two.size() : one < two;
      }
      i += one.size();
      k += two.size();
    } else if (a[i] != b[k]) {
      return a[i] < b[k];
    } else {
      ++i;
      ++k;
    }
  }
  return a.size() - i < b.size() - k;
}

/// The bag files in a folder, without metadata: detected by content, in numerical order.
std::vector<std::string> bagFilesIn(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string path = entry.path().string();
    const std::string ending = base::toLower(entry.path().extension().string());
    const bool isFile = entry.is_regular_file(ignored);
    const Kind kind = isFile ? kindOfFile(path) : Kind::None;
    // Other programs use databases for other purposes.
    if (kind != Kind::None && (kind != Kind::Database || ending == ".db3")) {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end(), isBeforeNaturally);
  return files;
}

/// A folder with the files of a run and without metadata.yaml is a run, even if it contains bag
/// files.
bool isRecord(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "trace.json", ignored);
}

Kind kindOf(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    const bool hasMetadata = fs::is_regular_file(fs::path(path) / kMetadataFile, ignored);
    return hasMetadata || (!isRecord(path) && !bagFilesIn(path).empty()) ? Kind::Folder
                                                                         : Kind::None;
  }
  return fs::is_regular_file(path, ignored) ? kindOfFile(path) : Kind::None;
}

std::string textOf(const base::YamlNode* map, const char* key) {
  const base::YamlNode* const node = map != nullptr ? map->find(key) : nullptr;
  return node != nullptr && node->isScalar() ? node->text : std::string();
}

/// The files of a split recording, read in sequence.
class SplitBag final : public Bag {
 public:
  explicit SplitBag(std::vector<std::unique_ptr<Bag>> files) : files_(std::move(files)) {
    for (const std::unique_ptr<Bag>& file : files_) {
      std::vector<std::size_t>& places = places_.emplace_back();
      for (const BagChannel& channel : file->channels()) {
        places.push_back(indexOfChannel(channel, channels_));
      }
    }
  }

  const std::vector<BagChannel>& channels() const override { return channels_; }

  base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) override {
    base::Diagnostics problems;
    for (std::size_t k = 0; k < files_.size(); ++k) {
      const std::vector<std::size_t>& places = places_[k];
      std::vector<bool> wanted(places.size());
      for (std::size_t own = 0; own < places.size(); ++own) {
        wanted[own] = channels[places[own]];
      }
      base::append(problems, files_[k]->read(wanted, [&](std::size_t channel, std::int64_t time,
                                                         std::string_view bytes) {
        visit(places[channel], time, bytes);
      }));
    }
    return problems;
  }

  std::string metadata(const std::string& name, const std::string& key) override {
    std::string value;
    for (auto file = files_.begin(); file != files_.end() && value.empty(); ++file) {
      value = (*file)->metadata(name, key);
    }
    return value;
  }

 private:
  std::vector<std::unique_ptr<Bag>> files_;
  std::vector<BagChannel> channels_;
  std::vector<std::vector<std::size_t>> places_;  // per file: channel index in channels_
};

/// The path of a file named in the metadata. Early versions include the folder in the name; a
/// manually decompressed file has lost its last extension. Empty: the file does not exist.
std::string placeOf(const std::string& folder, const std::string& name) {
  const fs::path file = fs::path(name).filename();
  const std::string ending = base::toLower(file.extension().string());
  const bool isPacked = ending == ".zstd" || ending == ".zst" || ending == ".lz4";
  for (const fs::path& place : {fs::path(folder) / name, fs::path(folder) / file,
                                fs::path(folder) / (isPacked ? file.stem() : file)}) {
    std::error_code ignored;
    if (fs::exists(place, ignored)) {
      return place.string();
    }
  }
  return {};
}

base::Diagnostic absent(const base::YamlNode& name, const std::string& folder,
                        const std::string& path) {
  std::vector<std::string> there;
  for (const std::string& file : bagFilesIn(folder)) {
    there.push_back(fs::path(file).filename().string());
  }
  return base::error("bag.absent-file", {name.text, base::join(there, ", ")}, path, name.line,
                     name.column);
}

/// The files named in the metadata; empty after an error.
std::vector<std::string> namedFiles(const std::string& folder, base::Diagnostics& problems) {
  const std::string path = (fs::path(folder) / kMetadataFile).string();
  const base::Result<std::string> text = base::readTextFile(path);
  base::append(problems, text.diagnostics());
  const base::YamlNode root =
      text ? base::parseYaml(*text, path, base::DuplicateKeys::FirstWins, problems)
           : base::YamlNode();
  if (base::hasErrors(problems)) {
    return {};
  }
  const base::YamlNode* const info = root.find("rosbag2_bagfile_information");
  const std::string storage = textOf(info, "storage_identifier");
  const std::string packing = textOf(info, "compression_format");
  const bool isPacked =
      !packing.empty() && base::toLower(textOf(info, "compression_mode")) == "message";
  const base::YamlNode* const names = info != nullptr ? info->find("relative_file_paths") : nullptr;
  if (storage != "mcap" && storage != "sqlite3" && !storage.empty()) {
    problems.push_back(base::error("bag.storage", {storage}, path));
  } else if (isPacked) {
    problems.push_back(base::error("bag.compressed-messages", {packing}, path));
  } else if (names == nullptr || !names->isList() || names->items.empty()) {
    problems.push_back(base::error("bag.bad-metadata", {}, path));
  }
  if (base::hasErrors(problems)) {
    return {};
  }
  std::vector<std::string> files;
  for (const base::YamlNode& name : names->items) {
    files.push_back(placeOf(folder, name.text));
    if (files.back().empty()) {
      problems.push_back(absent(name, folder, path));
    }
  }
  return base::hasErrors(problems) ? std::vector<std::string>() : files;
}

std::vector<std::string> filesOf(const std::string& folder, base::Diagnostics& problems) {
  std::error_code ignored;
  if (fs::exists(fs::path(folder) / kMetadataFile, ignored)) {
    return namedFiles(folder, problems);
  }
  std::vector<std::string> files = bagFilesIn(folder);
  problems.push_back(base::warning("bag.no-metadata", {files.size()}, folder));
  return files;
}

}  // namespace

std::size_t indexOfChannel(const BagChannel& channel, std::vector<BagChannel>& channels) {
  const auto known = std::find_if(channels.begin(), channels.end(), [&](const BagChannel& other) {
    return other.topic == channel.topic && other.type == channel.type;
  });
  const auto index = static_cast<std::size_t>(known - channels.begin());
  if (known == channels.end()) {
    channels.push_back(channel);
  }
  return index;
}

bool isBag(const std::string& path) {
  return kindOf(path) != Kind::None;
}

std::vector<std::string> filesOfBag(const std::string& path) {
  if (kindOf(path) != Kind::Folder) {
    return {path};
  }
  base::Diagnostics ignored;  // reported when the bag is opened
  std::vector<std::string> files = filesOf(path, ignored);
  const fs::path metadata = fs::path(path) / kMetadataFile;
  if (std::error_code none; fs::exists(metadata, none)) {
    files.insert(files.begin(), metadata.string());
  }
  return files;
}

base::Result<std::unique_ptr<Bag>> openBagFolder(const std::string& folder) {
  base::Diagnostics problems;
  std::vector<std::unique_ptr<Bag>> bags;
  for (const std::string& file : filesOf(folder, problems)) {
    const Kind kind = kindOf(file);
    if (kind == Kind::Folder) {  // nested folders are not supported
      problems.push_back(base::error("bag.no-bag", {}, file));
      continue;
    }
    base::Result<std::unique_ptr<Bag>> bag = openBag(file);
    base::append(problems, bag.diagnostics());
    if (bag) {
      bags.push_back(*std::move(bag));
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<Bag>(std::make_unique<SplitBag>(std::move(bags))), std::move(problems)};
}

base::Result<std::unique_ptr<Bag>> openBag(const std::string& path) {
  switch (kindOf(path)) {
    case Kind::Mcap:
      return openMcap(path);
    case Kind::Database:
      return openSqliteBag(path);
    case Kind::Folder:
      return openBagFolder(path);
    case Kind::Packed:
      return base::error("bag.compressed-file", {compressionOf(beginningOf(path))}, path);
    case Kind::LfsPointer:
      return base::error("file.lfs-pointer", {}, path);
    case Kind::None:
      break;
  }
  return base::error("bag.no-bag", {}, path);
}

}  // namespace bridge
