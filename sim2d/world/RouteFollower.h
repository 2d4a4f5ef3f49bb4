#pragma once

#include <optional>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/HumanBehavior.h"

namespace sim2d {

/// A body that stands in the way.
struct StandingBody {
  Vec2 position = Vec2::Zero();
  double radius = 0.35;  // [m]
};

/// A place beside those who stand on the line from `from` to `next`, to be passed first: planned
/// ways know walls alone. The shortest one that a body of this radius can walk to and on from;
/// nothing when nobody stands there or there is no room.
std::optional<Vec2> placeBeside(const std::vector<StandingBody>& standing, double radius,
                                const Vec2& from, const Vec2& next,
                                const NavigationMap& navigation);

/// Where one person heads on the way to a target: keeps the path, drops way points that are passed,
/// plans anew when the person was pushed off or does not get on.
class RouteFollower {
 public:
  struct Request {
    Vec2 position = Vec2::Zero();
    GoalItem target;
    double radius = 0.35;  // of the body [m]
    double speed = 1.0;    // wanted [m/s]
    double time = 0.0;     // [s]
    double spread = 0.0;   // [m]; corners are passed so far outside of the shortest way, if it fits
  };
  struct Leg {
    Vec2 direction = Vec2::Zero();  // unit vector; zero: arrived, or there is no way
    bool replanned = false;
    bool stuck = false;
  };

  Leg follow(const Request& request, const NavigationMap& navigation, const Obstacles& obstacles);
  /// Of Route::Direct, for which nothing has to be kept.
  static Leg straight(const Request& request);
  /// Of use after `stuck`: first to a place beside those who stand in the way, if there is room.
  void goRound(const Request& request, const std::vector<StandingBody>& standing,
               const NavigationMap& navigation);
  void reset() { *this = RouteFollower{}; }

  /// The points still to be walked to.
  std::vector<Vec2> rest() const;
  /// Who waits is not stuck.
  void wait(double time) { progressAt_ = time; }
  /// Round what stands in the only straight way (`closed`: convex polygons, kept out of until there
  /// is another target). Another way is taken once the wait has been as long as it takes longer, or
  /// 10 s. True: it was taken.
  bool takeAnotherWay(const Request& request, const std::vector<std::vector<Vec2>>& closed,
                      double waited, const NavigationMap& navigation);

 private:
  void plan(const Request& request, const NavigationMap& navigation);
  void passWayPoints(const Request& request, const NavigationMap& navigation, bool looks);
  bool isLost(const Request& request, const NavigationMap& navigation, const Obstacles& obstacles);
  bool isStuck(const Request& request);
  Vec2 besideCorner(const Request& request, const NavigationMap& navigation) const;

  bool isOpen(const Vec2& from, const Vec2& to) const;

  std::vector<Vec2> path_;
  std::vector<std::vector<Vec2>> closed_;  // polygons to keep out of
  double searchedAt_ = -1e9;               // for another way [s]
  double searchPause_ = 0.0;               // until the next search [s]
  std::size_t next_ = 0;
  bool isRound_ = false;        // the next way point leads round somebody: it is not left out
  Vec2 beside_ = Vec2::Zero();  // from the next way point to where it is passed [m]
  Vec2 target_ = Vec2::Zero();
  int version_ = -1;         // of the navigation map; -1: no path yet
  double plannedAt_ = -1e9;  // [s]
  double lookedAt_ = -1e9;   // lines were last tested [s]
  double clearAt_ = 0.0;     // the next way point was last clear [s]
  double bestRest_ = 1e300;  // shortest rest of the path so far [m]
  double progressAt_ = 0.0;  // when the rest last became shorter [s]
};

}  // namespace sim2d
