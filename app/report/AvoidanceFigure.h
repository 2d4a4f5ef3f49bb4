#pragma once

#include "app/report/Figure.h"
#include "app/report/RunPictures.h"
#include "app/studies/AvoidableContact.h"
#include "sim2d/trace/Trace.h"

namespace report {

/// The last avoidable action of a contact on the map: robot and person at its instant, their
/// recorded paths to the contact (grey) and those with the manoeuvre. Without an action of the
/// robot, that of the person; without both, the second before the contact. `name`: of the figure.
Figure avoidanceFigure(const std::string& name, const sim2d::Trace& trace,
                       const FloorPlan& floorPlan, const app::AvoidableContact& contact);

}  // namespace report
