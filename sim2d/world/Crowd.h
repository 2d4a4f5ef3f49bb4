#pragma once

#include <utility>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/crowd/CrowdForces.h"

namespace sim2d {

constexpr double kSlowestTurn = 0.07;   // [m/s]; slower people keep their heading
constexpr double kObstacleReach = 5.0;  // [m]; walls, and robots as obstacles, act up to here

/// What one person does in this step: all that threads need to know of it, in few bytes, as lines
/// of memory that go from one processor to another cost most of a short step.
struct StepPlan {
  double speed = 0.0;  // desired [m/s], >= 0
  int group = -1;
  Motion motion = Motion::Stand;
  RobotTreatment robot = RobotTreatment::Pedestrian;
  bool changes = false;   // sets off or ends to walk
  bool isPushed = false;  // by the extra force of the intent

  friend bool operator==(const StepPlan& a, const StepPlan& b) {
    return a.speed == b.speed && a.group == b.group && a.motion == b.motion && a.robot == b.robot &&
           a.changes == b.changes && a.isPushed == b.isPushed;
  }
};
struct StepPlans {  // one entry per person
  std::vector<StepPlan> steps;
  std::vector<Vec2> directions;  // unit vectors of the ways; zero: arrived, or there is none
};

/// The others as all people of a step see them. Filled anew in each step, the memory stays.
class Crowd {
 public:
  /// `world` and `plans` must live until the last call of this step.
  void update(const FrozenWorld& world, const StepPlans& plans, WorkerPool& workers);
  /// The social forces of large crowds, all at once, for models that have a `socialLaw`. Small
  /// crowds, exact runs and closed corridors go pair by pair in `fill`.
  void computeForces(WorkerPool& workers);

  /// What of the others, robots and walls acts on one person. All but `isVisible` is set anew.
  /// `walls`: null for none.
  void fill(std::size_t human, const std::vector<Obstacles::Point>* walls,
            Situation& situation) const;
  bool isVisible(std::size_t human, const Vec2& point) const;

  const PedestrianModel& modelOf(std::size_t human) const { return *traits_[human].model; }
  /// Somebody is soon asked for: fetches what the model needs into the cache.
  void expect(std::size_t human) const;
  const Walker& walker(std::size_t human) const { return walkers_[human]; }
  /// Free of walls round a person, at least [m].
  double room(std::size_t human) const { return room_[human]; }

 private:
  /// What of a person never changes and counts in every step, near each other in memory.
  struct Traits {
    const PedestrianModel* model = nullptr;
    const ForceParameters* law = nullptr;
    double radius = 0.0;  // [m]
    int id = 0;
    bool goesThroughWalls = false;
    bool looksAtDesires = false;
  };
  struct alignas(64) Summary {  // of the people that one thread looked at
    std::size_t count = 0;
    double fastest = 0.0;  // [m/s]
    bool hasGroups = false;
  };

  void learnTraits(const std::vector<Person>& people);
  void look(std::size_t human, Summary& summary);
  DesiredMotion desiredOf(std::size_t human) const;
  void findGroups();
  bool isSmall() const;
  /// From one free disc to the next along the line; where they get small the walls are asked.
  bool sees(std::size_t self, std::size_t other) const;
  void addOthers(std::size_t human, Situation& situation) const;
  void addPerson(std::size_t other, Situation& situation) const;
  void addRobots(RobotTreatment treatment, Situation& situation) const;
  void addGroup(std::size_t human, Situation& situation) const;
  /// Across the seam of a closed corridor.
  Walker imageOf(Walker other, const Walker& seenFrom) const;

  const FrozenWorld* world_ = nullptr;
  const StepPlans* plans_ = nullptr;
  std::vector<Traits> traits_;
  bool anyLooksAtDesires_ = false;
  std::vector<Walker> walkers_;
  std::vector<DesiredMotion> desires_;  // beside them, while somebody looks at desires
  std::vector<double> room_;            // of each person to the next wall [m]
  std::vector<Walker> robots_;
  std::vector<std::pair<int, std::size_t>> groups_;  // members by group
  Summary all_;
  std::vector<Summary> summaries_;  // by thread
  CrowdForces forces_;
  bool isAtOnce_ = false;        // `forces_` are those of this step
  std::vector<SocialLaw> laws_;  // by which people move in this step
};

}  // namespace sim2d
