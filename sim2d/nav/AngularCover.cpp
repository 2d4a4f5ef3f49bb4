#include "sim2d/nav/AngularCover.h"

#include <algorithm>
#include <iterator>

#include "sim2d/base/Types.h"

namespace sim2d {
namespace {

/// Calls visit(low, high) for the one or two parts that the interval has in [-pi, pi].
template <class Visit>
void forPlainParts(double from, double width, Visit visit) {
  constexpr double kTurn = 2.0 * base::kPi;
  if (width >= kTurn) {
    visit(-base::kPi, base::kPi);
    return;
  }
  double low = base::wrapToPi(from);
  low = low == base::kPi ? -base::kPi : low;
  const double high = low + width;
  visit(low, std::min(high, base::kPi));
  if (high > base::kPi) {
    visit(-base::kPi, high - kTurn);
  }
}

}  // namespace

void AngularCover::add(double from, double width) {
  forPlainParts(from, width, [this](double low, double high) { addPlain(low, high); });
}

double AngularCover::covered(double from, double width) const {
  double sum = 0.0;
  forPlainParts(from, width, [&](double low, double high) { sum += coveredPlain(low, high); });
  return sum;
}

void AngularCover::addPlain(double low, double high) {
  const auto first = std::lower_bound(intervals_.begin(), intervals_.end(), low,
                                      [](const Interval& i, double at) { return i.high < at; });
  auto last = first;
  for (; last != intervals_.end() && last->low <= high; ++last) {
  }
  if (first == last) {
    intervals_.insert(first, {low, high});
    return;
  }
  const Interval joined{std::min(low, first->low), std::max(high, std::prev(last)->high)};
  *first = joined;
  intervals_.erase(std::next(first), last);
}

double AngularCover::coveredPlain(double low, double high) const {
  auto at = std::lower_bound(intervals_.begin(), intervals_.end(), low,
                             [](const Interval& i, double angle) { return i.high < angle; });
  double sum = 0.0;
  for (; at != intervals_.end() && at->low < high; ++at) {
    sum += std::min(at->high, high) - std::max(at->low, low);
  }
  return sum;
}

}  // namespace sim2d
