#include "app/capsule/Unpacked.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/OutputFolder.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;
using RunJson = nlohmann::ordered_json;

constexpr std::size_t kMaxManifest = std::size_t{256} << 20U;  // [B]

std::string withoutEnd(const fs::path& folder) {
  const fs::path path = folder.lexically_normal();
  return path.has_filename() ? path.string() : path.parent_path().string();
}

/// The new place of a recorded file, or of a folder that contains one; nullopt: neither.
std::optional<std::string> newPlace(const std::string& recorded, const CapsuleManifest& manifest,
                                    const std::string& root) {
  for (const CapsuleInput& input : manifest.inputs) {
    if (input.path == recorded && !input.member.empty()) {
      return pathOfInput(input, root);
    }
  }
  for (const CapsuleInput& input : manifest.inputs) {
    if (!input.member.empty() && fs::path(input.path).has_parent_path() &&
        withoutEnd(fs::path(input.path).parent_path()) == withoutEnd(recorded)) {
      return fs::path(pathOfInput(input, root)).parent_path().string();
    }
  }
  return std::nullopt;
}

/// A word of a command line: a path, or "--option=path".
std::string relocatedWord(const std::string& word, const CapsuleManifest& manifest,
                          const std::string& root) {
  const bool isOption = base::startsWith(word, "--") && word.find('=') != std::string::npos;
  const std::size_t begin = isOption ? word.find('=') + 1 : 0;
  const auto place = newPlace(word.substr(begin), manifest, root);
  return place ? word.substr(0, begin) + *place : word;
}

}  // namespace

base::Result<TemporaryFolder> TemporaryFolder::create() {
  const char* const given = std::getenv("TMPDIR");
  std::string path =
      (fs::path(given != nullptr && *given != '\0' ? given : "/tmp") / "hunavsim-XXXXXX").string();
  if (::mkdtemp(path.data()) == nullptr) {
    return app::writeProblem(path);
  }
  std::error_code ignored;
  return TemporaryFolder(fs::weakly_canonical(path, ignored).string());
}

TemporaryFolder::~TemporaryFolder() {
  if (!path_.empty()) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

base::Result<CapsuleManifest> readCapsuleManifest(const ArchiveReader& archive,
                                                  const std::string& file) {
  const base::Result<std::string> text = archive.text(kManifestMember, kMaxManifest);
  return text ? parseCapsuleManifest(*text, file + "/" + kManifestMember)
              : base::Result<CapsuleManifest>(text.diagnostics());
}

std::string pathOfInput(const CapsuleInput& input, const std::string& root) {
  return input.member.empty() ? std::string() : app::pathIn(root, input.member);
}

std::string workingFolderOf(const CapsuleManifest& manifest, const std::string& root) {
  for (const CapsuleInput& input : manifest.inputs) {
    const std::string end = "/" + fs::path(input.path).lexically_normal().string();
    if (fs::path(input.path).is_relative() && base::endsWith(input.member, end)) {
      return app::pathIn(root, input.member.substr(0, input.member.size() - end.size()));
    }
  }
  return {};
}

std::string withRecordedPaths(std::string text, const CapsuleManifest& manifest,
                              const std::string& root) {
  for (const CapsuleInput& input : manifest.inputs) {
    const std::string path = pathOfInput(input, root);
    for (std::size_t at = path.empty() ? std::string::npos : text.find(path);
         at != std::string::npos; at = text.find(path, at + input.path.size())) {
      text.replace(at, path.size(), input.path);
    }
  }
  return text;
}

base::Diagnostics relocateRun(const CapsuleManifest& manifest, const std::string& root) {
  const std::string path = app::pathIn(root, std::string(kStudyFolder) + app::Manifest::kName);
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  RunJson json = RunJson::parse(base::shallowJson(*text), nullptr, false);
  try {
    for (RunJson& word : json.at("command_line")) {
      word = relocatedWord(word.get<std::string>(), manifest, root);
    }
    for (RunJson& input : json.at("inputs")) {
      input["path"] = relocatedWord(input.at("path").get<std::string>(), manifest, root);
    }
  } catch (const RunJson::exception&) {
    return {base::error("trace.bad-manifest", {}, path)};
  }
  return base::writeFileAtomically(path, base::jsonText(json) + "\n");
}

base::Diagnostics foreignInputs(const std::vector<app::InputHash>& used,
                                const CapsuleManifest& manifest, const std::string& root,
                                const std::string& file) {
  base::Diagnostics problems;
  for (const app::InputHash& input : used) {
    std::error_code ignored;
    const std::string path = fs::weakly_canonical(input.path, ignored).string();
    const auto found =
        std::find_if(manifest.inputs.begin(), manifest.inputs.end(), [&](const CapsuleInput& each) {
          return !each.member.empty() && pathOfInput(each, root) == path;
        });
    if (found == manifest.inputs.end()) {
      problems.push_back(base::error("capsule.outside", {input.path}, file));
    } else if (found->sha256 != input.sha256) {
      problems.push_back(
          base::error("capsule.other-input", {found->path}, file + "/" + found->member));
    }
  }
  return problems;
}

base::Diagnostics atMembers(base::Diagnostics problems, const std::string& root,
                            const std::string& file) {
  for (base::Diagnostic& problem : problems) {
    if (base::startsWith(problem.file, root)) {
      problem.file = file + problem.file.substr(root.size());
    }
  }
  return problems;
}

base::Result<UnpackedStudy> unpackStudy(const std::string& file, const std::string& folder) {
  const base::Result<std::unique_ptr<ArchiveReader>> archive = ArchiveReader::open(file);
  if (!archive) {
    return archive.diagnostics();
  }
  const base::Result<CapsuleManifest> manifest = readCapsuleManifest(**archive, file);
  if (!manifest) {
    return manifest.diagnostics();
  }
  base::Diagnostics problems = (*archive)->extract(folder);
  if (problems.empty() && !manifest->isBatch) {
    std::error_code ignored;
    problems = relocateRun(*manifest, fs::weakly_canonical(folder, ignored).string());
  }
  UnpackedStudy study{manifest->isBatch, app::pathIn(folder, "study"),
                      manifest->isBatch ? pathOfInput(manifest->inputs.front(), folder) : ""};
  return base::resultOf(std::move(study), std::move(problems));
}

}  // namespace capsule
