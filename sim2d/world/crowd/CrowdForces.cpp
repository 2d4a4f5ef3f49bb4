#include "sim2d/world/crowd/CrowdForces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <xmmintrin.h>

#include "sim2d/world/StepBuffers.h"
#include "sim2d/world/crowd/CrowdKernel.h"

namespace sim2d {
namespace {

constexpr double kForceCutOff = 5e-5;            // of k_s; forces below are ignored
constexpr std::size_t kBatch = 16;               // people
constexpr std::size_t kForceSlice = 2 * kBatch;  // people per work slice
constexpr std::size_t kKnownSlice = 256;         // people
constexpr std::size_t kMostCandidates = 8192;    // per batch, except batches of one person

// Discretisation of a reach:
constexpr int kDirections = 12;        // steps from straight ahead to straight back
constexpr int kVelocities = 8;         // steps along each half axis of the other's velocity
constexpr int kCentreSteps = 24;       // tested positions of the disc centre
constexpr double kReachMargin = 0.25;  // [m]; covers the discretisation error

// Parameters of the speed bound:
constexpr double kSpeedSpare = 0.25;              // [m/s] above the maximum while it may still grow
constexpr double kSteadySpare = 0.03;             // [m/s], afterwards
constexpr double kMaxSpeedSpare = 0.08;           // [m/s] above the maximum
constexpr std::size_t kRebuildThreshold = 50000;  // people computed with a too wide bound

/// Treats subnormal floats as zero, because they are slow.
class FlushDenormals {
 public:
  FlushDenormals() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040U);  // flush to zero, denormals are zero
  }
  ~FlushDenormals() { _mm_setcsr(before_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;
  FlushDenormals(FlushDenormals&&) = delete;
  FlushDenormals& operator=(FlushDenormals&&) = delete;

 private:
  unsigned before_;
};

/// True if the parameters are equal except for the force factor.
bool haveSameShape(const ForceParameters& a, const ForceParameters& b) {
  return a.lambda == b.lambda && a.gamma == b.gamma && a.n == b.n && a.nPrime == b.nPrime &&
         a.epsilon == b.epsilon;
}

}  // namespace

bool SpeedBound::update(double fastest, std::size_t people) {
  const double before = value_;
  if (fastest > value_) {
    value_ = fastest + kSpeedSpare;
    excessCount_ = 0;
  } else if (fastest + kMaxSpeedSpare > value_) {
    excessCount_ = 0;
  } else {
    largest_ = excessCount_ == 0 ? fastest : std::max(largest_, fastest);
    excessCount_ += people;
    if (excessCount_ > kRebuildThreshold) {
      value_ = largest_ + kSteadySpare;
      excessCount_ = 0;
    }
  }
  return value_ != before;
}

CrowdReach::CrowdReach(const ForceParameters& parameters, double cutOff, double fastest)
    : parameters_(parameters), cutOff_(cutOff), fastest_(fastest) {
  for (std::size_t i = 0; i < kDiscs; ++i) {
    const double step = fastest_ / static_cast<double>(kDiscs);
    discs_[i] = discFor(step * static_cast<double>(i), step * static_cast<double>(i + 1));
  }
}

const CrowdReach::Disc& CrowdReach::discOf(double speed) const {
  const double place = speed / fastest_ * static_cast<double>(kDiscs);
  return discs_[std::min(static_cast<std::size_t>(place), kDiscs - 1)];
}

/// Distance beyond which `isNegligible` holds for an interaction vector with these components
/// along and across the line to the other; a sharper bound for angles above a quarter turn [m].
double CrowdReach::interactionBound(double along, double across) const {
  const double side = std::min(parameters_.n, parameters_.nPrime) * parameters_.gamma;
  const double length2 = along * along + across * across;
  const double turned = along < 0.0 ? side * side * base::kPi * base::kPi / 4.0 * length2
                                    : side * side * across * across;
  return parameters_.gamma * std::sqrt(length2) * std::max(0.0, cutOff_ - turned);
}

/// Maximum over all velocities of the other, in one direction from a person who walks along x.
double CrowdReach::farthestAt(double cosine, double sine, double speed) const {
  double farthest = 0.0;
  for (int i = -kVelocities; i <= kVelocities; ++i) {
    const double along = fastest_ * i / kVelocities;
    const double most = std::sqrt(std::max(0.0, fastest_ * fastest_ - along * along));
    for (int k = -kVelocities; k <= kVelocities; ++k) {
      const double across = most * k / kVelocities;
      farthest =
          std::max(farthest, interactionBound(parameters_.lambda * (speed * cosine - along) + 1.0,
                                              parameters_.lambda * (speed * sine - across)));
    }
  }
  return farthest;
}

/// The smallest tested disc that contains all relevant people, for all speeds in between.
CrowdReach::Disc CrowdReach::discFor(double low, double high) const {
  std::array<Vec2, kDirections + 1> border;
  double ahead = 0.0;
  for (int i = 0; i <= kDirections; ++i) {
    const Vec2 direction = base::directionOf(base::kPi * i / kDirections);
    double farthest = 0.0;
    for (const double speed : {low, (low + high) / 2.0, high}) {
      farthest = std::max(farthest, farthestAt(direction.x(), direction.y(), speed));
    }
    border[static_cast<std::size_t>(i)] = farthest * direction;
    ahead = std::max(ahead, farthest);
  }
  Disc best{0.0, ahead};
  for (int i = 1; i <= kCentreSteps; ++i) {
    const Vec2 middle(ahead / 2.0 * i / kCentreSteps, 0.0);
    double radius = 0.0;
    for (const Vec2& point : border) {
      radius = std::max(radius, (point - middle).norm());
    }
    best = radius < best.radius ? Disc{middle.x(), radius} : best;
  }
  best.radius += kReachMargin;
  return best;
}

void CrowdForces::Scratch::resize(std::size_t candidates, std::size_t rows) {
  const std::size_t padded = candidates + (kBatch + rows) * static_cast<std::size_t>(kCrowdSpare);
  batch.slots.reserve(kBatch);
  batch.receivers.reserve(kBatch);
  batch.results.resize(kBatch);
  batch.spans.resize(std::max(batch.spans.size(), kBatch * rows));
  if (padded <= size) {
    return;
  }
  size = padded;
  for (std::unique_ptr<float[]>* column : {&x, &y, &vx, &vy, &fx, &fy}) {
    column->reset(new float[size]);
  }
  for (std::unique_ptr<int[]>* column : {&word, &wordAt, &slot, &touching, &doubtful}) {
    column->reset(new int[size]);
  }
}

CrowdPairs CrowdForces::Scratch::pairs() {
  return {word.get(), wordAt.get(), x.get(),  y.get(),        vx.get(),      vy.get(),
          slot.get(), fx.get(),     fy.get(), touching.get(), doubtful.get()};
}

CrowdForces::CrowdForces(SimdLevel path)
    : kernel_(crowdKernelFor(path)), cutOff_(cutOff(kForceCutOff)) {}

void CrowdForces::compute(const CrowdState& crowd, WorkerPool& workers) {
  forces_.resize(crowd.walkers.size(), Vec2::Zero());
  known_.resize(crowd.walkers.size());
  cells_.rebuild(crowd.walkers, crowd.present, crowd.room, workers);
  if (cells_.count() == 0) {
    return;
  }
  if (updateForceModels(crowd, workers)) {
    sortShapes(crowd);
  }
  prepareReach();
  scratches_.resize(workers.threadCount());
  workers.parallelFor(cells_.count(), kForceSlice,
                      [&](std::size_t thread, std::size_t begin, std::size_t end) {
                        computeSlots(crowd, begin, end, scratches_[thread]);
                      });
}

void CrowdForces::computeSlots(const CrowdState& crowd, std::size_t begin, std::size_t end,
                               Scratch& scratch) {
  const FlushDenormals mode;
  scratch.resize(kMostCandidates, cells_.rowCount());
  for (std::size_t slot = begin; slot < end; ++slot) {
    if (crowd.forceModels[cells_.personIn(slot)].parameters != nullptr) {
      addToBatch(crowd, slot, scratch);
    }
  }
  computeBatch(crowd, scratch);
}

/// Also zeroes the forces of people who feel none.
bool CrowdForces::updateForceModels(const CrowdState& crowd, WorkerPool& workers) {
  std::atomic<bool> hasNew{false};
  workers.parallelFor(known_.size(), kKnownSlice,
                      [&](std::size_t /*thread*/, std::size_t begin, std::size_t end) {
                        bool isNew = false;
                        for (std::size_t i = begin; i < end; ++i) {
                          const ForceParameters* const parameters = crowd.forceModels[i].parameters;
                          isNew = isNew || known_[i].parameters != parameters;
                          if (parameters == nullptr || crowd.present[i] == 0) {
                            assignIfChanged(forces_[i], Vec2(Vec2::Zero()));
                          }
                        }
                        if (isNew) {
                          hasNew = true;
                        }
                      });
  return hasNew;
}

void CrowdForces::sortShapes(const CrowdState& crowd) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const ForceParameters* const parameters = crowd.forceModels[i].parameters;
    if (known_[i].parameters == parameters) {
      continue;
    }
    known_[i] = parameters == nullptr ? CachedForceModel{}
                                      : CachedForceModel{parameters, findShape(*parameters),
                                                         parameters->socialFactor};
  }
}

std::size_t CrowdForces::findShape(const ForceParameters& parameters) {
  const auto found =
      std::find_if(shapes_.begin(), shapes_.end(),
                   [&](const ForceParameters& shape) { return haveSameShape(shape, parameters); });
  const auto place = static_cast<std::size_t>(found - shapes_.begin());
  if (found == shapes_.end()) {
    shapes_.push_back(parameters);
  }
  return place;
}

void CrowdForces::prepareReach() {
  if (fastest_.update(cells_.fastest(), cells_.count())) {
    reaches_.clear();
  }
  while (reaches_.size() < shapes_.size()) {
    reaches_.emplace_back(shapes_[reaches_.size()], cutOff_, fastest_.value());
  }
}

CrowdForceParameters CrowdForces::crowdForceParameters(const ForceParameters& parameters,
                                                       bool testsWalls) const {
  return {static_cast<float>(parameters.lambda),  static_cast<float>(parameters.gamma),
          static_cast<float>(parameters.n),       static_cast<float>(parameters.nPrime),
          static_cast<float>(parameters.epsilon), static_cast<float>(cutOff_),
          static_cast<float>(kForceCutOff),       testsWalls};
}

void CrowdForces::addToBatch(const CrowdState& crowd, std::size_t slot, Scratch& scratch) {
  const std::size_t person = cells_.personIn(slot);
  const CrowdForceModel& law = crowd.forceModels[person];
  const CrowdColumns columns = cells_.columns();
  const float vx = columns.vx[slot];
  const float vy = columns.vy[slot];
  const float speed = std::sqrt(vx * vx + vy * vy);
  const std::size_t shape = known_[person].shape;
  const CrowdReach::Disc disc = reaches_[shape].discOf(speed);
  const bool looks = !law.goesThroughWalls && crowd.room[person] < disc.ahead + disc.radius;
  Batch& batch = scratch.batch;
  const bool fits =
      batch.slots.size() < kBatch && looks == batch.law.testsWalls && shape == batch.shape;
  if (!fits && !batch.slots.empty()) {
    computeBatch(crowd, scratch);
  }
  const float ahead = speed > 0.0F ? static_cast<float>(disc.ahead) / speed : 0.0F;  // [s]
  CrowdReceiver receiver{columns.x[slot], columns.y[slot], vx, vy, columns.room[slot], 0, 0};
  const float x = receiver.x + ahead * vx;
  const float y = receiver.y + ahead * vy;
  const auto radius = static_cast<float>(disc.radius);
  const auto writeSpans = [&] {
    CrowdSpan* const spans = batch.spans.data();
    int candidates = 0;
    receiver.firstSpan = batch.spanCount;
    receiver.lastSpan = static_cast<int>(
        cells_.writeSpans(x, y, radius, spans + batch.spanCount, candidates) - spans);
    return candidates;
  };
  int candidates = writeSpans();
  const int wanted = batch.candidates + candidates;
  if (static_cast<std::size_t>(wanted) > kMostCandidates) {
    computeBatch(crowd, scratch);
    candidates = writeSpans();
    scratch.resize(static_cast<std::size_t>(candidates), cells_.rowCount());
  }
  if (batch.slots.empty()) {
    batch.law = crowdForceParameters(shapes_[shape], looks);
    batch.shape = shape;
  }
  batch.spanCount = receiver.lastSpan;
  batch.candidates += candidates;
  batch.slots.push_back(slot);
  batch.receivers.push_back(receiver);
}

void CrowdForces::computeBatch(const CrowdState& crowd, Scratch& scratch) {
  Batch& batch = scratch.batch;
  kernel_.forces(cells_.columns(),
                 {batch.law, batch.receivers.data(), static_cast<int>(batch.receivers.size()),
                  batch.spans.data(), batch.results.data()},
                 scratch.pairs());
  for (std::size_t i = 0; i < batch.slots.size(); ++i) {
    finish(crowd, i, scratch);
  }
  batch.slots.clear();
  batch.receivers.clear();
  batch.spanCount = batch.candidates = 0;
}

/// Applies what requires walls or ids of people.
void CrowdForces::finish(const CrowdState& crowd, std::size_t receiver, Scratch& scratch) {
  const CrowdPairs pairs = scratch.pairs();
  const std::size_t slot = scratch.batch.slots[receiver];
  const std::size_t person = cells_.personIn(slot);
  CrowdResult& result = scratch.batch.results[receiver];
  if (result.firstDoubtful < result.lastDoubtful) {
    for (int i = result.firstDoubtful; i < result.lastDoubtful; ++i) {
      const int pair = pairs.doubtful[i];
      if (!crowd.isVisible(person, cells_.personIn(static_cast<std::size_t>(pairs.slot[pair])))) {
        pairs.fx[pair] = pairs.fy[pair] = 0.0F;
      }
    }
    kernel_.sum(pairs, result);
  }
  Vec2& force = forces_[person];
  force = known_[person].socialFactor *
          Vec2(static_cast<double>(result.x), static_cast<double>(result.y));
  if (result.touching > 1) {
    force += coincidentForce(crowd, slot, scratch.batch, scratch.batch.receivers[receiver]);
  }
}

/// Force of people at the same position, which the kernel skips.
Vec2 CrowdForces::coincidentForce(const CrowdState& crowd, std::size_t slot, const Batch& batch,
                                  const CrowdReceiver& receiver) const {
  Vec2 force = Vec2::Zero();
  const std::size_t person = cells_.personIn(slot);
  const CrowdForceModel& law = crowd.forceModels[person];
  const CrowdColumns columns = cells_.columns();
  for (int k = receiver.firstSpan; k < receiver.lastSpan; ++k) {
    const CrowdSpan span = batch.spans[static_cast<std::size_t>(k)];
    for (auto at = static_cast<std::size_t>(span.first); at < static_cast<std::size_t>(span.last);
         ++at) {
      const float dx = columns.x[at] - columns.x[slot];
      const float dy = columns.y[at] - columns.y[slot];
      const std::size_t other = cells_.personIn(at);
      if (other == person || !(dx * dx + dy * dy <= kCoincidentDistance * kCoincidentDistance)) {
        continue;
      }
      if (law.goesThroughWalls || crowd.isVisible(person, other)) {
        force += socialForce(*law.parameters, crowd.walkers[person], crowd.walkers[other]);
      }
    }
  }
  return force;
}

const char* simdLevelName(SimdLevel path) {
  constexpr std::array<const char*, 3> kNames = {"SSE2", "AVX2", "AVX-512"};
  return kNames[static_cast<std::size_t>(path)];
}

bool isSimdLevelSupported(SimdLevel path) {
  const std::array<bool, 3> isThere = {true, __builtin_cpu_supports("avx2") != 0,
                                       __builtin_cpu_supports("avx512f") != 0};
  return isThere[static_cast<std::size_t>(path)];
}

SimdLevel fastestSimdLevel() {
  if (isSimdLevelSupported(SimdLevel::Avx512)) {
    return SimdLevel::Avx512;
  }
  return isSimdLevelSupported(SimdLevel::Avx2) ? SimdLevel::Avx2 : SimdLevel::Sse2;
}

CrowdKernel crowdKernelFor(SimdLevel path) {
  constexpr std::array<CrowdKernel (*)(), 3> kKernels = {crowdKernelSse2, crowdKernelAvx2,
                                                         crowdKernelAvx512};
  return kKernels[static_cast<std::size_t>(path)]();
}

}  // namespace sim2d
