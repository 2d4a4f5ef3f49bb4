#include "app/capsule/StudyMembers.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string_view>

#include "app/capsule/CapsuleManifest.h"
#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/ResultStore.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

constexpr const char* kStore = "results.sqlite";

bool isInName(char c) {
  return base::isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("_-.").find(c) != std::string_view::npos;
}

/// Replaces a path where it is not a part of a longer name.
void replacePath(std::string& text, const std::string& path, const std::string& name) {
  for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path, at)) {
    const std::size_t end = at + path.size();
    const bool isAfterName = at > 0 && (isInName(text[at - 1]) || text[at - 1] == '/');
    if (isAfterName || (end < text.size() && isInName(text[end]))) {
      at = end;
    } else {
      text.replace(at, path.size(), name);
      at += name.size();
    }
  }
}

/// The folders of a file and of its member above the part of the path that both have in common.
std::pair<std::string, std::string> differingFolders(const fs::path& path, const fs::path& member) {
  auto at = path.end(), of = member.end();
  while (at != path.begin() && of != member.begin() && *std::prev(at) == *std::prev(of)) {
    --at;
    --of;
  }
  fs::path folder, ofMember;
  for (auto part = path.begin(); part != at; ++part) {
    folder /= *part;
  }
  for (auto part = member.begin(); part != of; ++part) {
    ofMember /= *part;
  }
  return {folder.string(), ofMember.string()};
}

bool isManifest(const std::string& name) {
  const std::string file = fs::path(name).filename().string();
  return file == app::Manifest::kName || file == app::Manifest::kHiddenName;
}

/// Files of a report and tables; of kept runs only their manifests name files.
bool mayNamePaths(const std::string& name) {
  constexpr const char* kEndings[] = {".csv", ".html", ".json", ".md", ".tex", ".xml"};
  return isManifest(name) ||
         (!base::startsWith(name, "runs/") &&
          std::any_of(std::begin(kEndings), std::end(kEndings),
                      [&name](const char* ending) { return base::endsWith(name, ending); }));
}

/// Makes the members of a study. Manifests come last, because they list the hashes of other files.
class StudyMembers {
 public:
  StudyMembers(const StudySource& source, const PathNames& names, std::string temporary)
      : source_(source), names_(names), temporary_(std::move(temporary)) {}

  base::Result<std::vector<ArchiveMember>> make() {
    std::vector<std::string> files = source_.files;
    const auto orderOf = [](const std::string& name) {
      return !isManifest(name) ? 0 : base::startsWith(name, "runs/") ? 1 : 2;
    };
    std::stable_sort(files.begin(), files.end(),
                     [&](const auto& a, const auto& b) { return orderOf(a) < orderOf(b); });
    for (const std::string& name : files) {
      if (source_.isBatch && name == kStore) {
        addStore(name);
      } else if (mayNamePaths(name) && (source_.isBatch || isManifest(name))) {
        addText(name);
      } else {
        members_.push_back({kStudyFolder + name, {}, fileOf(name), false});
      }
    }
    return base::resultOf(std::move(members_), std::move(problems_));
  }

 private:
  std::string fileOf(const std::string& name) const { return app::pathIn(source_.folder, name); }

  void addText(const std::string& name) {
    const base::Result<std::string> text = base::readTextFile(fileOf(name), base::kMaxRecord);
    if (!text) {
      base::append(problems_, text.diagnostics());
      return;
    }
    std::string changed = names_.replaced(*text);
    if (isManifest(name)) {
      for (const auto& [former, hash] : hashes_) {
        replacePath(changed, former, hash);
      }
    }
    const bool isEqual = changed == *text;
    if (!isEqual) {
      hashes_.emplace_back(app::sha256Of(*text), app::sha256Of(changed));
    }
    members_.push_back({kStudyFolder + name, isEqual ? std::string() : std::move(changed),
                        isEqual ? fileOf(name) : std::string(), false});
  }

  void addStore(const std::string& name) {
    const std::string copy = app::pathIn(temporary_, name);
    std::error_code failure;
    fs::copy_file(fileOf(name), copy, failure);
    if (failure) {
      problems_.push_back(base::error("file.cannot-read", {failure.message()}, fileOf(name)));
      return;
    }
    const base::Result<std::unique_ptr<app::ResultStore>> store = app::ResultStore::open(copy);
    if (!store) {
      base::append(problems_, store.diagnostics());
      return;
    }
    const std::vector<app::InputHash>& inputs = (*store)->study().inputs;
    if (std::all_of(inputs.begin(), inputs.end(), [this](const app::InputHash& input) {
          return names_.replaced(input.path) == input.path;
        })) {
      members_.push_back({kStudyFolder + name, {}, fileOf(name), false});
      return;
    }
    base::append(problems_, (*store)->replacePaths(
                                [this](const std::string& text) { return names_.replaced(text); }));
    base::append(problems_, (*store)->close());
    hashes_.emplace_back(app::sha256OfFile(fileOf(name)).value_or(""),
                         app::sha256OfFile(copy).value_or(""));
    members_.push_back({kStudyFolder + name, {}, copy, false});
  }

  using Hashes = std::vector<std::pair<std::string, std::string>>;  // former and new ones

  const StudySource& source_;
  const PathNames& names_;
  const std::string temporary_;
  std::vector<ArchiveMember> members_;
  base::Diagnostics problems_;
  Hashes hashes_;
};

}  // namespace

PathNames::PathNames(const StudySource& source, const std::vector<std::string>& members) {
  for (std::size_t k = 0; k < source.inputs.size(); ++k) {
    const SourceInput& input = source.inputs[k];
    const std::string& member = members[k];
    const std::string file = fs::path(input.path).filename().string();
    add(input.recorded.path, member.empty() ? file : member);
    add(input.path, member.empty() ? file : member);
    if (!member.empty()) {
      const auto [folder, name] = differingFolders(input.path, member);
      add(folder, name.empty() ? "." : name);
    }
  }
  add(app::absolutePath(source.folder), "study");
  add(app::programPath(), "hunavsim");
  std::stable_sort(names_.begin(), names_.end(),
                   [](const auto& a, const auto& b) { return a.first.size() > b.first.size(); });
}

void PathNames::add(const std::string& path, const std::string& name) {
  const fs::path of(path);
  if (of.is_absolute() && of.has_relative_path()) {  // not "/"
    names_.emplace_back(path, name);
  }
}

std::string PathNames::replaced(std::string text) const {
  for (const auto& [path, name] : names_) {
    replacePath(text, path, name);
  }
  return text;
}

base::Result<std::vector<ArchiveMember>> studyMembers(const StudySource& source,
                                                      const PathNames& names,
                                                      const std::string& temporary) {
  return StudyMembers(source, names, temporary).make();
}

}  // namespace capsule
