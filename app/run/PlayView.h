#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/world/HumanBehavior.h"

namespace app {

/// The world of a tree that is played alone: one person at the origin, nobody and nothing else.
class PlayView final : public sim2d::WorldView {
 public:
  PlayView(double dt, std::uint64_t seed, const sim2d::Compatibility& compatibility)
      : dt_(dt), seed_(seed), compatibility_(compatibility) {
    person_.id = 1;
    person_.name = "agent1";
  }
  void beginStep() { ++step_; }

  std::int64_t step() const override { return step_; }
  double time() const override { return static_cast<double>(step_ - 1) * dt_; }
  double dt() const override { return dt_; }
  std::uint64_t seed() const override { return seed_; }
  const sim2d::Scenario& scenario() const override { return scenario_; }
  const sim2d::Compatibility& compatibility() const override { return compatibility_; }

  int humanCount() const override { return 1; }
  bool isPresent(int) const override { return true; }
  int indexOf(int humanId) const override { return humanId == person_.id ? 0 : -1; }
  const sim2d::ResolvedHuman& constants(int) const override { return person_; }
  base::Pose2 pose(int) const override { return {}; }
  base::Vec2 velocity(int) const override { return base::Vec2::Zero(); }
  void near(int, double, std::vector<int>& found) const override { found.clear(); }

  int robotCount() const override { return 0; }
  base::Pose2 robotPose(int) const override { return {}; }
  base::Vec2 robotVelocity(int) const override { return base::Vec2::Zero(); }
  double robotRadius(int) const override { return 0.0; }
  int nearestRobot(int) const override { return -1; }

  std::optional<base::Vec2> globalGoal(int) const override { return std::nullopt; }
  const sim2d::Area* area(const std::string&) const override { return nullptr; }
  bool isVisible(const base::Vec2&, const base::Vec2&) const override { return true; }
  bool isReachable(int, const base::Vec2&) const override { return true; }

 private:
  std::int64_t step_ = 0;
  double dt_;
  std::uint64_t seed_;
  sim2d::Compatibility compatibility_;
  sim2d::Scenario scenario_;
  sim2d::ResolvedHuman person_;
};

}  // namespace app
