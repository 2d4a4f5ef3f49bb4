#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "sim2d/nav/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {

/// The people of one instant sorted by cell, in the column format of the kernel. Does not allocate
/// once it has processed its largest crowd. Queries are thread-safe, `rebuild` is not.
class CrowdCells {
 public:
  /// All vectors have the same length. `room`: clearance of each person to walls [m].
  void rebuild(const std::vector<Walker>& walkers, const std::vector<char>& present,
               const std::vector<double>& room, WorkerPool& workers);

  std::size_t count() const { return order_.size(); }  // number of slots = people who are present
  std::size_t personIn(std::size_t slot) const { return static_cast<std::size_t>(order_[slot]); }
  CrowdColumns columns() const {
    return {x_.data(), y_.data(), vx_.data(), vy_.data(), room_.data()};
  }
  double fastest() const { return fastest_; }  // [m/s]
  std::size_t rowCount() const { return static_cast<std::size_t>(height_); }

  /// Writes the slots of the cells that a disc intersects as at most `rowCount` spans, and adds the
  /// number of slots to `slots`; returns the end of the spans. Coordinates are those of the
  /// columns.
  CrowdSpan* writeSpans(float x, float y, float radius, CrowdSpan* to, int& slots) const;

 private:
  struct alignas(64) Extent {  // of the people that one thread processed
    Vec2 low = Vec2::Zero(), high = Vec2::Zero();
    double squaredFastest = 0.0;
    bool isEmpty = true;
    void add(const Extent& other);
  };

  Extent extentOf(const std::vector<Walker>& walkers, const std::vector<char>& present,
                  WorkerPool& workers);
  void placeGrid(const Extent& all, std::size_t people);
  int cellAt(const Vec2& position) const;
  void fillColumns(const std::vector<Walker>& walkers, const std::vector<double>& room,
                   WorkerPool& workers);

  Vec2 origin_ = Vec2::Zero();  // corner of the grid
  Vec2 middle_ = Vec2::Zero();  // origin of the column coordinates
  Vec2 cell_ = Vec2::Ones();    // size [m]
  int width_ = 0, height_ = 0;
  float originX_ = 0.0F, originY_ = 0.0F;  // grid origin in column coordinates
  float slack_ = 0.0F;                     // [m]; above the rounding of the columns
  double fastest_ = 0.0;
  std::vector<Extent> extents_;  // per thread
  std::vector<int> start_, next_, cellOf_;
  std::vector<int> order_;                     // person per slot
  std::vector<float> x_, y_, vx_, vy_, room_;  // per slot
};

/// Upper bound of the speeds in a crowd that changes seldom, since tables depend on it.
class SpeedBound {
 public:
  /// Call before a step with this number of people; returns true if `value` has changed. The bound
  /// is lowered when that is worth new tables.
  bool update(double fastest, std::size_t people);
  double value() const { return value_; }  // [m/s]

 private:
  double value_ = -1.0;
  double largest_ = 0.0;         // maximum speed since the bound became too wide
  std::size_t excessCount_ = 0;  // people since then, over all steps
};

/// Region of people whose force on a walking person is relevant. Forces reach far towards oncoming
/// people and hardly backward, so the region is a disc with its centre ahead of the person.
class CrowdReach {
 public:
  struct Disc {
    double ahead = 0.0;   // of its centre, along the velocity [m]
    double radius = 0.0;  // [m]
  };

  /// For forces above `share` = exp(-cutOff) of k_s and speeds up to `fastest` [m/s], > 0.
  CrowdReach(const ForceParameters& parameters, double cutOff, double fastest);

  /// Disc of a person with this speed, at most the maximum [m/s].
  const Disc& discOf(double speed) const;

 private:
  static constexpr std::size_t kDiscs = 16;  // one per speed interval

  double interactionBound(double along, double across) const;
  double farthestAt(double cosine, double sine, double speed) const;
  Disc discFor(double low, double high) const;

  ForceParameters parameters_;
  double cutOff_;
  double fastest_;  // [m/s], > 0
  std::array<Disc, kDiscs> discs_;
};

/// State of the people at one instant. All vectors have the same length.
struct CrowdState {
  const std::vector<Walker>& walkers;
  const std::vector<char>& present;
  const std::vector<CrowdForceModel>& forceModels;
  const std::vector<double>& room;  // lower bound of each person's clearance to walls [m]
  /// True if no obstacle is between two people; must be thread-safe.
  const std::function<bool(std::size_t, std::size_t)>& isVisible;
};

/// Social forces (socialForce) among many people at once. Skips pairs with a force below 5e-5 of
/// k_s by the bound of `isNegligible`, and computes in single precision relative to the middle of
/// the crowd: the RMS error is below 0.25 % of the RMS force. Results are bit-identical for all
/// instruction sets and numbers of threads. Does not allocate once it has processed its largest
/// crowd.
class CrowdForces {
 public:
  explicit CrowdForces(SimdLevel path = fastestSimdLevel());

  /// The parameters of a law must not change while its pointer is in use.
  void compute(const CrowdState& crowd, WorkerPool& workers);
  /// Force on each person, by index [m/s²]; zero without a law.
  const std::vector<Vec2>& forces() const { return forces_; }

 private:
  struct CachedForceModel {  // of one person; avoids scattered memory access
    const ForceParameters* parameters = nullptr;
    std::size_t shape = 0;
    double socialFactor = 0.0;
  };
  struct Batch {  // of people with the same law
    CrowdForceParameters law;
    std::size_t shape = 0;
    std::vector<std::size_t> slots;
    std::vector<CrowdReceiver> receivers;
    std::vector<CrowdSpan> spans;
    std::vector<CrowdResult> results;
    int spanCount = 0, candidates = 0;
  };
  struct alignas(64) Scratch {  // of one thread
    // Uninitialised: most entries are never used and then take no physical memory.
    std::unique_ptr<float[]> x, y, vx, vy, fx, fy;
    std::unique_ptr<int[]> word, wordAt, slot, touching, doubtful;
    std::size_t size = 0;  // of these arrays
    Batch batch;
    void resize(std::size_t candidates, std::size_t rows);
    CrowdPairs pairs();
  };

  bool updateForceModels(const CrowdState& crowd, WorkerPool& workers);
  void sortShapes(const CrowdState& crowd);
  std::size_t findShape(const ForceParameters& parameters);
  void prepareReach();
  CrowdForceParameters crowdForceParameters(const ForceParameters& parameters,
                                            bool testsWalls) const;
  void computeSlots(const CrowdState& crowd, std::size_t begin, std::size_t end, Scratch& scratch);
  void addToBatch(const CrowdState& crowd, std::size_t slot, Scratch& scratch);
  void computeBatch(const CrowdState& crowd, Scratch& scratch);
  void finish(const CrowdState& crowd, std::size_t receiver, Scratch& scratch);
  Vec2 coincidentForce(const CrowdState& crowd, std::size_t slot, const Batch& batch,
                       const CrowdReceiver& receiver) const;

  CrowdKernel kernel_;
  double cutOff_ = 0.0;
  CrowdCells cells_;
  std::vector<ForceParameters> shapes_;  // distinct parameter sets without the force factor
  std::vector<CachedForceModel> known_;  // per person
  SpeedBound fastest_;
  std::vector<CrowdReach> reaches_;  // per shape
  std::vector<Scratch> scratches_;   // per thread
  std::vector<Vec2> forces_;
};

}  // namespace sim2d
