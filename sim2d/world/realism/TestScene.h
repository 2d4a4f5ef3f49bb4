#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Rng.h"
#include "sim2d/world/World.h"

namespace sim2d {

/// How a realism test is run.
struct RealismRun {
  std::string model = "sfm";
  long long seed = 1;
  std::function<bool()> wantsStop;  // may be empty
};

/// Thrown through a test to whoever measures.
struct NotPlayed {
  base::Diagnostic why;
};

/// A small world made in code: walls, people who know where to go, nothing else. SI, world frame.
class TestScene {
 public:
  /// Where somebody who stands at `place` heads for; the way there is straight or planned.
  using Target = std::function<Vec2(const Vec2& place)>;

  struct Actor {
    Vec2 start = Vec2::Zero();
    double speed = 1.34;  // v0 [m/s]
    Target target;
    std::optional<Vec2> goal = {};  // in the file; none: the target at the start
    double goalRadius = 0.3;        // in the file [m]
    /// Leaves the world then; empty: never.
    std::function<bool(const Vec2& place)> isDone = {};
    double heading = 0.0;  // [rad]
    double radius = 0.2;   // [m]
    int group = -1;
  };

  explicit TestScene(RealismRun run, double dt = 0.05);

  void add(Actor actor);
  void addWall(const std::vector<Vec2>& line);                   // 0.2 m thick
  void planWays() { scenario_.desktop.route = Route::Planned; }  // instead of straight ones
  /// A closed corridor from x = 0 to kRingLength, with walls at y = 0 and at its width.
  void addRing(double width);
  const std::vector<Actor>& actors() const { return actors_; }

  /// Steps for `seconds` and calls `look` after each step, until it returns false. A run that was
  /// stopped, failed, or could not begin: NotPlayed.
  using Look = std::function<bool(const World& world)>;
  void play(double seconds, const Look& look) const;
  double dt() const { return dt_; }
  /// As a file to open and watch: people with goals and generated trees instead of targets.
  Scenario scenario(const std::string& name, double duration) const;

 private:
  std::unique_ptr<World> build() const;

  RealismRun run_;
  double dt_;
  Scenario scenario_;
  std::vector<Actor> actors_;
};

constexpr double kRingLength = 26.0;  // [m]

/// Somebody who walks endlessly along the x axis.
TestScene::Actor ringWalker(const Vec2& start, double speed, bool goesLeft = false);
TestScene::Target endlessly(const Vec2& direction);
TestScene::Target always(const Vec2& place);

/// Free speeds of adults: normal, 1.34 ± 0.26 m/s (Weidmann 1993), cut at 0.5 and 2.2.
double freeSpeed(const RealismRun& run, int person, double mean = 1.34, double deviation = 0.26);

struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};
/// `count` places at random that are `apart` from each other, also across the ends when
/// `isClosed`; fewer when no more fit.
std::vector<Vec2> randomPlaces(const RealismRun& run, int count, const Box& box, double apart,
                               bool isClosed = false);

}  // namespace sim2d
