#pragma once

#include <cstdint>
#include <forward_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt/engine/LeafContext.h"
#include "bt/human/SpeechBus.h"
#include "sim2d/world/HumanBehavior.h"

/// What the leaves of people's trees get from the program that runs them.
namespace bt {

/// Who moves a person in this step. A group node goes before the person's own tree; of equals the
/// first.
enum class Mover : unsigned char { Nobody, Own, Group };

/// Goals and group of a person as they were before a node changed them.
struct SavedPerson {
  int human = -1;
  int visit = 0;  // of that person, see Mind
  std::vector<sim2d::GoalItem> goals;
  int group = -1;
};

/// Place of one member of a formation.
struct Spot {
  int human = -1;
  base::Vec2 position = base::Vec2::Zero();  // [m]
};

/// What a node keeps of others while it runs; too big for its bytes in the tree.
struct Notes {
  std::vector<SavedPerson> saved;
  std::vector<Spot> spots;
  base::Vec2 centre = base::Vec2::Zero();  // of the formation [m]
};

/// Somebody's place in a line of people that wait for the same point.
struct QueuePlace {
  int human = -1;
  base::Vec2 head = base::Vec2::Zero();  // where the line begins [m]
  std::int64_t number = 0;               // step in which the person joined; 0 = still on the way
  int node = -1;                         // of the tree, that holds the place
};

/// One person's mind beside the tree.
struct Mind {
  int visit = 0;  // how often the person has entered the world
  bool isFirstTick = true;
  bool hasOwnGoals = false;  // the tree has replaced the goals of the scenario
  std::forward_list<std::pair<int, Notes>> notes;  // by node of the tree
  std::unique_ptr<QueuePlace> queue;
};

/// What lasts from step to step for all people of a run.
struct Society {
  std::vector<Mind> minds;
  std::vector<int> groups;  // as this step began
  SpeechBus speech;
  std::vector<Mover> movers;       // of this step
  std::vector<char> changedGoals;  // of this step: a tree took a goal off the list
  std::set<std::string> told;      // warnings that were given
  base::Diagnostics troubles;      // not yet taken
};

/// One person's tick. Leaves read the frozen view and write intents; persons are given by index.
class HumanContext {
 public:
  HumanContext(Society& society, const sim2d::WorldView& view, sim2d::Intents& intents, int self)
      : society_(society), view_(view), intents_(intents), self_(self) {}

  const sim2d::WorldView& view() const { return view_; }
  sim2d::Intents& intents() { return intents_; }
  sim2d::HumanControl& control(int human) { return intents_.control(human); }
  int self() const { return self_; }  // whose tree is ticked
  Mind& mind() { return society_.minds[static_cast<std::size_t>(self_)]; }
  const Mind& mindOf(int human) const { return society_.minds[static_cast<std::size_t>(human)]; }
  SpeechBus& speech() { return society_.speech; }
  bool isOriginal(int quirk) const { return view_.compatibility().has(quirk); }
  int idOf(int human) const { return view_.constants(human).id; }

  /// As the step began, whatever nodes have changed since.
  int groupOf(int human) const { return society_.groups[static_cast<std::size_t>(human)]; }

  /// The person named by an id: nothing, and one warning, when nobody has it; nothing for people
  /// who are not in the world now.
  std::optional<int> personById(LeafContext& leaf, int id) {
    return unlessNobody(ifPresent(knownById(leaf, id)));
  }
  /// The same for an input port; a missing port makes the tree faulty.
  std::optional<int> person(LeafContext& leaf, int port) {
    return unlessNobody(ifPresent(knownAt(leaf, port)));
  }
  /// The same, also for people who are not in the world now.
  std::optional<int> knownPerson(LeafContext& leaf, int port) {
    return unlessNobody(knownAt(leaf, port));
  }
  /// A global goal by its port, else the two ports after it as coordinates (older files): nothing
  /// and one warning for an unknown goal. The radius is not set.
  std::optional<sim2d::GoalItem> place(LeafContext& leaf, int goalPort);
  /// Said once for the run.
  void warn(const LeafContext& leaf, std::string_view code, base::ProblemValues values);

  /// The person's motion of this step, or nothing when another mover was first. A person moved by
  /// the tree of somebody else, or by a group node, obeys that.
  bool move(int human, const sim2d::Intent& intent, Mover mover = Mover::Own);
  /// Column `state` of a person who does something social without being moved.
  void setActive(int human) { intents_.of(human).active = true; }
  void noteGoalChange(int human) { society_.changedGoals[static_cast<std::size_t>(human)] = 1; }

  /// Empty at first; stay where they are until dropped.
  Notes& notes(const LeafContext& leaf);
  void dropNotes(const LeafContext& leaf);

  /// `other`: the second person of the event; -1 = there is none.
  void emit(sim2d::EventKind kind, int human, std::string text, int other = -1);

 private:
  // Plain indices, as nearly every leaf asks: an optional is slow to hand from call to call.
  static constexpr int kNobody = -1;
  int knownById(LeafContext& leaf, int id);
  int knownAt(LeafContext& leaf, int port);
  int ifPresent(int human) const {
    return human != kNobody && view_.isPresent(human) ? human : kNobody;
  }
  static std::optional<int> unlessNobody(int human) {
    return human != kNobody ? std::optional<int>(human) : std::nullopt;
  }

  Society& society_;
  const sim2d::WorldView& view_;
  sim2d::Intents& intents_;
  int self_;
};

// Pieces that the nodes share.
using base::NodeStatus;

inline HumanContext& humanOf(LeafContext& leaf) {
  return leaf.host<HumanContext>();
}
inline NodeStatus successIf(bool condition) {
  return condition ? NodeStatus::Success : NodeStatus::Failure;
}

/// A stateful action ends with SUCCESS after `duration` [s]; 0 and less mean never.
inline NodeStatus byDuration(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return duration > 0.0 && leaf.hasElapsed(startStep, duration) ? NodeStatus::Success
                                                                : NodeStatus::Running;
}

/// A stateful condition that did not hold in this step: it waits for `duration` [s], then fails.
inline NodeStatus untilDuration(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return leaf.hasElapsed(startStep, duration) ? NodeStatus::Failure : NodeStatus::Running;
}

}  // namespace bt
