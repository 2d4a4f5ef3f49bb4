#include "sim2d/world/Population.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"

namespace sim2d {
namespace {

constexpr int kPlaceTrials = 60;  // draws for a free place in a source per step
constexpr double kNever = 1e300;  // [s]

/// The agent number of a source in the random counter; below all robots.
int counterOf(std::size_t area) {
  return -1000 - static_cast<int>(area);
}

Vec2 drawnPlace(const Area& area, const base::AgentRng& rng, std::uint32_t index) {
  Vec2 low = area.points.front();
  Vec2 high = low;
  for (const Vec2& point : area.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {rng.uniform(low.x(), high.x(), base::Draw::Placement, index),
          rng.uniform(low.y(), high.y(), base::Draw::Placement, index + 1)};
}

/// A body of this radius at `place` overlaps nobody present, people and robots.
bool isFree(const WorldModel& model, const WorldState& state, const Vec2& place, double radius) {
  for (std::size_t i = 0; i < state.present.size(); ++i) {
    const double apart = radius + model.people[i].constants.radius;
    if (state.present[i] != 0 && (state.position(i) - place).norm() < apart) {
      return false;
    }
  }
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const double apart = radius + reachOf(model.robots[i]);
    if ((state.robots[i].pose.position - place).norm() < apart) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<GoalItem> goalItems(const WorldModel& model, const std::vector<int>& ids,
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
    const Human& like = model.patterns.at(*area.like);
    const ResolvedHuman constants = resolvePerson(model, like);
    source.like = &like;
    source.plan = std::make_shared<GoalPlan>(
        GoalPlan{like.goals, goalItems(model, like.goals, constants.goalRadius)});
    source.next = area.from.value_or(0.0);
    scheduleNext(model, source);
    sources_.push_back(source);
  }
}

void Population::scheduleNext(const WorldModel& model, Source& source) const {
  const Area& area = *model.areas[source.area];
  const double rate = area.rate.value_or(0.0);
  const base::AgentRng rng(model.drawSeed, counterOf(source.area));
  const double draw = rng.uniform01(base::Draw::Source, static_cast<std::uint32_t>(source.arrived));
  source.next = rate > 0.0 ? source.next - base::log(1.0 - draw) / rate : kNever;
  const bool isOver =
      (area.until && source.next > *area.until) || (area.count && source.arrived >= *area.count);
  if (isOver) {
    source.next = kNever;
  }
}

bool Population::addCopy(Source& source, WorldModel& model, WorldState& state,
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
        rng.uniform(-base::kPi, base::kPi, base::Draw::Placement, 2 * kPlaceTrials);
    person.constants.startTime = state.time;
    person.model = model.registries->models.find(person.constants.model)->make(person.constants);
    model.people.push_back(std::move(person));
    model.lastId = id;
    state.append(model.people.back());
    return true;
  }
  return false;
}

std::vector<std::size_t> Population::dueNow(WorldModel& model, WorldState& state,
                                            const NavigationMap& navigation) {
  std::vector<std::size_t> due;
  std::vector<std::size_t> later;
  std::sort(waiting_.begin(), waiting_.end());
  for (const std::size_t human : waiting_) {
    const ResolvedHuman& person = model.people[human].constants;
    const bool isTime = person.startTime <= state.time + kTick;
    const bool isAtStart = state.step == 0;  // all together; overlaps were told about
    if (isTime && (isAtStart || isFree(model, state, person.start.position, person.radius))) {
      state.present[human] = 1;
      due.push_back(human);
    } else {
      later.push_back(human);
    }
  }
  waiting_ = std::move(later);
  for (Source& source : sources_) {
    while (source.next <= state.time + kTick && addCopy(source, model, state, navigation)) {
      ++source.arrived;
      state.present.back() = 1;
      due.push_back(model.people.size() - 1);
      scheduleNext(model, source);
    }
  }
  return due;
}

}  // namespace sim2d
