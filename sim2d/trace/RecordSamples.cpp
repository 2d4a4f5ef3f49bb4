#include "sim2d/trace/RecordSamples.h"

#include <algorithm>
#include <cmath>

namespace sim2d {
namespace {

constexpr double kSameTime = 1e-6;  // of a step

BodySample sampleOf(const BodyColumns& columns, std::size_t k) {
  return {{{columns.x[k], columns.y[k]}, columns.heading[k]},
          {columns.vx[k], columns.vy[k]},
          columns.omega[k],
          columns.goal[k]};
}

BodySample between(const BodySample& a, const BodySample& b, double share) {
  BodySample sample = a;
  sample.pose.position += share * (b.pose.position - a.pose.position);
  sample.pose.heading =
      base::wrapToPi(a.pose.heading + share * base::angleDiff(b.pose.heading, a.pose.heading));
  sample.velocity += share * (b.velocity - a.velocity);
  sample.omega += share * (b.omega - a.omega);
  return sample;
}

std::map<int, BodySample> bodiesOf(const BodyColumns& columns) {
  std::map<int, BodySample> bodies;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    bodies.emplace(columns.id[k], sampleOf(columns, k));
  }
  return bodies;
}

/// For the bodies that are in both states.
std::map<int, BodySample> bodiesBetween(const BodyColumns& a, const BodyColumns& b, double share) {
  const std::map<int, BodySample> later = bodiesOf(b);
  std::map<int, BodySample> bodies;
  for (const auto& [id, body] : bodiesOf(a)) {
    if (const auto found = later.find(id); found != later.end()) {
      bodies.emplace(id, between(body, found->second, share));
    }
  }
  return bodies;
}

}  // namespace

RecordSamples::RecordSamples(const Trace& trace, double rate) : trace_(trace), rate_(rate) {
  if (trace.frames.empty()) {
    return;
  }
  const double span = trace.frames.back().time - trace.frames.front().time;
  size_ = rate > 0.0 ? static_cast<std::size_t>(std::floor(span * rate + kSameTime)) + 1
                     : trace.frames.size();
}

RecordSample RecordSamples::at(std::size_t index) const {
  const std::vector<Frame>& frames = trace_.frames;
  RecordSample sample;
  if (!(rate_ > 0.0)) {
    const Frame& frame = frames[index];
    sample.time = frame.time - frames.front().time;
    sample.people = bodiesOf(frame.humans);
    sample.robots = bodiesOf(frame.robots);
    return sample;
  }
  sample.time = static_cast<double>(index) / rate_;
  const double time = frames.front().time + sample.time;
  const double slack = kSameTime * trace_.header.dt;
  const auto next =
      std::upper_bound(frames.begin(), frames.end(), time + slack,
                       [](double value, const Frame& frame) { return value < frame.time; });
  const Frame& before = *(next - 1);  // the first state is not later
  if (next == frames.end() || time - before.time <= slack) {
    sample.people = bodiesOf(before.humans);
    sample.robots = bodiesOf(before.robots);
    return sample;
  }
  const double share = (time - before.time) / (next->time - before.time);
  sample.people = bodiesBetween(before.humans, next->humans, share);
  sample.robots = bodiesBetween(before.robots, next->robots, share);
  return sample;
}

}  // namespace sim2d
