#pragma once

#include "sim2d/trace/Tracks.h"

/// How often the bodies of a file are observed; private to the folder.
namespace sim2d {

/// The middle of the times between two observations, the lower of two; 0 when there are none.
double medianInterval(const Track& track);

class TrackRates {
 public:
  /// `step` [s] of the record.
  TrackRates(const TrackFile& file, double step);

  /// A body that is unseen for longer is away [s]: 5.5 steps, or 5.5 intervals of its own. Its
  /// interval is believed up to 1 s or ten usual ones; of a body with few observations, up to that
  /// of the others. Infinite where points are corners of ways.
  double longestGap(const Track& track) const;

  /// Adds what is worth telling: rates that differ, bodies that are never there between two
  /// observations. True: the rates differ.
  bool tell(base::Diagnostics& problems) const;

 private:
  double knownInterval(const Track& track) const;

  const TrackFile& file_;
  double step_ = 1.0;      // [s]
  double believed_ = 1.0;  // [s] longest own interval that tells a way
  double slowest_ = 0.0;   // [s] of the bodies whose rate is known
};

}  // namespace sim2d
