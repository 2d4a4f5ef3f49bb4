#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"
#include "metrics/PersonCosts.h"

namespace metrics {

namespace {

/// A person who sees the robot.
struct View {
  double proxemic = 0.45;    // d_prox [m]
  double distance = 1.0;     // D [m]
  double angle = 0.0;        // theta [rad]
  double halfField = 1.0;    // half the field of view [rad]
  double recognition = 0.0;  // SR, 0 = just seen, 1 = reaction over
  double shockRate = 4.0;    // reaction time / recognition time
};

double visibilityCost(const View& view) {
  return view.proxemic / view.halfField * view.angle / view.distance;
}
double shockCost(const View& view) {
  return std::max(view.proxemic / view.distance * (1.0 - view.shockRate * view.recognition), 0.0);
}
double reactCost(const View& view) {
  return view.proxemic / view.distance * (1.0 - view.recognition);
}

using Cost = double (*)(const View&);

class SurpriseSum : public PersonCosts {
 public:
  SurpriseSum(Cost cost, const MetricParameters& given) : PersonCosts(given), cost_(cost) {}

  MetricValue value(const Recording& recording) const override {
    if (isOriginal() && recording.map.isEmpty()) {
      return undefinedValue("there is no map");
    }
    if (isOriginal() && cost_ != visibilityCost && recording.size() < 2) {
      return undefinedValue("IndexError: one sample only");
    }
    return PersonCosts::value(recording);
  }

 protected:
  void beginSample() override {
    seenBefore_.swap(seen_);
    seen_.clear();
  }

  std::optional<double> costOf(const Recording& recording, const Sample& sample,
                               const Person& person) override {
    const double half = parameters().fieldOfView / 2.0;
    const double angle = viewAngle(person, sample.robot);
    const bool unseen = angle > half || (isOriginal() && angle == 0.0);
    if (unseen || (isOriginal() && recording.map.isEmpty())) {
      return 0.0;
    }
    const Sight sight = lineOfSight(person, sample.robot, recording.map, parameters().profile);
    if (sight == Sight::OutsideMap) {
      return std::nullopt;
    }
    return sight == Sight::Free ? visibleCost(sample, person, angle) : 0.0;
  }

 private:
  double visibleCost(const Sample& sample, const Person& person, double angle) {
    View view;
    view.proxemic = parameters().surpriseDistance;
    view.angle = angle;
    view.halfField = parameters().fieldOfView / 2.0;
    view.shockRate = parameters().reactionTime / parameters().recognitionTime;
    if (isOriginal()) {
      view.distance = distance(sample.robot, person);
      view.recognition = 1.0;  // its clock runs backwards and never enters the reaction
      return cost_(view);
    }
    view.distance = std::max(gap(sample.robot, person), parameters().surpriseMinimumDistance);
    const double seenFor = sample.time - seenSince(person.id, sample.time);
    view.recognition = std::min(seenFor / parameters().reactionTime, 1.0);
    const bool stands = sample.robot.speed < parameters().stopLinearSpeed;
    const bool quiet = (parameters().surpriseRequiresMotion > 0 && stands) ||
                       (parameters().surpriseVisibilityOnlyUnrecognised > 0 &&
                        cost_ == visibilityCost && view.recognition >= 1.0);
    return quiet ? 0.0 : cost_(view);
  }

  /// Begin of the uninterrupted sight; notes that it goes on.
  double seenSince(int id, double now) {
    const auto found = std::find_if(seenBefore_.begin(), seenBefore_.end(),
                                    [id](const auto& entry) { return entry.first == id; });
    const double since = found != seenBefore_.end() ? found->second : now;
    seen_.emplace_back(id, since);
    return since;
  }

  Cost cost_;
  std::vector<std::pair<int, double>> seen_, seenBefore_;  // id, begin of the sight [s]
};

void addCost(MetricRegistry& to, MetricInfo info, Cost cost) {
  const std::string key = info.key;
  to.addAccumulated(std::move(info), [cost](const MetricParameters& parameters) {
    return std::make_unique<SurpriseSum>(cost, parameters);
  });
  to.addMeanOf(key);
}

}  // namespace

void addSurprise(MetricRegistry& to) {
  const Needs needs{true, true, false, false, false, true};
  const char source[] = "Singamaneni, Favier, Alami, RO-MAN 2023";
  addCost(to,
          {"surprise_visibility_cost", "Surprise: visibility", "", Category::DangerSurprise,
           Better::Lower, needs,
           "sum over i and a who sees the robot of (d_prox/D) * theta/half field of view", source,
           "[0, inf)", Kind::Number, 32, ""},
          visibilityCost);
  addCost(to,
          {"surprise_shock_cost", "Surprise: shock", "", Category::DangerSurprise, Better::Lower,
           needs, "sum of max((d_prox/D) * (1 - 4 SR), 0), SR = min(time seen/0.6 s, 1)", source,
           "[0, inf)", Kind::Number, 33, ""},
          shockCost);
  addCost(to,
          {"surprise_react_cost", "Surprise: reaction", "", Category::DangerSurprise, Better::Lower,
           needs, "sum of (d_prox/D) * (1 - SR), SR = min(time seen/0.6 s, 1)", source, "[0, inf)",
           Kind::Number, 34, ""},
          reactCost);
}

}  // namespace metrics
