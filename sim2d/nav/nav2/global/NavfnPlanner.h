#pragma once

#include <cstdint>
#include <vector>

#include "sim2d/base/StopFlag.h"
#include "sim2d/nav/nav2/Costmap.h"

namespace sim2d::nav2 {

/// The wave front of NavFn (nav2_navfn_planner, navfn.cpp): a potential that grows from the robot's
/// cell over the grid by an approximate eikonal update, and the descent along its gradient. Uses
/// the floats and visiting order of NavFn, because results depend on them.
class NavfnWavefront {
 public:
  static constexpr float kUnreached = 1.0e10F;
  static constexpr std::uint8_t kNeutral = 50, kObstacle = 254, kUnknownCost = 253;

  /// NavFn's cost of a costmap cell: 50 to 251, 253 for unknown space, 254 for obstacles.
  static std::uint8_t costOf(std::uint8_t cost, bool allowUnknown);

  /// Copies the costs; the outermost cells become obstacles.
  void setCosts(const Costmap& costmap, bool allowUnknown);
  /// Sets NavFn costs, row-major.
  void setCosts(int width, int height, std::vector<std::uint8_t> costs);
  void free(Cell cell);  // sets the cost of free space, unless the cell is on the border

  /// Expands from the robot's cell until the target has a potential, no cells are left or max(w h /
  /// 20, w + h) blocks are processed. Returns the number of updated cells.
  int propagate(Cell robot, Cell target, bool useAstar, const base::StopFlag* stop = nullptr);

  float potential(Cell cell) const { return potential_[indexOf(cell)]; }

  /// Descends from the target to the robot's cell of the last call of `propagate`, in steps of half
  /// a cell; unit: cells, (0, 0) is the first cell. Empty when there is no descent or `maxSteps`
  /// are exceeded.
  std::vector<Vec2> descend(Cell target, int maxSteps) const;

 private:
  using Block = std::vector<int>;  // indices of cells
  struct Descent {                 // a position as a cell and an offset in cells
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
  void processBlock(bool useAstar);
  void update(int index, bool useAstar);
  float estimate(int index) const;
  bool lacksGradient(int cell) const;
  bool moveToLowestNeighbour(Descent& at) const;
  bool step(Descent& at) const;
  Vec2 gradient(int index) const;

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> costs_;
  std::vector<float> potential_;
  std::vector<char> isPending_;
  std::vector<Block> blocks_ = std::vector<Block>(3);
  std::size_t current_ = 0, next_ = 1, overflow_ = 2;  // indices of blocks_
  float threshold_ = 0.0F;
  Cell robot_, target_;
};

}  // namespace sim2d::nav2
