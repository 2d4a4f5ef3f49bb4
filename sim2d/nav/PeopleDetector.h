#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "sim2d/base/Types.h"
#include "sim2d/nav/Observation.h"

/// Velocity estimation from successive positions.
namespace sim2d {

using base::Vec2;

/// Kalman filter of a body with nearly constant velocity, per axis. State (p, v), measurement z = p
/// + w, w ~ N(0, sigma_w²); the acceleration is white noise of power spectral density q. Prediction
/// over a time T:
///   F = (1 T; 0 1),  Q = q (T³/3 T²/2; T²/2 T),  x' = F x,  P' = F P F^T + Q;
/// measurement update:
///   S = P_pp + sigma_w²,  K = (P_pp, P_vp)^T / S,  x' = x + K (z - p),  P' = P - K (P_pp P_pv).
/// Both axes share P. Source: Bar-Shalom, Li & Kirubarajan 2001, Estimation with Applications to
/// Tracking and Navigation, ch. 5.2.3 and 6.2.2 (continuous white noise acceleration). With
/// constant T it converges to an alpha-beta filter.
class ConstantVelocityFilter {
 public:
  /// sigma_w [m] >= 0, q [m²/s³] > 0: within a second the velocity changes by sqrt(q) on each axis.
  ConstantVelocityFilter(double placeNoise, double accelerationPower)
      : positionVariance_(placeNoise * placeNoise), accelerationPower_(accelerationPower) {}

  /// First measurement; the velocity is initialised to 0 ± 1 m/s on each axis.
  void start(const Vec2& place);
  void predict(double duration);  // T [s] >= 0
  void correct(const Vec2& place);

  const Vec2& position() const { return position_; }  // [m]
  const Vec2& velocity() const { return velocity_; }  // [m/s]

 private:
  double positionVariance_, accelerationPower_;
  Vec2 position_ = Vec2::Zero(), velocity_ = Vec2::Zero();
  double pp_ = 0.0, pv_ = 0.0, vv_ = 0.0;  // P [m²], [m²/s], [m²/s²]
};

/// Angular intervals that are occluded from a viewpoint.

/// Union of angular intervals about one viewpoint [rad]. An interval runs counter-clockwise from
/// `from` over `width` in [0, 2 pi] and may cross ±pi. Exact up to rounding.
class AngularIntervalSet {
 public:
  void clear() { intervals_.clear(); }
  void add(double from, double width);
  /// Length of the part of the interval that is covered [rad].
  double covered(double from, double width) const;

 private:
  struct Interval {
    double low = 0.0, high = 0.0;  // in [-pi, pi]
  };
  void addUnwrapped(double low, double high);
  double coveredUnwrapped(double low, double high) const;

  std::vector<Interval> intervals_;  // ascending, disjoint
};

/// Perception of people and other robots: detections with gaps and errors, filtered into tracks.

struct DetectorParameters {
  double range = 10.0;             // of centres [m] > 0
  double field = 2.0 * base::kPi;  // full angle about the heading [rad]
  double rate = 10.0;              // cycles per second [Hz]; 0: one per step
  double latency = 0.1;            // from detection to report [s] >= 0
  double noise = 0.05;             // standard deviation of each coordinate [m] >= 0
  double misses = 0.05;            // probability per visible body and cycle
  double swaps = 0.01;             // probability per close pair of people and cycle
  double swapDistance = 0.8;       // between the centres of a close pair [m]
  bool isOccluded = true;          // walls and other bodies occlude
  double maxOcclusion = 0.5;       // of its angle; a body occluded to a larger part is not detected
  double coastTime = 1.0;          // [s]; a track that is not detected for longer is deleted
  double accelerationPower = 0.5;  // q of the filter [m²/s³] > 0
  bool measuresVelocity = false;   // velocity and heading are exact, without filter
};
/// All bodies everywhere, as they are at this step.
DetectorParameters groundTruthDetector();
/// Without errors: all bodies in default range and not occluded, as they are at this step.
DetectorParameters idealDetector();

/// Cycle n is taken at the first step not before n / rate; of several due cycles only the last is
/// taken. A body is detected when its centre is in range and in the field of view, no wall hides
/// the centre (Obstacles::isVisible), nearer bodies occlude at most `maxOcclusion` of its angular
/// width, and it is not missed at random. The detected position has an error and is relative to the
/// robot's odometry. Two people who are detected close to each other may swap their tracks
/// permanently; initially track ids are body ids. Robots are never swapped.
///
/// Positions are filtered into tracks (ConstantVelocityFilter). The heading of a track is that of
/// its velocity once it exceeds 0.2 m/s, and 0 before. A track without detection coasts at constant
/// velocity from cycle to cycle and is deleted after `coastTime`.
///
/// The detections of a cycle are reported at the first step not before its time + latency,
/// unchanged: there is no extrapolation between cycles or over the latency.
///
/// Draws are functions of (seed, robot, cycle, body or pair). Not thread-safe. Does not allocate
/// once its buffers have grown, except for swaps.
class PeopleDetector {
 public:
  PeopleDetector(const DetectorParameters& parameters, std::uint64_t seed, int robotId);

  void update(const SensedWorld& world);  // call once per step
  /// Sets the seed for further cycles.
  void reseed(std::uint64_t seed) { seed_ = seed; }
  /// Last report: people, then robots, sorted by id.
  const std::vector<TrackedBody>& bodies() const { return bodies_; }

 private:
  struct Candidate {  // a body in range
    std::size_t number = 0;
    double distance = 0.0;           // [m]
    double from = 0.0, width = 0.0;  // angle that it spans, world frame [rad]
  };
  struct Cycle {
    double time = 0.0;              // [s]
    std::vector<TrackedBody> seen;  // sorted by kind and track id
  };
  struct Track {
    TrackedBody body;
    ConstantVelocityFilter filter;
    double time = 0.0, lastSeen = 0.0;  // [s]
  };

  bool beginCycle(double time);
  void detect(const SensedWorld& world);
  void findCandidates(const SensedWorld& world);
  void findBodiesInSight(const SensedWorld& world);
  bool isInSight(const Candidate& candidate, const SensedWorld& world) const;
  static void setAngularSpan(Candidate& candidate, const Vec2& eye, const SensedBody& body);
  bool isInFieldOfView(const Pose2& eye, const Vec2& place) const;
  double uniformDraw(std::uint32_t index) const;
  TrackedBody measurementOf(const SensedWorld& world, const SensedBody& body) const;
  void swapTracks(const std::vector<SensedBody>& bodies);
  int trackOf(int person) const;
  void report(const Cycle& cycle);
  Track newTrack(const TrackedBody& seen, double time) const;
  void updateTrack(Track& track, const TrackedBody& seen, double time) const;
  void coast(Track& track, double time) const;
  bool isLost(const Track& track) const;

  DetectorParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  std::int64_t cycle_ = -1;
  AngularIntervalSet occludedAngles_;
  std::map<int, int> trackIds_;        // track ids of people who were swapped; one to one
  std::vector<Candidate> candidates_;  // of this cycle
  std::vector<std::size_t> seen_;      // body indices of this cycle
  std::vector<Cycle> pendingCycles_, reusedCycles_;  // oldest first; cycles whose memory is reused
  std::vector<Track> tracks_, tracksBefore_;         // sorted by kind and id
  std::vector<TrackedBody> bodies_;
};

}  // namespace sim2d
