#include "app/run/TreePlay.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/run/FileKind.h"
#include "bt/human/HumanContext.h"
#include "bt/human/TreeLoader.h"
#include "bt/robot/Nav2Files.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/world/HumanBehavior.h"

namespace app {

namespace {

using base::NodeStatus;

/// The world of a tree that is played alone: one agent at the origin and nothing else.
class EmptyWorldView final : public sim2d::WorldView {
 public:
  EmptyWorldView(double dt, std::uint64_t seed, const sim2d::Compatibility& compatibility)
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

/// The scripted results of leaves and a record of their calls.
class ScriptedLeaves {
 public:
  ScriptedLeaves(const bt::Program& program, LeafScript script) : script_(std::move(script)) {
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

/// The host of an agent's tree, derived from HumanContext because decorators and controls cast to
/// it.
class AgentHost : public bt::HumanContext {
 public:
  AgentHost(bt::CrowdState& society, const EmptyWorldView& view, sim2d::Intents& intents,
            ScriptedLeaves& leaves)
      : HumanContext(society, view, intents, 0), answers(leaves) {}
  ScriptedLeaves& answers;
};

/// The host of a navigator's tree: a robot at rest at the origin, with a constant goal.
class StationaryNavigator : public bt::NavigatorHost {
 public:
  explicit StationaryNavigator(ScriptedLeaves& leaves)
      : answers(leaves), goal_(paths().add({{{1.0, 0.0}, 0.0}})) {}
  ScriptedLeaves& answers;

  sim2d::nav2::Distro distro() const override { return sim2d::nav2::Distro::Main; }
  base::Pose2 pose() const override { return {}; }
  double speed() const override { return 0.0; }
  double goalReachedTolerance() const override { return 0.25; }
  bt::PathId goal() const { return goal_; }
  double time() const override { return 0.0; }
  sim2d::BodyTwist motion() const override { return {}; }
  double acceleration() const override { return 0.0; }
  bt::PathCheckResult checkPath(const bt::PathCheck&) const override { return {true, {}}; }
  std::optional<std::uint8_t> costAt(bool, const base::Pose2&, bool) const override { return 0; }
  sim2d::nav2::TrackingFeedback tracking() const override { return {}; }
  void enableCollisionMonitor(bool) override {}
  bt::TopicMessage lastMessage(const std::string&) const override { return {}; }
  void begin(bt::RobotAction, const bt::RobotRequest&) override {}
  bt::RobotOutcome outcome(bt::RobotAction) const override { return {}; }
  void cancel(bt::RobotAction) override {}
  bool clear(const bt::ClearRequest&) override { return true; }
  void countRecovery() override {}

 private:
  bt::PathId goal_;
};

ScriptedLeaves& agentLeaves(bt::LeafContext& leaf) {
  return static_cast<AgentHost&>(bt::humanOf(leaf)).answers;
}
ScriptedLeaves& robotLeaves(bt::LeafContext& leaf) {
  return static_cast<StationaryNavigator&>(bt::robotOf(leaf)).answers;
}

/// A scripted leaf for both kinds of trees; `leavesOf` returns the scripted results of a leaf.
template <ScriptedLeaves& (*leavesOf)(bt::LeafContext&)>
bt::StatefulFunctions scriptedLeaf() {
  const bt::LeafFunction answer = [](bt::LeafContext& leaf) {
    return leavesOf(leaf).answer(leaf.node());
  };
  return {answer, answer, [](bt::LeafContext& leaf) { leavesOf(leaf).noteHalt(leaf.node()); }};
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
    society_.agentStates.resize(1);
    society_.groups.assign(1, -1);
    if (isOfRobot_) {
      for (const int entry : {0, 1}) {
        state_.set(state_.program().hostSlot(entry), static_cast<int>(robot_.goal()));
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
    // As base class pointers, which the nodes expect as host.
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
    return {base::withContext(fault->path, base::error("run.tree-stops", {fault->message},
                                                       tree ? tree->file : std::string(),
                                                       program().lineOf(fault->node)))};
  }

 private:
  bt::TreeTable table_;
  EmptyWorldView view_;
  bt::CrowdState society_;
  std::vector<sim2d::HumanControl> controls_;
  sim2d::Intents intents_;
  ScriptedLeaves answers_;
  AgentHost person_;
  StationaryNavigator robot_;
  bool isOfRobot_;
  bt::TreeState state_;
};

/// The default entry names of the planner `nav2`.
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
  const bool isOfRobot = text && fileKindOf(*text) == FileKind::NavigatorTree;
  const bt::NodeLibrary library =
      isOfRobot ? bt::robotNodes().withLeafFunctions(scriptedLeaf<robotLeaves>())
                : bt::humanNodes().withLeafFunctions(scriptedLeaf<agentLeaves>());
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

namespace {

using base::YamlNode;

constexpr const char* kScriptStatuses = "SUCCESS, FAILURE or RUNNING";

std::optional<NodeStatus> scriptStatusOf(const std::string& word) {
  for (const NodeStatus status : {NodeStatus::Success, NodeStatus::Failure, NodeStatus::Running}) {
    if (word == base::nodeStatusName(status)) {
      return status;
    }
  }
  return std::nullopt;
}

/// Reads a script and reports every problem with file, line and column.
class ScriptReader {
 public:
  explicit ScriptReader(const std::string& path) { script_.path = path; }

  base::Result<LeafScript> read() {
    const base::Result<std::string> text = base::readTextFile(script_.path);
    if (!text) {
      return text.diagnostics();
    }
    const YamlNode root = base::parseYaml(*text, script_.path, problems_);
    if (!base::hasErrors(problems_)) {
      readRoot(root);
    }
    if (base::hasErrors(problems_)) {
      return problems_;
    }
    return {std::move(script_), std::move(problems_)};
  }

 private:
  void readRoot(const YamlNode& root) {
    if (root.isNull()) {
      return;  // an empty script: every leaf succeeds
    }
    if (!root.isMap()) {
      error(root, "script.no-map");
      return;
    }
    for (const YamlNode& item : root.items) {
      readEntry(item);
    }
  }

  void readEntry(const YamlNode& item) {
    LeafScript::Entry entry;
    entry.leaf = item.key;
    entry.line = item.keyLine;
    entry.column = item.keyColumn;
    const std::vector<YamlNode> words = item.isList() ? item.items : std::vector{item};
    for (const YamlNode& word : words) {
      readStatus(word, entry);
    }
    if (words.empty()) {
      error(item, "script.empty-list", {item.key});
    }
    script_.entries.push_back(std::move(entry));
  }

  void readStatus(const YamlNode& word, LeafScript::Entry& entry) {
    const std::optional<NodeStatus> status =
        word.isScalar() ? scriptStatusOf(word.text) : std::nullopt;
    if (status) {
      entry.statuses.push_back(*status);
      return;
    }
    const std::string what = word.isScalar() ? "'" + word.text + "' is" : "this is";
    error(word, "script.no-status", {what, kScriptStatuses});
  }

  void error(const YamlNode& node, std::string_view code, base::ProblemValues values = {}) {
    const bool isValue = !node.isNull() || node.keyLine == 0;  // the key has no value
    problems_.push_back(base::error(code, std::move(values), script_.path,
                                    isValue ? node.line : node.keyLine,
                                    isValue ? node.column : node.keyColumn));
  }

  LeafScript script_;
  base::Diagnostics problems_;
};

}  // namespace

base::Result<LeafScript> readLeafScript(const std::string& path) {
  return ScriptReader(path).read();
}

base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script) {
  std::vector<std::string> names;
  for (int node = 0; node < program.nodeCount(); ++node) {
    if (program.node(node).isStateful) {  // a scripted leaf
      names.push_back(program.label(node));
      names.push_back(program.manifest(node).id);
    }
  }
  base::Diagnostics found;
  for (const LeafScript::Entry& entry : script.entries) {
    if (std::find(names.begin(), names.end(), entry.leaf) == names.end()) {
      found.push_back(base::warning("run.unknown-leaf",
                                    {entry.leaf, base::nearestName(entry.leaf, names)}, script.path,
                                    entry.line, entry.column));
    }
  }
  return found;
}

}  // namespace app
