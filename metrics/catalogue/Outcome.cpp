#include "metrics/ContactEvents.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

bool isTimeout(const Recording& recording, const MetricParameters& parameters) {
  return recording.duration() >= parameters.timeLimit;
}

MetricValue success(const ContactEvents& contacts, const Recording& recording,
                    const MetricParameters& parameters) {
  const bool touched = contacts.count() > 0.0 || obstacleContacts(recording) > 0;
  return booleanValue(isCompleted(recording, parameters) && !touched &&
                      !isTimeout(recording, parameters));
}

MetricValue totalTime(const Recording& recording, const MetricParameters& /*parameters*/) {
  return numberValue(recording.duration());
}

MetricValue timeout(const Recording& recording, const MetricParameters& parameters) {
  return booleanValue(isTimeout(recording, parameters));
}

MetricValue obstacleCollisions(const Recording& recording, const MetricParameters& /*parameters*/) {
  return countValue(obstacleContacts(recording));
}

}  // namespace

void addOutcome(MetricRegistry& to) {
  to.addStream(
      {"success", "Success", "", Category::Navigation, Better::Higher,
       Needs{true, true, false, true, true},
       "completed, no contact with a person or an obstacle, no timeout",
       "Francis et al. 2025; SocNavBench; CrowdNav; Arena", "0 or 1", Kind::Boolean, 0, ""},
      contactStream(&MetricParameters::contactDistance, "contact", success));
  to.add({"total_time", "Duration of the record", "s", Category::Navigation, Better::Lower,
          Needs{false}, "T = t_(N-1) - t_0", "all benchmarks", "[0, inf)", Kind::Number, 0, ""},
         totalTime);
  to.add({"timeout", "Timeout", "", Category::Navigation, Better::Lower, Needs{false},
          "T >= time_limit", "Arena; CrowdNav", "0 or 1", Kind::Boolean, 0, ""},
         timeout);
  to.add({"obstacle_collisions", "Robot runs into an obstacle", "", Category::Safety, Better::Lower,
          Needs{true, false, false, true},
          "number of times the clearance of the robot falls to 0 or below",
          "SEAN 2.0; SocNavBench; Arena", "0, 1, ...", Kind::Count, 0, ""},
         obstacleCollisions);
}

}  // namespace metrics
