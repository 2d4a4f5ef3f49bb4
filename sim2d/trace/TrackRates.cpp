#include "sim2d/trace/TrackRates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr double kAwaySteps = 5.5;       // longer without observation: not there
constexpr double kOtherRate = 1.5;       // times as often observed as another
constexpr std::size_t kEnough = 5;       // observations: fewer tell no rate
constexpr double kSlowest = 10.0;        // usual intervals: more seldom tells no way
constexpr double kAlwaysBelieved = 1.0;  // [s] people hardly turn in it

void appendIntervals(const Track& track, std::vector<double>& intervals) {
  for (std::size_t k = 1; k < track.points.size(); ++k) {
    intervals.push_back(track.points[k].time - track.points[k - 1].time);
  }
}

/// The lower of two middle ones: a gap between two observations is no rate.
double medianOf(std::vector<double> intervals) {
  if (intervals.empty()) {
    return 0.0;
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>((intervals.size() - 1) / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  constexpr double kDigits = 1e9;  // differences of decimal times end in noise
  const double rounded = std::round(*middle * kDigits) / kDigits;
  return rounded > 0.0 && std::isfinite(rounded) ? rounded : *middle;
}

}  // namespace

double medianInterval(const std::vector<Track>& tracks) {
  std::vector<double> intervals;
  for (const Track& track : tracks) {
    appendIntervals(track, intervals);
  }
  return medianOf(std::move(intervals));
}

double medianInterval(const Track& track) {
  std::vector<double> intervals;
  appendIntervals(track, intervals);
  return medianOf(std::move(intervals));
}

TrackRates::TrackRates(const TrackFile& file, double step) : file_(file), step_(step) {
  believed_ = std::max(kSlowest * medianInterval(file.tracks), kAlwaysBelieved);
  for (const Track& track : file.tracks) {
    if (const double interval = knownInterval(track); interval <= believed_) {
      slowest_ = std::max(slowest_, interval);
    }
  }
}

/// 0: there are too few observations.
double TrackRates::knownInterval(const Track& track) const {
  return track.points.size() >= kEnough ? medianInterval(track) : 0.0;
}

double TrackRates::longestGap(const Track& track) const {
  if (file_.isSparse) {
    return std::numeric_limits<double>::infinity();
  }
  const double known = knownInterval(track);
  const double own =
      known > 0.0 ? std::min(known, believed_) : std::min(medianInterval(track), slowest_);
  return kAwaySteps * std::max(step_, own);
}

bool TrackRates::tell(base::Diagnostics& problems) const {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  double seldom = 0.0;
  std::size_t count = 0;
  for (const Track& track : file_.tracks) {
    const double interval = knownInterval(track);
    if (interval > longestGap(track)) {
      seldom = std::max(seldom, interval);
      ++count;
    } else if (interval > 0.0) {
      least = std::min(least, interval);
      most = std::max(most, interval);
    }
  }
  if (file_.isSparse) {
    return false;
  }
  if (count > 0) {
    problems.push_back(
        base::warning("tracks.seen-seldom", {count, base::formatDouble(seldom)}, file_.file));
  }
  const bool differ = most > kOtherRate * least;
  if (differ) {
    problems.push_back(base::warning(
        "tracks.rates-differ-by-body",
        {base::formatDouble(least), base::formatDouble(most), base::formatDouble(step_)},
        file_.file));
  }
  return differ;
}

}  // namespace sim2d
