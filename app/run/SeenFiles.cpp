#include "app/run/SeenFiles.h"

#include <algorithm>
#include <sys/stat.h>
#include <tuple>

#include "app/run/Sha256.h"

namespace app {

namespace {

auto parts(const std::timespec& time) {
  return std::make_pair(time.tv_sec, time.tv_nsec);
}

}  // namespace

bool SeenFiles::Stamp::operator==(const Stamp& other) const {
  const auto all = [](const Stamp& stamp) {
    return std::make_tuple(parts(stamp.time), stamp.size, stamp.device, stamp.inode);
  };
  return all(*this) == all(other);
}

std::optional<SeenFiles::Stamp> SeenFiles::stampOf(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return Stamp{status.st_ctim, status.st_size, status.st_dev, status.st_ino};
}

std::size_t SeenFiles::look(const std::string& path) {
  const auto [place, isNew] = numbers_.emplace(path, files_.size());
  if (isNew) {
    stamps_.push_back(stampOf(path));  // before it is read
    files_.push_back({path, sha256OfFile(path).value_or("")});
  }
  return place->second;
}

std::vector<InputHash> SeenFiles::thenAndNow(const std::vector<std::size_t>& numbers) {
  std::vector<InputHash> found;
  found.reserve(numbers.size());
  for (const std::size_t number : numbers) {
    const InputHash& then = files_[number];
    found.push_back(then);
    const std::optional<Stamp> now = stampOf(then.path);
    if (now == stamps_[number]) {
      continue;
    }
    const std::string hash = sha256OfFile(then.path).value_or("");
    if (hash == then.sha256) {
      stamps_[number] = now;  // the same was written again
    } else {
      found.push_back({then.path, hash});
    }
  }
  return found;
}

std::timespec SeenFiles::now() {
  std::timespec time = {};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

bool SeenFiles::areWrittenSince(const std::vector<std::size_t>& numbers,
                                const std::timespec& time) const {
  return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t number) {
    return stamps_[number] && parts(stamps_[number]->time) >= parts(time);
  });
}

}  // namespace app
