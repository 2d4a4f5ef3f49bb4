#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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
    Sobol,           // Joe & Kuo 2008, SIAM J. Sci. Comput. 30; without the origin
    // For sensitivity analysis (app/run/SensitivityDesign.h); `points` of them are not all points:
    Morris,   // trajectories, each of one point more than there are dimensions
    Saltelli  // base points, each with as many points as dimensions, and two more
  };
  static constexpr const char* kMethodNames[] = {"random", "latin_hypercube", "sobol", "morris",
                                                 "saltelli"};
  static constexpr std::size_t kMaxPoints = 1'000'000;
  static constexpr std::size_t kMaxDimensions = 1000;

  Method method = Method::Random;
  std::size_t points = 1;
  std::uint64_t seed = 1;  // of the draws; Sobol's sequence does not use it

  /// The number of all points.
  std::size_t pointCount(std::size_t dimensions) const {
    return method == Method::Morris     ? points * (dimensions + 1)
           : method == Method::Saltelli ? points * (dimensions + 2)
                                        : points;
  }
  bool isForSensitivity() const { return method == Method::Morris || method == Method::Saltelli; }
  const char* methodName() const { return kMethodNames[static_cast<std::size_t>(method)]; }
};

/// What a sensitivity analysis changes in the design of an experiment.
struct SensitivityRequest {
  std::optional<Design::Method> method;  // default: the file's, otherwise Morris
  std::optional<std::size_t> points;     // default: the file's, otherwise 20, or 64 of Saltelli
  Design appliedTo(const std::optional<Design>& design) const;
};

/// The points of a design in [0, 1)^dimensions, of Morris' design in [0, 1], one vector per point.
/// Equal arguments give equal bits on every machine; except for Latin hypercubes, a prefix is the
/// smaller design.
std::vector<std::vector<double>> designPoints(const Design& design, std::size_t dimensions);

/// Reads the key `design` of an experiment: {method: sobol, points: 64, seed: 1}; problems have
/// their locations, without the file.
base::Result<Design> readDesign(const base::YamlNode& node);

}  // namespace app
