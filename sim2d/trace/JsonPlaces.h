#pragma once

#include <map>
#include <string>

namespace sim2d {

/// In which lines of a JSON text the members of its objects stand, from 1.
class JsonPlaces {
 public:
  /// Empty for what is no JSON.
  explicit JsonPlaces(const std::string& text);

  /// `path` as "humans[3].radius"; of what has no line of its own that of what it is in, 0 where
  /// nothing of it is there.
  int lineOf(std::string path) const;

 private:
  std::map<std::string, int> lines_;  // by path
};

}  // namespace sim2d
