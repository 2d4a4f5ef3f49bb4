#include "app/run/SeenFiles.h"

#include <algorithm>
#include <sys/stat.h>
#include <tuple>

#include "app/run/Sha256.h"

namespace app {

bool SeenFiles::Stamp::operator==(const Stamp& other) const {
  const auto all = [](const Stamp& stamp) {
    return std::tie(stamp.seconds, stamp.nanoseconds, stamp.size, stamp.device, stamp.inode);
  };
  return all(*this) == all(other);
}

std::optional<SeenFiles::Stamp> SeenFiles::stampOf(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return Stamp{status.st_ctim.tv_sec, status.st_ctim.tv_nsec, status.st_size, status.st_dev,
               status.st_ino};
}

std::size_t SeenFiles::look(const std::string& path) {
  const auto found = std::find_if(hashes_.begin(), hashes_.end(),
                                  [&path](const InputHash& each) { return each.path == path; });
  if (found == hashes_.end()) {
    stamps_.push_back(stampOf(path));  // before it is read
    hashes_.push_back({path, sha256OfFile(path).value_or("")});
    return hashes_.size() - 1;
  }
  return static_cast<std::size_t>(found - hashes_.begin());
}

std::vector<std::string> SeenFiles::changed(const std::vector<std::size_t>& numbers) {
  std::vector<std::string> others;
  for (const std::size_t number : numbers) {
    const InputHash& input = hashes_[number];
    const std::optional<Stamp> now = stampOf(input.path);
    if (now == stamps_[number]) {
      continue;
    }
    if (sha256OfFile(input.path).value_or("") == input.sha256) {
      stamps_[number] = now;  // written again, or touched
    } else {
      others.push_back(input.path);
    }
  }
  return others;
}

}  // namespace app
