#include <memory>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/mppi/MppiPlanner.h"

namespace sim2d {
namespace {

base::Result<std::shared_ptr<Planner>> makeSocialMppi(const PlannerSetup& setup) {
  SocialMppiParameters parameters;
  socialMppiTable().set(parameters, setup.parameters);
  return std::shared_ptr<Planner>(
      std::make_shared<MppiPlanner>(setup, parameters.mppi, parameters));
}

}  // namespace

void addSocialMppi(PlannerRegistry& to);
void addSocialMppi(PlannerRegistry& to) {
  to.add("social_mppi", socialMppiTable().specs(), makeSocialMppi,
         "MPPI that predicts people, yields to them and avoids groups.");
}

}  // namespace sim2d
