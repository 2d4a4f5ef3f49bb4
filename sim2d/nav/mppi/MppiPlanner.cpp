#include "sim2d/nav/mppi/MppiPlanner.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/nav/mppi/MppiUpdate.h"

namespace sim2d {
namespace {

// Lanes of the finalists; the remaining lanes also brake.
constexpr int kSmoothLane = 0, kMeanLane = 1, kBestLane = 2, kLastPlanLane = 3, kBrakeLane = 4;
static_assert(kMppiDraw == static_cast<std::uint32_t>(base::DrawPurpose::Mppi) << 24U);
constexpr int kShownSamples = 40;
constexpr int kShownStride = 4;  // steps between displayed points of a trajectory

}  // namespace

void MppiPlanner::Columns::resize(int samples, int steps) {
  count = samples;
  for (std::vector<float>& column : controls) {
    column.assign(static_cast<std::size_t>(samples) * static_cast<std::size_t>(steps), 0.0F);
  }
  costs.assign(static_cast<std::size_t>(samples), 0.0F);
  hits.assign(static_cast<std::size_t>(samples), 0.0F);
}

MppiSamples MppiPlanner::Columns::view() {
  MppiSamples samples;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    samples.controls[axis] = controls[axis].data();
  }
  samples.stride = count;
  samples.costs = costs.data();
  samples.hits = hits.data();
  return samples;
}

MppiPlanner::MppiPlanner(const PlannerSetup& setup, const MppiParameters& parameters,
                         std::optional<SocialMppiParameters> social, MppiSimdLevel path)
    : body_(setup.body),
      parameters_(parameters),
      social_(social),
      reach_(circumscribedRadius(setup.body.footprint)),
      discs_(discsCovering(setup.body.footprint)),
      kernel_(mppiKernelFor(path)) {
  problem_.steps = static_cast<int>(
      std::clamp(std::round(parameters_.steps), 2.0, static_cast<double>(kMaxMppiSteps)));
  problem_.dt = static_cast<float>(parameters_.modelDt);
  setNoise(setup.seed);
  problem_.noise.robot = static_cast<std::uint32_t>(setup.robotId);
  const double registers =
      std::ceil(std::max(parameters_.samples, 2.0 * kMppiColumns) / kMppiColumns);
  samples_.resize(static_cast<int>(registers) * kMppiColumns, problem_.steps);
  finalists_.resize(kMppiColumns, problem_.steps);
  weights_.resize(samples_.costs.size());
  scene_.firstPerson.resize(stepCount() + 1);
  setDrive();
  setCosts();
  setSocial();
  reset();
}

void MppiPlanner::setNoise(std::uint64_t seed) {
  problem_.noise.key[0] = static_cast<std::uint32_t>(seed);
  problem_.noise.key[1] = static_cast<std::uint32_t>(seed >> 32U);
}

void MppiPlanner::reseed(std::uint64_t seed) {
  setNoise(seed);
}

void MppiPlanner::reset() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    plan_[axis].assign(stepCount(), 0.0F);
    lastCommands_[axis].fill(0.0F);
  }
  waitingSince_ = -1.0;
}

base::Result<BodyTwist> MppiPlanner::command(const Observation& observation) {
  start_ = observation.pose;
  // A long robot fits where its discs fit, because it aligns with the route first.
  route_.update(observation, static_cast<double>(discs_.front().radius), 1.0);
  if (route_.isEmpty()) {
    reset();
    samples_.hits.assign(samples_.hits.size(), 0.0F);
    return BodyTwist{};
  }
  for (std::vector<float>& axis : plan_) {
    axis = shifted(axis, observation.dt / parameters_.modelDt);
  }
  updateSurroundings(observation);
  setProblem(observation);
  fillProposals();
  sample();
  update();
  ++problem_.noise.call;
  return storePlan(take(finalists_, chosen_));
}

void MppiPlanner::setProblem(const Observation& observation) {
  const Vec2& origin = observation.pose.position;
  problem_.start.cosine = static_cast<float>(base::cos(observation.pose.heading));
  problem_.start.sine = static_cast<float>(base::sin(observation.pose.heading));
  problem_.start.linear = static_cast<float>(observation.motion.linear);
  problem_.start.angular = static_cast<float>(observation.motion.angular);
  problem_.start.lateral = static_cast<float>(observation.motion.lateral);
  problem_.costs.goalRadius = static_cast<float>(observation.goalRadius);
  problem_.clearance = clearance_.view(origin);
  problem_.distance = toGo_.view(origin);
  problem_.discs = discs_.data();
  problem_.discCount = static_cast<int>(discs_.size());
  problem_.people = scene_.people.data();
  problem_.firstPerson = scene_.firstPerson.data();
  problem_.zones = scene_.zones.data();
  problem_.zoneCount = static_cast<int>(scene_.zones.size());
  const std::array<double, kAxes> deviations = {static_cast<double>(problem_.noise.linear),
                                                static_cast<double>(problem_.noise.angular),
                                                static_cast<double>(problem_.noise.lateral)};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    mppiControlCost(plan_[axis], parameters_.gamma, deviations[axis],
                    static_cast<double>(problem_.noise.keep), controlCosts_[axis]);
    problem_.mean[axis] = plan_[axis].data();
    problem_.pull[axis] = controlCosts_[axis].data();
  }
}

/// Fills the first register of samples: the last plan, braking, and constant commands (arcs; for
/// omnidirectional robots directions).
void MppiPlanner::fillProposals() {
  put(plan_, 0, samples_);
  putConstant({0.0F, 0.0F, 0.0F}, 1, samples_);
  const auto fastest = static_cast<float>(body_.limits.maxVel);
  const float turning = problem_.drive.highAngular;
  int lane = 2;
  if (problem_.drive.isOmnidirectional) {
    for (; lane < kMppiColumns; ++lane) {
      const Vec2 way = base::directionOf(2.0 * base::kPi * (lane - 2) / (kMppiColumns - 2));
      putConstant(
          {fastest * static_cast<float>(way.x()), 0.0F, fastest * static_cast<float>(way.y())},
          lane, samples_);
    }
    return;
  }
  // A standing robot can turn in place; a car reverses instead.
  const float slowest = problem_.drive.isAckermann ? 0.5F * problem_.drive.lowLinear : 0.0F;
  for (const float speed : {slowest, 0.5F * fastest, fastest}) {
    for (const float share : {-1.0F, -0.5F, 0.0F, 0.5F, 1.0F}) {
      const bool isBraking = speed == slowest && share == 0.0F;
      if (!isBraking) {
        putConstant({speed, share * turning, 0.0F}, lane, samples_);
        ++lane;
      }
    }
  }
}

void MppiPlanner::sample() {
  const MppiSamples columns = samples_.view();
  kernel_.weigh(problem_, columns, 0, kMppiColumns);
  kernel_.draw(problem_, columns, kMppiColumns, samples_.count);
}

void MppiPlanner::update() {
  mppiWeights(samples_.costs.data(), samples_.count, parameters_.temperature, weights_.data());
  Sequence mean;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    mean[axis].resize(stepCount());
    for (std::size_t step = 0; step < stepCount(); ++step) {
      const std::size_t at = step * static_cast<std::size_t>(samples_.count);
      mean[axis][step] =
          kernel_.sum(weights_.data(), samples_.controls[axis].data() + at, samples_.count);
    }
  }
  Sequence smooth;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    smooth[axis] = savitzkyGolay(mean[axis], lastCommands_[axis]);
  }
  choose(mean, smooth);
}

/// The smoothed mean, unless another finalist is cheaper by more than the temperature.
void MppiPlanner::choose(const Sequence& mean, const Sequence& smooth) {
  const auto least = std::min_element(samples_.costs.begin(), samples_.costs.end());
  const auto best = static_cast<int>(least - samples_.costs.begin());
  put(smooth, kSmoothLane, finalists_);
  put(mean, kMeanLane, finalists_);
  put(take(samples_, best), kBestLane, finalists_);
  put(plan_, kLastPlanLane, finalists_);
  for (int lane = kBrakeLane; lane < kMppiColumns; ++lane) {
    putConstant({0.0F, 0.0F, 0.0F}, lane, finalists_);
  }
  kernel_.weigh(problem_, finalists_.view(), 0, kMppiColumns);
  chosen_ = kSmoothLane;
  auto cost = finalists_.costs[kSmoothLane] - static_cast<float>(parameters_.temperature);
  for (int lane = kMeanLane; lane <= kBrakeLane; ++lane) {
    if (finalists_.costs[static_cast<std::size_t>(lane)] < cost) {
      cost = finalists_.costs[static_cast<std::size_t>(lane)];
      chosen_ = lane;
    }
  }
}

void MppiPlanner::put(const Sequence& sequence, int lane, Columns& columns) const {
  const std::size_t axes = problem_.drive.isOmnidirectional ? kAxes : kAxes - 1;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    for (std::size_t step = 0; step < stepCount(); ++step) {
      columns.controls[axis][step * static_cast<std::size_t>(columns.count) +
                             static_cast<std::size_t>(lane)] = sequence[axis][step];
    }
  }
}

void MppiPlanner::putConstant(const std::array<float, kAxes>& control, int lane,
                              Columns& columns) const {
  Sequence sequence;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sequence[axis].assign(stepCount(), control[axis]);
  }
  put(sequence, lane, columns);
}

MppiPlanner::Sequence MppiPlanner::take(const Columns& columns, int lane) const {
  Sequence sequence;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sequence[axis].reserve(stepCount());
    for (std::size_t step = 0; step < stepCount(); ++step) {
      sequence[axis].push_back(
          columns.controls[axis][step * static_cast<std::size_t>(columns.count) +
                                 static_cast<std::size_t>(lane)]);
    }
  }
  return sequence;
}

BodyTwist MppiPlanner::storePlan(const Sequence& plan) {
  plan_ = plan;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    std::rotate(lastCommands_[axis].begin(), lastCommands_[axis].begin() + 1,
                lastCommands_[axis].end());
    lastCommands_[axis].back() = plan[axis].front();
  }
  return {static_cast<double>(plan[0].front()), static_cast<double>(plan[1].front()),
          static_cast<double>(plan[2].front())};
}

std::vector<Vec2> MppiPlanner::trajectoryPoints(const Columns& columns, int lane) const {
  const Sequence sequence = take(columns, lane);
  Pose2 pose = start_;
  std::vector<Vec2> points;
  points.reserve(stepCount() / kShownStride + 2);
  points.push_back(pose.position);
  for (std::size_t step = 0; step < stepCount(); ++step) {
    const double half = 0.5 * parameters_.modelDt * static_cast<double>(sequence[1][step]);
    const Vec2 way = parameters_.modelDt * Vec2(static_cast<double>(sequence[0][step]),
                                                static_cast<double>(sequence[2][step]));
    pose.heading = base::wrapToPi(pose.heading + half);
    pose.position = pose.toWorld(way);
    pose.heading = base::wrapToPi(pose.heading + half);
    if (step % kShownStride == kShownStride - 1 || step + 1 == stepCount()) {
      points.push_back(pose.position);
    }
  }
  return points;
}

std::vector<Vec2> MppiPlanner::path() const {
  return route_.isEmpty() ? std::vector<Vec2>{} : trajectoryPoints(finalists_, chosen_);
}

std::vector<Candidate> MppiPlanner::candidates() const {
  std::vector<Candidate> shown;
  if (route_.isEmpty()) {
    return shown;
  }
  const auto add = [&](const Columns& columns, int lane, bool isChosen) {
    const auto at = static_cast<std::size_t>(lane);
    const double cost = columns.hits[at] > 0.0F ? std::numeric_limits<double>::infinity()
                                                : static_cast<double>(columns.costs[at]);
    shown.push_back({trajectoryPoints(columns, lane), cost, isChosen});
  };
  shown.reserve(kShownSamples + 1);
  const int stride = std::max(1, samples_.count / kShownSamples);
  for (int lane = 0; lane < samples_.count && shown.size() < kShownSamples; lane += stride) {
    add(samples_, lane, false);
  }
  add(finalists_, chosen_, true);
  return shown;
}

}  // namespace sim2d
