#include <memory>
#include <optional>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/mppi/MppiPlanner.h"

namespace sim2d {
namespace {

base::Result<std::shared_ptr<Planner>> makeMppi(const PlannerSetup& setup) {
  MppiParameters parameters;
  mppiTable().set(parameters, setup.parameters);
  return std::shared_ptr<Planner>(std::make_shared<MppiPlanner>(setup, parameters, std::nullopt));
}

}  // namespace

void addMppi(PlannerRegistry& to);
void addMppi(PlannerRegistry& to) {
  to.add("mppi", mppiTable().specs(), makeMppi,
         "Model predictive path integral control (Williams et al. 2017): the weighted mean of many "
         "noisy trajectories.");
}

}  // namespace sim2d
