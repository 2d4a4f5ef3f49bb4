#pragma once

#include <vector>

#include "sim2d/world/realism/RealismTest.h"

/// The files of this folder add their tests here.
namespace sim2d {

void addCorridorTests(std::vector<RealismTest>& tests);
void addMeetingTests(std::vector<RealismTest>& tests);
void addPassageTests(std::vector<RealismTest>& tests);
void addWalkTests(std::vector<RealismTest>& tests);

}  // namespace sim2d
