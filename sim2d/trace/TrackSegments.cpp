#include "sim2d/trace/TrackSegments.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include "sim2d/base/Find.h"
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

constexpr double kWalkingSpeed = 0.05;  // [m/s]; below this the heading is undefined

Vec2 estimatedVelocity(const TrackPoint* begin, const TrackPoint* end, const TrackPoint* point) {
  if (end - begin < 2) {
    return Vec2::Zero();
  }
  const TrackPoint* before = point == begin ? point : point - 1;
  const TrackPoint* after = point + 1 == end ? point : point + 1;
  return (after->position - before->position) / (after->time - before->time);
}

class TrackChecker {
 public:
  TrackChecker(const TrackFile& file, const TrackOptions& options, base::Diagnostics& problems)
      : file_(file), options_(options), problems_(problems) {}

  const Track* check() {
    checkTimes();
    checkPlaces();
    chooseRobot();
    checkIds();
    return robot_;
  }

 private:
  void error(const TrackPoint& point, std::string_view code, base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_.file, point.line, point.column));
  }

  void checkTimes() {
    bool isEmpty = true;
    for (const Track& track : file_.tracks) {
      isEmpty = isEmpty && track.points.empty();
      for (std::size_t k = 1; k < track.points.size(); ++k) {
        if (track.points[k].time <= track.points[k - 1].time) {
          error(track.points[k], "tracks.backwards", {track.id});
        }
      }
    }
    if (isEmpty) {
      problems_.push_back(base::error("tracks.empty", {}, file_.file));
    }
  }

  /// Reports the first out-of-range position of each body.
  void checkPlaces() {
    for (const Track& track : file_.tracks) {
      const TrackPoint* const far = base::findIf(track.points, [](const TrackPoint& point) {
        return !(point.position.norm() <= kFarthestPosition);
      });
      if (far != nullptr) {
        error(*far, "tracks.too-far", {static_cast<int>(kFarthestPosition / 1000.0)});
      }
    }
  }

  static std::string nameOf(const Track& track) {
    return track.name.empty() ? std::to_string(track.id) : track.name;
  }

  bool isRobotRequested() const { return options_.robotId || !options_.robotName.empty(); }

  /// Matches by name if any track has it, else by id; without a request, tracks marked as robots.
  bool matchesRequest(const Track& track, bool byName) const {
    if (track.points.empty()) {
      return false;
    }
    if (byName) {
      return track.name == options_.robotName;
    }
    return isRobotRequested() ? options_.robotId && track.id == *options_.robotId : track.isRobot;
  }

  /// If a person and a robot match, only the robot is kept.
  std::vector<const Track*> findCandidates() const {
    const bool byName = !options_.robotName.empty() &&
                        std::any_of(file_.tracks.begin(), file_.tracks.end(),
                                    [&](const Track& t) { return t.name == options_.robotName; });
    std::vector<const Track*> candidates;
    for (const Track& track : file_.tracks) {
      if (matchesRequest(track, byName)) {
        candidates.push_back(&track);
      }
    }
    const auto isRobot = [](const Track* track) { return track->isRobot; };
    if (std::any_of(candidates.begin(), candidates.end(), isRobot)) {
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), std::not_fn(isRobot)),
                       candidates.end());
    }
    return candidates;
  }

  void chooseRobot() {
    const std::vector<const Track*> candidates = findCandidates();
    if (!candidates.empty()) {
      robot_ = candidates.front();
      for (std::size_t k = 1; k < candidates.size(); ++k) {
        error(candidates[k]->points.front(), "tracks.second-robot",
              {nameOf(*robot_), nameOf(*candidates[k])});
      }
      reportOtherRobots(candidates.size());
    } else if (isRobotRequested()) {
      reportUnknownRobot();
    } else if (options_.robotGoal) {
      problems_.push_back(base::error("tracks.goal-without-robot", {}, file_.file));
    }
  }

  void reportUnknownRobot() {
    std::vector<std::string> names;
    for (const Track& track : file_.tracks) {
      if (!track.name.empty()) {
        names.push_back(track.name);
      }
    }
    const std::string who =
        options_.robotName.empty() ? std::to_string(*options_.robotId) : options_.robotName;
    problems_.push_back(
        base::error("tracks.nobody", {who, base::nearestName(who, names)}, file_.file));
  }

  /// Other robots are treated as people.
  void reportOtherRobots(std::size_t chosen) {
    for (const Track& track : file_.tracks) {
      if (chosen == 1 && track.isRobot && &track != robot_ && !track.points.empty()) {
        problems_.push_back(
            base::warning("tracks.robot-among-people", {nameOf(track)}, file_.file));
      }
    }
  }

  /// Ids of people must be unique in a recording.
  void checkIds() {
    std::set<int> ids;
    for (const Track& track : file_.tracks) {
      if (&track != robot_ && !track.points.empty() && !ids.insert(track.id).second) {
        error(track.points.front(), "tracks.same-id", {track.id});
      }
    }
  }

  const TrackFile& file_;
  const TrackOptions& options_;
  base::Diagnostics& problems_;
  const Track* robot_ = nullptr;
};

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

const Track* checkTracks(const TrackFile& file, const TrackOptions& options,
                         base::Diagnostics& problems) {
  return TrackChecker(file, options, problems).check();
}

base::Diagnostics limitedPerKind(const base::Diagnostics& problems) {
  constexpr std::size_t kMost = 10;
  std::map<std::string_view, std::size_t> counts;
  base::Diagnostics few;
  for (const base::Diagnostic& problem : problems) {
    if (++counts[problem.code] <= kMost) {
      few.push_back(problem);
    }
  }
  for (const auto& [code, count] : counts) {
    if (count > kMost) {
      const base::Diagnostic* const first = base::findBy(few, &base::Diagnostic::code, code);
      few.push_back(base::problem(first->severity, "tracks.more-of-a-kind",
                                  {count - kMost, first->message}, first->file));
    }
  }
  return few;
}

}  // namespace sim2d
