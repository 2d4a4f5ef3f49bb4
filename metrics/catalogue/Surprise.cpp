#include <algorithm>

#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

/// The view of a person who sees the robot.
struct SeenRobot {
  double proxemic = 0.45;    // d_prox [m]
  double distance = 1.0;     // D [m]
  double angle = 0.0;        // theta [rad]
  double halfField = 1.0;    // half the field of view [rad]
  double recognition = 0.0;  // SR, 0: just seen, 1: reaction complete
  double shockRate = 4.0;    // reaction time / recognition time
};

double visibilityCost(const SeenRobot& view) {
  return view.proxemic / view.halfField * view.angle / view.distance;
}
double shockCost(const SeenRobot& view) {
  return std::max(view.proxemic / view.distance * (1.0 - view.shockRate * view.recognition), 0.0);
}
double reactCost(const SeenRobot& view) {
  return view.proxemic / view.distance * (1.0 - view.recognition);
}

// Indices of the costs.
constexpr std::size_t kVisibility = 0;
constexpr std::size_t kShock = 1;
constexpr std::size_t kReact = 2;
constexpr std::size_t kCosts = 3;

class SurpriseSum : public PersonCosts {
 public:
  SurpriseSum() : PersonCosts(kCosts) {}

  MetricValue value(std::size_t cost, const Instant& last) const {
    if (last.usesHunavProfile() && last.context.map.isEmpty()) {
      return undefinedValue("there is no map");
    }
    if (last.usesHunavProfile() && cost != kVisibility && last.count() < 2) {
      return undefinedValue("IndexError: only one sample");
    }
    return PersonCosts::value(cost, last);
  }

 protected:
  void beginSample() override {
    seenBefore_.swap(seen_);
    seen_.clear();
    next_ = 0;
  }

  bool addCosts(const Instant& at, const Pedestrian& person, std::vector<double>& costs) override {
    const double half = at.parameters.fieldOfView / 2.0;
    const double angle = person.pair.viewAngle;
    const bool unseen = angle > half || (at.usesHunavProfile() && angle == 0.0);
    if (unseen || (at.usesHunavProfile() && at.context.map.isEmpty())) {
      return true;
    }
    const Sight sight = person.pair.sight;
    if (sight == Sight::Free) {
      addVisible(at, person, costs);
    }
    return sight != Sight::OutsideMap;
  }

 private:
  void addVisible(const Instant& at, const Pedestrian& person, std::vector<double>& costs) {
    const MetricParameters& parameters = at.parameters;
    const Robot& robot = at.now.robot;
    SeenRobot view;
    view.proxemic = parameters.surpriseDistance;
    view.angle = person.pair.viewAngle;
    view.halfField = parameters.fieldOfView / 2.0;
    view.shockRate = parameters.reactionTime / parameters.recognitionTime;
    if (at.usesHunavProfile()) {
      view.distance = distance(robot, person);
      view.recognition = 1.0;  // the evaluator's clock runs backwards, so no reaction starts
    } else {
      view.distance = std::max(gap(robot, person), parameters.surpriseMinimumDistance);
      const double seenFor = at.now.time - seenSince(person.id, at.now.time);
      view.recognition = std::min(seenFor / parameters.reactionTime, 1.0);
      const bool stands = robot.speed < parameters.stopLinearSpeed;
      if (parameters.surpriseRequiresMotion > 0 && stands) {
        return;
      }
    }
    const bool isKnown = !at.usesHunavProfile() &&
                         parameters.surpriseVisibilityOnlyUnrecognised > 0 &&
                         view.recognition >= 1.0;
    costs[kVisibility] = isKnown ? 0.0 : visibilityCost(view);
    costs[kShock] = shockCost(view);
    costs[kReact] = reactCost(view);
  }

  /// Start of the uninterrupted sight; records that it continues.
  double seenSince(int id, double now) {
    const Seen* found = findInOrder(seenBefore_, next_, id);
    seen_.push_back({id, found != nullptr ? found->since : now});
    return seen_.back().since;
  }

  struct Seen {
    int id = 0;
    double since = 0.0;  // [s]
  };
  std::vector<Seen> seen_, seenBefore_;
  std::size_t next_ = 0;  // index in seenBefore_
};

constexpr char kSurpriseMetrics[] = R"(
= Danger & Surprise Metrics|lower|robot, people, map|Singamaneni, Favier, Alami, RO-MAN 2023
32 surprise_visibility_cost|Surprise: visibility||[0, inf)|sum over i and each a who sees the robot (field_of_view; METRICS.md, Walls and obstacles) of
  (surprise_distance/D) * theta/(field_of_view/2), D = max(gap, surprise_minimum_distance); 0 for SR = 1 if surprise_visibility_only_unrecognised is 1; 0 for a
  robot with s < stop_linear_speed if surprise_requires_motion is 1
33 surprise_shock_cost|Surprise: shock||[0, inf)|sum over i and each a who sees the robot of max((surprise_distance/D) * (1 - SR
  reaction_time/recognition_time), 0), SR = min((t_i - t_k)/reaction_time, 1), k = first of the samples of the interval since which a has been present and
  has seen it without interruption; D and surprise_requires_motion as in surprise_visibility_cost
34 surprise_react_cost|Surprise: reaction||[0, inf)|sum over i and each a who sees the robot of (surprise_distance/D) * (1 - SR); D, SR and
  surprise_requires_motion as in surprise_shock_cost
)";

}  // namespace

void addSurprise(MetricRegistry& to) {
  to.addSums(kSurpriseMetrics,
             {{"surprise_visibility_cost", metricOfPart<SurpriseSum>(kVisibility)},
              {"surprise_shock_cost", metricOfPart<SurpriseSum>(kShock)},
              {"surprise_react_cost", metricOfPart<SurpriseSum>(kReact)}});
}

}  // namespace metrics
