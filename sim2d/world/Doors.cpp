#include "sim2d/world/Doors.h"

#include <algorithm>

namespace sim2d {
namespace {

constexpr double kTick = 1e-9;  // [s]; a time has come so much before it

}  // namespace

std::vector<int> Doors::advance(const WorldModel& model, WorldState& state) {
  std::vector<int> switched;
  for (std::size_t door = 0; door < next_.size(); ++door) {
    std::vector<double> times = model.doors[door]->toggles;
    std::sort(times.begin(), times.end());
    bool changed = false;
    while (next_[door] < times.size() && times[next_[door]] <= state.time + kTick) {
      ++next_[door];
      changed = !changed;
      state.doorOpen[door] = state.doorOpen[door] == 0 ? 1 : 0;
      Event event;
      event.kind = EventKind::Door;
      event.hasId = false;
      event.text = model.doors[door]->name + (state.doorOpen[door] != 0 ? " open" : " closed");
      state.events.push_back(std::move(event));
    }
    if (changed) {
      switched.push_back(static_cast<int>(door));
    }
  }
  return switched;
}

}  // namespace sim2d
