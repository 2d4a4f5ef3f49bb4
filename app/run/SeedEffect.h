#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace app {

class ResultStore;

/// Finds cells (all that is not the seed is equal) whose runs are the same for all seeds. They are
/// not a sample: intervals and tests would treat repetitions of one run as independent runs.
///
/// Criterion: the cell has runs with several seeds, and each run differs from its first one by at
/// most 0.1 % of the larger value in every number column (both undefined: equal); at least one
/// column is defined.
class SeedEffect {
 public:
  /// Adds a run: its number columns in a fixed order, NaN: undefined; true is 1, false is 0.
  void add(const std::string& cell, long long seed, const std::vector<double>& values);
  std::size_t cellCount() const { return cells_.size(); }
  /// The cells without an effect of the seed, in alphabetical order.
  std::vector<std::string> constantCells() const;

 private:
  struct Cell {
    std::vector<double> first;
    long long firstSeed = 0;
    bool hasSeveralSeeds = false;
    bool isConstant = true;
  };
  std::map<std::string, Cell> cells_;
};

/// Of the runs stored so far. A cell is a scenario with the values that are not drawn by the seed:
/// "cafe, robot1.planner=dwa".
SeedEffect seedEffectOf(const ResultStore& store);

}  // namespace app
