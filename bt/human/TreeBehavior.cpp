#include "bt/human/TreeBehavior.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bt/engine/Script.h"
#include "bt/engine/TreeState.h"
#include "bt/human/HumanContext.h"
#include "bt/human/TreeLoader.h"
#include "sim2d/world/HumanBehavior.h"
#include "sim2d/world/StepBuffers.h"

namespace bt {

using base::Diagnostics;
using base::NodeStatus;
using sim2d::Intents;
using sim2d::TreeBreakpoint;
using sim2d::TreeChanges;
using sim2d::WorldView;

namespace {

/// Checks trees after their ticks for breakpoints. Not synchronised. A condition on entries that a
/// tree does not have, or that have no value, is false.
class Breakpoints {
 public:
  /// Breakpoints with problems (checkBreakpoint) are ignored.
  void set(std::vector<TreeBreakpoint> points);
  bool isEmpty() const { return watches_.empty(); }
  /// Call after each tick of this person's tree.
  void look(int person, const TreeState& tree);
  /// Resets the state of a person who has a new tree.
  void forget(int person);
  /// Returns and clears the first breakpoint hit since the last call.
  std::optional<sim2d::TreeBreakpointHit> take() { return std::exchange(hit_, std::nullopt); }

 private:
  /// A breakpoint resolved for one program.
  struct ResolvedBreakpoint {
    std::shared_ptr<const std::vector<std::string>> paths;  // keeps the map key unique
    int node = -1;                                          // -1: no such node
    std::optional<Script> condition;                        // empty: an entry of it is missing
  };
  struct Watch {
    TreeBreakpoint point;
    std::map<const Program*, ResolvedBreakpoint> places;
    std::set<int> people;  // ids of people for whom it currently holds
  };
  static const ResolvedBreakpoint& placeIn(Watch& watch, const Program& program);
  static bool holds(const Watch& watch, const ResolvedBreakpoint& place, const TreeState& tree);

  std::vector<Watch> watches_;
  std::optional<sim2d::TreeBreakpointHit> hit_;
};

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

/// One person's tree and its last published state.
struct AgentTree {
  const AgentProgram* program = nullptr;
  std::optional<TreeState> tree;
  std::unique_ptr<NodeStatus[]> shown;   // last published status per node
  std::vector<base::StatusSet> results;  // of all visits, per node
  std::string owner;                     // name of the person
  bool isTicking = false;                // ticked in the last step
  bool hasEnded = false;
  bool isFaulty = false;
};

/// The tree of a previous visit of a person. It is halted in the next step so that its effects on
/// others end.
struct AbandonedTree {
  int human = -1;
  TreeState tree;
  AgentState agentState;
};

/// Suffixes after the name of the leaf, by LeafEvent::Kind.
constexpr std::array<const char*, 4> kEventSuffixes = {"", " SUCCESS", " FAILURE", " HALTED"};

sim2d::Intent braking() {
  sim2d::Intent intent;
  intent.motion = sim2d::Motion::Brake;
  return intent;
}

class TreeBehavior final : public sim2d::HumanBehavior {
 public:
  TreeBehavior(AgentPrograms programs, bool loopsTrees)
      : programs_(std::move(programs)), loopsTrees_(loopsTrees) {}

  std::unique_ptr<sim2d::HumanBehavior> withInitialState() const {
    return std::make_unique<TreeBehavior>(programs_, loopsTrees_);
  }
  void enter(int human, const WorldView& view) override;
  void decide(const WorldView& view, Intents& intents) override;
  void takeTreeChanges(TreeChanges& changes) override {
    std::swap(changes, changes_);  // reuses the memory
    changes_.clear();
    changes_.forColumns(
        changes, [](auto& column, std::size_t usual) { sim2d::shrinkExcess(column, usual); });
  }
  std::vector<base::TreeResults> treeResults() const override {
    std::vector<base::TreeResults> all;
    for (const int human : order_) {
      const AgentTree& who = agentTrees_[static_cast<std::size_t>(human)];
      if (!who.results.empty()) {
        const Program& program = *who.program->program;
        base::addTreeResults({who.owner, program.paths(), who.results, program.unreachable()}, all);
      }
    }
    return all;
  }
  void takeDiagnostics(Diagnostics& found) override {
    found = std::move(society_.pendingDiagnostics);
    society_.pendingDiagnostics.clear();
  }
  bool hasCustomTree(int human, const WorldView& view) const override {
    const AgentPrograms::Entry* const entry = entryOf(human, view);
    return entry != nullptr && entry->isCustom;
  }
  std::vector<std::pair<std::string, std::string>> blackboard(int human) const override;
  std::string setBlackboardEntry(int human, const std::string& key,
                                 const std::string& text) override;
  void setBreakpoints(const std::vector<sim2d::TreeBreakpoint>& points) override {
    breakpoints_.set(points);
  }
  std::optional<sim2d::TreeBreakpointHit> takeBreakpointHit() override {
    return breakpoints_.take();
  }

 private:
  const AgentPrograms::Entry* entryOf(int human, const WorldView& view) const;
  void grow(int count);
  void orderById(const WorldView& view);
  void tick(int human, const WorldView& view, Intents& intents);
  void stop(int human, const WorldView& view, Intents& intents);
  void haltAbandonedTrees(const WorldView& view, Intents& intents);
  void handleFault(int human, HumanContext& context);
  bool isAtEnd(int human, NodeStatus status) const;
  void emitLeafEvents(const TreeState& tree, std::size_t first, HumanContext& context);
  void recordStatusChanges(int human, const WorldView& view, const StatusList& now);
  AgentTree& player(int human) { return agentTrees_[static_cast<std::size_t>(human)]; }

  AgentPrograms programs_;
  bool loopsTrees_;
  CrowdState society_;
  std::vector<AgentTree> agentTrees_;
  std::vector<int> order_;  // person indices by ascending id
  TreeChanges changes_;
  std::vector<AbandonedTree> retired_;
  Breakpoints breakpoints_;
};

/// Null if there is no program for the person; a copy has that of its original.
const AgentPrograms::Entry* TreeBehavior::entryOf(int human, const WorldView& view) const {
  const AgentPrograms::Entry* const own = programs_.find(view.constants(human));
  const int original = view.copiedFrom(human);
  return own == nullptr && original >= 0 ? programs_.find(view.constants(original)) : own;
}

void TreeBehavior::grow(int count) {
  const auto size = static_cast<std::size_t>(count);
  if (agentTrees_.size() < size) {
    agentTrees_.resize(size);
    society_.agentStates.resize(size);
    society_.groups.resize(size, -1);
  }
}

void TreeBehavior::enter(int human, const WorldView& view) {
  grow(std::max(view.humanCount(), human + 1));
  const sim2d::ResolvedHuman& constants = view.constants(human);
  AgentTree& who = player(human);
  const AgentPrograms::Entry* const entry = entryOf(human, view);
  who.program = entry != nullptr ? entry->program.get() : nullptr;
  AgentState& agentState = society_.agentStates[static_cast<std::size_t>(human)];
  const int visit = agentState.visit + 1;
  if (who.tree && who.isTicking && !who.isFaulty) {
    retired_.push_back({human, *std::move(who.tree), std::move(agentState)});
  }
  breakpoints_.forget(constants.id);
  who.tree.reset();
  if (who.program) {
    who.tree = who.program->start(constants);
    if (who.shown == nullptr) {
      who.shown = std::make_unique<NodeStatus[]>(who.tree->statuses().size());  // IDLE
      who.results.resize(who.tree->statuses().size());
      who.owner = constants.name;
    }
    who.tree->recordResults(who.results.data());
  }
  who.isTicking = false;
  who.hasEnded = false;
  who.isFaulty = false;
  agentState = AgentState{};
  agentState.visit = visit;
  society_.speech.forget(human);
}

void TreeBehavior::orderById(const WorldView& view) {
  if (order_.size() == static_cast<std::size_t>(view.humanCount())) {
    return;
  }
  order_.resize(static_cast<std::size_t>(view.humanCount()));
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(),
            [&view](int a, int b) { return view.constants(a).id < view.constants(b).id; });
}

void TreeBehavior::decide(const WorldView& view, Intents& intents) {
  grow(view.humanCount());
  society_.motionOwners.assign(agentTrees_.size(), MotionOwner::None);
  society_.changedGoals.assign(agentTrees_.size(), 0);
  orderById(view);
  society_.speech.beginStep();
  for (int human = 0; human < view.humanCount(); ++human) {
    society_.groups[static_cast<std::size_t>(human)] = intents.control(human).group;
  }
  changes_.clear();
  haltAbandonedTrees(view, intents);
  for (const int human : order_) {
    if (!view.decides(human)) {
      continue;
    }
    const AgentTree& who = player(human);
    const bool isPresent = view.isPresent(human);
    if (isPresent && who.tree && !who.hasEnded && !who.isFaulty) {
      tick(human, view, intents);
      continue;
    }
    stop(human, view, intents);
    if (isPresent && who.isFaulty) {
      HumanContext(society_, view, intents, human).move(human, braking());
    }
  }
}

void TreeBehavior::tick(int human, const WorldView& view, Intents& intents) {
  AgentTree& who = player(human);
  HumanContext context(society_, view, intents, human);
  TreeState& tree = *who.tree;
  tree.set(who.program->program->hostSlot(1), view.dt());
  const TickInput input{view.step(), view.dt(), &context};
  const NodeStatus status = tree.tickOnce(input);
  who.isTicking = true;
  context.agentState().isFirstTick = false;
  recordStatusChanges(human, view, tree.statuses());
  if (!breakpoints_.isEmpty()) {
    breakpoints_.look(view.constants(human).id, tree);
  }
  if (tree.fault()) {
    handleFault(human, context);
  } else {
    who.hasEnded = !loopsTrees_ && isAtEnd(human, status);
  }
  emitLeafEvents(tree, 0, context);
}

void TreeBehavior::haltAbandonedTrees(const WorldView& view, Intents& intents) {
  for (AbandonedTree& old : retired_) {
    const sim2d::HumanControl fresh = intents.control(old.human);
    AgentState& agentState = society_.agentStates[static_cast<std::size_t>(old.human)];
    std::swap(agentState, old.agentState);
    agentState.visit = old.agentState.visit;  // discards what the tree saved of its own person
    HumanContext context(society_, view, intents, old.human);
    old.tree.halt({view.step(), view.dt(), &context});
    std::swap(agentState, old.agentState);
    intents.control(old.human) = fresh;
  }
  retired_.clear();
}

bool TreeBehavior::isAtEnd(int human, NodeStatus status) const {
  const auto index = static_cast<std::size_t>(human);
  return status == NodeStatus::Success && society_.motionOwners[index] == MotionOwner::None &&
         society_.changedGoals[index] == 0;
}

void TreeBehavior::handleFault(int human, HumanContext& context) {
  AgentTree& who = player(human);
  who.isFaulty = true;
  const TreeFault& fault = *who.tree->fault();
  society_.pendingDiagnostics.push_back(
      base::withContext(context.view().constants(human).name + ": " + fault.path,
                        base::warning("tree.fault", {fault.message})));
  if (society_.motionOwners[static_cast<std::size_t>(human)] != MotionOwner::Group) {
    society_.motionOwners[static_cast<std::size_t>(human)] = MotionOwner::None;
    context.intents().of(human) = sim2d::Intent{};
    context.move(human, braking());
  }
}

/// Halts the running nodes of a tree that is not ticked in this step or any more.
void TreeBehavior::stop(int human, const WorldView& view, Intents& intents) {
  AgentTree& who = player(human);
  if (!who.isTicking) {
    return;
  }
  who.isTicking = false;
  HumanContext context(society_, view, intents, human);
  if (!who.isFaulty) {
    const std::size_t told = who.tree->events().size();
    who.tree->halt({view.step(), view.dt(), &context});
    emitLeafEvents(*who.tree, told, context);
  }
  const std::vector<NodeStatus> idle(who.tree->statuses().size(), NodeStatus::Idle);
  recordStatusChanges(human, view, {idle.data(), idle.size()});
}

void TreeBehavior::emitLeafEvents(const TreeState& tree, std::size_t first, HumanContext& context) {
  for (std::size_t i = first; i < tree.events().size(); ++i) {
    const LeafEvent& event = tree.events()[i];
    const bool isStart = event.kind == LeafEvent::Kind::Started;
    context.emit(
        isStart ? sim2d::EventKind::Action : sim2d::EventKind::ActionEnd, context.self(),
        tree.program().label(event.node) + kEventSuffixes[static_cast<std::size_t>(event.kind)]);
  }
}

void TreeBehavior::recordStatusChanges(int human, const WorldView& view, const StatusList& now) {
  AgentTree& who = player(human);
  if (std::memcmp(now.begin(), who.shown.get(), now.size() * sizeof(NodeStatus)) == 0) {
    return;  // the usual case
  }
  for (std::size_t node = 0; node < now.size(); ++node) {
    if (now[node] != who.shown[node]) {
      who.shown[node] = now[node];
      changes_.add(view.constants(human).id, who.program->program->paths(), static_cast<int>(node),
                   now[node]);
    }
  }
}

std::vector<std::pair<std::string, std::string>> TreeBehavior::blackboard(int human) const {
  const auto index = static_cast<std::size_t>(human);
  if (human < 0 || index >= agentTrees_.size() || !agentTrees_[index].tree) {
    return {};
  }
  return agentTrees_[index].tree->entries();
}

/// `id` and `dt` are set by the program: otherwise a tree would use a wrong id, or the value would
/// be overwritten.
std::string TreeBehavior::setBlackboardEntry(int human, const std::string& key,
                                             const std::string& text) {
  const auto index = static_cast<std::size_t>(human);
  if (human < 0 || index >= agentTrees_.size() || !agentTrees_[index].tree) {
    return "the person has no tree";
  }
  if (key == "id" || key == "dt") {
    return "the entry '" + key + "' is read-only";
  }
  return agentTrees_[index].tree->setFromText(key, text)
             ? std::string()
             : "'" + text + "' is not a valid value of the entry '" + key +
                   "', or there is no such entry";
}

}  // namespace

std::unique_ptr<sim2d::HumanBehavior> makeTreeBehavior(const sim2d::Scenario& scenario,
                                                       const TreeFiles& files,
                                                       Diagnostics& diagnostics,
                                                       const sim2d::Compatibility& quirks,
                                                       const std::shared_ptr<TreeCache>& known) {
  TreeLoader loader(scenario, quirks, known);
  Diagnostics found;
  AgentPrograms programs = loader.loadAll(files, found);
  base::append(diagnostics, found);
  if (base::hasErrors(found)) {
    return nullptr;
  }
  return std::make_unique<TreeBehavior>(std::move(programs),
                                        scenario.desktop.loopTrees.value_or(true));
}

std::unique_ptr<sim2d::HumanBehavior> withInitialState(const sim2d::HumanBehavior& behavior) {
  return dynamic_cast<const TreeBehavior&>(behavior).withInitialState();
}

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

}  // namespace bt
