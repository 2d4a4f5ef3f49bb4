#include <array>
#include <cmath>

#include "metrics/RobotMotion.h"

namespace metrics {

namespace {

/// HuNavSim's evaluator excludes pairs with equal ids.
bool counts(const Sample& sample, const Pedestrian& person, const MetricParameters& parameters) {
  return parameters.profile == Profile::Corrected || person.id != sample.robot.id;
}

constexpr double kSmallLength = 1e-9;  // [m]

/// Mean of the repulsions by the obstacle points of the body (Helbing and Molnar 1995).
Vec2 obstacleForce(const Body& body, const MetricParameters& parameters) {
  Vec2 sum = Vec2::Zero();
  for (const sim2d::Obstacles::Point& point : body.obstacles) {
    const Vec2 away = body.position - point.position;
    const double length = away.norm();
    if (length < kSmallLength) {
      continue;  // no direction
    }
    const double side = point.inside ? -1.0 : 1.0;
    const double strength = parameters.obstacleFactor *
                            std::exp(-(side * length - body.radius) / parameters.obstacleSigma);
    sum += side * strength / length * away;
  }
  if (!body.obstacles.empty()) {
    sum /= static_cast<double>(body.obstacles.size());
  }
  return sum;
}

/// `hadPoints`: the record contains obstacle points of bodies.
bool lacksObstacles(const Instant& last, bool hadPoints) {
  return !last.context.hasObstacles && !hadPoints && !last.usesHunavProfile();
}

// Indices of the sums.
constexpr std::size_t kOnPeople = 0;
constexpr std::size_t kOnRobot = 1;
constexpr std::size_t kWork = 2;
constexpr std::size_t kObstaclesOnRobot = 3;
constexpr std::size_t kForceSums = 4;

/// Forces between the robot and its surroundings.
class RobotForces : public Accumulator {
 public:
  void add(const Instant& at) override {
    const Sample& now = at.now;
    double onPeople = 0.0;
    double onRobot = 0.0;
    Vec2 total = Vec2::Zero();
    for (const Pedestrian& person : now.people) {
      if (counts(now, person, at.parameters)) {
        onPeople += person.pair.forceOnPerson;
        onRobot += lengthOf(person.pair.forceOnRobot);
        total += person.pair.forceOnRobot;
      }
    }
    const double obstacles = lengthOf(obstacleForce(now.robot, at.parameters));
    hadPoints_ = hadPoints_ || !now.robot.obstacles.empty();
    sums_[kOnPeople].add(at, onPeople);
    sums_[kOnRobot].add(at, onRobot);
    sums_[kWork].add(at, lengthOf(total) + obstacles + onPeople);
    sums_[kObstaclesOnRobot].add(at, obstacles);
  }
  MetricValue value(std::size_t sum, const Instant& last) const {
    const bool isUnknown = sum == kObstaclesOnRobot && lacksObstacles(last, hadPoints_);
    return isUnknown ? undefinedValue(kNoObstacles) : withTerms(sums_[sum]);
  }

 private:
  std::array<SeriesSum, kForceSums> sums_;
  bool hadPoints_ = false;  // for the robot
};

/// HuNavSim's evaluator divides by the number of people of every sample.
class PeopleObstacles : public Accumulator {
 public:
  void add(const Instant& at) override {
    const std::vector<Pedestrian>& people = at.now.people;
    double sum = 0.0;
    for (const Pedestrian& person : people) {
      sum += lengthOf(obstacleForce(person, at.parameters));
      hadPoints_ = hadPoints_ || !person.obstacles.empty();
    }
    sum_.add(at, people.empty() ? 0.0 : sum / static_cast<double>(people.size()));
    empty_ = empty_ || people.empty();
  }
  MetricValue value(const Instant& last) const {
    if (lacksObstacles(last, hadPoints_)) {
      return undefinedValue(kNoObstacles);
    }
    return last.usesHunavProfile() && empty_
               ? undefinedValue("ZeroDivisionError: a sample without people")
               : withTerms(sum_);
  }

 private:
  SeriesSum sum_;
  bool empty_ = false;
  bool hadPoints_ = false;  // for any person
};

constexpr char kSocialForcesMetrics[] = R"(
= Social Forces|lower|robot, people|Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm
25 social_force_on_agents|Social force of the robot on people|m/s²|[0, inf)|sum over i, a of |F(robot -> a)|, with a's own factor
26 social_force_on_robot|Social force of people on the robot|m/s²|[0, inf)|sum over i, a of |F(a -> robot)|
= Social Forces|lower|robot, people, obstacles|Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm
27 social_work|Social work|m/s²|[0, inf)|sum over i of (|sum over a of F(a -> robot)| + |O(robot)| + sum over a of |F(robot -> a)|)
= Social Forces|lower|robot, obstacles|Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm
28 obstacle_force_on_robot|Obstacle force on the robot|m/s²|[0, inf)|sum over i of |O(robot)|
= Social Forces|lower|people, obstacles|Helbing and Molnar 1995; Moussaid et al. 2009; lightsfm
29 obstacle_force_on_agents|Obstacle force on people|m/s²|[0, inf)|sum over i of the mean over a of |O(a)|, 0 without people
)";

}  // namespace

void addSocialForces(MetricRegistry& to) {
  to.addSums(kSocialForcesMetrics,
             {{"social_force_on_agents", metricOfPart<RobotForces>(kOnPeople)},
              {"social_force_on_robot", metricOfPart<RobotForces>(kOnRobot)},
              {"social_work", metricOfPart<RobotForces>(kWork)},
              {"obstacle_force_on_robot", metricOfPart<RobotForces>(kObstaclesOnRobot)},
              {"obstacle_force_on_agents", metricOf<PeopleObstacles>(&PeopleObstacles::value)}});
}

}  // namespace metrics
