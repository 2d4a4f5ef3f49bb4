#include "editor/tools/CrowdGenerator.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/look/Form.h"
#include "sim2d/base/Rng.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

using base::AgentRng;
using base::DrawPurpose;

constexpr double kBucket = 2.0;          // Side length [m]; more than two of the largest bodies.
constexpr int kTrials = 80;              // Attempts per person.
constexpr int kFull = 40;                // Consecutive failures until the area counts as full.
constexpr std::size_t kMaxGoals = 3;     // Maximum number of goals in a random route.
constexpr int kPositionAgent = -1;       // Agent number of the position draws.
constexpr int kBehaviorOrderAgent = -3;  // Agent number of the behaviour order draws.
constexpr int kGoalAgent = -4;           // Agent number of the draws of new goals.
constexpr std::size_t kBlock = 10;       // People among whom behaviours have their proportions.
constexpr std::uint32_t kGoalTrials = 80;
constexpr double kGoalRoom = 0.6;                         // Free radius around a new goal [m].
constexpr std::array<int, 5> kAges = {70, 10, 12, 3, 5};  // Kinds in a mixed crowd [%].

/// The purpose of a random draw for a person; index of the random number.
enum Choice : std::uint32_t { KindChoice = 1, HeadingChoice };

template <std::size_t N>
int weighted(const std::array<int, N>& weights, double uniform) {
  const int sum = std::accumulate(weights.begin(), weights.end(), 0);
  double left = uniform * sum;
  for (std::size_t i = 0; i < N; ++i) {
    left -= weights[i];
    if (left < 0.0) {
      return static_cast<int>(i);
    }
  }
  return 0;
}

std::vector<int> sampledRoute(const std::vector<sim2d::GlobalGoal>& goals, const AgentRng& rng) {
  std::vector<int> route;
  route.reserve(goals.size());
  for (const sim2d::GlobalGoal& goal : goals) {
    route.push_back(goal.id);
  }
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const double part = rng.uniform01(DrawPurpose::GoalChoice, static_cast<std::uint32_t>(i));
    const auto other = i + static_cast<std::size_t>(part * double(route.size() - i));
    std::swap(route[i], route[other]);
  }
  route.resize(std::min(route.size(), kMaxGoals));
  return route;
}

}  // namespace

FreeSpace::FreeSpace(const ScenarioDocument& document)
    : map_(document.map()),
      obstacles_(sim2d::makeSurroundings(document.scenario(), sim2d::OccupancyGrid()).obstacles) {
  const sim2d::Scenario& scenario = document.scenario();
  const long long seed = scenario.desktop.seed.value_or(1);
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed) {
      take(human.initPose.position, sim2d::resolveHuman(scenario, human, seed).radius);
    }
  }
  for (const sim2d::Robot& robot : scenario.robots) {
    if (robot.listed) {
      take(robot.start.position, sim2d::resolveRobot(scenario, robot, -1).radius);
    }
  }
}

FreeSpace::Bucket FreeSpace::bucketOf(const Vec2& place) {
  return {static_cast<int>(std::floor(place.x() / kBucket)),
          static_cast<int>(std::floor(place.y() / kBucket))};
}

bool FreeSpace::isClearOfWalls(const Vec2& place, double radius) const {
  if (map_->isEmpty()) {
    return true;
  }
  const Vec2 corner = map_->worldToCorner(place);
  const double reach = radius / map_->resolution();
  const int left = static_cast<int>(std::floor(corner.x() - reach));
  const int right = static_cast<int>(std::floor(corner.x() + reach));
  const int top = static_cast<int>(std::floor(corner.y() + reach));
  for (int row = static_cast<int>(std::floor(corner.y() - reach)); row <= top; ++row) {
    for (int column = left; column <= right; ++column) {
      const sim2d::Cell cell{column, row};
      const bool isGround = map_->contains(cell) && !map_->isWall(cell) && !map_->isUnknown(cell);
      const Vec2 nearest(std::clamp(corner.x(), double(column), column + 1.0),
                         std::clamp(corner.y(), double(row), row + 1.0));
      if (!isGround && (nearest - corner).norm() < reach) {
        return false;
      }
    }
  }
  return true;
}

bool FreeSpace::isFree(const Vec2& place, double radius) const {
  const Bucket middle = bucketOf(place);
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const auto bucket = taken_.find({middle.first + i, middle.second + j});
      if (bucket == taken_.end()) {
        continue;
      }
      for (const auto& [other, otherRadius] : bucket->second) {
        if ((other - place).norm() < radius + otherRadius + kPersonGap) {
          return false;
        }
      }
    }
  }
  return isClearOfWalls(place, radius) && obstacles_.clearance(place) > radius;
}

sim2d::Human newPerson() {
  sim2d::Human human;
  human.groupId = -1;
  human.skin = 0;
  human.maxVel = 1.3;
  human.radius = 0.35;
  human.goalRadius = 0.3;
  human.cyclicGoals = true;
  human.behavior.type = sim2d::BehaviorType::Regular;
  human.behavior.configuration = sim2d::Configuration::Default;
  human.behavior.goalForceFactor = 2.0;
  human.behavior.obstacleForceFactor = 10.0;
  human.behavior.socialForceFactor = 5.0;
  human.behavior.otherForceFactor = 20.0;
  return human;
}

QString peopleText(std::size_t count) {
  return counted(count, QStringLiteral("person"), QStringLiteral("people"));
}

double roundedToCentimetres(double metres) {
  return std::round(metres * 100.0) / 100.0;
}

int nextPersonIndex(const ScenarioDocument& document) {
  return static_cast<int>(document.scenario().humans.size());
}

sim2d::Human sampledPerson(const CrowdRecipe& recipe, sim2d::BehaviorType behavior, int index,
                           const sim2d::Scenario& scenario) {
  const AgentRng rng(static_cast<std::uint64_t>(recipe.seed), index);
  sim2d::Human human = newPerson();
  human.behavior.type = behavior;
  const auto kind = recipe.kind.value_or(static_cast<sim2d::PersonKind>(
      weighted(kAges, rng.uniform01(DrawPurpose::Placement, KindChoice))));
  if (kind != sim2d::PersonKind::Adult) {
    human.ours.kind = kind;
  }
  human.radius = sim2d::profileOf(kind).radius;
  human.maxVel = roundedToCentimetres(sim2d::sampleSpeed(kind, recipe.seed, index));
  human.initPose.heading = roundedToCentimetres(
      rng.uniform(-base::kPi, base::kPi, DrawPurpose::Placement, HeadingChoice));
  if (recipe.walks) {
    human.goals = sampledRoute(scenario.goals, rng);
  }
  addMissingReactionKeys(scenario, human);
  return human;
}

namespace {

/// Random positions inside the polygon on free ground.
std::vector<Vec2> goalCandidates(const std::vector<Vec2>& polygon, const CrowdRecipe& recipe,
                                 const FreeSpace& ground) {
  const auto [low, high] = *extentOf(polygon);
  const AgentRng rng(static_cast<std::uint64_t>(recipe.seed), kGoalAgent);
  std::vector<Vec2> places;
  for (std::uint32_t trial = 0; trial < kGoalTrials; ++trial) {
    const double x = rng.uniform(low.x(), high.x(), DrawPurpose::Placement, 2 * trial);
    const double y = rng.uniform(low.y(), high.y(), DrawPurpose::Placement, 2 * trial + 1);
    const Vec2 place(roundedToCentimetres(x), roundedToCentimetres(y));
    if (sim2d::isInside(polygon, place) && ground.isFree(place, kGoalRoom)) {
      places.push_back(place);
    }
  }
  return places;
}

/// Up to `kNewGoals` goals; each is the candidate farthest from the goals before it, the first one
/// the candidate farthest from the centre.
std::vector<sim2d::GlobalGoal> newGoals(const std::vector<Vec2>& polygon, const CrowdRecipe& recipe,
                                        const FreeSpace& ground) {
  const std::vector<Vec2> places = goalCandidates(polygon, recipe, ground);
  std::vector<sim2d::GlobalGoal> goals;
  std::vector<Vec2> avoided = {extentOf(polygon)->centre()};
  const auto distance = [&avoided](const Vec2& place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& other : avoided) {
      nearest = std::min(nearest, (other - place).norm());
    }
    return nearest;
  };
  while (goals.size() < std::min(kNewGoals, places.size())) {
    sim2d::GlobalGoal goal;
    goal.id = static_cast<int>(goals.size()) + 1;
    goal.key = {EntityKind::Goal, -goal.id};
    goal.position =
        *std::max_element(places.begin(), places.end(),
                          [&](const Vec2& a, const Vec2& b) { return distance(a) < distance(b); });
    if (goals.empty()) {
      avoided.clear();
    }
    avoided.push_back(goal.position);
    goals.push_back(goal);
  }
  return goals;
}

/// The first `count` behaviours in which each one follows its share: next is the one farthest below
/// its share.
std::vector<sim2d::BehaviorType> proportionalBehaviors(const CrowdRecipe& recipe,
                                                       std::size_t count) {
  const int sum = std::accumulate(recipe.mix.begin(), recipe.mix.end(), 0);
  std::array<long long, kBehaviorCount> given = {};
  std::vector<sim2d::BehaviorType> all;
  for (std::size_t n = 1; n <= count; ++n) {
    std::size_t next = 0;
    long long most = 0;
    for (std::size_t k = 0; k < given.size(); ++k) {
      const long long behind = static_cast<long long>(n) * recipe.mix[k] - given[k] * sum;
      if (behind > most) {
        most = behind;
        next = k;
      }
    }
    ++given[next];
    all.push_back(static_cast<sim2d::BehaviorType>(next + 1));
  }
  return all;
}

/// Shuffles `count` values from `first` on.
void shuffle(std::vector<sim2d::BehaviorType>& values, std::size_t first, std::size_t count,
             const AgentRng& rng) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double part = rng.uniform01(DrawPurpose::Placement, static_cast<std::uint32_t>(i));
    std::swap(values[first + i],
              values[first + i + static_cast<std::size_t>(part * double(count - i))]);
  }
}

}  // namespace

Crowd fillCrowd(const std::vector<Vec2>& polygon, std::size_t count, const CrowdRecipe& recipe,
                const ScenarioDocument& document) {
  const auto [low, high] = *extentOf(polygon);
  FreeSpace ground(document);
  Crowd crowd;
  sim2d::Scenario scenario;  // All that a person of the crowd depends on.
  scenario.goals = document.scenario().goals;
  static_cast<sim2d::ScenarioSettings&>(scenario) =
      static_cast<const sim2d::ScenarioSettings&>(document.scenario());
  if (recipe.walks && scenario.goals.empty()) {
    crowd.goals = newGoals(polygon, recipe, ground);
    scenario.goals = crowd.goals;
  }
  const int first = nextPersonIndex(document);
  const std::vector<sim2d::BehaviorType> behaviors = behaviorsFrom(recipe, first, count);
  int without = 0;  // Number of consecutive people without a free position.
  for (std::size_t i = 0; i < count && without < kFull; ++i) {
    const int index = first + static_cast<int>(i);
    sim2d::Human human = sampledPerson(recipe, behaviors[i], index, scenario);
    const AgentRng rng(static_cast<std::uint64_t>(recipe.seed), kPositionAgent,
                       static_cast<std::uint64_t>(index));
    ++without;
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
      const double x = rng.uniform(low.x(), high.x(), DrawPurpose::Placement, 2 * trial);
      const double y = rng.uniform(low.y(), high.y(), DrawPurpose::Placement, 2 * trial + 1);
      const Vec2 place(roundedToCentimetres(x), roundedToCentimetres(y));
      if (sim2d::isInside(polygon, place) && ground.isFree(place, *human.radius)) {
        ground.take(place, *human.radius);
        human.initPose.position = place;
        crowd.people.push_back(std::move(human));
        without = 0;
        break;
      }
    }
  }
  return crowd;
}

std::vector<sim2d::BehaviorType> behaviorsFrom(const CrowdRecipe& recipe, int first,
                                               std::size_t count) {
  const std::size_t begin = static_cast<std::size_t>(first);
  const std::size_t blocks = (begin + count + kBlock - 1) / kBlock;
  std::vector<sim2d::BehaviorType> all = proportionalBehaviors(recipe, blocks * kBlock);
  for (std::size_t block = 0; block < blocks; ++block) {
    const AgentRng rng(static_cast<std::uint64_t>(recipe.seed), kBehaviorOrderAgent, block);
    shuffle(all, block * kBlock, kBlock, rng);
  }
  const auto from = all.begin() + static_cast<std::ptrdiff_t>(begin);
  return {from, from + static_cast<std::ptrdiff_t>(count)};
}

std::vector<sim2d::BehaviorType> shuffledBehaviors(const CrowdRecipe& recipe, std::size_t count) {
  std::vector<sim2d::BehaviorType> all = proportionalBehaviors(recipe, count);
  const AgentRng rng(static_cast<std::uint64_t>(recipe.seed), kBehaviorOrderAgent);
  shuffle(all, 0, count, rng);
  return all;
}

void pushMix(ScenarioDocument& document, const std::vector<EntityId>& people,
             const CrowdRecipe& recipe) {
  const std::vector<sim2d::BehaviorType> behaviors = shuffledBehaviors(recipe, people.size());
  std::vector<Entity> values;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const sim2d::Human* there = document.human(people[i]);
    if (there == nullptr) {
      continue;  // Removed in the meantime.
    }
    sim2d::Human human = *there;
    human.behavior.type = behaviors[i];
    addMissingReactionKeys(document.scenario(), human);
    values.emplace_back(std::move(human));
  }
  pushEdit(document, std::move(values), QObject::tr("Mix behaviours"));
}

void showCrowd(MapScene& scene, const Crowd& crowd) {
  std::vector<ToolDot> dots;
  dots.reserve(crowd.people.size());
  for (const sim2d::Human& human : crowd.people) {
    dots.push_back({human.initPose.position, *human.radius,
                    scene.theme().line(lookOf(*human.behavior.type)), human.initPose.heading});
  }
  scene.marks().dots = std::move(dots);
  scene.setPreview(std::vector<Entity>(crowd.goals.begin(), crowd.goals.end()));
}

void addCrowd(ScenarioDocument& document, const Crowd& crowd) {
  if (crowd.people.empty()) {
    return;
  }
  std::vector<Entity> values(crowd.goals.begin(), crowd.goals.end());
  values.insert(values.end(), crowd.people.begin(), crowd.people.end());
  std::vector<EntityId> ids = pushAdd(document, std::move(values),
                                      QObject::tr("Add %1").arg(peopleText(crowd.people.size())));
  ids.erase(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(crowd.goals.size()));
  document.setSelection(std::move(ids));
}

}  // namespace editor
