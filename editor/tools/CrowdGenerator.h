#pragma once

#include <array>

#include "editor/canvas/Tool.h"
#include "sim2d/map/Obstacles.h"

namespace editor {

constexpr int kBehaviorCount = 6;

/// Properties of the people created by brush and fill. Equal recipes give equal people.
struct CrowdRecipe {
  std::array<int, kBehaviorCount> mix = {60, 10, 10, 5, 10, 5};  // Weights, in type order.
  std::optional<sim2d::PersonKind> kind;                         // None: all kinds, mostly adults.
  bool walks = true;  // Visits goals of the scenario in an individual order.
  int seed = 1;
};

/// Tests for free positions: outside walls, unknown cells, obstacles, closed doors, people, robots
/// and positions already taken. Owns its data; fast on large maps.
class FreeSpace {
 public:
  explicit FreeSpace(const ScenarioDocument& document);
  bool isFree(const Vec2& place, double radius) const;
  void take(const Vec2& place, double radius) {
    taken_[bucketOf(place)].emplace_back(place, radius);
  }

 private:
  using Bucket = std::pair<int, int>;
  static Bucket bucketOf(const Vec2& place);
  bool isClearOfWalls(const Vec2& place, double radius) const;
  std::shared_ptr<const sim2d::OccupancyGrid> map_;
  sim2d::Obstacles obstacles_;  // Obstacles of the scenario.
  std::map<Bucket, std::vector<std::pair<Vec2, double>>> taken_;
};

/// The index of the next person that a recipe draws; it changes when people are added.
int nextPersonIndex(const ScenarioDocument& document);
/// Person `index` of a crowd at the origin; kind, body, speed and route are drawn by the recipe.
/// The document assigns names and ids.
sim2d::Human sampledPerson(const CrowdRecipe& recipe, sim2d::BehaviorType behavior, int index,
                           const sim2d::Scenario& scenario);

/// People and goals that have not been added yet.
struct Crowd {
  std::vector<sim2d::Human> people;
  std::vector<sim2d::GlobalGoal> goals;
};
/// Up to `count` people at random positions inside the polygon with random headings; fewer if there
/// is no free space. If they walk and the scenario has no goals, up to `kNewGoals` goals far apart
/// in the polygon are part of the crowd.
Crowd fillCrowd(const std::vector<Vec2>& polygon, std::size_t count, const CrowdRecipe& recipe,
                const ScenarioDocument& document);

/// The behaviours of the people from `first` on, by their index in the scenario. Each ten people
/// have the proportions of the recipe, as far as whole people allow, in an order drawn with its
/// seed.
std::vector<sim2d::BehaviorType> behaviorsFrom(const CrowdRecipe& recipe, int first,
                                               std::size_t count);
/// `count` behaviours with the proportions of the recipe, rounded to whole people, in an order
/// drawn with its seed.
std::vector<sim2d::BehaviorType> shuffledBehaviors(const CrowdRecipe& recipe, std::size_t count);
/// Assigns behaviours to these people, with the parameters that their reactions require: one
/// command.
void pushMix(ScenarioDocument& document, const std::vector<EntityId>& people,
             const CrowdRecipe& recipe);

/// A person with default values, all set explicitly for other programs that read the file.
sim2d::Human newPerson();

/// Shows people as discs and goals as ghosts.
void showCrowd(MapScene& scene, const Crowd& crowd);
/// Adds the crowd and selects its people: one command; nothing if there are no people.
void addCrowd(ScenarioDocument& document, const Crowd& crowd);

QString peopleText(std::size_t count);       // "1 person", "20 people"
double roundedToCentimetres(double metres);  // Rounded, to keep the file short.

constexpr double kPersonGap = 0.1;   // Minimum distance between bodies [m].
constexpr int kLargestCrowd = 2000;  // Per operation.
constexpr std::size_t kNewGoals = 3;

}  // namespace editor
