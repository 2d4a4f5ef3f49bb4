#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/Placement.h"

namespace sim2d {
namespace {

constexpr int kPlaceTrials = 60;  // attempts per step to find a free place in a source
constexpr double kNever = 1e300;  // [s]

/// Agent number of a source in the random counter; below those of robots.
int drawAgentId(std::size_t area) {
  return -1000 - static_cast<int>(area);
}

Vec2 drawnPlace(const Area& area, const base::AgentRng& rng, std::uint32_t index) {
  Vec2 low = area.points.front();
  Vec2 high = low;
  for (const Vec2& point : area.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {rng.uniform(low.x(), high.x(), base::DrawPurpose::Placement, index),
          rng.uniform(low.y(), high.y(), base::DrawPurpose::Placement, index + 1)};
}

/// True if a body of this radius at `place` overlaps no person or robot.
bool isFree(const WorldModel& model, const WorldState& state, const Vec2& place, double radius) {
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    const double apart = radius + model.people[i].constants.radius;
    if (state.present[i] != 0 && (state.position(i) - place).norm() < apart) {
      return false;
    }
  }
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const double apart = radius + circumscribedRadius(model.robots[i]);
    if ((state.robots[i].pose.position - place).norm() < apart) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<GoalItem> goalItemsOf(const WorldModel& model, const std::vector<int>& ids,
                                  double radius) {
  std::vector<GoalItem> items;
  for (const int id : ids) {
    const auto found = model.globalGoals.find(id);
    if (found != model.globalGoals.end()) {
      items.push_back({id, found->second, radius});
    }
  }
  return items;
}

Population::Population(const WorldModel& model) {
  waiting_.resize(model.people.size());
  std::iota(waiting_.begin(), waiting_.end(), std::size_t{0});
  for (std::size_t i = 0; i < model.areas.size(); ++i) {
    const Area& area = *model.areas[i];
    if (area.kind != AreaKind::Source || !area.like) {
      continue;
    }
    Source source;
    source.area = i;
    const Human& like = model.sourceTemplates.at(*area.like);
    const ResolvedHuman constants = resolvePerson(model, like);
    source.like = &like;
    source.plan = std::make_shared<GoalPlan>(
        GoalPlan{like.goals, goalItemsOf(model, like.goals, constants.goalRadius)});
    source.next = area.from.value_or(0.0);
    scheduleNext(model, source);
    sources_.push_back(source);
  }
}

void Population::scheduleNext(const WorldModel& model, Source& source) const {
  const Area& area = *model.areas[source.area];
  const double rate = area.rate.value_or(0.0);
  const base::AgentRng rng(model.drawSeed, drawAgentId(source.area));
  const double draw =
      rng.uniform01(base::DrawPurpose::Source, static_cast<std::uint32_t>(source.arrived));
  source.next = rate > 0.0 ? source.next - base::log(1.0 - draw) / rate : kNever;
  const bool isOver =
      (area.until && source.next > *area.until) || (area.count && source.arrived >= *area.count);
  if (isOver) {
    source.next = kNever;
  }
}

bool Population::spawnCopy(Source& source, WorldModel& model, WorldState& state,
                           const NavigationMap& navigation) const {
  const Area& area = *model.areas[source.area];
  Person person;
  person.key = source.like->key;
  person.plan = source.plan;
  if (model.lastId == std::numeric_limits<int>::max()) {
    return false;
  }
  const int id = model.lastId + 1;
  Human copy = *source.like;
  copy.id = id;
  copy.name = area.name + "_" + std::to_string(source.arrived + 1);
  person.constants = resolvePerson(model, copy);
  const base::AgentRng rng(model.drawSeed, id, static_cast<std::uint64_t>(state.step));
  for (std::uint32_t trial = 0; trial < kPlaceTrials; ++trial) {
    const Vec2 place = drawnPlace(area, rng, 2 * trial);
    const double radius = person.constants.radius;
    if (!isInside(area.points, place) || !isFree(model, state, place, radius) ||
        navigation.clearance(place) < radius) {
      continue;
    }
    person.constants.start.position = place;
    person.constants.start.heading =
        rng.uniform(-base::kPi, base::kPi, base::DrawPurpose::Placement, 2 * kPlaceTrials);
    person.constants.startTime = state.time;
    person.model = model.registries->models.find(person.constants.model)->make(person.constants);
    model.people.push_back(std::move(person));
    model.lastId = id;
    state.append(model.people.back());
    return true;
  }
  return false;
}

std::vector<std::size_t> Population::takeDue(WorldModel& model, WorldState& state,
                                             const NavigationMap& navigation) {
  std::vector<std::size_t> due;
  std::vector<std::size_t> later;
  std::sort(waiting_.begin(), waiting_.end());
  for (const std::size_t human : waiting_) {
    const ResolvedHuman& person = model.people[human].constants;
    const bool isTime = person.startTime <= state.time + kTimeTolerance;
    const bool isAtStart = state.step == 0;  // all start together; overlaps were already reported
    if (isTime && (isAtStart || isFree(model, state, person.start.position, person.radius))) {
      state.present[human] = 1;
      due.push_back(human);
    } else {
      later.push_back(human);
    }
  }
  waiting_ = std::move(later);
  for (Source& source : sources_) {
    while (source.next <= state.time + kTimeTolerance &&
           spawnCopy(source, model, state, navigation)) {
      ++source.arrived;
      state.present.back() = 1;
      due.push_back(model.people.size() - 1);
      scheduleNext(model, source);
    }
  }
  return due;
}

namespace {

constexpr std::uint32_t kTrials = 16;
constexpr double kStride = 0.05;    // [m] between the tested places of a path
constexpr double kFarRoom = 50.0;   // [m], above the rounding of map distances
constexpr double kRobotRoom = 1.0;  // [m] about the centre of any robot; larger robots have more
constexpr double kClearanceRounding = 1e-9;  // [m]

struct RobotDisc {
  Vec2 position = Vec2::Zero();  // [m]
  double room = kRobotRoom;      // [m]
};

/// All robots of the scenario, and those of the run at their adjusted positions.
std::vector<RobotDisc> robotsOf(const Scenario& scenario, const NavigationMap& navigation,
                                const WorldModel& model) {
  std::vector<RobotDisc> discs;
  const auto add = [&discs](const Vec2& place, double reach) {
    discs.push_back({place, std::max(kRobotRoom, reach)});
  };
  for (const Robot& robot : scenario.robots) {
    const ResolvedRobot resolved = resolveRobot(scenario, robot, -1);
    const Vec2& written = resolved.start.position;
    add(navigation.nearestFreePosition(circumscribedRadius(resolved), written).value_or(written),
        circumscribedRadius(resolved));
  }
  for (const ResolvedRobot& robot : model.robots) {
    add(robot.start.position, circumscribedRadius(robot));
  }
  return discs;
}

/// Start positions of all people while they are being drawn.
class Starts {
 public:
  Starts(const Scenario& scenario, const NavigationMap& navigation, const WorldModel& model)
      : navigation_(navigation), model_(model), robots_(robotsOf(scenario, navigation, model)) {
    forEachListed(scenario.humans,
                  [this](const Human& human) { people_.emplace(human.id, &human); });
    for (const Person& person : model.people) {
      written_.push_back(person.constants.start.position);
      radii_.push_back(radiusOf(person));
      largest_ = std::max(largest_, radii_.back());
      comesLater_.push_back(writtenOf(person).ours.startTime.value_or(0.0) > 0.0 ? 1 : 0);
    }
    drawn_ = written_;
    grid_.rebuild(written_, std::vector<char>(written_.size(), 1));
  }

  void draw(std::size_t human) {
    const ResolvedHuman& person = model_.people[human].constants;
    const PersonVariation draws(model_.environment->desktop.variation,
                                static_cast<long long>(model_.seed), person.id, person.groupId);
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
      const Vec2 place = written_[human] + draws.startOffset(trial);
      if (base::isWithinCoordinateRange(place) && isInRing(place) && isClear(human, place) &&
          isAwayFromPeople(human, place) && isAwayFromRobots(human, place)) {
        drawn_[human] = place;
        farthest_ = std::max(farthest_, (place - written_[human]).norm());
        return;
      }
    }
  }
  const Vec2& placeOf(std::size_t human) const { return drawn_[human]; }

 private:
  const Human& writtenOf(const Person& person) const { return *people_.at(person.constants.id); }
  /// The scenario's radius, even if the model has a smaller body: places do not depend on the
  /// model.
  double radiusOf(const Person& person) const {
    return std::max(writtenOf(person).radius.value_or(ResolvedHuman().radius),
                    person.constants.radius);
  }

  bool isInRing(const Vec2& place) const { return model_.ring.inside(place) == place; }

  /// True if the straight path has the clearance of a body, or the clearance of the written place
  /// if that is less.
  bool isClear(std::size_t human, const Vec2& place) const {
    if (navigation_.isOpenPlane()) {
      return true;
    }
    const Vec2 way = place - written_[human];
    const double wanted =
        std::min(radii_[human], navigation_.clearance(written_[human])) - kClearanceRounding;
    const double room = std::max(wanted, model_.people[human].constants.radius);
    const int steps = static_cast<int>(std::ceil(way.norm() / kStride));
    for (int i = steps; i > 0;) {
      const double clearance =
          navigation_.clearance(written_[human] + way * (static_cast<double>(i) / steps));
      if (clearance < room) {
        return false;
      }
      // Far from walls the next places are free too and need not be checked.
      i -= 1 + static_cast<int>(std::clamp((clearance - room - kFarRoom) / kStride, 0.0, 1e6));
    }
    return true;
  }

  double gap(const Vec2& from, const Vec2& to) const {
    return (to + model_.ring.shift(to, from) - from).norm();
  }

  /// True if the distance is at least what bodies need, or what the scenario has. People who start
  /// later wait until their place is free, and may share a place with each other.
  bool isAwayFromPeople(std::size_t human, const Vec2& place) const {
    bool isAway = true;
    const double reach = radii_[human] + largest_ + farthest_;
    model_.ring.forEachImage(place, [&](const Vec2& centre) {
      grid_.forEachNear(centre, reach, [&](int index) {
        const auto other = static_cast<std::size_t>(index);
        const bool mayShare = comesLater_[human] != 0 && comesLater_[other] != 0;
        if (other == human || mayShare) {
          return;
        }
        const double needed =
            std::min(radii_[human] + radii_[other], gap(written_[human], written_[other]));
        isAway = isAway && gap(place, drawn_[other]) >= needed;
      });
    });
    return isAway;
  }

  bool isAwayFromRobots(std::size_t human, const Vec2& place) const {
    return std::all_of(robots_.begin(), robots_.end(), [&](const RobotDisc& robot) {
      const double needed =
          std::min(radii_[human] + robot.room, gap(written_[human], robot.position));
      return gap(place, robot.position) >= needed;
    });
  }

  const NavigationMap& navigation_;
  const WorldModel& model_;
  const std::vector<RobotDisc> robots_;
  std::map<int, const Human*> people_;  // by id
  std::vector<Vec2> written_, drawn_;
  std::vector<double> radii_;  // [m]
  std::vector<char> comesLater_;
  double largest_ = 0.0, farthest_ = 0.0;  // radius, displacement from the written place [m]
  NeighborGrid grid_;                      // of the written places
};

}  // namespace

void varyStarts(const Scenario& scenario, const NavigationMap& navigation, WorldModel& model) {
  const VariationSettings& variation = model.environment->desktop.variation;
  if (spreadOf(variation, VariationQuantity::Start).kind == SpreadKind::None) {
    return;
  }
  Starts starts(scenario, navigation, model);
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    starts.draw(i);
    model.people[i].constants.start.position = starts.placeOf(i);
  }
}

}  // namespace sim2d
