#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

struct zip;  // of libzip

/// ZIP files (PKWARE's APPNOTE 6.3) as far as capsules use them: regular files, stored or deflated.
namespace capsule {

/// A file to be written into an archive.
struct ArchiveMember {
  std::string name;           // relative, parts separated by '/'
  std::string content;        // used unless `file` is set
  std::string file;           // path of the file with the content
  bool isStored = false;      // not compressed
  bool isExecutable = false;  // a program
};

/// Writes an archive with these members in this order, or leaves the file as it was. All members
/// have the same time (1980-01-01), so equal members give equal bytes with the same versions of
/// libzip and zlib.
base::Diagnostics writeArchive(const std::string& path, const std::vector<ArchiveMember>& members);

/// Limits of sizes, above which open() rejects an archive, because it would fill the disk or
/// memory.
struct ArchiveLimits {
  std::size_t members = 500'000;
  std::uint64_t total = std::uint64_t{32} << 30U;  // [B] of all members, uncompressed
  /// [B] of all members that any archive may have; larger ones only if they are at most
  /// `expansion` times the size of the archive.
  std::uint64_t alwaysAllowed = std::uint64_t{256} << 20U;
  std::uint64_t expansion = 200;
};

/// Reads an archive from an untrusted source. One thread.
class ArchiveReader {
 public:
  struct Entry {
    std::string name;
    std::uint64_t size = 0;     // [B], uncompressed
    bool isExecutable = false;  // becomes an executable file
  };

  /// Checks all names, kinds and sizes before anything is read. Errors: not an archive, truncated
  /// or inconsistent; a member that is not a plain file, is encrypted or has another compression; a
  /// name that leaves the folder, has unusual characters or occurs twice; too many or too large
  /// members.
  static base::Result<std::unique_ptr<ArchiveReader>> open(const std::string& path,
                                                           const ArchiveLimits& limits = {});
  ~ArchiveReader();
  ArchiveReader(const ArchiveReader&) = delete;
  ArchiveReader& operator=(const ArchiveReader&) = delete;
  ArchiveReader(ArchiveReader&&) = delete;
  ArchiveReader& operator=(ArchiveReader&&) = delete;

  const std::vector<Entry>& entries() const { return entries_; }  // in the order of the archive
  bool has(const std::string& name) const;
  /// Reads a member piece by piece. Error: it is damaged; `take` may then have received a part.
  base::Diagnostics read(const std::string& name,
                         const std::function<void(std::string_view)>& take) const;
  /// The content of a member of at most `most` bytes. Errors: missing, larger, damaged.
  base::Result<std::string> text(const std::string& name, std::size_t most) const;
  /// Writes the members whose names begin with `prefix` as files into a folder, which must be empty
  /// or missing. `onMember` receives each name with its SHA-256. Damaged members are reported, all
  /// of them.
  using MemberCallback = std::function<void(const std::string& name, const std::string& sha256)>;
  base::Diagnostics extract(const std::string& folder, const std::string& prefix = {},
                            const MemberCallback& onMember = {}) const;

 private:
  ArchiveReader(std::string path, zip* archive) : path_(std::move(path)), archive_(archive) {}
  base::Diagnostics readEntries(const ArchiveLimits& limits);
  base::Diagnostics readEntry(std::uint64_t index);
  base::Diagnostics checkSizes(const ArchiveLimits& limits) const;
  base::Diagnostics extractOne(const Entry& entry, const std::string& target) const;

  std::string path_;
  zip* archive_;
  std::vector<Entry> entries_;
  std::map<std::string, std::uint64_t> indices_;  // in the archive, by name
  std::uint64_t total_ = 0;                       // [B]
};

/// Whether a name may be that of a member: relative, no control characters, no backslashes, no
/// empty part, no "." or "..".
bool isMemberName(const std::string& name);

}  // namespace capsule
