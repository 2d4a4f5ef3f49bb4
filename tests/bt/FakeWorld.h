#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/Program.h"
#include "bt/engine/TreeState.h"
#include "bt/human/HumanContext.h"
#include "bt/human/TreeLoader.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/world/HumanBehavior.h"

/// A world of points for the tests of people's trees: what a test does not set is empty.
class FakeWorld final : public sim2d::WorldView {
 public:
  struct Person {
    sim2d::ResolvedHuman constants;
    base::Pose2 pose;
    base::Vec2 velocity = base::Vec2::Zero();
    bool isPresent = true;
  };
  struct RobotBody {
    base::Pose2 pose;
    base::Vec2 velocity = base::Vec2::Zero();
    double radius = 0.35;
  };

  double stepLength = 0.1;
  std::int64_t present = 1;
  sim2d::Scenario settings;
  sim2d::Compatibility quirks;
  std::vector<Person> people;
  std::vector<RobotBody> robots;
  std::map<int, base::Vec2> goals;
  bool isDark = false;  // nobody sees or hears anybody

  int addPerson(int id, double x, double y, double heading = 0.0) {
    Person person;
    person.constants.id = id;
    person.constants.name = "agent" + std::to_string(id);
    person.pose = {base::Vec2(x, y), heading};
    person.constants.start = person.pose;
    people.push_back(person);
    return static_cast<int>(people.size()) - 1;
  }
  void addRobot(double x, double y, double heading = 0.0) {
    robots.push_back({{base::Vec2(x, y), heading}, base::Vec2::Zero(), 0.35});
  }
  Person& at(int human) { return people[static_cast<std::size_t>(human)]; }

  std::int64_t step() const override { return present; }
  double time() const override { return static_cast<double>(present - 1) * stepLength; }
  double dt() const override { return stepLength; }
  std::uint64_t seed() const override { return 1; }
  const sim2d::Scenario& scenario() const override { return settings; }
  const sim2d::Compatibility& compatibility() const override { return quirks; }
  int humanCount() const override { return static_cast<int>(people.size()); }
  bool isPresent(int human) const override { return of(human).isPresent; }
  int indexOf(int humanId) const override {
    for (std::size_t i = 0; i < people.size(); ++i) {
      if (people[i].constants.id == humanId) {
        return static_cast<int>(i);
      }
    }
    return -1;
  }
  const sim2d::ResolvedHuman& constants(int human) const override { return of(human).constants; }
  base::Pose2 pose(int human) const override { return of(human).pose; }
  base::Vec2 velocity(int human) const override { return of(human).velocity; }
  void near(int human, double range, std::vector<int>& found) const override {
    found.clear();
    std::vector<std::pair<double, int>> sorted;
    for (int i = 0; i < humanCount(); ++i) {
      const double distance = (of(i).pose.position - of(human).pose.position).norm();
      if (i != human && isPresent(i) && distance <= range) {
        sorted.emplace_back(distance, i);
      }
    }
    std::sort(sorted.begin(), sorted.end());
    for (const auto& entry : sorted) {
      found.push_back(entry.second);
    }
  }
  int robotCount() const override { return static_cast<int>(robots.size()); }
  base::Pose2 robotPose(int robot) const override { return body(robot).pose; }
  base::Vec2 robotVelocity(int robot) const override { return body(robot).velocity; }
  double robotRadius(int robot) const override { return body(robot).radius; }
  int nearestRobot(int human) const override {
    int nearest = -1;
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < robotCount(); ++i) {
      const double distance = (body(i).pose.position - of(human).pose.position).norm();
      if (distance < shortest) {
        shortest = distance;
        nearest = i;
      }
    }
    return nearest;
  }
  std::optional<base::Vec2> globalGoal(int id) const override {
    const auto found = goals.find(id);
    return found == goals.end() ? std::nullopt : std::optional<base::Vec2>(found->second);
  }
  const sim2d::Area* area(const std::string& name) const override {
    for (const sim2d::Area& area : settings.areas) {
      if (area.name == name) {
        return &area;
      }
    }
    return nullptr;
  }
  bool isVisible(const base::Vec2&, const base::Vec2&) const override { return !isDark; }
  bool isReachable(int, const base::Vec2&) const override { return true; }

  /// Moves everybody straight as they asked, and the clock.
  void apply(sim2d::Intents& intents) {
    for (int i = 0; i < humanCount(); ++i) {
      move(at(i), intents.of(i), intents.control(i));
    }
    ++present;
    intents.reset();
  }

 private:
  const Person& of(int human) const { return people[static_cast<std::size_t>(human)]; }
  const RobotBody& body(int robot) const { return robots[static_cast<std::size_t>(robot)]; }

  void move(Person& person, const sim2d::Intent& intent, sim2d::HumanControl& control) const {
    if (intent.motion == sim2d::Motion::Turn) {
      const double left = base::angleDiff(intent.heading, person.pose.heading);
      const double limit = intent.turnRate * stepLength;
      person.pose.heading = base::wrapToPi(person.pose.heading + std::clamp(left, -limit, limit));
    }
    if (intent.motion != sim2d::Motion::Walk) {
      return;
    }
    const base::Vec2 way = intent.target.position - person.pose.position;
    const double length = std::min(intent.speed * stepLength, way.norm());
    if (length > 0.0) {
      person.pose.heading = base::headingOf(way);
      person.pose.position += length * way.normalized();
    }
    const bool isInside =
        (intent.target.position - person.pose.position).norm() <= intent.target.radius;
    if (intent.targetIsGoal && isInside && !control.goals.empty()) {
      const sim2d::GoalItem goal = control.goals.front();
      control.goals.erase(control.goals.begin());
      if (person.constants.cyclicGoals) {
        control.goals.push_back(goal);
      }
    }
  }
};

/// A world with person 1 at the origin, looking along x.
inline FakeWorld withOnePerson() {
  FakeWorld world;
  world.addPerson(1, 0.0, 0.0);
  return world;
}

/// One tree of one person (index 0 unless said), ticked by hand.
class TreeBench {
 public:
  explicit TreeBench(FakeWorld& world) : world_(world), library_(bt::humanNodes()) {
    controls_.resize(world.people.size());
    intents_ = std::make_unique<sim2d::Intents>(controls_);
    society_.agentStates.resize(world.people.size());
    renewStep();
  }

  /// The tree around `body`, as the person with this index has it. False = does not load.
  bool load(const std::string& body, int human = 0) {
    const std::string text =
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" + body + "</BehaviorTree></root>";
    base::Result<bt::TreeFile> file = bt::readTreeText(text, "test.xml");
    found_ = file.diagnostics();
    if (!file) {
      return false;
    }
    base::Result<std::shared_ptr<const bt::Program>> program = bt::compile(*file, library_);
    base::append(found_, program.diagnostics());
    if (!program) {
      return false;
    }
    trees_.emplace_back(human, bt::TreeState(*program));
    bt::TreeState& tree = trees_.back().second;
    tree.set((*program)->hostSlot(0), world_.at(human).constants.id);
    tree.set((*program)->hostSlot(1), world_.stepLength);
    return true;
  }

  /// One step: ticks every tree in order, moves people; the status of the first tree.
  base::NodeStatus step() {
    base::NodeStatus first = base::NodeStatus::Idle;
    society_.groups.clear();
    for (const sim2d::HumanControl& control : controls_) {
      society_.groups.push_back(control.group);
    }
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      bt::HumanContext context(society_, world_, *intents_, trees_[i].first);
      const base::NodeStatus status =
          trees_[i].second.tickOnce({world_.present, world_.stepLength, &context});
      context.agentState().isFirstTick = false;
      first = i == 0 ? status : first;
    }
    last_.clear();
    for (int i = 0; i < world_.humanCount(); ++i) {
      last_.push_back(intents_->of(i));
    }
    events_ = intents_->events();
    world_.apply(*intents_);
    renewStep();
    return first;
  }
  void halt() {
    for (auto& entry : trees_) {
      bt::HumanContext context(society_, world_, *intents_, entry.first);
      entry.second.halt({world_.present, world_.stepLength, &context});
    }
  }
  /// Steps until the first tree gives this status; the number of steps, or -1.
  int stepsUntil(base::NodeStatus wanted, int most = 1000) {
    for (int i = 1; i <= most; ++i) {
      if (step() == wanted) {
        return i;
      }
    }
    return -1;
  }

  const sim2d::Intent& intent(int human = 0) const {
    return last_[static_cast<std::size_t>(human)];
  }
  sim2d::HumanControl& control(int human = 0) { return controls_[static_cast<std::size_t>(human)]; }
  const std::vector<sim2d::Event>& events() const { return events_; }
  const bt::TreeState& tree(std::size_t index = 0) const { return trees_[index].second; }
  bool isFaulty() const { return trees_.front().second.fault() != nullptr; }
  const base::Diagnostics& pendingDiagnostics() const { return society_.pendingDiagnostics; }
  const base::Diagnostics& loadDiagnostics() const { return found_; }
  std::string entry(const std::string& key) const {
    for (const auto& [entry, text] : trees_.front().second.entries()) {
      if (entry == key) {
        return text;
      }
    }
    return {};
  }
  bt::NodeLibrary& library() { return library_; }
  bt::CrowdState& society() { return society_; }
  sim2d::Intents& intents() { return *intents_; }

 private:
  void renewStep() {
    society_.motionOwners.assign(world_.people.size(), bt::MotionOwner::None);
    society_.changedGoals.assign(world_.people.size(), 0);
    society_.speech.beginStep();
  }

  FakeWorld& world_;
  bt::NodeLibrary library_;
  std::vector<sim2d::HumanControl> controls_;
  std::unique_ptr<sim2d::Intents> intents_;
  bt::CrowdState society_;
  std::vector<std::pair<int, bt::TreeState>> trees_;
  std::vector<sim2d::Intent> last_;
  std::vector<sim2d::Event> events_;
  base::Diagnostics found_;
};
