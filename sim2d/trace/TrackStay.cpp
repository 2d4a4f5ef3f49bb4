#include "sim2d/trace/TrackStay.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kWalkingSpeed = 0.05;  // [m/s] slower tells no direction

Vec2 estimatedVelocity(const TrackPoint* begin, const TrackPoint* end, const TrackPoint* point) {
  if (end - begin < 2) {
    return Vec2::Zero();
  }
  const TrackPoint* before = point == begin ? point : point - 1;
  const TrackPoint* after = point + 1 == end ? point : point + 1;
  return (after->position - before->position) / (after->time - before->time);
}

}  // namespace

TrackStay::TrackStay(const TrackPoint* begin, const TrackPoint* end) : points_(begin) {
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

TrackState TrackStay::at(double time, double slack) const {
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

const TrackPoint& TrackStay::nearest(double time) const {
  const auto next = static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), time) -
                                             times_.begin());
  const bool isBefore =
      next == times_.size() || (next > 0 && time - times_[next - 1] <= times_[next] - time);
  return points_[isBefore ? next - 1 : next];
}

/// Told headings, else the direction of walking; who stands keeps the last, or takes the next.
void TrackStay::fillHeadings(const TrackPoint* points) {
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

void TrackStay::fillTurning(const TrackPoint* points) {
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

std::vector<TrackStay> staysOf(const Track& track, double longest) {
  std::vector<TrackStay> stays;
  const TrackPoint* begin = track.points.data();
  const TrackPoint* const end = begin + track.points.size();
  for (const TrackPoint* point = begin; point != end; ++point) {
    if (point + 1 == end || (point + 1)->time - point->time > longest) {
      stays.emplace_back(begin, point + 1);
      begin = point + 1;
    }
  }
  return stays;
}

}  // namespace sim2d
