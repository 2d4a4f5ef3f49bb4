#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "editor/canvas/Tool.h"
#include "sim2d/map/Obstacles.h"

namespace editor {

constexpr int kBehaviorCount = 6;

/// Who the people of brush and fill are. The same recipe gives the same people.
struct CrowdRecipe {
  std::array<int, kBehaviorCount> mix = {60, 10, 10, 5, 10, 5};  // weights, in the types' order
  std::optional<sim2d::PersonKind> kind;                         // none: all ages, mostly adults
  bool walks = true;  // visits goals of the scenario, each in an own order
  int seed = 1;
};

/// Where people may stand: off walls, unknown ground, drawn obstacles, closed doors, people, robots
/// and each other. Holds what it needs; cheap for large maps.
class FreeGround {
 public:
  explicit FreeGround(const ScenarioDocument& document);
  bool isFree(const Vec2& place, double radius) const;
  void take(const Vec2& place, double radius);

 private:
  using Bucket = std::pair<int, int>;
  static Bucket bucketOf(const Vec2& place);
  bool isOffWalls(const Vec2& place, double radius) const;
  std::shared_ptr<const sim2d::OccupancyGrid> map_;
  sim2d::Obstacles obstacles_;  // drawn ones
  std::map<Bucket, std::vector<std::pair<Vec2, double>>> taken_;
};

/// The number of the next person that a recipe draws: another one whenever somebody was added.
int nextDraw(const ScenarioDocument& document);
/// Number `index` of a crowd: kind, body, speed, behaviour and route drawn by the recipe, at the
/// origin. Names and ids are left to the document.
sim2d::Human drawnPerson(const CrowdRecipe& recipe, int index, const sim2d::Scenario& scenario);
/// Up to `count` people at random places inside the polygon, looking anywhere; fewer when there is
/// no more room.
std::vector<sim2d::Human> fillCrowd(const std::vector<Vec2>& polygon, std::size_t count,
                                    const CrowdRecipe& recipe, const ScenarioDocument& document);

/// Behaviours for so many people in the shares of the recipe, as near as whole people come to them,
/// in an order drawn by its seed.
std::vector<sim2d::BehaviorType> mixedBehaviors(const CrowdRecipe& recipe, std::size_t count);
/// Gives them to these people, with what their reactions need: one command.
void pushMix(ScenarioDocument& document, const std::vector<EntityId>& people,
             const CrowdRecipe& recipe);

/// A person with the values of a new one, all written out so that other programs read them too.
sim2d::Human newPerson();

/// Shows people who are still to be made, as discs.
void showCrowd(MapScene& scene, const std::vector<sim2d::Human>& people);
/// Adds and selects them: one command; nothing for nobody.
void addCrowd(ScenarioDocument& document, const std::vector<sim2d::Human>& people);

QString peopleText(std::size_t count);  // "1 person", "20 people"
double toCentimetres(double metres);    // a place that is written shortly

constexpr double kPersonGap = 0.1;   // kept free between bodies [m]
constexpr int kLargestCrowd = 2000;  // at once

}  // namespace editor
