#include "app/studies/EliteArchive.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr int kMostCells = 1000;

}  // namespace

int Descriptor::cellOf(double value) const {
  if (std::isnan(value)) {
    return kUndefinedCell;
  }
  const double place = (value - low) / (high - low) * cells;
  return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(cells - 1)));
}

std::optional<Descriptor> parseDescriptor(const std::string& text) {
  const std::vector<std::string> parts = base::split(text, ':');
  if (parts.size() != 4 || parts[0].empty()) {
    return std::nullopt;
  }
  const std::optional<double> low = base::parseDouble(parts[1]), high = base::parseDouble(parts[2]);
  const std::optional<long long> cells = base::parseInt(parts[3]);
  const bool isValid = low && high && std::isfinite(*low) && std::isfinite(*high) && *low < *high &&
                       cells && *cells >= 1 && *cells <= kMostCells;
  return isValid ? std::optional(Descriptor{parts[0], *low, *high, static_cast<int>(*cells)})
                 : std::nullopt;
}

EliteArchive::Cell EliteArchive::cellOf(const Elite& elite) const {
  return {descriptors_[0].cellOf(elite.values[0]), descriptors_[1].cellOf(elite.values[1])};
}

std::optional<EliteArchive::Change> EliteArchive::add(const Elite& elite) {
  const auto [place, isNew] = elites_.try_emplace(cellOf(elite), elite);
  if (isNew) {
    return Change{true, elite.fitness};
  }
  const double improvement = elite.fitness - place->second.fitness;
  if (!(improvement > 0.0)) {
    return std::nullopt;
  }
  place->second = elite;
  return Change{false, improvement};
}

std::vector<std::size_t> EliteArchive::runs() const {
  std::vector<std::size_t> runs;
  std::transform(elites_.begin(), elites_.end(), std::back_inserter(runs),
                 [](const auto& entry) { return entry.second.run; });
  return runs;
}

std::vector<std::size_t> improvementRanks(
    const std::vector<std::optional<EliteArchive::Change>>& changes,
    const std::vector<double>& fitness) {
  const auto group = [&](std::size_t run) {
    return !changes[run] ? 2 : changes[run]->isNewCell ? 0 : 1;
  };
  const auto value = [&](std::size_t run) {
    return changes[run] ? changes[run]->improvement : fitness[run];
  };
  std::vector<std::size_t> order(changes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return group(a) != group(b) ? group(a) < group(b) : value(a) > value(b);
  });
  std::vector<std::size_t> ranks(order.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    ranks[order[rank]] = rank;
  }
  return ranks;
}

}  // namespace app
