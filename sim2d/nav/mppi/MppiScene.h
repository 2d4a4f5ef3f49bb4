#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/mppi/MppiGrids.h"
#include "sim2d/nav/mppi/MppiKernel.h"
#include "sim2d/nav/mppi/MppiParameters.h"
#include "sim2d/nav/mppi/MppiPeople.h"

/// What stands and walks round the robot in the form that the kernel wants.
namespace sim2d {

/// Discs of one size that together hold the footprint; the footprint itself when it is a disc. A
/// polygon is taken as its rectangle along the robot's axes.
std::vector<MppiDisc> coverOf(const Footprint& footprint);

/// The bodies at each step, those left out that no way of the robot can come near.
struct MppiScene {
  std::vector<MppiPerson> people;  // by step
  std::vector<int> firstPerson;    // of each step, and the end
  std::vector<MppiZone> zones;
};

/// How near others matter.
struct MppiRanges {
  double robotRadius = 0.35;  // of the discs of its footprint [m]
  double reach = 0.35;        // of the footprint [m]
  double margin = 0.1;        // gap that counts as touch [m]
  double range = 0.6;         // gap from which on they cost nothing [m]
  double comfortRange = 0.0;  // idem for what people feel [m]
  double stripTime = 2.0;     // [s]
  double speed = 1.0;         // the robot's fastest [m/s]
};

void addBodies(const std::vector<PredictedBody>& bodies, const Vec2& origin, double dt,
               const MppiRanges& ranges, MppiScene& scene);

/// Who stands, with `room` round the body.
std::vector<SlowDisc> standingBodies(const std::vector<PredictedBody>& bodies, double room);

/// The space that two share who stand near each other, face to face (the o-space of Kendon 1990).
void addGroups(const std::vector<PredictedBody>& bodies, const Vec2& origin, double weight,
               std::vector<MppiZone>& zones);

/// Looks for a narrow place ahead on the route through which somebody comes towards the robot.
/// A place is narrow when `width` does not fit between the walls.
struct NarrowPlace {
  bool isThere = false;
  Vec2 position = Vec2::Zero(), direction = Vec2(1.0, 0.0);  // of the route
  double width = 0.0;                                        // [m]
};
NarrowPlace narrowPlaceAhead(const RobotRoute& route, const Vec2& position,
                             const Obstacles& obstacles, double width);
bool comesThrough(const TrackedBody& body, const NarrowPlace& place);

}  // namespace sim2d
