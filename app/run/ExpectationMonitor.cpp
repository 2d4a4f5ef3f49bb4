#include "app/run/ExpectationMonitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using base::Vec2;
using sim2d::Event;
using sim2d::EventKind;
using What = sim2d::Expectation::What;

constexpr double kReachDistance = 0.5;   // [m] from a goal
constexpr double kGoalDistance = 1.0;    // [m], "at" a goal
constexpr double kDoorDistance = 1.5;    // [m], "at" a door
constexpr double kRestSpeed = 0.1;       // [m/s]
constexpr double kTimeTolerance = 1e-9;  // [s]
constexpr double kFarAway = std::numeric_limits<double>::infinity();

double distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point - (from + t * along)).norm();
}

bool isInside(const Vec2& point, const std::vector<Vec2>& corners) {
  bool inside = false;
  for (std::size_t i = 0, k = corners.size() - 1; i < corners.size(); k = i++) {
    const Vec2 &a = corners[i], &b = corners[k];
    const bool crosses = (a.y() > point.y()) != (b.y() > point.y());
    if (crosses && point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
      inside = !inside;
    }
  }
  return inside;
}

double distanceToArea(const Vec2& point, const std::vector<Vec2>& corners) {
  if (isInside(point, corners)) {
    return 0.0;
  }
  double least = kFarAway;
  for (std::size_t i = 0, k = corners.size() - 1; i < corners.size(); k = i++) {
    least = std::min(least, distanceToSegment(point, corners[k], corners[i]));
  }
  return least;
}

std::optional<std::size_t> rowOf(int id, const sim2d::Frame& frame) {
  const auto& ids = frame.humans.id;  // ascending
  const auto found = std::lower_bound(ids.begin(), ids.end(), id);
  return found != ids.end() && *found == id
             ? std::optional(static_cast<std::size_t>(found - ids.begin()))
             : std::nullopt;
}

Vec2 positionOf(std::size_t row, const sim2d::Frame& frame) {
  return {frame.humans.x[row], frame.humans.y[row]};
}

std::optional<EventKind> eventOf(What what) {
  switch (what) {
    case What::ReachesGoal:
      return EventKind::Goal;
    case What::Arrives:
      return EventKind::Arrived;
    case What::Leaves:
      return EventKind::Leave;
    case What::Says:
      return EventKind::Say;
    case What::Hears:
      return EventKind::Heard;
    case What::Starts:
      return EventKind::Action;
    case What::Ends:
      return EventKind::ActionEnd;
    case What::Touches:
      return EventKind::Contact;
    case What::Enters:
    case What::Stands:
    case What::Nears:
      break;
  }
  return std::nullopt;
}

}  // namespace

ExpectationMonitor::ExpectationMonitor(const sim2d::Scenario& scenario) : scenario_(scenario) {
  for (const std::string& text : scenario.desktop.card.expect) {
    const base::Result<sim2d::Expectation> expectation = sim2d::parseExpectation(text);
    if (!expectation) {
      continue;
    }
    Item item;
    item.expectation = *expectation;
    item.subject = idOf(expectation->subject).value_or(-1);
    const bool isPerson = expectation->what == What::Hears || expectation->what == What::Touches ||
                          expectation->what == What::Nears;
    item.other = isPerson ? idOf(expectation->object) : std::nullopt;
    items_.push_back(std::move(item));
  }
}

/// People of a source get ids during the run, so only those of the file have one here.
std::optional<int> ExpectationMonitor::idOf(const std::string& name) const {
  const sim2d::Human* const human = scenario_.human(name);
  return human == nullptr ? std::nullopt : std::optional(human->id);
}

bool ExpectationMonitor::hasEvent(const Item& item, int id, const sim2d::Frame& frame) const {
  const sim2d::Expectation& expected = item.expectation;
  const std::optional<EventKind> kind = eventOf(expected.what);
  return std::any_of(frame.events.begin(), frame.events.end(), [&](const Event& event) {
    if (event.kind != kind || !event.hasId) {
      return false;
    }
    if (expected.what == What::Touches) {
      const bool isFirst = event.id == id;
      const bool isSecond = event.hasOther && event.other == id;
      const int partner = isFirst ? event.other : event.id;
      return (isFirst || isSecond) && event.hasOther && (!item.other || *item.other == partner);
    }
    if (event.id != id) {
      return false;
    }
    switch (expected.what) {
      case What::ReachesGoal:
        return event.text == std::to_string(expected.goal);
      case What::Says:
        return event.text.find(expected.object) != std::string::npos;
      case What::Hears:
        return event.hasOther && item.other == event.other;
      case What::Starts:
      case What::Ends:
        return base::startsWith(event.text, expected.object);
      default:
        return true;
    }
  });
}

/// Distance from the object of the expectation; without one 0, infinite if it is not in the world.
double ExpectationMonitor::distanceTo(const Item& item, const Vec2& from,
                                      const sim2d::Frame& frame) const {
  const sim2d::Expectation& expected = item.expectation;
  if (expected.goal > 0) {
    const sim2d::GlobalGoal* const goal = scenario_.goal(expected.goal);
    return goal == nullptr ? kFarAway : (goal->position - from).norm();
  }
  if (expected.object.empty()) {
    return 0.0;
  }
  if (item.other) {
    const std::optional<std::size_t> row = rowOf(*item.other, frame);
    return row ? (positionOf(*row, frame) - from).norm() : kFarAway;
  }
  if (const auto* area = base::findBy(scenario_.areas, &sim2d::Area::name, expected.object)) {
    return distanceToArea(from, area->points);
  }
  const auto* door = base::findBy(scenario_.doors, &sim2d::Door::name, expected.object);
  return door == nullptr ? kFarAway : distanceToSegment(from, door->from, door->to);
}

bool ExpectationMonitor::stands(Item& item, int id, std::size_t row,
                                const sim2d::Frame& frame) const {
  const sim2d::Expectation& expected = item.expectation;
  const double speed = Vec2(frame.humans.vx[row], frame.humans.vy[row]).norm();
  const bool isDoor = base::findBy(scenario_.doors, &sim2d::Door::name, expected.object) != nullptr;
  const double reach = expected.goal > 0 ? kGoalDistance : isDoor ? kDoorDistance : 0.0;
  if (speed > kRestSpeed || distanceTo(item, positionOf(row, frame), frame) > reach) {
    item.since.erase(id);
    return false;
  }
  const double since = item.since.emplace(id, frame.time).first->second;
  return frame.time - since >= expected.amount - kTimeTolerance;
}

bool ExpectationMonitor::happens(Item& item, int id, std::size_t row,
                                 const sim2d::Frame& frame) const {
  const Vec2 position = positionOf(row, frame);
  switch (item.expectation.what) {
    case What::Stands:
      return stands(item, id, row, frame);
    case What::Nears:
      return distanceTo(item, position, frame) <= item.expectation.amount;
    case What::Enters:
      return distanceTo(item, position, frame) <= 0.0;
    case What::ReachesGoal:
      return distanceTo(item, position, frame) <= kReachDistance || hasEvent(item, id, frame);
    default:
      return hasEvent(item, id, frame);
  }
}

void ExpectationMonitor::observe(Item& item, const sim2d::Frame& frame) const {
  const sim2d::Expectation& expected = item.expectation;
  const bool isPlace = expected.what == What::Stands;  // standing may begin before the interval
  const bool isInTime =
      frame.time >= expected.from - kTimeTolerance && frame.time <= expected.until + kTimeTolerance;
  if (item.time || (!isInTime && !isPlace)) {
    return;
  }
  if (expected.what == What::Leaves && expected.people == 0 &&
      hasEvent(item, item.subject, frame)) {
    item.time = frame.time;  // people who left no longer have a row
    return;
  }
  for (std::size_t row = 0; row < frame.humans.size(); ++row) {
    const int id = frame.humans.id[row];
    const bool isSubject = expected.people > 0 || id == item.subject;
    if (isSubject && happens(item, id, row, frame) && isInTime) {
      item.people.insert(id);
    }
  }
  if (expected.people > 0) {  // those who leave in this step
    for (const Event& event : frame.events) {
      if (event.hasId && isInTime && eventOf(expected.what) == event.kind &&
          hasEvent(item, event.id, frame)) {
        item.people.insert(event.id);
      }
    }
  }
  if (!item.people.empty() && static_cast<int>(item.people.size()) >= expected.people) {
    item.time = frame.time;
  }
}

void ExpectationMonitor::add(const sim2d::Frame& frame) {
  for (Item& item : items_) {
    observe(item, frame);
  }
}

std::vector<ExpectationOutcome> ExpectationMonitor::outcomes() const {
  std::vector<ExpectationOutcome> all;
  for (const Item& item : items_) {
    all.push_back(
        {item.expectation.text, item.time.has_value() != item.expectation.isDenied, item.time});
  }
  return all;
}

double ExpectationMonitor::horizon() const {
  double latest = 0.0;
  for (const Item& item : items_) {
    latest = std::max(latest, item.expectation.until);
  }
  return latest;
}

bool ExpectationMonitor::isDecided() const {
  return std::all_of(items_.begin(), items_.end(), [](const Item& item) {
    return item.time.has_value() && !item.expectation.isDenied;
  });
}

}  // namespace app
