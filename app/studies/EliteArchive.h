#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {

/// A quantity that distinguishes kinds of runs: a metric and its division into cells.
struct Descriptor {
  std::string key;  // of the metric
  double low = 0.0, high = 1.0;
  int cells = 1;

  static constexpr int kUndefinedCell = -1;
  /// The cell of a value, from 0: cells have equal widths, values beyond the range belong to the
  /// first or last cell. An undefined value (NaN) has the cell kUndefinedCell.
  int cellOf(double value) const;
};

/// Reads `KEY:LOW:HIGH:CELLS`; nullopt: it is something else, LOW >= HIGH or CELLS is not 1 … 1000.
std::optional<Descriptor> parseDescriptor(const std::string& text);

/// The best run of each cell over two descriptors: the archive of MAP-Elites (Mouret & Clune 2015,
/// arXiv:1504.04909). Larger fitness is better.
class EliteArchive {
 public:
  using Cell = std::array<int, 2>;
  struct Elite {
    std::size_t run = 0;  // number of the run
    double fitness = 0.0;
    std::array<double, 2> values{};  // of the descriptors; NaN: undefined
  };
  /// What a run changed. The improvement is its fitness less that of the former elite; in a new
  /// cell its fitness.
  struct Change {
    bool isNewCell = false;
    double improvement = 0.0;
  };

  explicit EliteArchive(std::array<Descriptor, 2> descriptors)
      : descriptors_(std::move(descriptors)) {}

  const std::array<Descriptor, 2>& descriptors() const { return descriptors_; }
  Cell cellOf(const Elite& elite) const;
  /// nullopt: the cell has an elite that is as good, so the archive has not changed.
  std::optional<Change> add(const Elite& elite);
  /// In the order of the cells.
  const std::map<Cell, Elite>& elites() const { return elites_; }
  bool isEmpty() const { return elites_.empty(); }
  std::vector<std::size_t> runs() const;  // of the elites, in the order of the cells

 private:
  std::array<Descriptor, 2> descriptors_;
  std::map<Cell, Elite> elites_;
};

/// The places of runs in the order of the improvement emitter of CMA-ME (Fontaine et al. 2020,
/// arXiv:1912.02400): first the runs that found a new cell, then those that improved one, each by
/// decreasing improvement, then the others by decreasing fitness. Equal runs keep their order.
/// Result: for each run its rank, from 0.
std::vector<std::size_t> improvementRanks(
    const std::vector<std::optional<EliteArchive::Change>>& changes,
    const std::vector<double>& fitness);

}  // namespace app
