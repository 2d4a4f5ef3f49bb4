#include "sim2d/world/Compatibility.h"

#include <algorithm>
#include <array>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

/// Quirks that change the behaviour of people and give the same result in each run. The others are
/// crashes, files that do not load, undefined behaviour, wall-clock time, or permanently
/// reproduced.
constexpr std::array<int, 18> kSwitchable = {6,  7,  9,  11, 12, 13, 14, 15, 17,
                                             18, 19, 20, 24, 29, 30, 31, 32, 34};

bool isSwitchable(int quirk) {
  return std::find(kSwitchable.begin(), kSwitchable.end(), quirk) != kSwitchable.end();
}

std::string nameOf(int quirk) {
  return std::string("Q-") + (quirk < 10 ? "0" : "") + std::to_string(quirk);
}

std::string switchableNames() {
  std::string names;
  for (const int quirk : kSwitchable) {
    names += (names.empty() ? "" : ", ") + nameOf(quirk);
  }
  return names;
}

std::optional<int> numberOf(const std::string& name) {
  const std::string lower = base::toLower(base::trimmed(name));
  if (lower.size() != 4 || lower.compare(0, 2, "q-") != 0) {
    return std::nullopt;
  }
  const std::optional<long long> number = base::parseInt(lower.substr(2));
  const bool isQuirk = number && *number >= 1 && *number < Compatibility::kCount;
  return isQuirk ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

}  // namespace

std::vector<std::string> Compatibility::names() const {
  std::vector<std::string> names;
  if (hunav2_) {
    names.emplace_back("hunav2");
  }
  for (int quirk = 1; quirk < kCount; ++quirk) {
    if (has(quirk)) {
      names.push_back(nameOf(quirk));
    }
  }
  return names;
}

base::Result<Compatibility> Compatibility::parse(const std::string& text) {
  Compatibility result;
  if (base::toLower(base::trimmed(text)) == "hunav2") {
    result.hunav2_ = true;
    for (const int quirk : kSwitchable) {
      result.set(quirk);
    }
    return result;
  }
  base::Diagnostics problems;
  for (const std::string& name : base::split(text, ',')) {
    const std::optional<int> quirk = numberOf(name);
    if (!quirk) {
      problems.push_back(base::error("world.no-quirk", {base::trimmed(name)}));
    } else if (!isSwitchable(*quirk)) {
      problems.push_back(
          base::error("world.quirk-not-switchable", {nameOf(*quirk), switchableNames()}));
    } else {
      result.set(*quirk);
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return result;
}

}  // namespace sim2d
