#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/nav/Observation.h"

/// First hits of lidar beams, computed shape by shape instead of ray by ray.
namespace sim2d {

using base::Vec2;

/// Two discs; world frame.
struct Legs {
  Vec2 left = Vec2::Zero(), right = Vec2::Zero();  // [m]
  double radius = 0.06;                            // [m]
};

/// Step length L = sqrt(W v) [m] at speed v [m/s]. The walk ratio W (step length over step rate)
/// does not depend on speed; 0.0065 m/(steps/min) = 0.39 m s in adults (Sekiya & Nagasaki 1998,
/// Gait & Posture 7). v = 1.34 m/s: L = 0.72 m, 111 steps/min. 0 when standing.
double stepLength(double speed);

/// Legs of a pedestrian at a gait phase in [0, 1), half a shoulder width (0.1 m) to either side.
/// The left leg moves linearly from the foremost position (0) to the rearmost (0.5) and back (1),
/// the right one opposite. The amplitude is half a step, so that the foot on the ground does not
/// slide; less if the legs would leave the disc of the body. Standing: side by side.
Legs legsAt(const SensedBody& person, double stride);

/// Gait phase of each pedestrian, from the distance walked; a stride is two steps. Initial phases
/// are drawn from (seed, person), so all gaits of one seed agree. Not thread-safe.
class LegGait {
 public:
  explicit LegGait(std::uint64_t seed) : seed_(seed) {}

  /// Call once per step. Pedestrians in `bodies` are sorted by id; new ones start with a drawn
  /// phase.
  void update(const std::vector<SensedBody>& bodies);
  /// Phase of the body with that index in the last update, in [0, 1); 0 for robots.
  double gaitPhase(std::size_t number) const { return walkers_[number].stride; }

 private:
  struct Walker {
    int id = -1;  // -1: a robot
    Vec2 position = Vec2::Zero();
    double stride = 0.0;
  };

  std::uint64_t seed_;
  std::vector<Walker> walkers_, before_;  // same order as `bodies`
};

/// Beams from the origin, evenly spaced counter-clockwise from +x. A shape covers an interval of
/// beams, found by a pseudo-angle that is monotonic in the angle; 1/distance to a straight edge is
/// linear in the beam's direction, so a beam costs two products and no division. The results equal
/// those of casting each beam alone. Allocates in the constructor only. Not thread-safe.
class LidarRaster {
 public:
  /// `angleIncrement` [rad] in [1e-4, 2 pi], the beams within one turn; `range` [m] > 0.
  LidarRaster(int beams, double angleIncrement, double range);

  void clear();  // no hits
  void block();  // the origin is inside a solid: all distances are 0
  /// Adds an edge that is visible from its right side only; the solid lies to the left of a→b.
  void addEdge(const Vec2& a, const Vec2& b);
  void addCircle(const Vec2& centre, double radius);

  /// Beam indices [first, end); indices beyond the last beam wrap around: `beams` is beam 0 again.
  struct Beams {
    int first = 0, end = 0;
  };
  /// Beams that hit the circle; all beams if the origin lies in it.
  Beams beamsOf(const Vec2& centre, double radius) const;
  /// True if each of these beams has a hit nearer than `distance` [m].
  bool areCovered(const Beams& beams, double distance) const;
  /// Adds a circle that lies inside the larger one for which `beams` were computed.
  void addCircle(const Vec2& centre, double radius, const Beams& beams);

  /// [m]; `range` for beams without a hit within it.
  void writeDistances(std::vector<double>& distances) const;

 private:
  /// Monotonic in the angle: [0, 4] for a full turn from +x.
  static double pseudoAngle(const Vec2& direction);
  int firstFrom(double pseudo) const;
  Beams beamsBetween(const Vec2& first, const Vec2& last) const;
  void rasterizeEdge(int first, int end, const Vec2& slope);
  void rasterizeCircle(int first, int end, const Vec2& centre, double radius);
  void castBeam(int beam, const Vec2& a, const Vec2& b);
  Vec2 directionOfBeam(int beam) const;
  template <class Visit>
  void forRanges(const Beams& beams, Visit visit) const;

  int beams_;
  double range_;
  double perPseudo_;  // buckets per unit of pseudo-angle
  std::vector<double> cosines_, sines_, pseudos_;
  std::vector<int> start_;  // per pseudo-angle bucket: first beam at or after its start
  std::vector<double> inverseDistances_;  // 1/distance [1/m], per beam
};

/// Snapshot of the surroundings of a planar lidar, and the computation of its scan.

struct LidarParameters {
  int beams = 360;               // >= 1
  double range = 30.0;           // [m] > 0
  double rate = 10.0;            // scans per second [Hz] > 0
  double angleMin = -base::kPi;  // [rad], of the first beam
  double angleMax = base::kPi;   // [rad], of the last beam; above angleMin, by a full turn at most
  Pose2 mount;                   // in the robot's frame
  double noise = 0.0;            // standard deviation of a distance [m] >= 0
  bool legs = true;              // people are two legs; otherwise discs
};

/// Preconditions of a lidar: beams at least 1e-4 rad apart and within a turn, range and rate above
/// 0.
bool areValidParameters(const LidarParameters& parameters);

/// The world at the instant of a scan, from which the scan can be computed at any later time. World
/// frame.
struct LidarSnapshot {
  std::int64_t number = -1;
  std::uint64_t seed = 0;
  double time = 0.0;                                  // [s]
  Pose2 sensor;                                       // sensor pose as estimated by the robot
  Pose2 mapToOdom;                                    // of the robot
  Vec2 origin = Vec2::Zero();                         // true position of the sensor
  Vec2 ahead{1.0, 0.0};                               // direction of the first beam
  bool isInsideObstacle = false;                      // then all distances are 0
  std::shared_ptr<const std::vector<Segment>> walls;  // never null; all walls within range
  std::vector<SensedBody> bodies;
  std::vector<double> gaitPhases;  // gait phase per body, in [0, 1); empty: people are discs
};

/// Computes the scans of a lidar's snapshots. Thread-safe (calls are serialised). Allocates nothing
/// after the first scan.
class LidarScanner {
 public:
  /// `sensor` in [0, 1023]: index of the lidar on the robot.
  LidarScanner(const LidarParameters& parameters, int robotId, int sensor);

  void cast(const LidarSnapshot& turn, LaserScan& scan);

 private:
  void addBodies(const LidarSnapshot& turn);
  void addPerson(const LidarSnapshot& turn, std::size_t number);
  void addPolygon(const LidarSnapshot& turn, const SensedBody& robot);
  void addNoise(const LidarSnapshot& turn, std::vector<double>& distances) const;

  LidarParameters parameters_;
  int robotId_;
  int sensor_;
  std::mutex mutex_;  // guards the raster
  LidarRaster raster_;
};

/// Planar lidar on a robot.

/// Whether a scan is read: `Later` means possibly after the step, or never.
enum class ScanDemand : std::uint8_t { None, Later, Now };

/// Beams are evenly spaced from angleMin to angleMax; over a full turn the spacing is a turn /
/// beams, so that the last beam does not coincide with the first. The spacing is at least 1e-4 rad.
/// A scan is taken at one instant. If the sensor is inside a wall or body, all distances are 0.
///
/// Each measured distance has an independent Gaussian error, drawn from (seed, robot, scan number,
/// sensor, beam) and clamped to [0, range]; beams without a hit have exactly `range`. Not
/// thread-safe. Allocates nothing after the first scan unless the crowd or the number of walls
/// grows, or scans are deferred.
class Lidar {
 public:
  static constexpr double kWallMargin = 2.0;  // [m]

  /// `sensor` in [0, 1023]: index of the lidar on the robot.
  Lidar(const LidarParameters& parameters, std::uint64_t seed, int robotId, int sensor = 0);
  ~Lidar() = default;
  Lidar(const Lidar&) = delete;  // state is shared with its own deferred scans only
  Lidar& operator=(const Lidar&) = delete;
  Lidar(Lidar&&) = default;
  Lidar& operator=(Lidar&&) = default;

  /// Call once per step. The n-th scan is due at n / rate and taken at the first step not before
  /// that; of several due scans only the last is taken. Returns whether this step's scan was
  /// computed. A deferred scan is computed when a later call uses `Now`. With `None` legs keep
  /// moving but no scan is taken; later scans are the same.
  bool update(const SensedWorld& world, ScanDemand use = ScanDemand::Now);
  /// Sets the seed for further scans; the legs are not affected.
  void reseed(std::uint64_t seed) { seed_ = seed; }
  /// The last scan that was computed, stamped with the time of its step; null before the first.
  const LaserScan* scan() const { return scan_.distances.empty() ? nullptr : &scan_; }
  /// The last scan, if it is deferred and not computed yet; otherwise null. The footprints of its
  /// bodies belong to the world that it was taken from.
  const std::shared_ptr<const LidarSnapshot>& deferredSnapshot() const { return deferredSnapshot_; }
  const std::shared_ptr<LidarScanner>& caster() const { return caster_; }

 private:
  void take(const SensedWorld& world, LidarSnapshot& turn);
  void gatherWalls(const Obstacles& obstacles, const Vec2& from);

  LidarParameters parameters_;
  std::uint64_t seed_;
  std::int64_t number_ = -1;  // of the last scan
  LegGait gait_;
  std::shared_ptr<LidarScanner> caster_;
  LidarSnapshot turn_;  // reused buffer
  LaserScan scan_;
  std::shared_ptr<const LidarSnapshot> deferredSnapshot_;

  /// Walls within range and margin of the place where they were gathered.
  std::shared_ptr<std::vector<Segment>> walls_;
  bool areWallsShared_ = false;  // with deferred scans
  Vec2 wallsFrom_ = Vec2::Zero();
  std::vector<char> wallParts_;  // which were enabled at that time
};

}  // namespace sim2d
