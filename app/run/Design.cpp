#include "app/run/Design.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <iterator>
#include <numeric>

#include "app/run/ExperimentValues.h"
#include "app/run/SensitivityDesign.h"
#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

using Points = std::vector<std::vector<double>>;

double uniform(std::uint64_t seed, std::size_t point, std::size_t dimension) {
  return base::AgentRng(seed, static_cast<int>(dimension), point)
      .uniform01(base::DrawPurpose::Design);
}

/// A permutation of 0 … n - 1 per dimension (Fisher-Yates), and a place within each cell.
void fillLatinHypercube(const Design& design, std::size_t dimension, Points& points) {
  std::vector<std::size_t> cells(points.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  const base::AgentRng rng(design.seed, static_cast<int>(dimension));
  for (std::size_t left = cells.size(); left > 1; --left) {
    const double draw =
        rng.uniform01(base::DrawPurpose::DesignOrder, static_cast<std::uint32_t>(left));
    std::swap(cells[left - 1], cells[static_cast<std::size_t>(draw * static_cast<double>(left))]);
  }
  for (std::size_t point = 0; point < points.size(); ++point) {
    points[point][dimension] =
        (static_cast<double>(cells[point]) + uniform(design.seed, point, dimension)) /
        static_cast<double>(points.size());
  }
}

void fillSobol(Points& points, std::size_t dimensions) {
  boost::random::sobol sequence(dimensions);
  for (std::vector<double>& point : points) {
    for (double& coordinate : point) {
      coordinate = static_cast<double>(sequence() >> 11U) * 0x1p-53;
    }
  }
}

bool readCount(const base::YamlNode& node, Design& design) {
  const auto count = base::parseInt(node.text);
  const bool isPossible =
      count && *count >= 1 && *count <= static_cast<long long>(Design::kMaxPoints);
  design.points = isPossible ? static_cast<std::size_t>(*count) : 1;
  return isPossible;
}

bool readMethod(const base::YamlNode& node, Design& design) {
  const auto& names = Design::kMethodNames;
  const auto* const found = std::find(std::begin(names), std::end(names), node.text);
  design.method = static_cast<Design::Method>(found - std::begin(names));
  return found != std::end(names);
}

bool readSeed(const base::YamlNode& node, Design& design) {
  const auto seed = base::parseInt(node.text);
  design.seed = static_cast<std::uint64_t>(seed.value_or(0));
  return seed && *seed >= 0;
}

}  // namespace

Design SensitivityRequest::appliedTo(const std::optional<Design>& design) const {
  constexpr std::size_t kTrajectories = 20, kBasePoints = 64;
  Design applied = design.value_or(Design());
  const bool keepsMethod =
      applied.isForSensitivity() && method.value_or(applied.method) == applied.method;
  if (!keepsMethod) {
    applied.method = method.value_or(Design::Method::Morris);
    applied.points = applied.method == Design::Method::Morris ? kTrajectories : kBasePoints;
  }
  applied.points = points.value_or(applied.points);
  return applied;
}

Points designPoints(const Design& design, std::size_t dimensions) {
  if (design.method == Design::Method::Morris) {
    return morrisPoints(design, dimensions);
  }
  if (design.method == Design::Method::Saltelli) {
    return saltelliPoints(design, dimensions);
  }
  Points points(design.points, std::vector<double>(dimensions));
  if (design.method == Design::Method::Sobol) {
    fillSobol(points, dimensions);
    return points;
  }
  for (std::size_t dimension = 0; dimension < dimensions; ++dimension) {
    if (design.method == Design::Method::LatinHypercube) {
      fillLatinHypercube(design, dimension, points);
      continue;
    }
    for (std::size_t point = 0; point < points.size(); ++point) {
      points[point][dimension] = uniform(design.seed, point, dimension);
    }
  }
  return points;
}

base::Result<Design> readDesign(const base::YamlNode& node) {
  const base::YamlNode* const method = node.isMap() ? node.find("method") : nullptr;
  const base::YamlNode* const points = node.isMap() ? node.find("points") : nullptr;
  if (method == nullptr || points == nullptr) {
    return located(node, base::error("experiment.bad-design"));
  }
  Design design;
  base::Diagnostics problems;
  for (const base::YamlNode& item : node.items) {
    if (item.key != "method" && item.key != "points" && item.key != "seed") {
      problems.push_back(located(
          base::keyNode(item),
          base::error("experiment.unknown-key",
                      {item.key, base::nearestName(item.key, {"method", "points", "seed"})})));
    }
  }
  const base::YamlNode* const seed = node.find("seed");
  const std::vector<std::string> methods(std::begin(Design::kMethodNames),
                                         std::end(Design::kMethodNames));
  if (!readMethod(*method, design)) {
    problems.push_back(located(
        *method, base::error("experiment.unknown-name", {"design method", method->text,
                                                         base::nearestName(method->text, methods),
                                                         base::join(methods, ", ")})));
  }
  if (!readCount(*points, design)) {
    problems.push_back(
        located(*points, base::error("experiment.bad-points", {Design::kMaxPoints})));
  }
  if (seed != nullptr && !readSeed(*seed, design)) {
    problems.push_back(located(*seed, base::error("experiment.bad-seed")));
  }
  return base::resultOf(design, std::move(problems));
}

}  // namespace app
