#include "app/run/SeedEffect.h"

#include <algorithm>
#include <cmath>

#include "app/run/ResultStore.h"

namespace app {

namespace {

bool areAlike(double first, double second) {
  constexpr double kShare = 1e-3;
  if (std::isnan(first) || std::isnan(second)) {
    return std::isnan(first) && std::isnan(second);
  }
  return first == second ||  // also infinite values
         std::abs(first - second) <= kShare * std::max(std::abs(first), std::abs(second));
}

bool isDefined(double value) {
  return !std::isnan(value);
}

/// The scenario and the values that are not drawn.
std::string cellName(const Study& study, const StoredRun& run) {
  std::string name = run.scenario;
  for (std::size_t k = 0; k < run.values.size(); ++k) {
    const bool isDrawn =
        std::find(study.drawn.begin(), study.drawn.end(), study.paths[k]) != study.drawn.end();
    name += isDrawn ? std::string() : ", " + study.paths[k] + "=" + run.values[k];
  }
  return name;
}

}  // namespace

void SeedEffect::add(const std::string& cell, long long seed, const std::vector<double>& values) {
  const auto [found, isFirst] = cells_.try_emplace(cell);
  Cell& of = found->second;
  if (isFirst) {
    of.first = values;
    of.firstSeed = seed;
    of.isConstant = std::any_of(values.begin(), values.end(), isDefined);
    return;
  }
  of.hasSeveralSeeds = of.hasSeveralSeeds || seed != of.firstSeed;
  of.isConstant = of.isConstant && std::equal(values.begin(), values.end(), of.first.begin(),
                                              of.first.end(), areAlike);
}

std::vector<std::string> SeedEffect::constantCells() const {
  std::vector<std::string> constant;
  for (const auto& [cell, of] : cells_) {
    if (of.hasSeveralSeeds && of.isConstant) {
      constant.push_back(cell);
    }
  }
  return constant;
}

SeedEffect seedEffectOf(const ResultStore& store) {
  SeedEffect effect;
  // An unreadable store is reported by what writes the results.
  static_cast<void>(store.forEach([&](const StoredRun& run) {
    std::vector<double> values;
    values.reserve(run.row.fields.size());
    for (const auto& [column, field] : run.row.fields) {
      values.push_back(numberIn(field).value_or(std::nan("")));
    }
    effect.add(cellName(store.study(), run), run.seed, values);
  }));
  return effect;
}

}  // namespace app
