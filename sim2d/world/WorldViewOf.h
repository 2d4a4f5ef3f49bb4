#pragma once

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// The running world as behaviours and others read it.
class WorldViewOf : public WorldView {
 public:
  WorldViewOf(const WorldModel& model, const WorldState& state, const NeighborGrid& grid,
              const Obstacles& obstacles, const NavigationMap& navigation)
      : model_(model), state_(state), grid_(grid), obstacles_(obstacles), navigation_(navigation) {}

  std::int64_t step() const override { return state_.step + 1; }
  double time() const override { return state_.time; }
  double dt() const override { return model_.dt; }
  std::uint64_t seed() const override { return model_.seed; }
  const Environment& scenario() const override { return *model_.environment; }
  const Compatibility& compatibility() const override { return model_.compatibility; }

  int humanCount() const override { return static_cast<int>(model_.people.size()); }
  bool isPresent(int human) const override { return state_.present[at(human)] != 0; }
  int indexOf(int humanId) const override;
  const ResolvedHuman& constants(int human) const override {
    return model_.people[at(human)].constants;
  }
  int copiedFrom(int human) const override { return model_.people[at(human)].copiedFrom; }
  Pose2 pose(int human) const override { return state_.pose(at(human)); }
  Vec2 velocity(int human) const override { return state_.velocity(at(human)); }
  void near(int human, double range, std::vector<int>& found) const override;

  int robotCount() const override { return static_cast<int>(state_.robots.size()); }
  Pose2 robotPose(int robot) const override { return state_.robots[at(robot)].pose; }
  Vec2 robotVelocity(int robot) const override { return state_.robots[at(robot)].velocity; }
  double robotRadius(int robot) const override { return reachOf(model_.robots[at(robot)]); }
  int nearestRobot(int human) const override;

  std::optional<Vec2> globalGoal(int id) const override;
  const Area* area(const std::string& name) const override;
  bool isVisible(const Vec2& from, const Vec2& to) const override;
  bool isReachable(int human, const Vec2& point) const override;
  std::optional<double> wayLength(int human, const Vec2& point) const override;

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  const WorldModel& model_;
  const WorldState& state_;
  const NeighborGrid& grid_;
  const Obstacles& obstacles_;
  const NavigationMap& navigation_;
};

}  // namespace sim2d
