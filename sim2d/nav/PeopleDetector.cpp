#include "sim2d/nav/PeopleDetector.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/base/Types.h"

namespace sim2d {

void ConstantVelocityFilter::start(const Vec2& place) {
  position_ = place;
  velocity_ = Vec2::Zero();
  pp_ = positionVariance_;
  pv_ = 0.0;
  vv_ = 1.0;
}

void ConstantVelocityFilter::predict(double duration) {
  const double t = duration;
  const double q = accelerationPower_;
  position_ += t * velocity_;
  pp_ += t * (2.0 * pv_ + t * vv_) + q * t * t * t / 3.0;
  pv_ += t * vv_ + q * t * t / 2.0;
  vv_ += q * t;
}

void ConstantVelocityFilter::correct(const Vec2& place) {
  const double variance = pp_ + positionVariance_;  // S
  if (variance <= 0.0) {  // two measurements at the same time without noise
    return;
  }
  const double forPosition = pp_ / variance;
  const double forVelocity = pv_ / variance;
  const Vec2 innovation = place - position_;
  position_ += forPosition * innovation;
  velocity_ += forVelocity * innovation;
  vv_ -= forVelocity * pv_;
  pv_ -= forPosition * pv_;
  pp_ -= forPosition * pp_;
}

namespace {

/// Calls visit(low, high) for the one or two parts of the interval within [-pi, pi].
template <class Visit>
void forUnwrappedParts(double from, double width, Visit visit) {
  constexpr double kTurn = 2.0 * base::kPi;
  if (width >= kTurn) {
    visit(-base::kPi, base::kPi);
    return;
  }
  double low = base::wrapToPi(from);
  low = low == base::kPi ? -base::kPi : low;
  const double high = low + width;
  visit(low, std::min(high, base::kPi));
  if (high > base::kPi) {
    visit(-base::kPi, high - kTurn);
  }
}

}  // namespace

void AngularIntervalSet::add(double from, double width) {
  forUnwrappedParts(from, width, [this](double low, double high) { addUnwrapped(low, high); });
}

double AngularIntervalSet::covered(double from, double width) const {
  double sum = 0.0;
  forUnwrappedParts(from, width,
                    [&](double low, double high) { sum += coveredUnwrapped(low, high); });
  return sum;
}

void AngularIntervalSet::addUnwrapped(double low, double high) {
  const auto first = std::lower_bound(intervals_.begin(), intervals_.end(), low,
                                      [](const Interval& i, double at) { return i.high < at; });
  auto last = first;
  for (; last != intervals_.end() && last->low <= high; ++last) {
  }
  if (first == last) {
    intervals_.insert(first, {low, high});
    return;
  }
  const Interval joined{std::min(low, first->low), std::max(high, std::prev(last)->high)};
  *first = joined;
  intervals_.erase(std::next(first), last);
}

double AngularIntervalSet::coveredUnwrapped(double low, double high) const {
  auto at = std::lower_bound(intervals_.begin(), intervals_.end(), low,
                             [](const Interval& i, double angle) { return i.high < angle; });
  double sum = 0.0;
  for (; at != intervals_.end() && at->low < high; ++at) {
    sum += std::min(at->high, high) - std::max(at->low, low);
  }
  return sum;
}

namespace {

constexpr double kAllAround = 2.0 * base::kPi;
constexpr double kHeadingSpeed = 0.2;   // [m/s]; slower tracks keep their heading
constexpr double kTimeRounding = 1e-9;  // [s], rounding of step times

enum class DetectorDraw : std::uint32_t { Miss, ErrorX, ErrorY, Swap };

std::uint32_t detectorIndex(DetectorDraw purpose, std::uint32_t what) {
  return (static_cast<std::uint32_t>(purpose) << 28U) | (what & 0xFFFFFFFU);
}

std::uint32_t bodyIndex(DetectorDraw purpose, const SensedBody& body) {
  const std::uint32_t kind = body.kind == BodyKind::Robot ? 1U << 27U : 0U;
  return detectorIndex(purpose, kind | (static_cast<std::uint32_t>(body.id) & 0x7FFFFFFU));
}

/// Hash of two ids, which do not fit into one draw index; collisions are rare.
std::uint32_t pairIndex(int first, int second) {
  const auto mixed = base::philox4x32(
      {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), 0U, 0U}, {0U, 0U});
  return detectorIndex(DetectorDraw::Swap, mixed[0]);
}

bool isTrackBefore(const TrackedBody& a, const TrackedBody& b) {
  return std::tie(a.kind, a.id) < std::tie(b.kind, b.id);
}

/// Pairs of people closer than `distance`, as (lower, higher id), ascending.
std::vector<std::pair<int, int>> closePairs(std::vector<const SensedBody*> people,
                                            double distance) {
  std::sort(people.begin(), people.end(), [](const SensedBody* a, const SensedBody* b) {
    return a->position.x() < b->position.x();
  });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const Vec2& place = people[i]->position;
    for (std::size_t j = i + 1; j < people.size() && people[j]->position.x() - place.x() < distance;
         ++j) {
      if ((people[j]->position - place).norm() < distance) {
        pairs.push_back(std::minmax({people[i]->id, people[j]->id}));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

DetectorParameters groundTruthDetector() {
  DetectorParameters parameters = idealDetector();
  parameters.range = std::numeric_limits<double>::infinity();
  parameters.isOccluded = false;
  parameters.coastTime = 0.0;
  return parameters;
}

DetectorParameters idealDetector() {
  DetectorParameters parameters;
  parameters.rate = 0.0;
  parameters.latency = 0.0;
  parameters.noise = 0.0;
  parameters.misses = 0.0;
  parameters.swaps = 0.0;
  parameters.measuresVelocity = true;
  return parameters;
}

PeopleDetector::PeopleDetector(const DetectorParameters& parameters, std::uint64_t seed,
                               int robotId)
    : parameters_(parameters), seed_(seed), robotId_(robotId) {
  assert(parameters.range > 0.0 && parameters.rate >= 0.0 && parameters.latency >= 0.0);
  assert(parameters.noise >= 0.0 && parameters.accelerationPower > 0.0);
}

void PeopleDetector::update(const SensedWorld& world) {
  if (beginCycle(world.time)) {
    detect(world);
  }
  auto next = pendingCycles_.begin();
  for (; next != pendingCycles_.end() &&
         next->time + parameters_.latency <= world.time + kTimeRounding;
       ++next) {
    report(*next);
  }
  std::move(pendingCycles_.begin(), next, std::back_inserter(reusedCycles_));
  pendingCycles_.erase(pendingCycles_.begin(), next);
}

bool PeopleDetector::beginCycle(double time) {
  const std::int64_t due =
      parameters_.rate > 0.0 ? eventIndexAt(time, parameters_.rate) : cycle_ + 1;
  const bool isDue = due > cycle_;
  cycle_ = std::max(cycle_, due);
  return isDue;
}

/// Uniform in [0, 1), for this cycle.
double PeopleDetector::uniformDraw(std::uint32_t index) const {
  return base::AgentRng(seed_, robotId_, static_cast<std::uint64_t>(cycle_))
      .uniform01(base::DrawPurpose::Detector, index);
}

void PeopleDetector::detect(const SensedWorld& world) {
  findBodiesInSight(world);
  const auto isMissed = [&](std::size_t i) {
    return parameters_.misses > 0.0 &&
           uniformDraw(bodyIndex(DetectorDraw::Miss, world.bodies[i])) < parameters_.misses;
  };
  seen_.erase(std::remove_if(seen_.begin(), seen_.end(), isMissed), seen_.end());
  swapTracks(world.bodies);
  if (reusedCycles_.empty()) {
    reusedCycles_.emplace_back();
  }
  Cycle& cycle = pendingCycles_.emplace_back(std::move(reusedCycles_.back()));
  reusedCycles_.pop_back();
  cycle.time = world.time;
  cycle.seen.clear();
  cycle.seen.reserve(seen_.size());
  for (const std::size_t i : seen_) {
    cycle.seen.push_back(measurementOf(world, world.bodies[i]));
  }
  std::sort(cycle.seen.begin(), cycle.seen.end(), isTrackBefore);
}

/// All other bodies in range; sorted by distance if occlusion is simulated.
void PeopleDetector::findCandidates(const SensedWorld& world) {
  const Vec2& eye = world.pose.position;
  candidates_.clear();
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const SensedBody& body = world.bodies[i];
    const Vec2 offset = body.position - eye;
    const double distance = offset.norm();
    const bool isSelf = body.kind == BodyKind::Robot && body.id == robotId_;
    if (isSelf || distance > parameters_.range) {
      continue;
    }
    candidates_.push_back({i, distance, 0.0, 0.0});
    if (parameters_.isOccluded) {
      setAngularSpan(candidates_.back(), eye, body);
    }
  }
  if (parameters_.isOccluded) {
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.distance, a.number) < std::tie(b.distance, b.number);
    });
  }
}

/// Sets the angular interval of the body about the bearing of its centre.
void PeopleDetector::setAngularSpan(Candidate& candidate, const Vec2& eye, const SensedBody& body) {
  const double bearing = base::headingOf(body.position - eye);
  double left = 0.0;
  double right = 0.0;
  if (body.footprint != nullptr && !body.footprint->isDisc()) {
    for (const Vec2& corner : body.footprint->corners) {
      const Vec2 offset = body.pose().toWorld(corner) - eye;
      const double aside = base::angleDiff(base::headingOf(offset), bearing);
      right = std::min(right, aside);
      left = std::max(left, aside);
    }
  } else if (candidate.distance > body.radius) {
    left = base::kPi / 2.0 - base::acos(body.radius / candidate.distance);
    right = -left;
  } else {
    left = base::kPi;
    right = -base::kPi;
  }
  candidate.from = bearing + right;
  candidate.width = left - right;
}

void PeopleDetector::findBodiesInSight(const SensedWorld& world) {
  findCandidates(world);
  occludedAngles_.clear();
  seen_.clear();
  for (const Candidate& candidate : candidates_) {
    if (isInSight(candidate, world)) {
      seen_.push_back(candidate.number);
    }
    if (parameters_.isOccluded) {
      occludedAngles_.add(candidate.from, candidate.width);
    }
  }
}

bool PeopleDetector::isInSight(const Candidate& candidate, const SensedWorld& world) const {
  const Vec2& place = world.bodies[candidate.number].position;
  if (!isInFieldOfView(world.pose, place)) {
    return false;
  }
  if (!parameters_.isOccluded) {
    return true;
  }
  const double hidden = occludedAngles_.covered(candidate.from, candidate.width);
  return hidden <= parameters_.maxOcclusion * candidate.width &&
         world.obstacles.isVisible(world.pose.position, place);
}

bool PeopleDetector::isInFieldOfView(const Pose2& eye, const Vec2& place) const {
  if (parameters_.field >= kAllAround) {
    return true;
  }
  const double bearing = base::angleDiff(base::headingOf(place - eye.position), eye.heading);
  return std::fabs(bearing) <= 0.5 * parameters_.field;
}

TrackedBody PeopleDetector::measurementOf(const SensedWorld& world, const SensedBody& body) const {
  TrackedBody seen;
  seen.id = body.kind == BodyKind::Person ? trackOf(body.id) : body.id;
  seen.kind = body.kind;
  seen.radius = body.radius;
  seen.position = body.position;
  seen.velocity = body.velocity;
  seen.heading = body.heading;
  if (world.odometry != world.pose) {
    const double turn = world.odometry.heading - world.pose.heading;
    seen.position = world.odometry.toWorld(world.pose.toLocal(body.position));
    seen.velocity = Pose2{Vec2::Zero(), turn}.toWorld(body.velocity);
    seen.heading = base::wrapToPi(body.heading + turn);
  }
  if (parameters_.noise > 0.0) {
    const base::AgentRng rng(seed_, robotId_, static_cast<std::uint64_t>(cycle_));
    const auto error = [&](DetectorDraw axis) {
      return rng.normal(0.0, parameters_.noise, base::DrawPurpose::Detector, bodyIndex(axis, body));
    };
    seen.position += Vec2(error(DetectorDraw::ErrorX), error(DetectorDraw::ErrorY));
  }
  return seen;
}

void PeopleDetector::swapTracks(const std::vector<SensedBody>& bodies) {
  if (parameters_.swaps <= 0.0) {
    return;
  }
  std::vector<const SensedBody*> people;
  people.reserve(seen_.size());
  for (const std::size_t i : seen_) {
    if (bodies[i].kind == BodyKind::Person) {
      people.push_back(&bodies[i]);
    }
  }
  for (const auto& [first, second] : closePairs(std::move(people), parameters_.swapDistance)) {
    if (uniformDraw(pairIndex(first, second)) < parameters_.swaps) {
      int& one = trackIds_.try_emplace(first, first).first->second;
      int& other = trackIds_.try_emplace(second, second).first->second;
      std::swap(one, other);
    }
  }
}

int PeopleDetector::trackOf(int person) const {
  const auto found = trackIds_.find(person);
  return found == trackIds_.end() ? person : found->second;
}

void PeopleDetector::report(const Cycle& cycle) {
  tracksBefore_.swap(tracks_);
  tracks_.clear();
  const auto coastUntil = [&](auto old, const auto& isReached) {
    for (; old != tracksBefore_.end() && !isReached(*old); ++old) {
      coast(*old, cycle.time);
      if (!isLost(*old)) {
        tracks_.push_back(*old);
      }
    }
    return old;
  };
  auto old = tracksBefore_.begin();
  for (const TrackedBody& seen : cycle.seen) {
    old = coastUntil(old, [&](const Track& track) { return !isTrackBefore(track.body, seen); });
    if (old != tracksBefore_.end() && !isTrackBefore(seen, old->body)) {
      updateTrack(*old, seen, cycle.time);
      tracks_.push_back(*old++);
    } else {
      tracks_.push_back(newTrack(seen, cycle.time));
    }
  }
  coastUntil(old, [](const Track& /*track*/) { return false; });
  bodies_.clear();
  bodies_.reserve(tracks_.size());
  for (const Track& track : tracks_) {
    bodies_.push_back(track.body);
  }
}

PeopleDetector::Track PeopleDetector::newTrack(const TrackedBody& seen, double time) const {
  Track track{seen, ConstantVelocityFilter(parameters_.noise, parameters_.accelerationPower), time,
              time};
  track.filter.start(seen.position);
  if (!parameters_.measuresVelocity) {
    track.body.velocity = Vec2::Zero();
    track.body.heading = 0.0;
  }
  return track;
}

void PeopleDetector::updateTrack(Track& track, const TrackedBody& seen, double time) const {
  if (parameters_.measuresVelocity) {
    track.body = seen;
  } else {
    track.filter.predict(time - track.time);
    track.filter.correct(seen.position);
    track.body.position = track.filter.position();
    track.body.velocity = track.filter.velocity();
    track.body.radius = seen.radius;
    if (track.body.velocity.norm() > kHeadingSpeed) {
      track.body.heading = base::headingOf(track.body.velocity);
    }
  }
  track.time = time;
  track.lastSeen = time;
}

void PeopleDetector::coast(Track& track, double time) const {
  const double duration = time - track.time;
  track.filter.predict(duration);
  track.body.position += duration * track.body.velocity;
  track.time = time;
}

bool PeopleDetector::isLost(const Track& track) const {
  return track.time - track.lastSeen > parameters_.coastTime + kTimeRounding;
}

}  // namespace sim2d
