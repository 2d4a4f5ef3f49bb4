#include "app/studies/StudyFolder.h"

#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

/// Whether a file begins as RunPool writes it.
bool isJournal(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path, base::kMaxRecord);
  return text && base::startsWith(*text, "{\"hunavsim_journal\"");
}

}  // namespace

ExistingStudy existingStudy(bool resume, bool force) {
  return resume ? ExistingStudy::Resume : force ? ExistingStudy::Replace : ExistingStudy::Refuse;
}

base::Result<std::unique_ptr<StudyFolder>> StudyFolder::open(const std::string& folder,
                                                             const std::vector<std::string>& files,
                                                             ExistingStudy earlier) {
  base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(folder, earlier == ExistingStudy::Replace);
  if (!output) {
    return output.diagnostics();
  }
  std::unique_ptr<StudyFolder> study(new StudyFolder(*std::move(output)));
  base::Diagnostics problems = study->output_->conflictingFiles(files);
  if (!base::hasErrors(problems)) {
    problems = study->prepareJournal(earlier);
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return study;
}

std::string StudyFolder::journal() const {
  return pathIn(output_->path(), kJournal);
}

/// Removes the journal of an earlier study unless it is resumed.
base::Diagnostics StudyFolder::prepareJournal(ExistingStudy earlier) const {
  const std::string path = journal();
  if (!entryExists(path) || earlier == ExistingStudy::Resume) {
    return {};
  }
  const bool isFinished = output_->manifest().matches(output_->path(), kJournal);
  if (earlier == ExistingStudy::Refuse && !isFinished) {
    return {isJournal(path) ? base::error("study.unfinished", {}, output_->path())
                            : base::error("file.is-in-the-way", {}, path)};
  }
  std::error_code error;
  std::filesystem::remove(path, error);
  return error ? base::Diagnostics{writeProblem(path)} : base::Diagnostics();
}

base::Diagnostics StudyFolder::finish(const std::vector<base::FileContent>& files,
                                      const std::string& kind) {
  base::Diagnostics problems;
  for (const base::FileContent& file : files) {
    base::append(problems, output_->write(file.path, file.content));
  }
  if (entryExists(journal())) {
    const base::Result<std::string> text = base::readTextFile(journal(), base::kMaxRecord);
    base::append(problems, text.diagnostics());
    base::append(problems, text ? output_->write(kJournal, *text) : base::Diagnostics());
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  const nlohmann::ordered_json manifest = {
      {"kind", kind}, {"program", {{"version", programVersion()}, {"commit", programCommit()}}}};
  return output_->commit(base::jsonText(manifest), OutputFolder::EarlierFiles::Removed);
}

}  // namespace app
