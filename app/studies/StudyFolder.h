#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/run/OutputFolder.h"
#include "sim2d/base/Result.h"

namespace app {

/// The handling of results of the same kind that are already in a folder. `Resume` uses the journal
/// of an interrupted or finished study.
enum class ExistingStudy { Refuse, Resume, Replace };
ExistingStudy existingStudy(bool resume, bool force);

/// The output folder of a study: the journal of its runs (RunPool) from the beginning, and all
/// other files at the end. One process at a time.
class StudyFolder {
 public:
  static constexpr const char* kJournal = "journal.jsonl";

  /// Creates the folder. `files`: what finish() will write, as far as known. Errors: in use, not
  /// writable, contains files that hunavsim did not create, or an interrupted study with `Refuse`.
  static base::Result<std::unique_ptr<StudyFolder>> open(const std::string& folder,
                                                         const std::vector<std::string>& files,
                                                         ExistingStudy earlier);

  std::string journal() const;  // its path
  /// Writes the files, the journal among them, and removes those of an earlier study. `kind`: the
  /// command, for the manifest: "search".
  base::Diagnostics finish(const std::vector<base::FileContent>& files, const std::string& kind);

 private:
  explicit StudyFolder(std::unique_ptr<OutputFolder> output) : output_(std::move(output)) {}
  base::Diagnostics prepareJournal(ExistingStudy earlier) const;

  std::unique_ptr<OutputFolder> output_;
};

}  // namespace app
