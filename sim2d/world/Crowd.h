#pragma once

#include <utility>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/NeighborGrid.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/crowd/CrowdForces.h"

namespace sim2d {

constexpr double kMinHeadingSpeed = 0.07;  // [m/s]; slower people keep their heading
constexpr double kObstacleRange = 5.0;  // [m]; range of walls, and of robots treated as obstacles

/// Action of one person in this step. It is compact, because cache lines that move between
/// processors dominate the cost of short steps.
struct StepPlan {
  double speed = 0.0;  // desired [m/s], >= 0
  int group = -1;
  Motion motion = Motion::Stand;
  RobotTreatment robot = RobotTreatment::Pedestrian;
  bool startsOrStops = false;  // starts or stops walking
  bool hasExtraForce = false;  // the intent has an extra force

  friend bool operator==(const StepPlan& a, const StepPlan& b) {
    return a.speed == b.speed && a.group == b.group && a.motion == b.motion && a.robot == b.robot &&
           a.startsOrStops == b.startsOrStops && a.hasExtraForce == b.hasExtraForce;
  }
};
struct StepPlans {  // one entry per person
  std::vector<StepPlan> steps;
  std::vector<Vec2> directions;  // unit vectors; zero: arrived, or no path
};

/// The other people as seen by all people in a step. Refilled in each step, reusing memory.
class Crowd {
 public:
  /// `world` and `plans` must outlive the last call of this step.
  void update(const FrozenWorld& world, const StepPlans& plans, WorkerPool& workers);
  /// Social forces of large crowds, computed at once, for models with a `crowdForceModel`. Small
  /// crowds, exact runs and closed corridors are computed pair by pair in `fill`.
  void computeForces(WorkerPool& workers);

  /// Sets all influences of other people, robots and walls on one person, except `isVisible`.
  /// `walls`: null for none.
  void fill(std::size_t human, const std::vector<Obstacles::Point>* walls,
            Situation& situation) const;
  bool isVisible(std::size_t human, const Vec2& point) const;

  const PedestrianModel& modelOf(std::size_t human) const { return *traits_[human].model; }
  /// Prefetches the model of a person who will soon be computed.
  void prefetch(std::size_t human) const;
  const Walker& walker(std::size_t human) const { return walkers_[human]; }
  /// Lower bound of the clearance of a person to walls [m].
  double room(std::size_t human) const { return room_[human]; }

 private:
  /// Constants of a person that are needed in every step, compact in memory.
  struct Traits {
    const PedestrianModel* model = nullptr;
    const ForceParameters* law = nullptr;
    double radius = 0.0;  // [m]
    int id = 0;
    bool goesThroughWalls = false;
    bool usesDesiredMotions = false;
  };
  struct alignas(64) Summary {  // of the people that one thread processed
    std::size_t count = 0;
    double fastest = 0.0;  // [m/s]
    bool hasGroups = false;
  };

  void cacheTraits(const std::vector<Person>& people);
  void look(std::size_t human, Summary& summary);
  DesiredMotion desiredMotionOf(std::size_t human) const;
  void findGroups();
  bool isSmall() const;
  /// Steps along the line from one free disc to the next; where they become small, the walls are
  /// tested.
  bool sees(std::size_t self, std::size_t other) const;
  void addOthers(std::size_t human, Situation& situation) const;
  /// Adds the nearest visible people within `range` [m].
  void addNearest(std::size_t human, std::size_t count, double range, Situation& situation) const;
  /// Calls visit(index) for the others within `range` [m], in a small crowd for all.
  template <class Visit>
  void forEachOther(std::size_t human, double range, const Visit& visit) const;
  void addPerson(std::size_t other, Situation& situation) const;
  void addRobots(RobotTreatment treatment, Situation& situation) const;
  void addGroup(std::size_t human, Situation& situation) const;
  /// The image nearest to `seenFrom` in a closed corridor.
  Walker imageOf(Walker other, const Walker& seenFrom) const;

  const FrozenWorld* world_ = nullptr;
  const StepPlans* plans_ = nullptr;
  std::vector<Traits> traits_;
  bool anyUsesDesiredMotions_ = false;
  std::vector<Walker> walkers_;
  std::vector<DesiredMotion> desiredMotions_;  // same order, only if a model uses them
  std::vector<double> room_;                   // clearance of each person [m]
  std::vector<Walker> robots_;
  std::vector<std::pair<int, std::size_t>> groups_;  // (group, member), sorted
  Summary all_;
  std::vector<Summary> summaries_;  // per thread
  CrowdForces forces_;
  bool hasBatchForces_ = false;               // `forces_` were computed in this step
  std::vector<CrowdForceModel> forceModels_;  // per person, in this step
};

}  // namespace sim2d
