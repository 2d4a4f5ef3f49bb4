#include <array>

#include "metrics/Interaction.h"
#include "metrics/MetricRegistry.h"

namespace metrics {

namespace {

MetricValue valueOf(const SeriesSum& sum) {
  return withSeries(numberValue(sum.sum()), sum.terms());
}

/// The original leaves out pairs with equal ids.
bool counts(const Sample& sample, const Person& person, const MetricParameters& parameters) {
  return parameters.profile == Profile::Corrected || person.id != sample.robot.id;
}

// Places of the sums.
constexpr std::size_t kOnPeople = 0;
constexpr std::size_t kOnRobot = 1;
constexpr std::size_t kWork = 2;
constexpr std::size_t kObstaclesOnRobot = 3;
constexpr std::size_t kForceSums = 4;

/// What acts between the robot and its surroundings.
class RobotForces : public Accumulator {
 public:
  void add(const Instant& at) override {
    const Sample& now = at.now;
    double onPeople = 0.0;
    double onRobot = 0.0;
    Vec2 total = Vec2::Zero();
    for (const Person& person : now.people) {
      if (counts(now, person, at.parameters)) {
        onPeople += person.pair.forceOnPerson;
        onRobot += lengthOf(person.pair.forceOnRobot);
        total += person.pair.forceOnRobot;
      }
    }
    const double obstacles = lengthOf(obstacleForce(now.robot, at.parameters));
    sums_[kOnPeople].add(at, onPeople);
    sums_[kOnRobot].add(at, onRobot);
    sums_[kWork].add(at, lengthOf(total) + obstacles + onPeople);
    sums_[kObstaclesOnRobot].add(at, obstacles);
  }
  MetricValue value(std::size_t sum, const Instant& /*last*/) const { return valueOf(sums_[sum]); }

 private:
  std::array<SeriesSum, kForceSums> sums_;
};

/// The original divides by the number of people of every sample.
class PeopleObstacles : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Person>& people = at.now.people;
    double sum = 0.0;
    for (const Person& person : people) {
      sum += lengthOf(obstacleForce(person, at.parameters));
    }
    sum_.add(at, people.empty() ? 0.0 : sum / static_cast<double>(people.size()));
    empty_ = empty_ || people.empty();
  }
  MetricValue value(const Instant& last) const {
    return last.isOriginal() && empty_
               ? undefinedValue("ZeroDivisionError: a sample without people")
               : valueOf(sum_);
  }

 private:
  SeriesSum sum_;
  bool empty_ = false;
};

}  // namespace

void addSocialForces(MetricRegistry& to) {
  const Needs people{true, true};
  const char source[] = "Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm";
  const char unit[] = "m/s²";
  to.addSum(
      {"social_force_on_agents", "Social force of the robot on people", unit, Category::Forces,
       Better::Lower, people, "sum over i, a of |F(robot -> a)| with a's own factor", source,
       "[0, inf)", Kind::Number, 25},
      streamOfPart<RobotForces>(kOnPeople));
  to.addSum({"social_force_on_robot", "Social force of people on the robot", unit, Category::Forces,
             Better::Lower, people, "sum over i, a of |F(a -> robot)|", source, "[0, inf)",
             Kind::Number, 26},
            streamOfPart<RobotForces>(kOnRobot));
  to.addSum({"social_work", "Social work", unit, Category::Forces, Better::Lower,
             Needs{true, true, false, true},
             "sum over i of |sum_a F(a -> robot)| + |O(robot)| + sum_a |F(robot -> a)|", source,
             "[0, inf)", Kind::Number, 27},
            streamOfPart<RobotForces>(kWork));
  to.addSum({"obstacle_force_on_robot", "Obstacle force on the robot", unit, Category::Forces,
             Better::Lower, Needs{true, false, false, true}, "sum over i of |O(robot)|", source,
             "[0, inf)", Kind::Number, 28},
            streamOfPart<RobotForces>(kObstaclesOnRobot));
  to.addSum({"obstacle_force_on_agents", "Obstacle force on people", unit, Category::Forces,
             Better::Lower, Needs{false, true, false, true}, "sum over i of mean over a of |O(a)|",
             source, "[0, inf)", Kind::Number, 29},
            streamOf<PeopleObstacles>(&PeopleObstacles::value));
}

}  // namespace metrics
