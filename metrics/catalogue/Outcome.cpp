#include "metrics/ContactEvents.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

bool isTimeout(const Instant& last) {
  return last.elapsed() >= last.parameters.timeLimit;
}

class Collisions : public Accumulator {
 public:
  explicit Collisions(const MetricParameters& parameters) : people_(parameters.contactDistance) {}
  void add(const Instant& at) override {
    people_.add(at);
    obstacles_.add(at.now.robot);
  }
  MetricValue success(const Instant& last) const {
    const bool touched = people_.count() > 0.0 || obstacles_.count() > 0;
    return booleanValue(isCompleted(last) && !touched && !isTimeout(last));
  }

 private:
  ContactEvents people_;
  ObstacleContacts obstacles_;
};

class ObstacleCollisions : public Accumulator {
 public:
  void add(const Instant& at) override { contacts_.add(at.now.robot); }
  MetricValue value(const Instant& /*last*/) const { return countValue(contacts_.count()); }

 private:
  ObstacleContacts contacts_;
};

MetricValue totalTime(const Instant& last) {
  return numberValue(last.elapsed());
}

MetricValue timeout(const Instant& last) {
  return booleanValue(isTimeout(last));
}

}  // namespace

void addOutcome(MetricRegistry& to) {
  to.add({"success", "Success", "", Category::Navigation, Better::Higher,
          Needs{true, true, false, true, true},
          "completed, no contact with a person or an obstacle, no timeout",
          "Francis et al. 2025; SocNavBench; CrowdNav; Arena", "0 or 1", Kind::Boolean, 0, ""},
         streamOf<Collisions>(&Collisions::success));
  to.add({"total_time", "Duration of the record", "s", Category::Navigation, Better::Lower,
          Needs{false}, "T = t_(N-1) - t_0", "all benchmarks", "[0, inf)", Kind::Number, 0, ""},
         streamOfLast(totalTime));
  to.add({"timeout", "Timeout", "", Category::Navigation, Better::Lower, Needs{false},
          "T >= time_limit", "Arena; CrowdNav", "0 or 1", Kind::Boolean, 0, ""},
         streamOfLast(timeout));
  to.add({"obstacle_collisions", "Robot runs into an obstacle", "", Category::Safety, Better::Lower,
          Needs{true, false, false, true},
          "number of times the clearance of the robot falls to 0 or below",
          "SEAN 2.0; SocNavBench; Arena", "0, 1, ...", Kind::Count, 0, ""},
         streamOf<ObstacleCollisions>(&ObstacleCollisions::value));
}

}  // namespace metrics
