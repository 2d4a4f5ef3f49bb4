#include "sim2d/world/crowd/CrowdForces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <xmmintrin.h>

#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

constexpr double kLeftOut = 5e-5;  // of k_s
constexpr std::size_t kMostReaches = 8;
constexpr std::size_t kMostShapes = 64;
constexpr std::size_t kBatch = 16;               // people
constexpr std::size_t kForceSlice = 2 * kBatch;  // people a thread takes before it asks for more
constexpr std::size_t kLookSlice = 256;          // people
constexpr std::size_t kMostCandidates = 8192;    // of a batch, but of one person more

/// Numbers too small for a normal float count as zero, so that they cost no time.
class ZeroForTiny {
 public:
  ZeroForTiny() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040U);  // flush to zero, denormals are zero
  }
  ~ZeroForTiny() { _mm_setcsr(before_); }
  ZeroForTiny(const ZeroForTiny&) = delete;
  ZeroForTiny& operator=(const ZeroForTiny&) = delete;
  ZeroForTiny(ZeroForTiny&&) = delete;
  ZeroForTiny& operator=(ZeroForTiny&&) = delete;

 private:
  unsigned before_;
};

}  // namespace

void CrowdForces::Batch::clear() {
  slots.clear();
  receivers.clear();
  spanCount = 0;
  candidates = 0;
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
  for (Column<float>* column : {&x, &y, &vx, &vy, &fx, &fy}) {
    column->resize(size);
  }
  for (Column<int>* column : {&word, &wordAt, &slot, &touching, &doubtful}) {
    column->resize(size);
  }
}

CrowdPairs CrowdForces::Scratch::pairs() {
  return {word.data(), wordAt.data(), x.data(),  y.data(),        vx.data(),      vy.data(),
          slot.data(), fx.data(),     fy.data(), touching.data(), doubtful.data()};
}

CrowdForces::CrowdForces(VectorPath path) : kernel_(kernelOf(path)), cutOff_(cutOff(kLeftOut)) {}

void CrowdForces::compute(const CrowdState& crowd, WorkerPool& workers) {
  forces_.resize(crowd.walkers.size(), Vec2::Zero());
  known_.resize(crowd.walkers.size());
  cells_.rebuild(crowd.walkers, crowd.present, crowd.room, workers);
  if (cells_.count() == 0) {
    return;
  }
  if (hasNewLaws(crowd, workers)) {
    sortShapes(crowd);
  }
  prepareReach();
  scratches_.resize(workers.threadCount());
  workers.forSlices(cells_.count(), kForceSlice,
                    [&](std::size_t thread, std::size_t begin, std::size_t end) {
                      computeSlots(crowd, begin, end, scratches_[thread]);
                    });
}

void CrowdForces::computeSlots(const CrowdState& crowd, std::size_t begin, std::size_t end,
                               Scratch& scratch) {
  const ZeroForTiny mode;
  scratch.resize(kMostCandidates, cells_.rowCount());
  for (std::size_t slot = begin; slot < end; ++slot) {
    if (crowd.laws[cells_.personIn(slot)].parameters != nullptr) {
      addToBatch(crowd, slot, scratch);
    }
  }
  computeBatch(crowd, scratch);
}

/// Also sets the forces of those who feel none.
bool CrowdForces::hasNewLaws(const CrowdState& crowd, WorkerPool& workers) {
  std::atomic<bool> hasNew{false};
  workers.forSlices(known_.size(), kLookSlice,
                    [&](std::size_t /*thread*/, std::size_t begin, std::size_t end) {
                      bool isNew = false;
                      for (std::size_t i = begin; i < end; ++i) {
                        const ForceParameters* const parameters = crowd.laws[i].parameters;
                        isNew = isNew || known_[i].parameters != parameters;
                        if (parameters == nullptr || crowd.present[i] == 0) {
                          writeNew(forces_[i], Vec2(Vec2::Zero()));
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
    const ForceParameters* const parameters = crowd.laws[i].parameters;
    if (known_[i].parameters == parameters) {
      continue;
    }
    known_[i] = parameters == nullptr
                    ? KnownLaw{}
                    : KnownLaw{parameters, findShape(*parameters), parameters->socialFactor};
  }
}

int CrowdForces::findShape(const ForceParameters& parameters) {
  const auto found = std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& shape) {
    return haveOneShape(shape.parameters, parameters) &&
           shape.parameters.epsilon == parameters.epsilon;
  });
  if (found != shapes_.end()) {
    return static_cast<int>(found - shapes_.begin());
  }
  if (shapes_.size() == kMostShapes) {
    return kOther;
  }
  shapes_.push_back({parameters, -1});
  return static_cast<int>(shapes_.size()) - 1;
}

/// One for each shape, as long as there are few of them.
void CrowdForces::prepareReach() {
  if (fastest_.update(cells_.fastest(), cells_.count())) {
    reaches_.clear();
    for (Shape& shape : shapes_) {
      shape.reach = -1;
    }
  }
  for (Shape& shape : shapes_) {
    if (shape.reach >= 0) {
      continue;
    }
    const auto found = std::find_if(reaches_.begin(), reaches_.end(), [&](const CrowdReach& reach) {
      return haveOneShape(reach.parameters(), shape.parameters);
    });
    if (found == reaches_.end() && reaches_.size() == kMostReaches) {
      continue;
    }
    shape.reach = static_cast<int>(found - reaches_.begin());
    if (found == reaches_.end()) {
      reaches_.emplace_back(shape.parameters, cutOff_, fastest_.value());
    }
  }
}

CrowdReach::Disc CrowdForces::discOf(const ForceParameters& parameters, int shape,
                                     double speed) const {
  const int reach = shape == kOther ? -1 : shapes_[static_cast<std::size_t>(shape)].reach;
  return reach >= 0
             ? reaches_[static_cast<std::size_t>(reach)].discOf(speed)
             : CrowdReach::Disc{0.0, socialRange(parameters, speed, cells_.fastest(), cutOff_)};
}

/// Whether somebody may join the others of a batch.
bool CrowdForces::fits(const SocialLaw& law, int shape, bool looksForWalls,
                       const Batch& batch) const {
  if (batch.slots.empty()) {
    return true;
  }
  if (batch.slots.size() == kBatch || looksForWalls != batch.law.looksForWalls ||
      shape != batch.shape) {
    return false;
  }
  return shape != kOther || (haveOneShape(*law.parameters, *batch.parameters) &&
                             law.parameters->epsilon == batch.parameters->epsilon);
}

CrowdLaw CrowdForces::lawOf(const ForceParameters& parameters, bool looksForWalls) const {
  CrowdLaw result;
  result.lambda = static_cast<float>(parameters.lambda);
  result.gamma = static_cast<float>(parameters.gamma);
  result.n = static_cast<float>(parameters.n);
  result.nPrime = static_cast<float>(parameters.nPrime);
  result.epsilon = static_cast<float>(parameters.epsilon);
  result.cutOff = static_cast<float>(cutOff_);
  result.leastLooked = static_cast<float>(kLeftOut);
  result.looksForWalls = looksForWalls;
  return result;
}

void CrowdForces::addToBatch(const CrowdState& crowd, std::size_t slot, Scratch& scratch) {
  const std::size_t person = cells_.personIn(slot);
  const SocialLaw& law = crowd.laws[person];
  const CrowdColumns columns = cells_.columns();
  const float vx = columns.vx[slot];
  const float vy = columns.vy[slot];
  const float speed = std::sqrt(vx * vx + vy * vy);
  const int shape = known_[person].shape;
  const CrowdReach::Disc disc = discOf(*law.parameters, shape, speed);
  const bool looks = !law.goesThroughWalls && crowd.room[person] < disc.ahead + disc.radius;
  Batch& batch = scratch.batch;
  if (!fits(law, shape, looks, batch)) {
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
    // Of a known shape all is near in memory.
    batch.parameters =
        shape == kOther ? law.parameters : &shapes_[static_cast<std::size_t>(shape)].parameters;
    batch.law = lawOf(*batch.parameters, looks);
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
  batch.clear();
}

/// What needs to know the walls or the ids of people.
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
    force += forceOfTouching(crowd, slot, scratch.batch, scratch.batch.receivers[receiver]);
  }
}

/// Of those in the same place, whom the kernel leaves out.
Vec2 CrowdForces::forceOfTouching(const CrowdState& crowd, std::size_t slot, const Batch& batch,
                                  const CrowdReceiver& receiver) const {
  Vec2 force = Vec2::Zero();
  const std::size_t person = cells_.personIn(slot);
  const SocialLaw& law = crowd.laws[person];
  const CrowdColumns columns = cells_.columns();
  for (int k = receiver.firstSpan; k < receiver.lastSpan; ++k) {
    const CrowdSpan span = batch.spans[static_cast<std::size_t>(k)];
    for (auto at = static_cast<std::size_t>(span.first); at < static_cast<std::size_t>(span.last);
         ++at) {
      const float dx = columns.x[at] - columns.x[slot];
      const float dy = columns.y[at] - columns.y[slot];
      const std::size_t other = cells_.personIn(at);
      if (other == person || !(dx * dx + dy * dy <= kCrowdTouching * kCrowdTouching)) {
        continue;
      }
      if (law.goesThroughWalls || crowd.isVisible(person, other)) {
        force += socialForce(*law.parameters, crowd.walkers[person], crowd.walkers[other]);
      }
    }
  }
  return force;
}

}  // namespace sim2d
