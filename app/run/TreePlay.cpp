#include "app/run/TreePlay.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/run/LeafScript.h"
#include "bt/human/HumanContext.h"
#include "bt/human/HumanNodes.h"
#include "bt/robot/Nav2Files.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/HumanBehavior.h"

namespace app {

namespace {

using base::NodeStatus;

/// The world of a tree that is played alone: one person at the origin, nobody and nothing else.
class PlayView final : public sim2d::WorldView {
 public:
  PlayView(double dt, std::uint64_t seed, const sim2d::Compatibility& compatibility)
      : dt_(dt), seed_(seed), compatibility_(compatibility) {
    person_.id = 1;
    person_.name = "agent1";
  }
  void beginStep() { ++step_; }

  std::int64_t step() const override { return step_; }
  double time() const override { return static_cast<double>(step_ - 1) * dt_; }
  double dt() const override { return dt_; }
  std::uint64_t seed() const override { return seed_; }
  const sim2d::Scenario& scenario() const override { return scenario_; }
  const sim2d::Compatibility& compatibility() const override { return compatibility_; }

  int humanCount() const override { return 1; }
  bool isPresent(int) const override { return true; }
  int indexOf(int humanId) const override { return humanId == person_.id ? 0 : -1; }
  const sim2d::ResolvedHuman& constants(int) const override { return person_; }
  base::Pose2 pose(int) const override { return {}; }
  base::Vec2 velocity(int) const override { return base::Vec2::Zero(); }
  void near(int, double, std::vector<int>& found) const override { found.clear(); }

  int robotCount() const override { return 0; }
  base::Pose2 robotPose(int) const override { return {}; }
  base::Vec2 robotVelocity(int) const override { return base::Vec2::Zero(); }
  double robotRadius(int) const override { return 0.0; }
  int nearestRobot(int) const override { return -1; }

  std::optional<base::Vec2> globalGoal(int) const override { return std::nullopt; }
  const sim2d::Area* area(const std::string&) const override { return nullptr; }
  bool isVisible(const base::Vec2&, const base::Vec2&) const override { return true; }
  bool isReachable(int, const base::Vec2&) const override { return true; }

 private:
  std::int64_t step_ = 0;
  double dt_;
  std::uint64_t seed_;
  sim2d::Compatibility compatibility_;
  sim2d::Scenario scenario_;
  sim2d::ResolvedHuman person_;
};

/// What the leaves of a tree answer, by a script, and how they were called.
class LeafAnswers {
 public:
  LeafAnswers(const bt::Program& program, LeafScript script) : script_(std::move(script)) {
    for (int node = 0; node < program.nodeCount(); ++node) {
      const LeafScript::Entry* named = script_.find(program.label(node));
      answers_.push_back({named ? named : script_.find(program.manifest(node).id)});
    }
  }
  void beginStep() { calls_.clear(); }
  NodeStatus answer(int node) {
    Answer& own = answers_[static_cast<std::size_t>(node)];
    NodeStatus status = NodeStatus::Success;
    if (own.entry) {
      const std::vector<NodeStatus>& all = own.entry->statuses;
      status = all[std::min(own.calls, all.size() - 1)];
    }
    ++own.calls;
    calls_.push_back({node, status, false});
    return status;
  }
  void noteHalt(int node) { calls_.push_back({node, NodeStatus::Idle, true}); }
  const std::vector<LeafCall>& calls() const { return calls_; }

 private:
  struct Answer {
    const LeafScript::Entry* entry = nullptr;
    std::size_t calls = 0;
  };
  const LeafScript script_;
  std::vector<Answer> answers_;  // by node
  std::vector<LeafCall> calls_;
};

/// The host of a person's tree. Decorators and controls take it for the context of a person, which
/// it is.
class PersonHost : public bt::HumanContext {
 public:
  PersonHost(bt::Society& society, const PlayView& view, sim2d::Intents& intents,
             LeafAnswers& leaves)
      : HumanContext(society, view, intents, 0), answers(leaves) {}
  LeafAnswers& answers;
};

/// The host of a navigator's tree: a robot that stands at the origin, with a goal that stays.
class NavigatorOfPlay : public bt::NavigatorHost {
 public:
  explicit NavigatorOfPlay(LeafAnswers& leaves)
      : answers(leaves), goal_(paths().add({{{1.0, 0.0}, 0.0}})) {}
  LeafAnswers& answers;

  sim2d::nav2::Distro distro() const override { return sim2d::nav2::Distro::Main; }
  base::Pose2 pose() const override { return {}; }
  double speed() const override { return 0.0; }
  double goalReachedTolerance() const override { return 0.25; }
  bt::PathId newestGoal() const override { return goal_; }
  double time() const override { return 0.0; }
  sim2d::BodyTwist motion() const override { return {}; }
  double acceleration() const override { return 0.0; }
  bt::PathCheckResult checkPath(const bt::PathCheck&) const override { return {true, {}}; }
  std::optional<std::uint8_t> costAt(bool, const base::Pose2&, bool) const override { return 0; }
  sim2d::nav2::TrackingFeedback tracking() const override { return {}; }
  void monitorCollisions(bool) override {}
  bt::TopicMessage lastMessage(const std::string&) const override { return {}; }
  void begin(bt::RobotAction, const bt::RobotRequest&) override {}
  bt::RobotOutcome outcome(bt::RobotAction) const override { return {}; }
  void cancel(bt::RobotAction) override {}
  bool clear(const bt::ClearRequest&) override { return true; }
  void countRecovery() override {}

 private:
  bt::PathId goal_;
};

LeafAnswers& personsAnswers(bt::LeafContext& leaf) {
  return static_cast<PersonHost&>(bt::humanOf(leaf)).answers;
}
LeafAnswers& robotsAnswers(bt::LeafContext& leaf) {
  return static_cast<NavigatorOfPlay&>(bt::robotOf(leaf)).answers;
}

/// Of both kinds of trees, by where a leaf finds its answers.
template <LeafAnswers& (*answersOf)(bt::LeafContext&)>
bt::StatefulFunctions scriptedLeaf() {
  const bt::LeafFunction answer = [](bt::LeafContext& leaf) {
    return answersOf(leaf).answer(leaf.node());
  };
  return {answer, answer, [](bt::LeafContext& leaf) { answersOf(leaf).noteHalt(leaf.node()); }};
}

class ScriptedPlay final : public TreePlay {
 public:
  ScriptedPlay(const PlaySetup& setup, bt::TreeTable files, LeafScript script,
               std::shared_ptr<const bt::Program> program, bool isOfRobot)
      : table_(std::move(files)),
        view_(setup.dt, setup.seed, setup.compatibility),
        controls_(1),
        intents_(controls_),
        answers_(*program, std::move(script)),
        person_(society_, view_, intents_, answers_),
        robot_(answers_),
        isOfRobot_(isOfRobot),
        state_(std::move(program)) {
    society_.minds.resize(1);
    society_.groups.assign(1, -1);
    if (isOfRobot_) {
      for (const int goal : {0, 1}) {
        state_.set(state_.program().hostSlot(goal), static_cast<int>(robot_.newestGoal()));
      }
      state_.set(state_.program().hostSlot(2), 0);
    } else {
      state_.set(state_.program().hostSlot(0), view_.constants(0).id);
      state_.set(state_.program().hostSlot(1), setup.dt);
    }
  }

  NodeStatus tick() override {
    view_.beginStep();
    answers_.beginStep();
    // As their bases: that is what the nodes take the host for.
    bt::HumanContext* const person = &person_;
    bt::NavigatorHost* const robot = &robot_;
    return isOfRobot_ ? state_.tickOnce({view_.step(), view_.dt(), robot})
                      : state_.tickOnce({view_.step(), view_.dt(), person});
  }
  const std::vector<LeafCall>& calls() const override { return answers_.calls(); }
  const bt::Program& program() const override { return state_.program(); }

  base::Diagnostics fault() const override {
    const bt::TreeFault* const fault = state_.fault();
    if (fault == nullptr) {
      return {};
    }
    const bt::TreeTable::Entry* tree = table_.find(program().treeOf(fault->node));
    return {base::within(fault->path, base::error("run.tree-stops", {fault->message},
                                                  tree ? tree->file : std::string(),
                                                  program().lineOf(fault->node)))};
  }

 private:
  bt::TreeTable table_;
  PlayView view_;
  bt::Society society_;
  std::vector<sim2d::HumanControl> controls_;
  sim2d::Intents intents_;
  LeafAnswers answers_;
  PersonHost person_;
  NavigatorOfPlay robot_;
  bool isOfRobot_;
  bt::TreeState state_;
};

/// As the planner `nav2` names them when its file says nothing else.
bt::CompileOptions navigatorOptions(const bt::TreeTable& table) {
  bt::CompileOptions options;
  options.mainTree = table.mainTree;
  options.hostEntries = {{"goal", bt::PortType::Any},
                         {"goals", bt::PortType::Any},
                         {"number_recoveries", bt::PortType::Int},
                         {"waypoint_statuses", bt::PortType::Any}};
  return options;
}

}  // namespace

base::Result<std::unique_ptr<TreePlay>> TreePlay::create(const PlaySetup& setup) {
  base::Result<bt::TreeTable> table = bt::loadTrees(setup.tree);
  base::Diagnostics problems = table.diagnostics();
  base::Result<LeafScript> script = LeafScript();
  if (!setup.script.empty()) {
    script = readLeafScript(setup.script);
    base::append(problems, script.diagnostics());
  }
  if (!table) {
    return problems;
  }
  const base::Result<std::string> text = base::readTextFile(setup.tree);
  const bool isOfRobot = text && bt::looksLikeNavigatorTree(*text);
  const bt::NodeLibrary library = isOfRobot
                                      ? bt::robotNodes().withLeaves(scriptedLeaf<robotsAnswers>())
                                      : bt::humanNodes().withLeaves(scriptedLeaf<personsAnswers>());
  const base::Result<std::shared_ptr<const bt::Program>> program =
      bt::compile(*table, library, isOfRobot ? navigatorOptions(*table) : bt::CompileOptions());
  base::append(problems, program.diagnostics());
  if (!program || !script) {
    return problems;
  }
  base::append(problems, unusedNames(**program, *script));
  return {std::make_unique<ScriptedPlay>(setup, *std::move(table), *std::move(script), *program,
                                         isOfRobot),
          std::move(problems)};
}

}  // namespace app
