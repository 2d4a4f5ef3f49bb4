#pragma once

#include "sim2d/nav/Planner.h"

/// What the sources of the planners define for the registry: tests make one planner without the
/// others.
namespace sim2d {

void addDwa(PlannerRegistry& to);
void addExternal(PlannerRegistry& to);
void addLibrary(PlannerRegistry& to);
void addMppi(PlannerRegistry& to);
void addOnnx(PlannerRegistry& to);
void addOrcaPlanner(PlannerRegistry& to);
void addReplay(PlannerRegistry& to);
void addSocialForcePlanner(PlannerRegistry& to);
void addSocialMppi(PlannerRegistry& to);
void addTeleop(PlannerRegistry& to);

}  // namespace sim2d
