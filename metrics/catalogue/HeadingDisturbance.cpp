#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

double gaussian(double x, double sigma) {
  return std::exp(-x * x / (2.0 * sigma * sigma));
}

/// The part that speed and distance have in it; the whole is not larger.
double presence(const Person& person, const Robot& robot, const MetricParameters& parameters) {
  const double separation = distance(robot, person);
  const double near = (robot.radius + parameters.disturbanceRadius) / separation;
  const double fast = robot.speed / parameters.disturbanceSpeed;
  return separation > 0.0 ? std::fmin(fast, 1.0) * std::fmin(near, 1.0) : 0.0;
}

/// How much the robot's heading bothers the person: it aims at the place where the person stands,
/// from where it is seen.
double disturbance(const Person& person, const Robot& robot, const Vec2& heading,
                   const MetricParameters& parameters) {
  const auto toLocal = [&person](const Vec2& vector) {
    return Vec2(person.pair.ahead.dot(vector), base::cross(person.pair.ahead, vector));
  };
  const Vec2 place = toLocal(robot.position - person.position);
  const Vec2 aim = toLocal(heading);
  const double way = -place.x() / aim.x();  // along the heading to the line across the person
  if (!std::isfinite(way) || way < 0.0) {
    return 0.0;
  }
  const double offset = place.y() + way * aim.y();
  return gaussian(offset, parameters.disturbanceRadius / 2.0) *
         gaussian(base::headingOf(place), parameters.disturbanceFieldOfView / 4.0);
}

double worst(const Sample& sample, const MetricParameters& parameters) {
  double value = sample.people.empty() ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  const Vec2 heading = base::directionOf(sample.robot.heading);
  for (const Person& person : sample.people) {
    const double most = presence(person, sample.robot, parameters);
    if (most > value) {
      value = std::fmax(value, most * disturbance(person, sample.robot, heading, parameters));
    }
  }
  return value;
}

MetricValue average(const Figures& figures, const Instant& /*last*/) {
  const double mean = figures.timeMean();
  std::vector<double> series = figures.series();
  for (double& term : series) {
    term *= 100.0;
  }
  return withSeries(std::isnan(mean) ? numberValue(0.0) : numberValue(100.0 * mean),
                    std::move(series));
}

MetricValue largest(const Figures& figures, const Instant& /*last*/) {
  const double value = figures.largest();
  return std::isnan(value) ? undefinedValue("nobody in the record") : numberValue(100.0 * value);
}

}  // namespace

void addHeadingDisturbance(MetricRegistry& to) {
  const Needs needs{true, true};
  const char formula[] =
      "time-weighted mean of max over a of G(offset; disturbance_radius/2) * G(bearing; "
      "disturbance_field_of_view/4) * min(s/disturbance_speed, 1) * min((r_r + "
      "disturbance_radius)/d, 1); offset: where the line of the robot's heading meets the line "
      "across the person, bearing: of the robot in the person's view, G(x; s) = exp(-x^2/2s^2)";
  to.add({"heading_direction_disturbance", "Disturbance by the robot's heading", "%",
          Category::Social, Better::Lower, needs, formula, "SRPB", "[0, 100]", Kind::Number, 0, ""},
         figuresOf<worst>(average));
  to.add({"heading_direction_disturbance_max", "Disturbance by the robot's heading, largest", "%",
          Category::Social, Better::Lower, needs, "max over samples of the same", "SRPB",
          "[0, 100]", Kind::Number, 0, ""},
         figuresOf<worst>(largest));
}

}  // namespace metrics
