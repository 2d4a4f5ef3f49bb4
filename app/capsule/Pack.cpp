#include "app/capsule/Pack.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/capsule/Archive.h"
#include "app/capsule/CapsuleManifest.h"
#include "app/capsule/InputTree.h"
#include "app/capsule/StudyMembers.h"
#include "app/capsule/StudySource.h"
#include "app/capsule/Texts.h"
#include "app/capsule/Unpacked.h"
#include "app/capsule/UnpackedInputs.h"
#include "app/run/OutputFolder.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

/// Whether the input is left out.
bool isOmitted(const SourceInput& input, bool withCode) {
  return input.isCode && !withCode;
}

bool isExecutable(const std::string& file) {
  return ::access(file.c_str(), X_OK) == 0;
}

/// The inputs have the paths that the study recorded.
CapsuleManifest manifestOf(const StudySource& source, bool withCode) {
  CapsuleManifest manifest;
  manifest.isBatch = source.isBatch;
  manifest.version = source.version;
  manifest.commit = source.commit;
  manifest.runs = source.runs;
  manifest.finished = source.finished;
  manifest.allowsCode = source.allowsCode;
  std::vector<std::string> paths;
  for (const SourceInput& input : source.inputs) {
    if (!isOmitted(input, withCode)) {
      paths.push_back(input.path);
    }
  }
  const std::vector<std::string> names = inputMembers(paths);
  auto name = names.begin();
  for (const SourceInput& input : source.inputs) {
    const std::string member = isOmitted(input, withCode) ? std::string() : *name++;
    manifest.inputs.push_back({input.recorded.path, input.recorded.sha256, member});
  }
  return manifest;
}

/// Names of the study for what it recorded with absolute paths.
PathNames renameInputs(const StudySource& source, CapsuleManifest& manifest) {
  std::vector<std::string> members;
  members.reserve(manifest.inputs.size());
  for (const CapsuleInput& input : manifest.inputs) {
    members.push_back(input.member);
  }
  PathNames names(source, members);
  for (CapsuleInput& input : manifest.inputs) {
    input.path = names.replaced(input.path);
  }
  return names;
}

/// The input files.
std::vector<ArchiveMember> inputsOf(const StudySource& source, const CapsuleManifest& manifest) {
  std::vector<ArchiveMember> members;
  for (std::size_t k = 0; k < source.inputs.size(); ++k) {
    const SourceInput& input = source.inputs[k];
    const std::string& name = manifest.inputs[k].member;
    const bool isKnown =
        name.empty() || std::any_of(members.begin(), members.end(),
                                    [&name](const auto& each) { return each.name == name; });
    if (!isKnown) {  // two paths may lead to one file
      const std::string file = input.content.empty() ? input.path : "";
      members.push_back({name, input.content, file, false, input.isCode && isExecutable(file)});
    }
  }
  return members;
}

/// Hashes of the members. Error: a file cannot be read.
base::Diagnostics addHashes(const std::vector<ArchiveMember>& members, app::FileHashes& hashes) {
  base::Diagnostics problems;
  for (const ArchiveMember& member : members) {
    const std::optional<std::string> hash =
        member.file.empty() ? app::sha256Of(member.content) : app::sha256OfFile(member.file);
    if (hash) {
      hashes[member.name] = *hash;
    } else {
      problems.push_back(base::error("file.cannot-read", {"it is missing"}, member.file));
    }
  }
  return problems;
}

void sortByName(std::vector<ArchiveMember>& members) {
  std::sort(members.begin(), members.end(),
            [](const ArchiveMember& a, const ArchiveMember& b) { return a.name < b.name; });
}

/// Unpacks the inputs of the new archive and reads them there.
base::Diagnostics testArchive(const std::string& file, const std::string& shown,
                              const CapsuleManifest& manifest, const sim2d::ImageLoader& loader) {
  const base::Result<std::unique_ptr<ArchiveReader>> archive = ArchiveReader::open(file);
  if (!archive) {
    return archive.diagnostics();
  }
  const base::Result<TemporaryFolder> folder = TemporaryFolder::create();
  if (!folder) {
    return folder.diagnostics();
  }
  const std::string root = app::pathIn(folder->path(), "capsule");
  base::Diagnostics problems = (*archive)->extract(root);
  if (problems.empty() && !manifest.isBatch) {
    problems = relocateRun(manifest, root);
  }
  if (problems.empty()) {
    problems = checkUnpackedInputs(manifest, root, shown, loader);
  }
  return problems;
}

}  // namespace

base::Result<PackedStudy> packStudy(const PackOptions& options) {
  const base::Result<StudySource> source = readStudySource(options.study);
  if (!source) {
    return source.diagnostics();
  }
  CapsuleManifest manifest = manifestOf(*source, options.withCode);
  const PathNames names = renameInputs(*source, manifest);
  const base::Result<TemporaryFolder> temporary = TemporaryFolder::create();
  if (!temporary) {
    return temporary.diagnostics();
  }
  base::Result<std::vector<ArchiveMember>> texts = textMembers(*source);
  base::Result<std::vector<ArchiveMember>> files = studyMembers(*source, names, temporary->path());
  if (!texts || !files) {
    return texts ? files.diagnostics() : texts.diagnostics();
  }
  for (ArchiveMember& text : *texts) {
    text.content = names.replaced(std::move(text.content));
  }
  const ArchiveMember type = {kTypeMember, kTypeText, {}, true};
  std::vector<ArchiveMember> members = inputsOf(*source, manifest);
  members.insert(members.end(), files->begin(), files->end());
  members.insert(members.end(), texts->begin(), texts->end());
  base::Diagnostics problems = addHashes(members, manifest.members);
  base::append(problems, addHashes({type}, manifest.members));
  app::FileHashes sums = manifest.members;
  members.push_back({kManifestMember, manifestText(manifest), {}, false});
  base::append(problems, addHashes({members.back()}, sums));
  members.push_back({kSumsMember, sumsText(sums), {}, false});
  const std::string identity = app::sha256Of(members.back().content);
  sortByName(members);
  members.insert(members.begin(), type);  // first, so that file(1) knows the type
  const std::string unnamed = options.output + ".unchecked";
  if (!base::hasErrors(problems)) {
    problems = writeArchive(unnamed, members);
  }
  if (!base::hasErrors(problems)) {
    problems = testArchive(unnamed, options.output, manifest, options.loader);
  }
  std::error_code ignored;
  const std::uint64_t size = fs::file_size(unnamed, ignored);
  if (!base::hasErrors(problems) && std::rename(unnamed.c_str(), options.output.c_str()) != 0) {
    problems.push_back(app::writeProblem(options.output));
  }
  fs::remove(unnamed, ignored);
  PackedStudy packed{identity, size, members.size(), source->runs, {}};
  for (const CapsuleInput& input : manifest.inputs) {
    if (input.member.empty()) {
      packed.omittedCode.push_back(input.path);
    }
  }
  base::append(problems, source.diagnostics());
  return base::resultOf(std::move(packed), std::move(problems));
}

}  // namespace capsule
