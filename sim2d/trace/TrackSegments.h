#pragma once

#include <vector>

#include "sim2d/trace/Tracks.h"

/// Observation rates of the bodies in a file. Private to the folder.
namespace sim2d {

/// Lower median of the time between two observations; 0: fewer than two.
double medianInterval(const Track& track);

class TrackRates {
 public:
  /// `step`: of the recording [s].
  TrackRates(const TrackFile& file, double step);

  /// Longest gap [s] that is interpolated; after a longer one the body is absent: 5.5 steps, or 5.5
  /// of its own intervals. Its interval is used up to 1 s or ten median intervals; for a body with
  /// few observations, up to the longest of the others. Infinite if the points are corners of
  /// paths.
  double longestGap(const Track& track) const;

  /// Adds warnings about differing rates and about bodies that are too sparse to interpolate. True:
  /// the rates differ.
  bool report(base::Diagnostics& problems) const;

 private:
  double knownInterval(const Track& track) const;

  const TrackFile& file_;
  double step_ = 1.0;             // [s]
  double trustedInterval_ = 1.0;  // [s], longest own interval that is interpolated
  double slowest_ = 0.0;          // [s], among bodies with a known rate
};

/// Contiguous parts of tracks. Private to the folder.

/// The complete state of a body at one instant.
struct TrackState {
  Vec2 position = Vec2::Zero();
  Vec2 velocity = Vec2::Zero();
  double heading = 0.0, omega = 0.0;
};

/// A part of a track without absence, with at least one observation; estimates missing quantities.
/// The observations must outlive it.
class TrackSegment {
 public:
  TrackSegment(const TrackPoint* begin, const TrackPoint* end);
  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }
  /// Within `slack` of an observation: that observation; outside the interval: the nearest one;
  /// else interpolated.
  TrackState at(double time, double slack) const;
  /// The observation nearest in time; the earlier one of two.
  const TrackPoint& nearest(double time) const;

 private:
  void fillHeadings(const TrackPoint* points);
  void fillTurning(const TrackPoint* points);

  const TrackPoint* points_;
  std::vector<double> times_;
  std::vector<TrackState> states_;
};

/// Splits a track at gaps longer than `longest` [s].
std::vector<TrackSegment> segmentsOf(const Track& track, double longest);

// Problems of tracks. Private to the folder.

/// Reports problems with times, positions, ids and the choice of the robot. Returns the robot;
/// null: none.
const Track* checkTracks(const TrackFile& file, const TrackOptions& options,
                         base::Diagnostics& problems);

/// Limits diagnostics to ten per kind and adds the number of omitted ones: a file read in the wrong
/// format has one per line.
base::Diagnostics limitedPerKind(const base::Diagnostics& problems);

}  // namespace sim2d
