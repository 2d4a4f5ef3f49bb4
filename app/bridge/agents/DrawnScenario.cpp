#include "app/bridge/agents/DrawnScenario.h"

#include <utility>

#include "sim2d/scenario/Variation.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {
namespace {

using sim2d::Human;
using sim2d::Scenario;
using sim2d::Varied;

bool isDrawn(const sim2d::VariationSettings& variation, Varied quantity) {
  return sim2d::spreadOf(variation, quantity).kind != sim2d::SpreadKind::None;
}

/// Its robots are switched off, so that no planner has to be started: a run without robots has the
/// same people.
base::Result<std::unique_ptr<sim2d::CoupledWorld>> peopleOf(app::Bundle bundle) {
  auto people = std::make_shared<Scenario>(*bundle.scenario);
  for (sim2d::Robot& robot : people->robots) {
    robot.listed = false;
  }
  bundle.scenario = std::move(people);
  bundle.remarks.clear();
  app::Verdict verdict = app::check(bundle, app::CheckDepth::Setup);
  if (!verdict.setup) {
    return app::errorsOf(verdict.problems);
  }
  return sim2d::CoupledWorld::create(std::move(*verdict.setup));
}

void writeDraws(const sim2d::VariationSettings& variation, long long seed,
                const sim2d::ResolvedHuman& drawn, Human& human) {
  if (isDrawn(variation, Varied::Start)) {
    human.initPose.position = drawn.start.position;
  }
  if (isDrawn(variation, Varied::Heading)) {
    human.initPose.heading = drawn.start.heading;
  }
  if (isDrawn(variation, Varied::Speed)) {
    human.maxVel = drawn.desiredSpeed;
  }
  sim2d::FirstGoal first = sim2d::firstGoalOf(variation, human, seed);
  human.goals = std::move(first.goals);
  human.ours.wait = std::move(first.wait);
}

}  // namespace

sim2d::VariationSettings reactionTimesAlone(sim2d::VariationSettings variation) {
  for (std::size_t i = 0; i < sim2d::kVariedCount; ++i) {
    if (static_cast<Varied>(i) != Varied::ReactionTime) {
      variation.spreads.at(i) = {};
      variation.spreads.at(i).kind = sim2d::SpreadKind::None;
    }
  }
  return variation;
}

base::Result<std::shared_ptr<const Scenario>> drawnScenario(const app::Bundle& bundle) {
  const sim2d::VariationSettings& variation = bundle.scenario->desktop.variation;
  if (!sim2d::isVaried(variation)) {
    return bundle.scenario;
  }
  const auto world = peopleOf(bundle);
  if (!world) {
    return world.diagnostics();
  }
  auto drawn = std::make_shared<Scenario>(*bundle.scenario);
  const sim2d::WorldView& view = (*world)->view();
  for (Human& human : drawn->humans) {
    const int index = view.indexOf(human.id);
    if (human.listed && index >= 0) {
      writeDraws(variation, drawn->desktop.seed.value_or(1), view.constants(index), human);
    }
  }
  drawn->desktop.variation = reactionTimesAlone(variation);
  return std::shared_ptr<const Scenario>(std::move(drawn));
}

}  // namespace bridge
