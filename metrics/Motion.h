#pragma once

#include <optional>
#include <vector>

#include "metrics/MetricParameters.h"
#include "metrics/Recording.h"

/// Quantities of the robot's run that several metrics use.
namespace metrics {

double pathLength(const Recording& recording);                   // L [m]
std::vector<double> headingChanges(const Recording& recording);  // 0, then |turn| [rad]
/// Speed differences over time, one per interval [m/s^2]; 0 where no time passes.
std::vector<double> accelerations(const Recording& recording);
/// Change of acceleration around each inner sample 1..N-2 [m/s^3]; none where no time passes.
std::vector<std::optional<double>> jerks(const Recording& recording);

bool isInGoalRegion(const Recording& recording, std::size_t sample,
                    const MetricParameters& parameters);
bool isCompleted(const Recording& recording, const MetricParameters& parameters);
double distanceToGoals(const Recording& recording, std::size_t sample);  // nearest goal; inf: none

/// The robot touches an obstacle: begins at these many samples.
int obstacleContacts(const Recording& recording);

/// Ways on the map or straight.
std::vector<Vec2> shortestPath(const Recording& recording, const Vec2& from, const Vec2& to);

/// Sum of the intervals after the samples for which `holds(i)`; the last sample counts for none.
template <class Holds>
double timeWhere(const Recording& recording, Holds holds) {
  double time = 0.0;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    if (holds(i)) {
      time += recording.interval(i);
    }
  }
  return time;
}

}  // namespace metrics
