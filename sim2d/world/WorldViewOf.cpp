#include "sim2d/world/WorldViewOf.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr int kQuirkNoOcclusion = 34;

}  // namespace

int WorldViewOf::indexOf(int humanId) const {
  const int guess = model_.people.empty() ? -1 : humanId - model_.people.front().constants.id;
  if (guess >= 0 && guess < humanCount() && model_.people[at(guess)].constants.id == humanId) {
    return guess;  // ids without gaps
  }
  const auto found =
      std::lower_bound(model_.people.begin(), model_.people.end(), humanId,
                       [](const Person& person, int id) { return person.constants.id < id; });
  const bool isThere = found != model_.people.end() && found->constants.id == humanId;
  return isThere ? static_cast<int>(found - model_.people.begin()) : -1;
}

void WorldViewOf::near(int human, double range, std::vector<int>& found) const {
  found.clear();
  const Vec2 centre = state_.position(at(human));
  grid_.forEachNear(centre, range, [&](int other) {
    if (other != human) {
      found.push_back(other);
    }
  });
  std::sort(found.begin(), found.end(), [&](int a, int b) {
    const double first = (state_.position(at(a)) - centre).norm();
    const double second = (state_.position(at(b)) - centre).norm();
    return first != second ? first < second : a < b;
  });
}

int WorldViewOf::nearestRobot(int human) const {
  int nearest = -1;
  double least = 0.0;
  for (int robot = 0; robot < robotCount(); ++robot) {
    const double distance = (robotPose(robot).position - state_.position(at(human))).norm();
    if (nearest < 0 || distance < least) {
      nearest = robot;
      least = distance;
    }
  }
  return nearest;
}

std::optional<Vec2> WorldViewOf::globalGoal(int id) const {
  const auto found = model_.globalGoals.find(id);
  return found == model_.globalGoals.end() ? std::nullopt : std::optional<Vec2>(found->second);
}

const Area* WorldViewOf::area(const std::string& name) const {
  const auto found = std::find_if(model_.areas.begin(), model_.areas.end(),
                                  [&](const Area* area) { return area->name == name; });
  return found == model_.areas.end() ? nullptr : *found;
}

bool WorldViewOf::isVisible(const Vec2& from, const Vec2& to) const {
  return model_.compatibility.has(kQuirkNoOcclusion) || obstacles_.isVisible(from, to);
}

bool WorldViewOf::isReachable(int human, const Vec2& point) const {
  const ResolvedHuman& person = constants(human);
  return person.route == Route::Direct ||
         navigation_.isReachable(person.radius, state_.position(at(human)), point);
}

std::optional<double> WorldViewOf::wayLength(int human, const Vec2& point) const {
  const ResolvedHuman& person = constants(human);
  if (person.route == Route::Direct) {
    return (point - state_.position(at(human))).norm();
  }
  const Path path{navigation_.plan(person.radius, state_.position(at(human)), point)};
  return path.points.empty() ? std::nullopt : std::optional<double>(path.length());
}

}  // namespace sim2d
