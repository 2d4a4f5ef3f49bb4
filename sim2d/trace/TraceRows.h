#pragma once

#include <string>

#include "sim2d/trace/Frame.h"

/// The files of a run row by row, for records that are written while they are made.
namespace sim2d {

std::string trajectoryHead();  // first lines, with their ends
std::string eventsHead();
std::string treesHead();

/// One row per body.
void appendTrajectoryRows(std::string& to, const Frame& frame);
void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event);
void appendTreeRow(std::string& to, std::int64_t step, int id, const std::string& path,
                   base::NodeStatus status);

}  // namespace sim2d
