#include "app/run/ListedFiles.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;
using ListedJson = nlohmann::json;

namespace {

fs::file_status statusIn(const std::string& folder, const std::string& name) {
  std::error_code ignored;  // what cannot be looked at is not there
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
  return !text || ListedJson::parse(*text, nullptr, false).is_object()
             ? text
             : base::Result<std::string>(std::string("{}"));
}

base::Result<FileHashes> listedFiles(const std::string& folder, const char* name) {
  const base::Result<std::string> text = manifestText(folder, name);
  if (!text) {
    return text.diagnostics();
  }
  const ListedJson manifest = ListedJson::parse(*text);
  FileHashes listed;
  const auto outputs = manifest.find("outputs");
  for (const ListedJson& output :
       outputs != manifest.end() && outputs->is_array() ? *outputs : ListedJson()) {
    const ListedJson path = output.is_object() ? output.value("path", ListedJson()) : ListedJson();
    const ListedJson hash =
        output.is_object() ? output.value("sha256", ListedJson()) : ListedJson();
    if (path.is_string() && hash.is_string() && isWithin(path.get<std::string>())) {
      listed[path.get<std::string>()] = hash.get<std::string>();
    }
  }
  return listed;
}

std::optional<std::string> findInput(const std::string& named, const std::string& runFolder,
                                     const std::string& sha256) {
  if (named.empty() || named == kStandardInput) {
    return std::nullopt;  // it would wait for what nobody says
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

bool isAsListed(const std::string& folder, const FileHashes& listed, const std::string& name) {
  const auto found = listed.find(name);
  return found != listed.end() && fs::is_regular_file(statusIn(folder, name)) &&
         sha256OfFile((fs::path(folder) / name).string()) == found->second;
}

base::Diagnostics checkListed(const std::string& folder, const std::vector<std::string>& names) {
  const base::Result<std::string> text = manifestText(folder, "manifest.json");
  const base::Result<FileHashes> read = listedFiles(folder, "manifest.json");
  if (!text || !read) {
    return text ? read.diagnostics() : text.diagnostics();
  }
  const bool hasList =
      ListedJson::parse(*text).value("outputs", ListedJson()).is_array();  // it may be empty
  const FileHashes& listed = *read;
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const bool isMeant = listed.count(name) != 0 || fs::exists(statusIn(folder, name));
    if (hasList && isMeant && !isAsListed(folder, listed, name)) {
      problems.push_back(base::error("trace.other-run", {}, (fs::path(folder) / name).string()));
    }
  }
  return problems;
}

}  // namespace app
