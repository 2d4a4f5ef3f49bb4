#pragma once

#include <vector>

#include "sim2d/trace/Tracks.h"

/// Parts of tracks between two observations; private to the folder.
namespace sim2d {

/// A body at one instant, every quantity filled in.
struct TrackState {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  double heading = 0.0, omega = 0.0;
};

/// A part of a track without absence, at least one observation; estimates missing quantities. The
/// observations must outlive it.
class TrackStay {
 public:
  TrackStay(const TrackPoint* begin, const TrackPoint* end);
  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }
  /// Within `slack` of an observation: that one, unchanged. Outside: the nearest.
  TrackState at(double time, double slack) const;
  /// The observation nearest in time, of two the earlier.
  const TrackPoint& nearest(double time) const;

 private:
  void fillHeadings(const TrackPoint* points);
  void fillTurning(const TrackPoint* points);

  const TrackPoint* points_;
  std::vector<double> times_;
  std::vector<TrackState> states_;
};

/// Cut where nothing was seen for longer than `longest` [s].
std::vector<TrackStay> staysOf(const Track& track, double longest);

}  // namespace sim2d
