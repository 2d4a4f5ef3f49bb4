#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "sim2d/nav/AngularCover.h"
#include "sim2d/nav/MotionFilter.h"
#include "sim2d/nav/SensedWorld.h"

/// How a robot knows of people and other robots: seen with gaps and errors, followed as tracks.
namespace sim2d {

struct DetectorParameters {
  double range = 10.0;             // of centres [m] > 0
  double field = 2.0 * base::kPi;  // whole angle about the heading [rad]
  double rate = 10.0;              // cycles per second [Hz]; 0: one at each step
  double latency = 0.1;            // from sight to report [s] >= 0
  double noise = 0.05;             // standard deviation of each coordinate [m] >= 0
  double misses = 0.05;            // probability by body in sight and cycle
  double swaps = 0.01;             // probability by close pair of people and cycle
  double swapDistance = 0.8;       // of the centres of a close pair [m]
  bool isOccluded = true;          // walls and other bodies hide
  double hiddenShare = 0.5;        // of its angle; hidden by others to more than that: not seen
  double coastTime = 1.0;          // [s]; a track that is not seen for longer goes
  double accelerationPower = 0.5;  // q of the filter [m²/s³] > 0
  bool isMotionMeasured = false;   // velocity and heading are seen as they are, no filter
};
/// Everybody, everywhere, as he is at this step.
DetectorParameters groundTruth();
/// Without faults: who is within the usual range and not hidden, as he is at this step.
DetectorParameters idealDetector();

/// A cycle of number n is taken at the first step not before n / rate; of several that are due only
/// the last one. In it a body is seen when its centre lies in range and field, no wall stands
/// before the centre (Obstacles::isVisible), nearer bodies hide no more than `hiddenShare` of the
/// angle that it spans, and it is not missed. Its place is seen with an error and told as the
/// robot's odometry has it. Two people who are both seen close to each other may swap their tracks,
/// for good: ids of tracks are first those of the bodies. Robots are never swapped.
///
/// Places are filtered to tracks (MotionFilter). The heading of a track is that of its velocity
/// once that is faster than 0.2 m/s, before 0. A track that is not seen coasts at its velocity from
/// cycle to cycle, and goes once it has not been seen for longer than `coastTime`.
///
/// What a cycle saw is told at the first step not before its time + latency, as it was then:
/// neither between cycles nor for the latency is anything extrapolated.
///
/// Draws are functions of (seed, robot, cycle, body or pair). Thread: one at a time. Takes no
/// memory once its buffers have grown, but for swaps.
class PeopleDetector {
 public:
  PeopleDetector(const DetectorParameters& parameters, std::uint64_t seed, int robotId);

  void update(const SensedWorld& world);  // each step
  /// Draws of further cycles.
  void reseed(std::uint64_t seed) { seed_ = seed; }
  /// People, then robots, by id: what has been told last.
  const std::vector<TrackedBody>& bodies() const { return bodies_; }

 private:
  struct Candidate {  // a body in range
    std::size_t number = 0;
    double distance = 0.0;           // [m]
    double from = 0.0, width = 0.0;  // the angle that it spans, world frame [rad]
  };
  struct Cycle {
    double time = 0.0;              // [s]
    std::vector<TrackedBody> seen;  // by kind and id of the track
  };
  struct Track {
    TrackedBody body;
    MotionFilter filter;
    double time = 0.0, lastSeen = 0.0;  // [s]
  };

  bool beginCycle(double time);
  void look(const SensedWorld& world);
  void findCandidates(const SensedWorld& world);
  void findBodiesInSight(const SensedWorld& world);
  bool isInSight(const Candidate& candidate, const SensedWorld& world) const;
  static void setSpan(Candidate& candidate, const Vec2& eye, const SensedBody& body);
  bool isInField(const Pose2& eye, const Vec2& place) const;
  double chance(std::uint32_t index) const;
  TrackedBody measured(const SensedWorld& world, const SensedBody& body) const;
  void swapTracks(const std::vector<SensedBody>& bodies);
  int trackOf(int person) const;
  void tell(const Cycle& cycle);
  Track started(const TrackedBody& seen, double time) const;
  void follow(Track& track, const TrackedBody& seen, double time) const;
  void coast(Track& track, double time) const;
  bool isLost(const Track& track) const;

  DetectorParameters parameters_;
  std::uint64_t seed_;
  int robotId_;
  std::int64_t cycle_ = -1;
  AngularCover hidden_;
  std::map<int, int> swapped_;                // tracks of people who have not their own; one to one
  std::vector<Candidate> candidates_;         // of this cycle
  std::vector<std::size_t> seen_;             // idem: numbers of bodies
  std::vector<Cycle> untold_, told_;          // oldest first; those whose memory is used again
  std::vector<Track> tracks_, tracksBefore_;  // by kind and id
  std::vector<TrackedBody> bodies_;
};

}  // namespace sim2d
