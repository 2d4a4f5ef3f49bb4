#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"

namespace metrics {

namespace {

/// A sum over samples of terms that depend on one sample each.
class TermSum : public Accumulator {
 public:
  using Term = double (*)(const Sample& sample, const MetricParameters& parameters);
  TermSum(Term term, const MetricParameters& parameters) : term_(term), parameters_(parameters) {}

  void add(const Recording& recording, std::size_t sample) override {
    series_.push_back(term_(recording.samples[sample], parameters_));
    sum_ += series_.back();
  }
  MetricValue value(const Recording& /*recording*/) const override {
    return withSeries(numberValue(sum_), series_);
  }

 private:
  Term term_;
  MetricParameters parameters_;
  std::vector<double> series_;
  double sum_ = 0.0;
};

/// The original leaves out pairs with equal ids.
bool counts(const Sample& sample, const Person& person, const MetricParameters& parameters) {
  return parameters.profile == Profile::Corrected || person.id != sample.robot.id;
}

double factorOf(const Person& person, const MetricParameters& parameters) {
  const bool own = parameters.profile == Profile::Corrected && parameters.personForceParameters > 0;
  return own ? person.socialFactor.value_or(parameters.socialFactor) : parameters.socialFactor;
}

double onPeople(const Sample& sample, const MetricParameters& parameters) {
  double sum = 0.0;
  for (const Person& person : sample.people) {
    if (counts(sample, person, parameters)) {
      sum += lengthOf(socialForce(sample.robot, person, factorOf(person, parameters), parameters));
    }
  }
  return sum;
}

double onRobot(const Sample& sample, const MetricParameters& parameters) {
  double sum = 0.0;
  for (const Person& person : sample.people) {
    if (counts(sample, person, parameters)) {
      sum += lengthOf(socialForce(person, sample.robot, parameters.socialFactor, parameters));
    }
  }
  return sum;
}

double work(const Sample& sample, const MetricParameters& parameters) {
  Vec2 total = Vec2::Zero();
  for (const Person& person : sample.people) {
    if (counts(sample, person, parameters)) {
      total += socialForce(person, sample.robot, parameters.socialFactor, parameters);
    }
  }
  return lengthOf(total) + lengthOf(obstacleForce(sample.robot, parameters)) +
         onPeople(sample, parameters);
}

double obstaclesOnRobot(const Sample& sample, const MetricParameters& parameters) {
  return lengthOf(obstacleForce(sample.robot, parameters));
}

double obstaclesOnPeople(const Sample& sample, const MetricParameters& parameters) {
  double sum = 0.0;
  for (const Person& person : sample.people) {
    sum += lengthOf(obstacleForce(person, parameters));
  }
  return sample.people.empty() ? 0.0 : sum / static_cast<double>(sample.people.size());
}

/// The original divides by the number of people of every sample.
class PeopleObstacleSum : public TermSum {
 public:
  explicit PeopleObstacleSum(const MetricParameters& parameters)
      : TermSum(obstaclesOnPeople, parameters), original_(parameters.profile == Profile::Hunav2) {}
  void add(const Recording& recording, std::size_t sample) override {
    TermSum::add(recording, sample);
    empty_ = empty_ || recording.samples[sample].people.empty();
  }
  MetricValue value(const Recording& recording) const override {
    return original_ && empty_ ? undefinedValue("ZeroDivisionError: a sample without people")
                               : TermSum::value(recording);
  }

 private:
  bool original_;
  bool empty_ = false;
};

void addSum(MetricRegistry& to, MetricInfo info, TermSum::Term term) {
  const std::string key = info.key;
  to.addAccumulated(std::move(info), [term](const MetricParameters& parameters) {
    return std::make_unique<TermSum>(term, parameters);
  });
  to.addMeanOf(key);
}

}  // namespace

void addSocialForces(MetricRegistry& to) {
  const Needs people{true, true};
  const char source[] = "Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm";
  const char unit[] = "m/s²";
  addSum(to,
         {"social_force_on_agents", "Social force of the robot on people", unit, Category::Forces,
          Better::Lower, people, "sum over i, a of |F(robot -> a)| with a's own factor", source,
          "[0, inf)", Kind::Number, 25, ""},
         onPeople);
  addSum(to,
         {"social_force_on_robot", "Social force of people on the robot", unit, Category::Forces,
          Better::Lower, people, "sum over i, a of |F(a -> robot)|", source, "[0, inf)",
          Kind::Number, 26, ""},
         onRobot);
  addSum(to,
         {"social_work", "Social work", unit, Category::Forces, Better::Lower,
          Needs{true, true, false, true},
          "sum over i of |sum_a F(a -> robot)| + |O(robot)| + sum_a |F(robot -> a)|", source,
          "[0, inf)", Kind::Number, 27, ""},
         work);
  addSum(to,
         {"obstacle_force_on_robot", "Obstacle force on the robot", unit, Category::Forces,
          Better::Lower, Needs{true, false, false, true}, "sum over i of |O(robot)|", source,
          "[0, inf)", Kind::Number, 28, ""},
         obstaclesOnRobot);
  to.addAccumulated(
      {"obstacle_force_on_agents", "Obstacle force on people", unit, Category::Forces,
       Better::Lower, Needs{false, true, false, true}, "sum over i of mean over a of |O(a)|",
       source, "[0, inf)", Kind::Number, 29, ""},
      [](const MetricParameters& parameters) {
        return std::make_unique<PeopleObstacleSum>(parameters);
      });
  to.addMeanOf("obstacle_force_on_agents");
}

}  // namespace metrics
