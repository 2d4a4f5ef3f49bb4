#pragma once

#include <bitset>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"

namespace sim2d {

/// Enabled quirks of the original HuNavSim (`--compat hunav2`, `--compat Q-13,Q-20`).
class Compatibility {
 public:
  static constexpr int kCount = 35;  // Q-01 … Q-34

  bool has(int quirk) const { return quirks_.test(static_cast<std::size_t>(quirk)); }
  void set(int quirk) { quirks_.set(static_cast<std::size_t>(quirk)); }
  bool hunav2() const { return hunav2_; }
  std::vector<std::string> names() const;  // "Q-13", …; "hunav2" first if all are enabled

  /// "hunav2" or a comma-separated list of Q-nn; a quirk that cannot be switched is an error.
  static base::Result<Compatibility> parse(const std::string& text);

 private:
  std::bitset<kCount> quirks_;
  bool hunav2_ = false;
};

}  // namespace sim2d
