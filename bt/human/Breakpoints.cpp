#include "bt/human/Breakpoints.h"

#include <algorithm>
#include <utility>

namespace bt {

using base::NodeStatus;
using sim2d::TreeBreakpoint;

base::Diagnostics checkBreakpoint(const TreeBreakpoint& point) {
  if (point.condition.empty()) {
    return {};
  }
  const base::Result<Script> script =
      compileScript(point.condition, [](const std::string& /*key*/) { return 0; });
  if (!script) {
    return script.diagnostics();
  }
  if (!script->written.empty()) {
    return {base::error("breakpoint.assigns", {point.condition})};
  }
  return {};
}

void Breakpoints::set(std::vector<TreeBreakpoint> points) {
  watches_.clear();
  for (TreeBreakpoint& point : points) {
    if (checkBreakpoint(point).empty()) {
      watches_.push_back({std::move(point), {}, {}});
    }
  }
}

const Breakpoints::ResolvedBreakpoint& Breakpoints::placeIn(Watch& watch, const Program& program) {
  const auto [found, isNew] = watch.places.try_emplace(&program);
  ResolvedBreakpoint& place = found->second;
  if (!isNew) {
    return place;
  }
  place.paths = program.paths();
  const auto at = std::find(place.paths->begin(), place.paths->end(), watch.point.path);
  place.node = at == place.paths->end() ? -1 : static_cast<int>(at - place.paths->begin());
  bool areKnown = true;
  const auto slotOf = [&](const std::string& key) {
    const int slot = program.findSlot(key);
    areKnown = areKnown && slot >= 0;
    return std::max(slot, 0);
  };
  base::Result<Script> script = compileScript(watch.point.condition, slotOf);
  if (script && areKnown) {
    place.condition = *std::move(script);
  }
  return place;
}

bool Breakpoints::holds(const Watch& watch, const ResolvedBreakpoint& place,
                        const TreeState& tree) {
  if (place.node < 0) {
    return false;
  }
  const NodeStatus now = tree.statuses()[static_cast<std::size_t>(place.node)];
  const bool isLike = watch.point.status ? now == *watch.point.status : now != NodeStatus::Idle;
  return isLike && (watch.point.condition.empty() ||
                    (place.condition && tree.evaluateCondition(*place.condition).value_or(false)));
}

void Breakpoints::look(int person, const TreeState& tree) {
  for (Watch& watch : watches_) {
    if (watch.point.person.value_or(person) != person) {
      continue;
    }
    const ResolvedBreakpoint& place = placeIn(watch, tree.program());
    if (!holds(watch, place, tree)) {
      watch.people.erase(person);
    } else if (watch.people.insert(person).second && !hit_) {
      hit_ = {watch.point, person, tree.statuses()[static_cast<std::size_t>(place.node)]};
    }
  }
}

void Breakpoints::forget(int person) {
  for (Watch& watch : watches_) {
    watch.people.erase(person);
  }
}

}  // namespace bt
