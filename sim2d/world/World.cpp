#include "sim2d/world/World.h"

#include <algorithm>

#include "sim2d/world/WorldInside.h"
#include "sim2d/world/WorldRecord.h"

namespace sim2d {

base::Result<std::unique_ptr<World>> World::create(WorldSetup setup) {
  base::Result<std::unique_ptr<WorldParts>> parts = buildWorld(setup);
  if (!parts) {
    return parts.diagnostics();
  }
  setup.scenario = nullptr;  // people need the memory, unless the caller still uses it
  auto state = std::make_unique<State>(std::move(**parts), std::move(setup.behavior));
  return {std::unique_ptr<World>(new World(std::move(state))), parts.diagnostics()};
}

World::World(std::unique_ptr<State> state) : state_(std::move(state)) {}
World::~World() = default;

bool World::step(const StepInputs& inputs) {
  return state_->step(inputs);
}
const base::Diagnostics& World::refused() const {
  return state_->refused;
}
void World::measure(StepTimes* times) {
  state_->times = times;
}
const std::string& World::failure() const {
  return state_->failure;
}
const Frame& World::frame() const {
  return state_->frame;
}
std::int64_t World::stepIndex() const {
  return state_->state.step;
}
double World::time() const {
  return state_->state.time;
}
double World::dt() const {
  return state_->model.dt;
}

std::optional<double> World::arrivedAt() const {
  std::optional<double> last;
  for (std::size_t i = 0; i < state_->model.robots.size(); ++i) {
    if (state_->model.robots[i].goals.empty()) {
      continue;
    }
    const double arrived = state_->state.robots[i].arrivedAt;
    if (arrived < 0.0) {
      return std::nullopt;
    }
    last = std::max(last.value_or(arrived), arrived);
  }
  return last;
}

TraceHeader World::header() const {
  return makeHeader(state_->model, state_->surroundings);
}
const WorldView& World::view() const {
  return state_->view;
}
HumanBehavior& World::behavior() {
  return *state_->behavior;
}

}  // namespace sim2d
