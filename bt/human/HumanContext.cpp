#include "bt/human/HumanContext.h"

namespace bt {

using sim2d::EventKind;
using sim2d::GoalItem;
using sim2d::Intent;

int HumanContext::knownById(LeafContext& leaf, int id) {
  const int human = id == idOf(self_) ? self_ : view_.indexOf(id);
  if (human == kNobody) {
    warn(leaf, "tree.runs-without-person", {id});
  }
  return human;
}

int HumanContext::knownAt(LeafContext& leaf, int port) {
  const int id = leaf.require<int>(port);  // 0 when it is missing
  return id != 0 || leaf.get<int>(port) ? knownById(leaf, id) : kNobody;
}

Notes& HumanContext::notes(const LeafContext& leaf) {
  for (auto& [node, notes] : mind().notes) {
    if (node == leaf.node()) {
      return notes;
    }
  }
  return mind().notes.emplace_front(leaf.node(), Notes{}).second;
}

void HumanContext::dropNotes(const LeafContext& leaf) {
  mind().notes.remove_if([&leaf](const auto& entry) { return entry.first == leaf.node(); });
}

std::optional<GoalItem> HumanContext::place(LeafContext& leaf, int goalPort) {
  GoalItem item;
  if (leaf.state(goalPort) == PortState::Missing && leaf.state(goalPort + 1) == PortState::Given) {
    item.position.x() = leaf.require<double>(goalPort + 1);
    item.position.y() = leaf.require<double>(goalPort + 2);
    return item;
  }
  const std::optional<int> id = leaf.get<int>(goalPort);
  if (!id) {
    leaf.require<int>(goalPort);
    return std::nullopt;
  }
  const std::optional<base::Vec2> position = view_.globalGoal(*id);
  if (!position) {
    warn(leaf, "tree.runs-without-goal", {*id});
    return std::nullopt;
  }
  item.id = *id;
  item.position = *position;
  return item;
}

void HumanContext::warn(const LeafContext& leaf, std::string_view code,
                        base::ProblemValues values) {
  base::Diagnostic trouble = base::within(view_.constants(self_).name + ": " + leaf.path(),
                                          base::warning(code, std::move(values)));
  if (society_.told.insert(trouble.message).second) {
    society_.troubles.push_back(std::move(trouble));
  }
}

bool HumanContext::move(int human, const Intent& intent, Mover mover) {
  const Mover rank = human == self_ ? mover : Mover::Group;
  Mover& present = society_.movers[static_cast<std::size_t>(human)];
  if (rank <= present) {
    return false;
  }
  present = rank;
  const bool wasActive = intents_.of(human).active;
  intents_.of(human) = intent;
  // A node of the own tree that runs without moving keeps the mark.
  intents_.of(human).active = intent.active || (wasActive && rank == Mover::Own);
  return true;
}

void HumanContext::emit(EventKind kind, int human, std::string text, int other) {
  sim2d::Event event;
  event.kind = kind;
  event.id = idOf(human);
  event.text = std::move(text);
  if (other >= 0) {
    event.other = idOf(other);
    event.hasOther = true;
  }
  intents_.emit(std::move(event));
}

}  // namespace bt
