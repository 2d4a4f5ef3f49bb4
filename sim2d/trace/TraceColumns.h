#pragma once

namespace sim2d {

/// First lines of the files of a run.
constexpr char kTrajectoryColumns[] = "step,time,id,kind,x,y,heading,vx,vy,omega,group,state,goal";
constexpr char kEventColumns[] = "step,time,kind,id,other,text";

}  // namespace sim2d
