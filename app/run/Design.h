#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/base/Result.h"

namespace base {
struct YamlNode;
}  // namespace base

namespace app {

/// The points of an experiment at which its values of the form `between` are taken together.
struct Design {
  enum class Method {
    Random,
    LatinHypercube,  // McKay, Beckman & Conover 1979, Technometrics 21
    Sobol            // Joe & Kuo 2008, SIAM J. Sci. Comput. 30; without the origin
  };
  static constexpr const char* kMethodNames[] = {"random", "latin_hypercube", "sobol"};
  static constexpr std::size_t kMaxPoints = 1'000'000;
  static constexpr std::size_t kMaxDimensions = 1000;

  Method method = Method::Random;
  std::size_t points = 1;
  std::uint64_t seed = 1;  // of the draws; Sobol's sequence does not use it
};

/// The points of a design in [0, 1)^dimensions, one vector per point. Equal arguments give equal
/// bits on every machine; a prefix of a random or Sobol design is the smaller design.
std::vector<std::vector<double>> designPoints(const Design& design, std::size_t dimensions);

/// Reads the key `design` of an experiment: {method: sobol, points: 64, seed: 1}; problems have
/// their locations, without the file.
base::Result<Design> readDesign(const base::YamlNode& node);

}  // namespace app
