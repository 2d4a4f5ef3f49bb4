#pragma once

#include <optional>

#include "metrics/MetricParameters.h"
#include "metrics/Samples.h"

/// How two bodies act on each other: forces, collision courses, sight.
namespace metrics {

/// Mean of the repulsions by the obstacle points of the body (Helbing and Molnar 1995).
Vec2 obstacleForce(const Body& body, const MetricParameters& parameters);

/// Straight on with both velocities: time until the discs touch, 0 when they do; none if never
/// (Singamaneni et al. 2023).
std::optional<double> timeToCollision(const Body& robot, const Body& person);

/// 1 / time to collision, capped; 0 without a collision course. The pair must be known.
double fearCost(const Body& robot, const Person& person, const MetricParameters& parameters);
/// Of approaching pairs that will narrowly miss each other.
double panicCost(const Body& robot, const Body& person, const MetricParameters& parameters);

/// Angle between the person's heading and the robot, [0, pi].
double viewAngle(const Person& person, const Body& robot);

/// Fills in the pairs of a sample with a robot that are not known yet; the sight when `map` is
/// given.
void workOutPairs(Sample& sample, const sim2d::OccupancyGrid* map,
                  const MetricParameters& parameters);

}  // namespace metrics
