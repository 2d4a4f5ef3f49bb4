#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace app {

/// A file and what stood in it.
struct InputHash {
  std::string path, sha256;
};

/// Files as they were when they were first looked at, for who reads them later, again and again,
/// and wants the same each time. One thread.
class SeenFiles {
 public:
  /// The number of a file; it is looked at the first time.
  std::size_t look(const std::string& path);
  /// All of them, by number; without a hash what could not be read.
  const std::vector<InputHash>& hashes() const { return hashes_; }

  /// Paths of those that hold something else by now, or are gone. Reads only what was written
  /// since.
  std::vector<std::string> changed(const std::vector<std::size_t>& numbers);

 private:
  /// What changes whenever a file is written or another takes its place.
  struct Stamp {
    long long seconds = 0, nanoseconds = 0, size = 0;
    unsigned long long device = 0, inode = 0;
    bool operator==(const Stamp& other) const;
  };
  static std::optional<Stamp> stampOf(const std::string& path);

  std::vector<InputHash> hashes_;
  std::vector<std::optional<Stamp>> stamps_;  // nothing: it was not there
};

}  // namespace app
