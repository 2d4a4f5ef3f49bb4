#include "metrics/RobotPositions.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "metrics/RobotMotion.h"

namespace metrics {

namespace {

/// Records the robot's positions.
class PathRecorder : public Accumulator {
 public:
  void add(const Instant& at) override {
    places_.emplace_back(at.elapsed(), at.now.robot.position);
  }
  const TimedPath& places() const { return places_; }

 private:
  TimedPath places_;
};

/// Records the positions where contacts start.
class ContactRecorder : public ContactsWithin<&MetricParameters::contactDistance> {
 public:
  using ContactsWithin::ContactsWithin;

  void add(const Instant& at) override {
    ContactsWithin::add(at);
    obstacles_.add(at);
    for (const int person : begun()) {
      places_.push_back({at.now.time, at.now.robot.position, person});
    }
    if (obstacles_.hasBegun()) {
      places_.push_back({at.now.time, at.now.robot.position});
    }
  }
  const std::vector<RobotContact>& places() const { return places_; }

 private:
  ObstacleContacts obstacles_;
  std::vector<RobotContact> places_;
};

template <class Places>
auto recordedBy(const sim2d::Trace& trace, const Selection& selection,
                const MetricParameters& parameters) {
  std::decay_t<decltype(std::declval<Places>().places())> places;
  MetricEntry entry;
  entry.info.key = "places";
  entry.computation = metricOf<Places>([&places](const Places& all) {
    places = all.places();
    return MetricValue();
  });
  Selection only = *selectionOfKeys({});
  only.own = {entry};
  only.window = selection.window;
  only.robotId = selection.robotId;
  only.behaviors = false;
  const std::vector<sim2d::TraceRobot>& robots = trace.header.robots;
  const bool isThere = std::any_of(robots.begin(), robots.end(), [&](const auto& robot) {
    return robot.id == selection.robotId;
  });
  if (!isThere && !robots.empty()) {
    only.robotId = robots.front().id;
  }
  return evaluate(trace, only, parameters) ? places : decltype(places)();
}

}  // namespace

TimedPath robotPathOf(const sim2d::Trace& trace, const Selection& selection,
                      const MetricParameters& parameters) {
  return recordedBy<PathRecorder>(trace, selection, parameters);
}

std::vector<RobotContact> robotContacts(const sim2d::Trace& trace, const Selection& selection,
                                        const MetricParameters& parameters) {
  return recordedBy<ContactRecorder>(trace, selection, parameters);
}

}  // namespace metrics
