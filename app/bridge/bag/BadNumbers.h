#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/bag/Bag.h"

namespace bridge {

// No plausible number of a recording is larger.
constexpr double kMostMetres = 1e9;    // from the origin, as the reader of tracks has it
constexpr double kMostSpeed = 1e4;     // [m/s], and [rad/s] of turning
constexpr double kMostRadius = 100.0;  // [m] of a body
constexpr double kMostFactor = 1e6;    // of a force; also [m] of a goal's radius

/// Numbers in messages that are not finite or implausibly large, counted by topic and field.
class BadNumbers {
 public:
  enum class Loss { Sample, Value };  // what is left out together with the number

  /// False, and counted, when a number is not finite or its magnitude is above `most`.
  bool areFine(std::size_t channel, const char* field, std::initializer_list<double> numbers,
               double most, Loss loss = Loss::Sample);
  bool hasSamples() const;  // some samples were left out
  /// One warning per topic and field.
  base::Diagnostics warnings(const std::vector<BagChannel>& channels,
                             const std::string& path) const;

 private:
  struct Count {
    std::size_t count = 0;
    double first = 0.0;
    Loss loss = Loss::Sample;
  };
  std::map<std::pair<std::size_t, std::string>, Count> counts_;
};

}  // namespace bridge
