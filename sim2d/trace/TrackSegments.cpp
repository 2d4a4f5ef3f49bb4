#include "sim2d/trace/TrackSegments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr double kAbsenceSteps = 5.5;        // longer gaps mean absence
constexpr double kRateRatio = 1.5;           // ratio that counts as a different rate
constexpr std::size_t kMinObservations = 5;  // minimum observations to determine a rate
constexpr double kMaxTrustedRatio = 10.0;    // median intervals: too sparse to infer motion
constexpr double kMinTrustedInterval = 1.0;  // [s], people hardly turn within this time

void appendIntervals(const Track& track, std::vector<double>& intervals) {
  for (std::size_t k = 1; k < track.points.size(); ++k) {
    intervals.push_back(track.points[k].time - track.points[k - 1].time);
  }
}

/// The lower median: with two values, the longer may be a gap.
double medianOf(std::vector<double> intervals) {
  if (intervals.empty()) {
    return 0.0;
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>((intervals.size() - 1) / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  constexpr double kDigits = 1e9;  // rounds off errors of decimal times
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
  trustedInterval_ = std::max(kMaxTrustedRatio * medianInterval(file.tracks), kMinTrustedInterval);
  for (const Track& track : file.tracks) {
    if (const double interval = knownInterval(track); interval <= trustedInterval_) {
      slowest_ = std::max(slowest_, interval);
    }
  }
}

/// 0: too few observations.
double TrackRates::knownInterval(const Track& track) const {
  return track.points.size() >= kMinObservations ? medianInterval(track) : 0.0;
}

double TrackRates::longestGap(const Track& track) const {
  if (file_.isSparse) {
    return std::numeric_limits<double>::infinity();
  }
  const double known = knownInterval(track);
  const double own =
      known > 0.0 ? std::min(known, trustedInterval_) : std::min(medianInterval(track), slowest_);
  return kAbsenceSteps * std::max(step_, own);
}

bool TrackRates::report(base::Diagnostics& problems) const {
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
  const bool differ = most > kRateRatio * least;
  if (differ) {
    problems.push_back(base::warning(
        "tracks.rates-differ-by-body",
        {base::formatDouble(least), base::formatDouble(most), base::formatDouble(step_)},
        file_.file));
  }
  return differ;
}

namespace {

constexpr double kWalkingSpeed = 0.05;  // [m/s]; below this the heading is undefined

Vec2 estimatedVelocity(const TrackPoint* begin, const TrackPoint* end, const TrackPoint* point) {
  if (end - begin < 2) {
    return Vec2::Zero();
  }
  const TrackPoint* before = point == begin ? point : point - 1;
  const TrackPoint* after = point + 1 == end ? point : point + 1;
  return (after->position - before->position) / (after->time - before->time);
}

}  // namespace

TrackSegment::TrackSegment(const TrackPoint* begin, const TrackPoint* end) : points_(begin) {
  for (const TrackPoint* point = begin; point != end; ++point) {
    times_.push_back(point->time);
    TrackState state;
    state.position = point->position;
    state.velocity = point->velocity ? *point->velocity : estimatedVelocity(begin, end, point);
    states_.push_back(state);
  }
  fillHeadings(begin);
  fillTurning(begin);
}

TrackState TrackSegment::at(double time, double slack) const {
  const auto next = static_cast<std::size_t>(
      std::upper_bound(times_.begin(), times_.end(), time + slack) - times_.begin());
  if (next == 0) {
    return states_.front();
  }
  if (next == states_.size() || time - times_[next - 1] <= slack) {
    return states_[next - 1];
  }
  const TrackState& a = states_[next - 1];
  const TrackState& b = states_[next];
  const double share = (time - times_[next - 1]) / (times_[next] - times_[next - 1]);
  TrackState state;
  state.position = a.position + share * (b.position - a.position);
  state.velocity = a.velocity + share * (b.velocity - a.velocity);
  state.heading = base::wrapToPi(a.heading + share * base::angleDiff(b.heading, a.heading));
  state.omega = a.omega + share * (b.omega - a.omega);
  return state;
}

const TrackPoint& TrackSegment::nearest(double time) const {
  const auto next = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), time) -
                                             times_.begin());
  const bool isBefore =
      next == times_.size() || (next > 0 && time - times_[next - 1] <= times_[next] - time);
  return points_[isBefore ? next - 1 : next];
}

/// Given headings, else the direction of motion; standing bodies keep the last heading, or take the
/// next.
void TrackSegment::fillHeadings(const TrackPoint* points) {
  std::vector<std::optional<double>> headings;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const Vec2& velocity = states_[k].velocity;
    headings.push_back(points[k].heading);
    if (!headings.back() && velocity.norm() > kWalkingSpeed) {
      headings.back() = base::headingOf(velocity);
    } else if (!headings.back() && k > 0) {
      headings.back() = headings[k - 1];
    }
  }
  const auto known = std::find_if(headings.begin(), headings.end(),
                                  [](const std::optional<double>& h) { return h.has_value(); });
  const double first = known == headings.end() ? 0.0 : **known;
  for (std::size_t k = 0; k < states_.size(); ++k) {
    states_[k].heading = base::wrapToPi(headings[k].value_or(first));
  }
}

void TrackSegment::fillTurning(const TrackPoint* points) {
  for (std::size_t k = 0; k < states_.size(); ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1;
    const std::size_t after = std::min(k + 1, states_.size() - 1);
    if (points[k].angularSpeed) {
      states_[k].omega = *points[k].angularSpeed;
    } else if (after > before) {
      const double turn = base::angleDiff(states_[k].heading, states_[before].heading) +
                          base::angleDiff(states_[after].heading, states_[k].heading);
      states_[k].omega = turn / (times_[after] - times_[before]);
    }
  }
}

std::vector<TrackSegment> segmentsOf(const Track& track, double longest) {
  std::vector<TrackSegment> segments;
  const TrackPoint* begin = track.points.data();
  const TrackPoint* const end = begin + track.points.size();
  for (const TrackPoint* point = begin; point != end; ++point) {
    if (point + 1 == end || (point + 1)->time - point->time > longest) {
      segments.emplace_back(begin, point + 1);
      begin = point + 1;
    }
  }
  return segments;
}

}  // namespace sim2d
