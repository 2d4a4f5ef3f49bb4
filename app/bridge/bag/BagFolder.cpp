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
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/trace/ForeignFiles.h"

namespace bridge {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDatabaseMagic = "SQLite format 3";
constexpr const char* kMetadataFile = "metadata.yaml";

enum class Kind { None, Mcap, Database, Folder };

Kind kindOf(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    const bool isBagFolder = fs::is_regular_file(fs::path(path) / kMetadataFile, ignored);
    return isBagFolder ? Kind::Folder : Kind::None;
  }
  if (!fs::is_regular_file(path, ignored)) {
    return Kind::None;
  }
  std::ifstream file(path, std::ios::binary);
  std::string begin(kDatabaseMagic.size(), '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<std::size_t>(file.gcount()));
  if (begin.substr(0, kMcapMagic.size()) == kMcapMagic) {
    return Kind::Mcap;
  }
  return begin == kDatabaseMagic && !sim2d::isTrajectoryDatabase(path) ? Kind::Database
                                                                       : Kind::None;
}

std::string textOf(const base::YamlNode* map, const char* key) {
  const base::YamlNode* const node = map != nullptr ? map->find(key) : nullptr;
  return node != nullptr && node->isScalar() ? node->text : std::string();
}

/// Files of one recording, one after the other.
class FileRow final : public Bag {
 public:
  explicit FileRow(std::vector<std::unique_ptr<Bag>> files) : files_(std::move(files)) {
    for (const std::unique_ptr<Bag>& file : files_) {
      std::vector<std::size_t>& places = places_.emplace_back();
      for (const BagChannel& channel : file->channels()) {
        places.push_back(placeOf(channel));
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
  std::size_t placeOf(const BagChannel& channel) {
    const auto known =
        std::find_if(channels_.begin(), channels_.end(), [&](const BagChannel& other) {
          return other.topic == channel.topic && other.type == channel.type;
        });
    const auto place = static_cast<std::size_t>(known - channels_.begin());
    if (known == channels_.end()) {
      channels_.push_back(channel);
    }
    return place;
  }

  std::vector<std::unique_ptr<Bag>> files_;
  std::vector<BagChannel> channels_;
  std::vector<std::vector<std::size_t>> places_;  // of each file's channels in channels_
};

/// The files that the metadata names; empty with an error.
std::vector<std::string> filesOf(const std::string& folder, base::Diagnostics& problems) {
  const std::string path = (fs::path(folder) / kMetadataFile).string();
  const base::Result<std::string> text = base::readTextFile(path);
  base::append(problems, text.diagnostics());
  const base::YamlNode root = text ? base::parseYaml(*text, path, problems) : base::YamlNode();
  if (base::hasErrors(problems)) {
    return {};
  }
  const base::YamlNode* const info = root.find("rosbag2_bagfile_information");
  const std::string storage = textOf(info, "storage_identifier");
  const std::string packing = textOf(info, "compression_format");
  const bool isPacked =
      !packing.empty() && base::lowered(textOf(info, "compression_mode")) == "file";
  const base::YamlNode* const names = info != nullptr ? info->find("relative_file_paths") : nullptr;
  if (storage != "mcap" && storage != "sqlite3" && !storage.empty()) {
    problems.push_back(base::error("bag.storage", {storage}, path));
  } else if (isPacked) {
    problems.push_back(base::error("bag.compressed-file", {packing}, path));
  } else if (names == nullptr || !names->isList() || names->items.empty()) {
    problems.push_back(base::error("bag.bad-metadata", {}, path));
  }
  std::vector<std::string> files;
  for (std::size_t k = 0; !base::hasErrors(problems) && k < names->items.size(); ++k) {
    files.push_back((fs::path(folder) / names->items[k].text).string());
  }
  return files;
}

}  // namespace

bool isBag(const std::string& path) {
  return kindOf(path) != Kind::None;
}

std::vector<std::string> filesOfBag(const std::string& path) {
  if (kindOf(path) != Kind::Folder) {
    return {path};
  }
  base::Diagnostics ignored;  // told when it is opened
  std::vector<std::string> files = filesOf(path, ignored);
  files.insert(files.begin(), (fs::path(path) / kMetadataFile).string());
  return files;
}

base::Result<std::unique_ptr<Bag>> openBagFolder(const std::string& folder) {
  base::Diagnostics problems;
  std::vector<std::unique_ptr<Bag>> bags;
  for (const std::string& file : filesOf(folder, problems)) {
    const Kind kind = kindOf(file);
    if (kind == Kind::Folder) {  // no folders in folders
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
  return {std::unique_ptr<Bag>(std::make_unique<FileRow>(std::move(bags))), std::move(problems)};
}

base::Result<std::unique_ptr<Bag>> openBag(const std::string& path) {
  switch (kindOf(path)) {
    case Kind::Mcap:
      return openMcap(path);
    case Kind::Database:
      return openDatabase(path);
    case Kind::Folder:
      return openBagFolder(path);
    case Kind::None:
      break;
  }
  return base::error("bag.no-bag", {}, path);
}

}  // namespace bridge
