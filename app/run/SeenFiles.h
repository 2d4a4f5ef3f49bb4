#pragma once

#include <ctime>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// A file and what stood in it.
struct InputHash {
  std::string path, sha256;  // no hash: it was not there, or could not be read
};

/// Files as they were when they were first looked at, for who reads them again and again and wants
/// the same each time. One thread.
class SeenFiles {
 public:
  /// The number of a file; it is looked at the first time.
  std::size_t look(const std::string& path);
  /// All of them, by number, as they were then.
  const std::vector<InputHash>& all() const { return files_; }

  /// These as they were then; one that holds something else by now, or is gone, comes twice, the
  /// second time as it is. Reads only what was written meanwhile.
  std::vector<InputHash> thenAndNow(const std::vector<std::size_t>& numbers);

  /// By the clock of files.
  static std::timespec now();
  /// Whether one of these was written at that time or later: who has read it since may have read
  /// something else than was looked at.
  bool areWrittenSince(const std::vector<std::size_t>& numbers, const std::timespec& time) const;

 private:
  /// Changes whenever a file is written or another takes its place.
  struct Stamp {
    std::timespec time = {};
    long long size = 0;
    unsigned long long device = 0, inode = 0;
    bool operator==(const Stamp& other) const;
  };
  static std::optional<Stamp> stampOf(const std::string& path);

  std::vector<InputHash> files_;
  std::vector<std::optional<Stamp>> stamps_;  // nothing: it was not there
  std::map<std::string, std::size_t> numbers_;
};

}  // namespace app
