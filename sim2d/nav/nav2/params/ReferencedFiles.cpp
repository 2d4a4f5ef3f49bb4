#include "sim2d/nav/nav2/params/ReferencedFiles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

namespace fs = std::filesystem;

/// Subfolders in which ROS packages keep such files.
constexpr std::array<const char*, 10> kStandardFolders = {
    "params", "config", "behavior_trees", "behavior_tree", "bt", "trees",
    "maps",   "map",    "graphs",         "masks"};
constexpr int kMaxParentFolders = 4;  // parent folders in which a package is searched

bool isFile(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

bool isFolder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(path, none);
}

/// The position after the last "$(…)" or "${…}", or 0 without one. An unclosed one extends to the
/// end.
std::size_t endOfPlaceholders(std::string_view text) {
  std::size_t end = 0, depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool opens =
        text[i] == '$' && i + 1 < text.size() && (text[i + 1] == '(' || text[i + 1] == '{');
    if (opens || (depth > 0 && text[i] == '(')) {
      ++depth;
      i += opens ? 1 : 0;
    } else if (depth > 0 && (text[i] == ')' || text[i] == '}') && --depth == 0) {
      end = i + 1;
    }
  }
  return depth > 0 ? text.size() : end;
}

/// The package name in "package://pkg/…" and "$(find-pkg-share pkg)…".
std::string packageOf(std::string_view named) {
  constexpr std::string_view kUrl = "package://";
  if (base::startsWith(named, kUrl)) {
    const std::string_view rest = named.substr(kUrl.size());
    return std::string(rest.substr(0, rest.find('/')));
  }
  for (const std::string_view start : {"$(find-pkg-share ", "$(find-pkg-prefix ", "$(find "}) {
    const std::size_t at = named.find(start);
    const std::size_t end = at == std::string_view::npos ? at : named.find(')', at);
    if (end != std::string_view::npos) {
      const std::size_t begin = at + start.size();
      return base::trimmed(std::string(named.substr(begin, end - begin)));
    }
  }
  return {};
}

/// The path and its suffixes, from the longest to the shortest.
std::vector<fs::path> pathSuffixes(const fs::path& path) {
  std::vector<fs::path> parts;
  for (const fs::path& part : path.relative_path()) {
    if (part != "." && part != ".." && !part.empty()) {
      parts.push_back(part);
    }
  }
  std::vector<fs::path> ends;
  ends.reserve(parts.size());
  for (std::size_t first = 0; first < parts.size(); ++first) {
    fs::path& end = ends.emplace_back();
    for (std::size_t i = first; i < parts.size(); ++i) {
      end /= parts[i];
    }
  }
  return ends;
}

/// The normalized folder without a trailing slash.
fs::path normalFolder(const fs::path& folder) {
  const fs::path normal = folder.lexically_normal();
  const fs::path plain = normal.has_filename() ? normal : normal.parent_path();
  return plain.empty() ? fs::path(".") : plain;
}

/// Existing folders to search, without duplicates.
class SearchFolders {
 public:
  void add(const fs::path& folder) {
    fs::path place = normalFolder(folder);
    if (isFolder(place) && std::find(all_.begin(), all_.end(), place) == all_.end()) {
      all_.push_back(std::move(place));
    }
  }
  void addWithSubfolders(const fs::path& folder) {
    add(folder);
    for (const char* const usual : kStandardFolders) {
      add(folder / usual);
    }
  }
  /// Adds a package's folder that is an ancestor of a parameter file or a sibling of one.
  void addPackage(const fs::path& folder, const std::string& package) {
    std::error_code none;
    fs::path above = normalFolder(fs::absolute(normalFolder(folder), none));
    for (int i = 0; i <= kMaxParentFolders && !above.empty(); ++i) {
      if (above.filename() == package) {
        add(above);
      }
      add(above / package);
      above = above.parent_path();
    }
  }
  const std::vector<fs::path>& all() const { return all_; }

 private:
  std::vector<fs::path> all_;
};

SearchFolders searchFoldersFor(const std::string& package,
                               const std::vector<std::string>& folders) {
  SearchFolders searchFolders;
  for (const std::string& folder : folders) {
    if (!package.empty()) {
      searchFolders.addPackage(folder, package);
    }
  }
  for (const std::string& folder : folders) {
    searchFolders.addWithSubfolders(folder);
    searchFolders.addWithSubfolders(fs::path(folder) / "..");
  }
  return searchFolders;
}

std::string normal(const fs::path& path) {
  return path.lexically_normal().string();
}

}  // namespace

std::string pathWithoutSubstitution(std::string_view named) {
  constexpr std::string_view kPackageUri = "package://", kFileUri = "file://";
  if (base::startsWith(named, kPackageUri)) {
    const std::size_t slash = named.find('/', kPackageUri.size());
    return slash == std::string_view::npos ? std::string() : std::string(named.substr(slash + 1));
  }
  if (base::startsWith(named, kFileUri)) {
    return std::string(named.substr(kFileUri.size()));
  }
  const std::size_t end = base::startsWith(named, "~/") ? 1 : endOfPlaceholders(named);
  if (end == 0) {
    return std::string(named);
  }
  const std::string_view rest = named.substr(end);
  const std::size_t first = rest.find_first_not_of('/');
  // "$(var map).yaml" leaves only a part of a name
  return first == std::string_view::npos || first == 0 ? std::string()
                                                       : std::string(rest.substr(first));
}

ReferencedFile findReferencedFile(const std::string& named,
                                  const std::vector<std::string>& folders) {
  ReferencedFile found;
  const fs::path path = pathWithoutSubstitution(named);
  if (path.empty()) {
    return found;
  }
  if (path.is_absolute() && isFile(path)) {
    found.file = normal(path);
    return found;
  }
  for (const std::string& folder : folders) {
    if (path.is_relative() && isFile(fs::path(folder) / path)) {  // also paths with ".."
      found.file = normal(fs::path(folder) / path);
      return found;
    }
  }
  const SearchFolders searchFolders = searchFoldersFor(packageOf(named), folders);
  for (const fs::path& end : pathSuffixes(path)) {
    for (const fs::path& place : searchFolders.all()) {
      if (isFile(place / end)) {
        found.file = normal(place / end);
        return found;
      }
    }
  }
  found.searched.reserve(searchFolders.all().size());
  for (const fs::path& place : searchFolders.all()) {
    found.searched.push_back(place.string());
  }
  return found;
}

base::Diagnostic referencedFileMissing(const std::string& key, const std::string& named,
                                       const ReferencedFile& found, const std::string& instead) {
  return base::warning("nav2.file-not-found",
                       {key, named, base::join(found.searched, ", "), instead});
}

}  // namespace sim2d::nav2
