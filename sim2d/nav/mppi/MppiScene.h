#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/RobotRoute.h"
#include "sim2d/nav/mppi/MppiGrids.h"
#include "sim2d/nav/mppi/MppiKernel.h"

/// Predicted motion of other bodies during the robot's plan. World frame, SI.
namespace sim2d {

/// Entry k of the columns is the state at (k + 1) dt.
struct PredictedBody {
  TrackedBody now;
  std::vector<Vec2> positions, velocities;
};

/// The nearest bodies within `range` of the robot, in the order of the observation.
std::vector<PredictedBody> bodiesNear(const Observation& observation, double range);

void predictConstant(std::vector<PredictedBody>& bodies, int steps, double dt);

/// Prediction by the social force model with default parameters: each person tries to keep the
/// current velocity and feels the others, the nearest wall and the robot on its trajectory `robot`
/// (one state per step). Other robots move straight on.
void predictSocial(std::vector<PredictedBody>& bodies, const PredictedBody& robot, int steps,
                   double dt, const ClearanceGrid& clearance);

/// Surroundings of the robot in the form required by the kernel.

/// Discs of equal radius that together cover the footprint; the footprint itself if it is a disc. A
/// polygon is covered by its bounding rectangle along the robot's axes.
std::vector<MppiDisc> discsCovering(const Footprint& footprint);

/// The bodies at each step, without those that no trajectory of the robot can reach.
struct MppiScene {
  std::vector<MppiPerson> people;  // grouped by step
  std::vector<int> firstPerson;    // index per step, plus the end
  std::vector<MppiZone> zones;
};

/// Distances within which other bodies matter.
struct MppiRanges {
  double robotRadius = 0.35;  // of the discs of the footprint [m]
  double reach = 0.35;        // circumscribed radius of the footprint [m]
  double margin = 0.1;        // smaller gaps count as contact [m]
  double range = 0.6;         // gap beyond which there is no cost [m]
  double comfortRange = 0.0;  // same for comfort costs [m]
  double stripTime = 2.0;     // [s]
  double speed = 1.0;         // maximum speed of the robot [m/s]
};

void addBodies(const std::vector<PredictedBody>& bodies, const Vec2& origin, double dt,
               const MppiRanges& ranges, MppiScene& scene);

/// Discs about people who stand, enlarged by `room`.
std::vector<SlowDisc> standingBodies(const std::vector<PredictedBody>& bodies, double room);

/// Space shared by two people who stand face to face (the o-space of Kendon 1990).
void addGroups(const std::vector<PredictedBody>& bodies, const Vec2& origin, double weight,
               std::vector<MppiZone>& zones);

/// A place on the route ahead where the walls leave less than `width`.
struct NarrowPlace {
  bool isFound = false;
  Vec2 position = Vec2::Zero(), direction = Vec2(1.0, 0.0);  // of the route
  double width = 0.0;                                        // [m]
};
NarrowPlace narrowPlaceAhead(const RobotRoute& route, const Vec2& position,
                             const Obstacles& obstacles, double width);
bool isComingThrough(const TrackedBody& body, const NarrowPlace& place);

}  // namespace sim2d
