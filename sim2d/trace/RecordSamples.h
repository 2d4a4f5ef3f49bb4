#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "sim2d/trace/Trace.h"

/// States of a run at even times; private to the folder.
namespace sim2d {

struct BodySample {
  base::Pose2 pose;
  Vec2 velocity = Vec2::Zero();  // [m/s]
  double omega = 0.0;            // [rad/s]
  int goal = kNoGoal;
};

struct RecordSample {
  double time = 0.0;                 // [s] from the first
  std::map<int, BodySample> people;  // by id
  std::map<int, BodySample> robots;  // by id, -1, -2 …
};

/// From the first state to the last, 1 / `rate` [s] apart; 0: the states themselves. Bodies that
/// are in both of two states are interpolated linearly between them.
class RecordSamples {
 public:
  RecordSamples(const Trace& trace, double rate);

  std::size_t size() const { return size_; }
  RecordSample at(std::size_t index) const;

 private:
  const Trace& trace_;
  double rate_;
  std::size_t size_ = 0;
};

}  // namespace sim2d
