#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/PersonMotion.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// WorldView of the running world.
class WorldStateView : public WorldView {
 public:
  explicit WorldStateView(const FrozenWorld& world)
      : world_(world), model_(world.model), state_(world.state) {}

  std::optional<int> only;  // index of the only person who may decide; none: all

  std::int64_t step() const override { return state_.step + 1; }
  double time() const override { return state_.time; }
  double dt() const override { return model_.dt; }
  std::uint64_t seed() const override { return model_.drawSeed; }
  const Environment& scenario() const override { return *model_.environment; }
  const Compatibility& compatibility() const override { return model_.compatibility; }

  int humanCount() const override { return static_cast<int>(model_.people.size()); }
  bool isPresent(int human) const override { return state_.present[at(human)] != 0; }
  int indexOf(int humanId) const override {
    const int guess = model_.people.empty() ? -1 : humanId - model_.people.front().constants.id;
    if (guess >= 0 && guess < humanCount() && model_.people[at(guess)].constants.id == humanId) {
      return guess;  // consecutive ids
    }
    const auto found =
        std::lower_bound(model_.people.begin(), model_.people.end(), humanId,
                         [](const Person& person, int id) { return person.constants.id < id; });
    const bool isThere = found != model_.people.end() && found->constants.id == humanId;
    return isThere ? static_cast<int>(found - model_.people.begin()) : -1;
  }
  const ResolvedHuman& constants(int human) const override {
    return model_.people[at(human)].constants;
  }
  int copiedFrom(int human) const override { return model_.people[at(human)].copiedFrom; }
  Pose2 pose(int human) const override { return state_.pose(at(human)); }
  bool decides(int human) const override { return !only || *only == human; }
  Vec2 velocity(int human) const override { return state_.velocity(at(human)); }
  void near(int human, double range, std::vector<int>& found) const override {
    found.clear();
    const Vec2 centre = state_.position(at(human));
    world_.grid.forEachNear(centre, range, [&](int other) {
      if (other != human) {
        found.push_back(other);
      }
    });
    std::sort(found.begin(), found.end(), [&](int a, int b) {
      const double first = (state_.position(at(a)) - centre).norm();
      const double second = (state_.position(at(b)) - centre).norm();
      return first != second ? first < second : a < b;
    });
  }

  int robotCount() const override { return static_cast<int>(state_.robots.size()); }
  Pose2 robotPose(int robot) const override { return state_.robots[at(robot)].pose; }
  Vec2 robotVelocity(int robot) const override { return state_.robots[at(robot)].velocity; }
  double robotRadius(int robot) const override {
    return circumscribedRadius(model_.robots[at(robot)]);
  }
  int nearestRobot(int human) const override {
    int nearest = -1;
    double least = 0.0;
    for (int robot = 0; robot < robotCount(); ++robot) {
      const double distance = (robotPose(robot).position - state_.position(at(human))).norm();
      if (nearest < 0 || distance < least) {
        nearest = robot;
        least = distance;
      }
    }
    return nearest;
  }

  std::optional<Vec2> globalGoal(int id) const override {
    const auto found = model_.globalGoals.find(id);
    return found == model_.globalGoals.end() ? std::nullopt : std::optional<Vec2>(found->second);
  }
  const Area* area(const std::string& name) const override {
    const auto found = std::find_if(model_.areas.begin(), model_.areas.end(),
                                    [&](const Area* area) { return area->name == name; });
    return found == model_.areas.end() ? nullptr : *found;
  }
  bool isVisible(const Vec2& from, const Vec2& to) const override {
    constexpr int kQuirkNoOcclusion = 34;
    return model_.compatibility.has(kQuirkNoOcclusion) || world_.obstacles.isVisible(from, to);
  }
  bool isReachable(int human, const Vec2& point) const override {
    const ResolvedHuman& person = constants(human);
    return person.route == Route::Direct ||
           world_.navigation.isReachable(person.radius, state_.position(at(human)), point);
  }
  std::optional<double> pathLength(int human, const Vec2& point) const override {
    const ResolvedHuman& person = constants(human);
    if (person.route == Route::Direct) {
      return (point - state_.position(at(human))).norm();
    }
    const std::vector<Vec2> way =
        world_.navigation.plan(person.radius, state_.position(at(human)), point);
    return way.empty() ? std::nullopt : std::optional<double>(polylineLength(way));
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  const FrozenWorld& world_;
  const WorldModel& model_;
  const WorldState& state_;
};

struct WorldSetup;

/// Validated parts of a world.
struct WorldParts {
  WorldModel model;
  Surroundings surroundings;
  std::unique_ptr<NavigationMap> navigation;
  std::vector<std::shared_ptr<Planner>> planners;  // one per robot
};

/// Resolves the scenario, moves starts and goals to places where bodies fit, and removes
/// unreachable goals. Collects all problems.
base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup);

/// A moving disc.
struct MovingDisc {
  Vec2 position = Vec2::Zero();                          // [m]
  Vec2 velocity = Vec2::Zero();                          // desired; afterwards limited [m/s]
  double radius = 0.35;                                  // [m]
  double mass = 80.0;                                    // [kg]
  const std::vector<Obstacles::Point>* walls = nullptr;  // boundary points near the disc
};
struct DiscPair {
  int first = 0, second = 0;
  double shift = 0.0;  // offset of the second along x in a closed corridor [m]
};

/// What every world with people consists of.
class WorldBase {
 public:
  const WorldView& view() const { return view_; }
  HumanBehavior& behavior() { return *behavior_; }

 protected:
  /// Takes all parts except the planners. Nobody is present yet.
  WorldBase(WorldParts& parts, std::unique_ptr<HumanBehavior> humanBehavior);

  WorldModel model_;
  Surroundings surroundings_;
  const base::StopInhibitor pathWork_;  // keeps routing computations required
  std::unique_ptr<NavigationMap> navigation_;
  WorldState state_;
  NeighborGrid grid_;
  FrozenWorld frozen_;
  WorldStateView view_;
  Intents intents_;
  std::unique_ptr<HumanBehavior> behavior_;
  PersonMotion motion_;
  PersonGoals goals_;
  std::vector<double> headingsBefore_;  // of the people, before the step
  std::vector<MovingDisc> discs_;
  std::vector<DiscPair> pairs_;
  std::string failure_;
};

/// Converts the state to a frame, except paths of robots, inputs and tree changes. `frame` must
/// already contain the forces of all people in the step that led to it. The events are moved from
/// the state and sorted. Reuses the memory of the frame.
void fillFrame(const WorldModel& model, WorldState& state, Frame& frame);

/// All people so far with all resolved numbers, outlines, map.
TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings);

/// Names of the parts of the surroundings: "map", then listed obstacles, then listed doors.
std::vector<std::string> partNames(const Environment& scenario);

/// Limits velocities that would press discs into each other or into walls before the step ends:
/// each such pair loses its closing speed by a plastic impact shared by mass, in the given order,
/// repeated until nothing changes. Discs stop half a millimetre before contact.
void keepApart(std::vector<MovingDisc>& discs, const std::vector<DiscPair>& pairs, double dt);

constexpr std::size_t kSolverPeopleLimit = 65;  // people; up to here the solver handles all

}  // namespace sim2d
