#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "SampledRun.h"

/// Small records by hand, for values that were worked out by hand.
namespace handmade {

using metrics::MetricEntry;
using metrics::MetricParameters;
using metrics::Pedestrian;
using metrics::Sample;
using metrics::SampledRun;
using metrics::Vec2;
using sim2d::EventKind;

inline Pedestrian personAt(int id, double x, double y, double vx = 0.0, double vy = 0.0) {
  Pedestrian person;
  person.id = id;
  person.position = Vec2(x, y);
  person.velocity = Vec2(vx, vy);
  person.speed = person.velocity.norm();
  person.heading = person.speed > 0.0 ? std::atan2(vy, vx) : 0.0;
  person.radius = 0.25;
  return person;
}

inline Sample sampleAt(double time, double x, double y, double speed = 0.0) {
  Sample sample;
  sample.time = time;
  sample.robot.id = -1;
  sample.robot.position = Vec2(x, y);
  sample.robot.velocity = Vec2(speed, 0.0);
  sample.robot.speed = speed;
  sample.robot.radius = 0.25;
  return sample;
}

inline sim2d::Event eventOf(sim2d::EventKind kind, int id) {
  sim2d::Event event;
  event.kind = kind;
  event.id = id;
  return event;
}

inline SampledRun recordingOfSamples(std::vector<Sample> samples) {
  SampledRun recording;
  recording.hasRobot = true;
  recording.samples = std::move(samples);
  return recording;
}

inline double valueOf(const SampledRun& recording, const char* key,
                      const MetricParameters& parameters = {}) {
  const MetricEntry* entry = metrics::standardRegistry().find(key);
  return entry == nullptr
             ? std::nan("")
             : metrics::valueOf(*entry, recording, parameters).value.value_or(std::nan(""));
}

inline bool isNear(double a, double b) {
  return std::fabs(a - b) <= 1e-9 * std::max(1.0, std::fabs(b));
}

}  // namespace handmade
