#include "sim2d/world/Contacts.h"

#include <algorithm>
#include <tuple>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

int idOf(const BodyOwner& owner, const WorldModel& model) {
  const auto at = static_cast<std::size_t>(owner.index);
  return owner.isRobot ? model.robots[at].id : model.people[at].constants.id;
}

bool precedes(const Touch& a, const Touch& b) {
  return std::tie(a.body, a.other, a.part) < std::tie(b.body, b.other, b.part);
}

}  // namespace

void Contacts::update(Physics& physics, const std::vector<BodyOwner>& owners,
                      const std::function<Vec2(int)>& wanted, const WorldModel& model,
                      WorldState& state) {
  std::swap(before_, touches_);
  touches_.reserve(owners.size());
  physics.touches(before_, touches_);
  for (const Touch& touch : touches_) {
    if (std::binary_search(before_.begin(), before_.end(), touch, precedes)) {
      continue;
    }
    const auto body = static_cast<std::size_t>(touch.body);
    Vec2 relative = wanted(touch.body);
    Event event;
    event.kind = EventKind::Contact;
    event.id = idOf(owners[body], model);
    if (touch.other >= 0) {
      const auto other = static_cast<std::size_t>(touch.other);
      relative -= wanted(touch.other);
      event.other = idOf(owners[other], model);
      event.hasOther = true;
      const bool otherIsFirst = owners[other].isRobot == owners[body].isRobot
                                    ? event.other < event.id && !owners[body].isRobot
                                    : owners[other].isRobot;
      if (otherIsFirst) {
        std::swap(event.id, event.other);
      }
    }
    event.text = base::formatDouble(std::max(0.0, relative.dot(touch.normal)));
    if (touch.part >= 0 && !partNames_[static_cast<std::size_t>(touch.part)].empty()) {
      event.text += " " + partNames_[static_cast<std::size_t>(touch.part)];
    }
    state.events.push_back(std::move(event));
  }
}

}  // namespace sim2d
