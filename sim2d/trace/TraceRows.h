#pragma once

#include <string>

#include "sim2d/trace/Frame.h"

/// The files of a run: row by row, for records that are written while they are made.
namespace sim2d {

/// First lines of the files.
constexpr char kTrajectoryColumns[] = "step,time,id,kind,x,y,heading,vx,vy,omega,group,state,goal";
constexpr char kEventColumns[] = "step,time,kind,id,other,text";
constexpr char kTreeColumns[] = "step,id,node,status";
std::string headLine(const char* columns);  // with its end

/// One row per body.
void appendTrajectoryRows(std::string& to, const Frame& frame);
void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event);
void appendTreeRows(std::string& to, std::int64_t step, const TreeChanges& changes);

}  // namespace sim2d
