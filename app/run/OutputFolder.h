#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/run/FolderLock.h"
#include "app/run/ListedFiles.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Result.h"

namespace app {

/// The files that one command writes into a folder: all of them or none, one process at a time, and
/// nothing is lost that others put there.
///
/// While they are made they lie in `.hunavsim-new-<process>` of the folder. commit() names that
/// `.hunavsim-commit`: from this moment on the new files count. They are put in their places then,
/// manifest.json last, which lists them with their hashes; what a killed process did not get done
/// of that is done by whoever opens or reads the folder next. Only files that manifest.json lists,
/// as it lists them, are ever replaced or removed. Names are relative to the folder. One thread.
class OutputFolder {
 public:
  static constexpr const char* kManifest = "manifest.json";
  static constexpr const char* kHiddenManifest =
      ".hunavsim-manifest.json";  // in folders of other programs

  /// Makes the folder and takes its lock. Error: another process has it, which is named, or the
  /// folder cannot be written to. `force`: files of others may be replaced.
  static base::Result<std::unique_ptr<OutputFolder>> open(const std::string& folder, bool force,
                                                          const char* manifest = kManifest);
  /// Without commit() the folder is as it was.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  OutputFolder(OutputFolder&&) = delete;
  OutputFolder& operator=(OutputFolder&&) = delete;

  /// What stands where files of these names will be put and would be lost, an error for each.
  base::Diagnostics inTheWay(const std::vector<std::string>& names) const;
  const std::string& path() const { return folder_; }
  /// Where the files are made until they are put in their places.
  const std::string& staging() const { return staging_; }
  /// Error: a name that leaves the folder.
  base::Diagnostics write(const std::string& name, std::string_view content);
  /// SHA-256 of a file of the staging folder that is complete: it is not read again for that.
  void knowHash(const std::string& name, std::string sha256) { known_[name] = std::move(sha256); }
  /// Problems with files of the staging folder, told of the places that they are made for.
  base::Diagnostics atTheirPlaces(base::Diagnostics problems) const;

  /// What becomes of the files that the manifest lists so far and that are not made anew.
  enum class Earlier { Removed, Kept };
  /// Earlier files of these names do not stay, even where the others are kept, unless made anew.
  void drop(const std::vector<std::string>& names) { dropped_ = names; }
  /// Puts all that the staging folder holds in its place. `manifest`: a JSON object, to which the
  /// list of files is added; where earlier files are kept, the earlier manifest stays with another
  /// list. Errors: nothing has changed, unless the disk fails in the midst of renaming.
  base::Diagnostics commit(const std::string& manifest, Earlier earlier);

 private:
  OutputFolder(std::string folder, bool force, bool isNew, const char* manifest);
  bool isOurs(const std::string& name) const;
  bool isInTheWay(const std::string& name) const;

  std::string folder_, staging_;
  bool force_, isNew_;
  const char* manifest_;
  std::unique_ptr<FolderLock> lock_;
  FileHashes listed_;  // by the manifest that was there
  FileHashes known_;   // of new files
  std::vector<std::string> dropped_;
};

/// Files with names in a folder of another program, beside what is there: all of them or none.
/// `kind`: of the command that makes them; `dropped`: names of earlier ones that go, unless made
/// anew.
base::Diagnostics writeIntoOthers(const std::string& folder,
                                  const std::vector<base::FileContent>& files, const char* kind,
                                  bool force, const std::vector<std::string>& dropped = {});

/// For commands that write one file; many may write to one folder at the same time. An existing
/// file that the folder's hidden manifest does not list with its present content is an error,
/// unless `force` is given.
base::Diagnostics otherFileInTheWay(const std::string& file, bool force);
/// Writes the file unless another is in the way; one with the same content is not.
base::Diagnostics writeFile(const std::string& file, const std::string& content, bool force);
/// Adds the file that was written to the hidden manifest. `kind`: of the command, used where there
/// is no manifest yet. Waits for other processes that do the same.
base::Diagnostics noteFile(const std::string& file, const char* kind);

/// A name in a folder that is of the work of this program on it, not a result.
bool isRestOfOutput(const std::string& name);

/// What a file was to become that a killed process left unfinished, as base::GrowingFile names it;
/// nothing for other names.
std::optional<std::string> nameOfUnfinished(const std::string& name);

/// Before a folder is read: ends what a killed process has begun there. Error: another process
/// writes into it, or that cannot be done.
base::Diagnostics settleFolder(const std::string& folder);

}  // namespace app
