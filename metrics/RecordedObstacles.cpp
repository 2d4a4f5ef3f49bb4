#include "metrics/RecordedObstacles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/IncrementalEvaluation.h"

namespace metrics {
namespace {

void takePoints(const sim2d::RecordedPoints::Range& points, Body& body) {
  body.obstacles.clear();
  for (const Vec2& point : points) {
    body.obstacles.push_back({point, lengthOf(point - body.position), false});
  }
}

void takeRobotsPoints(const sim2d::RecordedPoints::Range& points, Robot& robot) {
  takePoints(points, robot);
  for (const Vec2& point : points) {
    const double distance = lengthOf(point - robot.position);
    robot.obstacleDistance = std::min(robot.obstacleDistance.value_or(distance), distance);
  }
}

/// Evaluates one robot of a record, or only its people.
class Evaluator {
 public:
  Evaluator(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
            const Selection& selection, const MetricParameters& parameters)
      : trace_(trace),
        points_(points),
        builder_(trace.header, selection.robotId),
        running_(contextOf(builder_, points), selection, parameters) {}

  base::Result<Evaluation> evaluate() {
    for (const sim2d::Frame& frame : trace_.frames) {
      noteUntil(frame.time);
      running_.add(sampleOf(frame));
    }
    noteUntil(HUGE_VAL);
    return running_.finish();
  }

 private:
  static RunContext contextOf(const SampleBuilder& builder, const sim2d::RecordedPoints& points) {
    RunContext context = builder.context();
    context.hasObstacles = context.hasObstacles || points.hasRobot();
    return context;
  }

  void noteUntil(double time) {
    for (; event_ < trace_.events.size(); ++event_) {
      const auto& [step, event] = trace_.events[event_];
      const double itsTime = static_cast<double>(step) * trace_.header.dt;
      if (itsTime > time + kTimeSlack) {
        return;
      }
      running_.note(itsTime, event);
    }
  }

  Sample sampleOf(const sim2d::Frame& frame) {
    std::vector<Pedestrian> people = builder_.peopleOf(frame);
    for (Pedestrian& person : people) {
      if (points_.hasPeople()) {
        takePoints(points_.of(frame.step, person.id, false), person);
      }
    }
    Sample sample = builder_.sampleOf(frame, std::move(people));
    if (points_.hasRobot()) {
      takeRobotsPoints(points_.of(frame.step, sample.robot.id, true), sample.robot);
    }
    return sample;
  }

  const sim2d::Trace& trace_;
  const sim2d::RecordedPoints& points_;
  SampleBuilder builder_;
  IncrementalEvaluation running_;
  std::size_t event_ = 0;
};

}  // namespace

/// A record with points has at most one robot.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                  const Selection& selection, const MetricParameters& parameters) {
  if (points.isEmpty()) {
    return evaluate(trace, selection, parameters);
  }
  base::Result<Evaluation> made = Evaluator(trace, points, selection, parameters).evaluate();
  const std::vector<sim2d::TraceRobot>& robots = trace.header.robots;
  for (std::size_t k = 0; made && k < robots.size(); ++k) {
    if (robots[k].id == selection.robotId) {
      made->robot = robotNames(robots)[k];
    }
  }
  return made;
}

}  // namespace metrics
