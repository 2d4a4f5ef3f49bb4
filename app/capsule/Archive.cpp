#include "app/capsule/Archive.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <zip.h>

#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

// MS-DOS date and time, the earliest possible: 1980-01-01 00:00.
constexpr zip_uint16_t kDosTime = 0;
constexpr zip_uint16_t kDosDate = (1U << 5U) | 1U;
constexpr mode_t kFileMode = 0644, kProgramMode = 0755;
constexpr zip_uint32_t kBestCompression = 9;

std::string zipErrorText(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

/// Adds one member to an archive that is being written. False: libzip refuses it.
bool addMember(zip_t* archive, const ArchiveMember& member) {
  zip_source_t* const source =
      member.file.empty()
          ? zip_source_buffer(archive, member.content.data(), member.content.size(), 0)
          : zip_source_file(archive, member.file.c_str(), 0, -1);
  if (source == nullptr) {
    return false;
  }
  const zip_int64_t added =
      zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_GUESS);  // takes the source
  if (added < 0) {
    zip_source_free(source);
    return false;
  }
  const auto index = static_cast<zip_uint64_t>(added);
  const auto mode =
      static_cast<zip_uint32_t>(S_IFREG | (member.isExecutable ? kProgramMode : kFileMode));
  const zip_int32_t method = member.isStored ? ZIP_CM_STORE : ZIP_CM_DEFLATE;
  return zip_set_file_compression(archive, index, method, member.isStored ? 0 : kBestCompression) ==
             0 &&
         zip_file_set_dostime(archive, index, kDosTime, kDosDate, 0) == 0 &&
         zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, mode << 16U) == 0;
}

/// The mode of a member in an archive made on Unix, where it may be that of a link or a device;
/// nullopt: unreadable.
std::optional<zip_uint32_t> modeOf(zip_t* archive, zip_uint64_t index) {
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) != 0) {
    return std::nullopt;
  }
  return attributes >> 16U;
}

bool isPlainFile(zip_uint32_t mode) {
  const zip_uint32_t kind = mode & static_cast<zip_uint32_t>(S_IFMT);
  return kind == 0 || kind == static_cast<zip_uint32_t>(S_IFREG);
}

}  // namespace

bool isMemberName(const std::string& name) {
  const auto isUnusual = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (name.empty() || name.find('\\') != std::string::npos ||
      std::any_of(name.begin(), name.end(), isUnusual)) {
    return false;
  }
  const std::vector<std::string> parts = base::split(name, '/');
  return std::none_of(parts.begin(), parts.end(), [](const std::string& part) {
    return part.empty() || part == "." || part == "..";
  });
}

base::Diagnostics writeArchive(const std::string& path, const std::vector<ArchiveMember>& members) {
  const std::string temporary = path + ".new-" + std::to_string(::getpid());
  int code = 0;
  zip_t* const archive = zip_open(temporary.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) {
    return {base::error("file.cannot-write", {zipErrorText(code)}, path)};
  }
  const bool isAdded =
      std::all_of(members.begin(), members.end(),
                  [archive](const ArchiveMember& member) { return addMember(archive, member); });
  if (!isAdded || zip_close(archive) != 0) {
    const std::string reason = zip_strerror(archive);
    zip_discard(archive);
    return {base::error("file.cannot-write", {reason}, path)};
  }
  const base::FileDescriptor file(::open(temporary.c_str(), O_RDONLY | O_CLOEXEC));
  if (::chmod(temporary.c_str(), 0644) != 0 || !file.isOpen() || ::fsync(file.number()) != 0 ||
      std::rename(temporary.c_str(), path.c_str()) != 0) {
    const base::Diagnostic problem = app::writeProblem(path);
    ::unlink(temporary.c_str());
    return {problem};
  }
  return {};
}

base::Result<std::unique_ptr<ArchiveReader>> ArchiveReader::open(const std::string& path,
                                                                 const ArchiveLimits& limits) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return base::error("file.cannot-read", {"it is missing or not a file"}, path);
  }
  int code = 0;
  zip_t* const archive = zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code);
  if (archive == nullptr) {
    return base::error("capsule.no-archive", {zipErrorText(code)}, path);
  }
  std::unique_ptr<ArchiveReader> reader(new ArchiveReader(path, archive));
  base::Diagnostics problems = reader->readEntries(limits);
  if (!problems.empty()) {
    return problems;
  }
  return reader;
}

ArchiveReader::~ArchiveReader() {
  zip_discard(archive_);
}

base::Diagnostics ArchiveReader::readEntries(const ArchiveLimits& limits) {
  const zip_int64_t count = zip_get_num_entries(archive_, 0);
  if (count < 0 || static_cast<std::uint64_t>(count) > limits.members) {
    return {base::error("capsule.too-many", {count, limits.members}, path_)};
  }
  base::Diagnostics problems;
  for (std::uint64_t index = 0; index < static_cast<std::uint64_t>(count); ++index) {
    base::append(problems, readEntry(index));
  }
  // A file and a folder of the same name: "a" and "a/b".
  for (const auto& [name, index] : indices_) {
    const auto below = indices_.lower_bound(name + '/');
    if (below != indices_.end() && base::startsWith(below->first, name + '/')) {
      problems.push_back(base::error("capsule.bad-name", {below->first}, path_));
    }
  }
  base::append(problems, checkSizes(limits));
  return problems;
}

base::Diagnostics ArchiveReader::readEntry(std::uint64_t index) {
  zip_stat_t found;
  const char* const raw = zip_get_name(archive_, index, ZIP_FL_ENC_RAW);
  if (raw == nullptr || zip_stat_index(archive_, index, 0, &found) != 0) {
    return {base::error("capsule.no-archive", {zip_strerror(archive_)}, path_)};
  }
  const std::string name = raw;
  if (!isMemberName(name)) {
    return {base::error("capsule.bad-name", {name}, path_)};
  }
  const bool isReadable =
      found.encryption_method == ZIP_EM_NONE &&
      (found.comp_method == ZIP_CM_STORE || found.comp_method == ZIP_CM_DEFLATE);
  const std::optional<zip_uint32_t> mode = modeOf(archive_, index);
  if (!isReadable || !mode || !isPlainFile(*mode)) {
    return {base::error("capsule.no-plain-file", {name}, path_)};
  }
  if (!indices_.emplace(name, index).second) {
    return {base::error("capsule.no-archive", {"'" + name + "' occurs twice"}, path_)};
  }
  entries_.push_back({name, found.size, (*mode & static_cast<zip_uint32_t>(S_IXUSR)) != 0});
  total_ = found.size > UINT64_MAX - total_ ? UINT64_MAX : total_ + found.size;
  return {};
}

base::Diagnostics ArchiveReader::checkSizes(const ArchiveLimits& limits) const {
  std::error_code ignored;
  const std::uint64_t size = fs::file_size(path_, ignored);
  const std::uint64_t most =
      std::min(limits.total, std::max(limits.alwaysAllowed, limits.expansion * size));
  return total_ <= most
             ? base::Diagnostics()
             : base::Diagnostics{base::error("capsule.too-large", {total_, most}, path_)};
}

bool ArchiveReader::has(const std::string& name) const {
  return indices_.count(name) != 0;
}

base::Diagnostics ArchiveReader::read(const std::string& name,
                                      const std::function<void(std::string_view)>& take) const {
  const auto found = indices_.find(name);
  if (found == indices_.end()) {
    return {base::error("capsule.missing", {}, path_ + "/" + name)};
  }
  zip_stat_t stat;
  zip_file_t* const file = zip_stat_index(archive_, found->second, 0, &stat) == 0
                               ? zip_fopen_index(archive_, found->second, 0)
                               : nullptr;
  if (file == nullptr) {
    return {base::error("capsule.damaged", {zip_strerror(archive_)}, path_ + "/" + name)};
  }
  std::vector<char> piece(std::size_t{1} << 16U);
  std::uint64_t size = 0;
  std::string reason;
  while (reason.empty()) {
    const zip_int64_t got = zip_fread(file, piece.data(), piece.size());
    if (got < 0) {
      reason = zip_file_strerror(file);
    }
    if (got <= 0) {
      break;
    }
    size += static_cast<std::uint64_t>(got);
    if (size > stat.size) {
      reason = "it is larger than its size in the archive";
    } else {
      take({piece.data(), static_cast<std::size_t>(got)});
    }
  }
  zip_fclose(file);
  if (reason.empty() && size < stat.size) {
    reason = "it is smaller than its size in the archive";
  }
  return reason.empty()
             ? base::Diagnostics()
             : base::Diagnostics{base::error("capsule.damaged", {reason}, path_ + "/" + name)};
}

base::Result<std::string> ArchiveReader::text(const std::string& name, std::size_t most) const {
  const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                  [&name](const Entry& each) { return each.name == name; });
  if (entry != entries_.end() && entry->size > most) {
    return base::error("capsule.too-large", {entry->size, most}, path_ + "/" + name);
  }
  std::string content;
  base::Diagnostics problems = read(name, [&content](std::string_view piece) { content += piece; });
  return base::resultOf(std::move(content), std::move(problems));
}

base::Diagnostics ArchiveReader::extractOne(const Entry& entry, const std::string& target) const {
  std::error_code failure;
  fs::create_directories(fs::path(target).parent_path(), failure);
  // The folder is new and nothing makes links in it; an existing file is an error.
  base::FileDescriptor file(::open(target.c_str(),
                                   O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                   entry.isExecutable ? kProgramMode : kFileMode));
  if (!file.isOpen()) {
    return {app::writeProblem(target)};
  }
  base::Diagnostics unwritten;
  base::Diagnostics problems = read(entry.name, [&](std::string_view piece) {
    while (unwritten.empty() && !piece.empty()) {
      const ssize_t done = ::write(file.number(), piece.data(), piece.size());
      if (done > 0) {
        piece.remove_prefix(static_cast<std::size_t>(done));
      } else if (errno != EINTR) {
        unwritten.push_back(app::writeProblem(target));
      }
    }
  });
  base::append(problems, unwritten);
  return problems;
}

base::Diagnostics ArchiveReader::extract(const std::string& folder, const std::string& prefix,
                                         const MemberCallback& onMember) const {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_empty(folder, failure) || failure) {
    return {base::error("capsule.folder-not-empty", {}, folder)};
  }
  base::Diagnostics problems;
  for (const Entry& entry : entries_) {
    if (!base::startsWith(entry.name, prefix)) {
      continue;
    }
    const std::string target = app::pathIn(folder, entry.name);
    base::Diagnostics ofMember = extractOne(entry, target);
    const bool isWhole = ofMember.empty();
    base::append(problems, ofMember);
    if (isWhole && onMember) {
      onMember(entry.name, app::sha256OfFile(target).value_or(""));
    }
  }
  return problems;
}

}  // namespace capsule
