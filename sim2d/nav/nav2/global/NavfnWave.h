#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim2d/base/Stop.h"
#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// The wave front of NavFn (nav2_navfn_planner, navfn.cpp): a potential that grows from the robot's
/// cell over the grid by an approximate eikonal update, and the descent along its gradient. Floats
/// and the order of visits are NavFn's, as results depend on them.
class NavfnWave {
 public:
  static constexpr float kUnreached = 1.0e10F;
  static constexpr std::uint8_t kNeutral = 50, kObstacle = 254, kUnknownCost = 253;

  /// NavFn's cost of a costmap's cell: 50 to 251, 253 for unknown space, 254 for obstacles.
  static std::uint8_t costOf(std::uint8_t cost, bool allowUnknown);

  /// Takes over the costs; the outermost cells become obstacles.
  void setCosts(const Costmap& costmap, bool allowUnknown);
  /// NavFn's own costs, row by row.
  void setCosts(int width, int height, std::vector<std::uint8_t> costs);
  void free(Cell cell);  // as a costmap's 0, unless it lies on the border

  /// Spreads from the robot's cell until the target has a potential, nothing is left or
  /// max(w h / 20, w + h) blocks are worked off. Returns the number of cells updated.
  int spread(Cell robot, Cell target, bool useAstar, const base::StopFlag* stop = nullptr);

  float potential(Cell cell) const { return potential_[indexOf(cell)]; }

  /// From the target down to the robot of the last spread, in steps of half a cell; unit: cells,
  /// (0, 0) is the first cell. Empty when there is no way down or `mostSteps` are used up.
  std::vector<Vec2> descend(Cell target, int mostSteps) const;

 private:
  static constexpr int kBlockSize = 10000;  // what does not go in is lost, as in NavFn
  struct Block {
    std::array<int, kBlockSize> cells;
    int count = 0;
  };
  struct Descent {  // a place as a cell and an offset in cells
    int cell = 0;
    float dx = 0.0F, dy = 0.0F;
  };

  std::size_t indexOf(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.column);
  }
  float at(int index) const {
    return index >= 0 && index < size() ? potential_[static_cast<std::size_t>(index)] : kUnreached;
  }
  int size() const { return width_ * height_; }
  void closeBorder();
  void push(int index, Block& block);
  void seed(int robot);
  void workOff(bool useAstar);
  void update(int index, bool useAstar);
  float estimate(int index) const;
  bool isRough(int cell) const;
  bool fallToLowest(Descent& at) const;
  bool step(Descent& at) const;
  Vec2 gradient(int index) const;

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> costs_;
  std::vector<float> potential_;
  std::vector<char> isPending_;
  std::vector<Block> blocks_ = std::vector<Block>(3);
  std::size_t current_ = 0, next_ = 1, overflow_ = 2;  // which of the blocks
  float threshold_ = 0.0F;
  Cell robot_, target_;
};

}  // namespace sim2d::nav2
