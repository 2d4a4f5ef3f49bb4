#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "sim2d/world/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {

/// Instruction sets that the kernel is compiled for.
enum class VectorPath : std::uint8_t { Sse2, Avx2, Avx512 };
const char* vectorPathName(VectorPath path);
bool hasVectorPath(VectorPath path);  // this processor
VectorPath fastestVectorPath();

/// The people of one instant. The vectors are as long as each other.
struct CrowdState {
  const std::vector<Walker>& walkers;
  const std::vector<char>& present;
  const std::vector<SocialLaw>& laws;
  const std::vector<double>& room;  // free of walls round each person, at least [m]
  /// Nothing solid between two people; may be called by several threads at once.
  const std::function<bool(std::size_t, std::size_t)>& isVisible;
};

/// The social forces (socialForce) among many people at once. Leaves out pairs whose force is below
/// 5e-5 of k_s by `isNegligible`'s bound and works in single precision about the middle of the
/// crowd: the RMS error is below 0.25 % of the RMS force. The bits depend neither on the
/// instruction set nor on the number of threads. Allocates nothing once it has seen its largest
/// crowd.
class CrowdForces {
 public:
  explicit CrowdForces(VectorPath path = fastestVectorPath());

  void compute(const CrowdState& crowd, WorkerPool& workers);
  /// Of each person, by index [m/s²]; zero without a law.
  const std::vector<Vec2>& forces() const { return forces_; }

 private:
  struct Columns {
    std::vector<float> x, y, vx, vy, room;
    void resize(std::size_t count);
    CrowdColumns view();
  };
  struct Row {  // of people near a cell
    int slot = 0;
    int first = 0;  // candidate
  };
  struct Scratch {  // of one thread
    Columns near;
    std::vector<Row> rows;  // that the people in `near` are from
    std::vector<float> dx, dy, dvx, dvy, fx, fy;
    std::vector<int> index, doubtful;
    void resize(std::size_t count);
    CrowdPairs pairs();
  };

  void sortIntoCells(const CrowdState& crowd);
  void placeGrid(const CrowdState& crowd);
  void fillColumns(const CrowdState& crowd);
  void computeCells(const CrowdState& crowd, int first, int last, Scratch& scratch);
  void computeCell(const CrowdState& crowd, int column, int row, Scratch& scratch);
  double rangeOf(const CrowdState& crowd, std::size_t cell) const;
  int gatherNear(int column, int row, double range, Scratch& scratch);
  std::size_t personOf(int candidate, const Scratch& scratch) const;
  void forceOn(const CrowdState& crowd, std::size_t slot, int candidates, Scratch& scratch);
  Vec2 forceOfTouching(const CrowdState& crowd, std::size_t slot, int candidates,
                       const Scratch& scratch) const;

  CrowdKernel kernel_;
  Vec2 origin_ = Vec2::Zero();  // corner of the grid
  Vec2 middle_ = Vec2::Zero();  // of the columns
  double cell_ = 1.0;           // [m]
  int width_ = 0, height_ = 0;
  double fastest_ = 0.0;  // [m/s]
  double cutOff_ = 0.0;
  std::vector<int> start_, next_, cellOf_;
  std::vector<std::size_t> order_;  // person in each slot, sorted by cell
  Columns sorted_;
  std::vector<Scratch> scratches_;  // by share
  std::vector<int> firstCells_;     // of each share
  std::vector<Vec2> forces_;
};

}  // namespace sim2d
