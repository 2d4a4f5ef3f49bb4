#pragma once

#include <optional>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/HumanBehavior.h"

namespace sim2d {

/// A standing body.
struct StandingBody {
  Vec2 position = Vec2::Zero();
  double radius = 0.35;  // [m]
};

/// A place beside the bodies that stand on the line from `from` to `next`, to be passed first:
/// planned paths consider walls only. Chooses the shortest detour that a body of this radius can
/// walk; none if nothing is in the way or there is no space.
std::optional<Vec2> passingPoint(const std::vector<StandingBody>& standing, double radius,
                                 const Vec2& from, const Vec2& next,
                                 const NavigationMap& navigation);

/// Path following of one person: keeps the path, removes passed way points, and replans when the
/// person was pushed off the path or makes no progress.
class RouteFollower {
 public:
  struct Request {
    Vec2 position = Vec2::Zero();
    GoalItem target;
    double radius = 0.35;  // of the body [m]
    double speed = 1.0;    // desired [m/s]
    double time = 0.0;     // [s]
    double spread = 0.0;   // [m]; offset at corners outside of the shortest path
  };
  struct Guidance {
    Vec2 direction = Vec2::Zero();  // unit vector; zero: arrived, or no path
    bool replanned = false;
    bool stuck = false;
  };

  Guidance follow(const Request& request, const NavigationMap& navigation,
                  const Obstacles& obstacles);
  /// Direction for Route::Direct; stateless.
  static Guidance straight(const Request& request);
  /// Use after `stuck`: inserts a place beside standing bodies, if there is space.
  void insertDetour(const Request& request, const std::vector<StandingBody>& standing,
                    const NavigationMap& navigation);
  void reset() { *this = RouteFollower{}; }

  /// The remaining path points.
  std::vector<Vec2> rest() const;
  /// Resets the progress timer: a waiting person is not stuck.
  void wait(double time) { lastProgressTime_ = time; }
  /// Searches a path around the obstacles `closed` (convex polygons, avoided until the target
  /// changes). It is taken once the person has waited as long as it takes longer, or 10 s. Returns
  /// true if it was taken.
  bool tryAlternativePath(const Request& request, const std::vector<std::vector<Vec2>>& closed,
                          double waited, const NavigationMap& navigation);

 private:
  void plan(const Request& request, const NavigationMap& navigation);
  void passWayPoints(const Request& request, const NavigationMap& navigation, bool looks);
  bool isLost(const Request& request, const NavigationMap& navigation, const Obstacles& obstacles);
  bool isStuck(const Request& request);
  Vec2 cornerOffset(const Request& request, const NavigationMap& navigation) const;

  bool isOpen(const Vec2& from, const Vec2& to) const;

  std::vector<Vec2> path_;
  std::vector<std::vector<Vec2>> blockedAreas_;  // polygons to avoid
  double lastSearchTime_ = -1e9;                 // last search for another path [s]
  double searchPause_ = 0.0;                     // until the next search [s]
  std::size_t next_ = 0;
  bool isDetour_ = false;             // the next way point leads around a body and is not skipped
  Vec2 cornerOffset_ = Vec2::Zero();  // offset of the passing point from the next way point [m]
  Vec2 target_ = Vec2::Zero();
  int version_ = -1;               // of the navigation map; -1: no path yet
  double planTime_ = -1e9;         // [s]
  double lastCheckTime_ = -1e9;    // last visibility test [s]
  double lastClearTime_ = 0.0;     // time at which the next way point was last visible [s]
  double minRemaining_ = 1e300;    // minimum remaining path length so far [m]
  double lastProgressTime_ = 0.0;  // time at which it last decreased [s]
};

}  // namespace sim2d
