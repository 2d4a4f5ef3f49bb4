#pragma once

#include <vector>

#include "sim2d/nav/Body.h"
#include "sim2d/nav/Observation.h"

namespace sim2d {

/// Cache of distances to walls and scan points on a lattice around one robot; values stay valid
/// while it drives. Not thread-safe.
class ClearanceCache {
 public:
  /// `spacing` of the lattice [m]; `limit`: distances are computed up to this value [m].
  ClearanceCache(double spacing, double limit);

  /// Must be called before the queries of one step; the arguments must outlive them. Wall distances
  /// are invalidated when a door has moved, point distances when `pointsTime` [s] changes.
  void update(const Observation& observation, const std::vector<Vec2>& points, double pointsTime);

  /// Lower bound of the distance [m] to the nearest wall or point: 0 inside a solid, `limit` if
  /// nothing is nearer. Interpolated between four lattice nodes so that it never overestimates: the
  /// squared distance d² to any set, minus |p|², is a concave function of p, hence d²(p) >= mean of
  /// d² at the corners - (mean of |corner|² - |p|²).
  double distanceAt(const Vec2& place);

 private:
  struct Place {
    int column = 0, row = 0;
    int wallsRevision = 0, pointsRevision = 0;  // revisions at which they were computed; 0: never
    double toWalls = 0.0;                       // [m²]
    double toPoints = 0.0;                      // [m²]
  };
  double squaredAt(int column, int row);
  double squaredToWalls(const Vec2& place) const;
  double squaredToPoints(const Vec2& place) const;

  double spacing_, limit_;
  std::vector<Place> places_;  // node (column, row) is stored at the lowest bits of both
  const Obstacles* obstacles_ = nullptr;
  const NavigationMap* navigation_ = nullptr;
  const std::vector<Vec2>* points_ = nullptr;
  int version_ = -1;          // of the navigation map
  double pointsTime_ = -1e9;  // [s]
  int wallsRevision_ = 0, pointsRevision_ = 0;
};

/// Minimum gaps of one robot to walls, scan points and people along a trajectory of poses at equal
/// time steps. People are assumed to move at constant velocity. Not thread-safe.
class SweptClearance {
 public:
  /// `wide`: gaps are computed up to this limit [m].
  SweptClearance(const RobotBody& body, double wide);

  /// Sets the observation for the queries that follow. A gap below `margin` [m] counts as a hit; if
  /// the gap is already smaller now, a decreasing gap counts. People who cannot come near within
  /// `time` [s] at a robot speed of at most `speed` [m/s] are ignored.
  void observe(const Observation& observation, double margin, double speed, double time);

  struct Trajectory {
    const std::vector<Pose2>& poses;  // the current one first
    double step = 0.1;                // [s] between them
    double speed = 1.0;               // upper bound of the speed of the centre [m/s]
  };
  struct Evaluation {
    int wallStep = 0;  // first pose that hits a wall or scan point; poses.size(): none
    int bodyStep = 0;  // same for people and robots
    double gap = 0.0;  // minimum gap up to the hit [m]; at most `wide`
  };
  Evaluation along(const Trajectory& way);

  /// Whether the robot stops before it hits anything if it follows the trajectory for `hold` [s]
  /// and then brakes evenly within `stopTime` [s]. For walls this is v <= sqrt(2 d a) (Fox, Burgard
  /// & Thrun 1997, eq. 14) with the distance d left after `hold`. A person who walks into the robot
  /// does not count unless the robot itself moves closer.
  bool canStop(const Trajectory& way, const Evaluation& found, double hold, double stopTime) const;

  /// Scan points that belong neither to known walls nor to known bodies; world frame [m].
  const std::vector<Vec2>& points() const { return points_; }
  /// Gap to the nearest body ahead of the robot [m]; infinite if none is near.
  double gapAhead() const { return gapAhead_; }

 private:
  struct NearbyBody {
    Vec2 position = Vec2::Zero(), velocity = Vec2::Zero();
    double radius = 0.0;
    double speed = 0.0;
    double least = 0.0;   // a smaller gap is a hit [m]
    double gapNow = 0.0;  // [m]
  };
  void updateBodies(const Observation& observation, double speed, double time);
  void updatePoints(const Observation& observation);
  bool isExplained(const Observation& observation, const Vec2& point) const;
  double contactGap(double gapNow) const;
  double gapTo(const NearbyBody& body, const Pose2& pose, double time) const;
  double gapToWall(const Pose2& pose);
  void checkWalls(const Trajectory& way, Evaluation& found);
  void checkBody(const Trajectory& way, const NearbyBody& body, Evaluation& found) const;
  bool isHitAt(const Pose2& before, const Pose2& pose, double time) const;

  RobotBody body_;
  double reach_, maxGap_;
  double margin_ = 0.0;
  double wallContactGap_ = 0.0;  // a smaller gap to walls is a hit [m]
  double gapAhead_ = 0.0;
  ClearanceCache cache_;
  std::vector<NearbyBody> near_;
  std::vector<Vec2> points_;
  double scanTime_ = -1e9;  // [s]
  const Obstacles* obstacles_ = nullptr;
};

}  // namespace sim2d
