#pragma once

#include <string>
#include <vector>

namespace base {

/// A key that we do not know, kept as YAML text (block style, not indented), in the order found.
struct UnknownKey {
  std::string key;
  std::string yaml;

  friend bool operator==(const UnknownKey& a, const UnknownKey& b) {
    return a.key == b.key && a.yaml == b.yaml;
  }
};
using UnknownKeys = std::vector<UnknownKey>;

}  // namespace base
