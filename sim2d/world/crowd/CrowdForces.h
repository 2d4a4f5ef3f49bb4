#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sim2d/world/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdCells.h"
#include "sim2d/world/crowd/CrowdReach.h"
#include "sim2d/world/crowd/VectorPath.h"

namespace sim2d {

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
  /// The parameters that a law points to must stay what they are as long as the pointer is used.
  /// Of each person, by index [m/s²]; zero without a law.
  const std::vector<Vec2>& forces() const { return forces_; }

 private:
  static constexpr int kOther = -1;  // a shape that has no entry
  struct Shape {                     // what people have in common who feel alike
    ForceParameters parameters;
    int reach = -1;  // in reaches_; -1: none
  };
  struct KnownLaw {  // of one person; spares a look into memory all over the place
    const ForceParameters* parameters = nullptr;
    int shape = kOther;
    double socialFactor = 0.0;
  };
  struct Batch {  // of people with the same law
    CrowdLaw law;
    const ForceParameters* parameters = nullptr;  // of the first
    int shape = kOther;                           // of all
    std::vector<std::size_t> slots;
    std::vector<CrowdReceiver> receivers;
    std::vector<CrowdSpan> spans;
    std::vector<CrowdResult> results;
    int spanCount = 0, candidates = 0;
    void clear();
  };
  /// Memory that is not written before it is used, as most of it never is.
  template <class Item>
  class Column {
   public:
    void resize(std::size_t count) { items_.reset(new Item[count]); }
    Item* data() { return items_.get(); }

   private:
    std::unique_ptr<Item[]> items_;
  };
  struct alignas(64) Scratch {  // of one thread
    Column<float> x, y, vx, vy, fx, fy;
    Column<int> word, wordAt, slot, touching, doubtful;
    std::size_t size = 0;  // of the columns
    Batch batch;
    void resize(std::size_t candidates, std::size_t rows);
    CrowdPairs pairs();
  };

  bool hasNewLaws(const CrowdState& crowd, WorkerPool& workers);
  void sortShapes(const CrowdState& crowd);
  int findShape(const ForceParameters& parameters);
  void prepareReach();
  bool fits(const SocialLaw& law, int shape, bool looksForWalls, const Batch& batch) const;
  CrowdReach::Disc discOf(const ForceParameters& parameters, int shape, double speed) const;
  CrowdLaw lawOf(const ForceParameters& parameters, bool looksForWalls) const;
  void computeSlots(const CrowdState& crowd, std::size_t begin, std::size_t end, Scratch& scratch);
  void addToBatch(const CrowdState& crowd, std::size_t slot, Scratch& scratch);
  void computeBatch(const CrowdState& crowd, Scratch& scratch);
  void finish(const CrowdState& crowd, std::size_t receiver, Scratch& scratch);
  Vec2 forceOfTouching(const CrowdState& crowd, std::size_t slot, const Batch& batch,
                       const CrowdReceiver& receiver) const;

  CrowdKernel kernel_;
  double cutOff_ = 0.0;
  CrowdCells cells_;
  std::vector<Shape> shapes_;
  std::vector<KnownLaw> known_;  // by person
  SpeedBound fastest_;
  std::vector<CrowdReach> reaches_;
  std::vector<Scratch> scratches_;  // by thread
  std::vector<Vec2> forces_;
};

}  // namespace sim2d
