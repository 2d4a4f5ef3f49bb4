#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "sim2d/nav/SocialForce.h"
#include "sim2d/world/WorkerPool.h"
#include "sim2d/world/crowd/CrowdCells.h"

namespace sim2d {

/// Not less than the fastest of a crowd, and changed seldom: tables hang on it.
class SpeedBound {
 public:
  /// Before a step of so many people; true: `value` has changed. It becomes smaller once that is
  /// worth the time of new tables.
  bool update(double fastest, std::size_t people);
  double value() const { return value_; }  // [m/s]

 private:
  double value_ = -1.0;
  double largest_ = 0.0;    // of the fastest since the bound became too wide
  std::size_t wasted_ = 0;  // people since then, all steps together
};

/// Where those can be whom a walking person feels. Forces reach far towards people who come head
/// on and hardly back, so the place is a disc with its middle ahead of the person.
class CrowdReach {
 public:
  struct Disc {
    double ahead = 0.0;   // of its middle, along the velocity [m]
    double radius = 0.0;  // [m]
  };

  /// For forces above `share` = exp(-cutOff) of k_s, nobody faster than `fastest` [m/s], > 0.
  CrowdReach(const ForceParameters& parameters, double cutOff, double fastest);

  /// Of a person with this speed, at most the fastest [m/s].
  const Disc& discOf(double speed) const;

 private:
  static constexpr std::size_t kDiscs = 16;  // by speed

  double boundOf(double along, double across) const;
  double farthestAt(double cosine, double sine, double speed) const;
  Disc discOver(double low, double high) const;

  ForceParameters parameters_;
  double cutOff_;
  double fastest_;  // [m/s], > 0
  std::array<Disc, kDiscs> discs_;
};

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

  /// The parameters that a law points to must stay what they are as long as the pointer is used.
  void compute(const CrowdState& crowd, WorkerPool& workers);
  /// Of each person, by index [m/s²]; zero without a law.
  const std::vector<Vec2>& forces() const { return forces_; }

 private:
  struct KnownLaw {  // of one person; spares a look into memory all over the place
    const ForceParameters* parameters = nullptr;
    std::size_t shape = 0;
    double socialFactor = 0.0;
  };
  struct Batch {  // of people with the same law
    CrowdLaw law;
    std::size_t shape = 0;
    std::vector<std::size_t> slots;
    std::vector<CrowdReceiver> receivers;
    std::vector<CrowdSpan> spans;
    std::vector<CrowdResult> results;
    int spanCount = 0, candidates = 0;
  };
  struct alignas(64) Scratch {  // of one thread
    // Not written before they are used, as most of them never are: that takes no memory.
    std::unique_ptr<float[]> x, y, vx, vy, fx, fy;
    std::unique_ptr<int[]> word, wordAt, slot, touching, doubtful;
    std::size_t size = 0;  // of these
    Batch batch;
    void resize(std::size_t candidates, std::size_t rows);
    CrowdPairs pairs();
  };

  bool hasNewLaws(const CrowdState& crowd, WorkerPool& workers);
  void sortShapes(const CrowdState& crowd);
  std::size_t findShape(const ForceParameters& parameters);
  void prepareReach();
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
  std::vector<ForceParameters> shapes_;  // what people have in common who feel alike
  std::vector<KnownLaw> known_;          // by person
  SpeedBound fastest_;
  std::vector<CrowdReach> reaches_;  // by shape
  std::vector<Scratch> scratches_;   // by thread
  std::vector<Vec2> forces_;
};

}  // namespace sim2d
