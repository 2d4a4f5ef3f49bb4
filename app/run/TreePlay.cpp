#include "app/run/TreePlay.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bt/human/HumanContext.h"
#include "bt/human/HumanNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/world/HumanBehavior.h"

namespace app {

namespace {

using base::NodeStatus;
using base::YamlNode;

/// What leaves answer while a tree is played.
struct LeafScript {
  struct Entry {
    std::string leaf;
    std::vector<base::NodeStatus> statuses;  // never empty; SUCCESS, FAILURE or RUNNING
    int line = 0, column = 0;
  };
  std::string path;
  std::vector<Entry> entries;  // in the order of the file

  const Entry* find(const std::string& leaf) const {  // nullptr = not in the script
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&leaf](const Entry& entry) { return entry.leaf == leaf; });
    return found == entries.end() ? nullptr : &*found;
  }
};

constexpr const char* kStatuses = "SUCCESS, FAILURE or RUNNING";

std::optional<NodeStatus> statusOf(const std::string& word) {
  for (const NodeStatus status : {NodeStatus::Success, NodeStatus::Failure, NodeStatus::Running}) {
    if (word == base::nodeStatusName(status)) {
      return status;
    }
  }
  return std::nullopt;
}

/// Every problem of a script with file, line and column.
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
      return;  // nothing is said: every leaf succeeds
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
    const std::optional<NodeStatus> status = word.isScalar() ? statusOf(word.text) : std::nullopt;
    if (status) {
      entry.statuses.push_back(*status);
      return;
    }
    const std::string what = word.isScalar() ? "'" + word.text + "' is" : "this is";
    error(word, "script.no-status", {what, kStatuses});
  }

  void error(const YamlNode& node, std::string_view code, base::ProblemValues values = {}) {
    const bool isValue = !node.isNull() || node.keyLine == 0;  // nothing stands behind its key
    problems_.push_back(base::error(code, std::move(values), script_.path,
                                    isValue ? node.line : node.keyLine,
                                    isValue ? node.column : node.keyColumn));
  }

  LeafScript script_;
  base::Diagnostics problems_;
};

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

/// The host of a played tree. Decorators and controls of people's trees take it for the context of
/// a person, which it is.
class TreePlayer : public bt::HumanContext {
 public:
  TreePlayer(bt::Society& society, const PlayView& view, sim2d::Intents& intents,
             const bt::Program& program, LeafScript script)
      : HumanContext(society, view, intents, 0), script_(std::move(script)) {
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

TreePlayer& playerOf(bt::LeafContext& leaf) {
  return static_cast<TreePlayer&>(bt::humanOf(leaf));
}

NodeStatus answer(bt::LeafContext& leaf) {
  return playerOf(leaf).answer(leaf.node());
}

void noteHalt(bt::LeafContext& leaf) {
  playerOf(leaf).noteHalt(leaf.node());
}

/// Names of the script that no leaf has: most likely a slip.
base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script) {
  std::vector<std::string> names;
  for (int node = 0; node < program.nodeCount(); ++node) {
    if (program.node(node).isStateful) {  // a leaf of the script
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

class ScriptedPlay final : public TreePlay {
 public:
  ScriptedPlay(const PlaySetup& setup, bt::TreeTable files, LeafScript script,
               std::shared_ptr<const bt::Program> program)
      : table_(std::move(files)),
        view_(setup.dt, setup.seed, setup.compatibility),
        controls_(1),
        intents_(controls_),
        player_(society_, view_, intents_, *program, std::move(script)),
        state_(std::move(program)) {
    society_.minds.resize(1);
    society_.groups.assign(1, -1);
    state_.set(state_.program().hostSlot(0), view_.constants(0).id);
    state_.set(state_.program().hostSlot(1), setup.dt);
  }

  NodeStatus tick() override {
    view_.beginStep();
    player_.beginStep();
    // As its base: that is what the nodes take the host for.
    bt::HumanContext* const host = &player_;
    return state_.tickOnce({view_.step(), view_.dt(), host});
  }
  const std::vector<LeafCall>& calls() const override { return player_.calls(); }
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
  TreePlayer player_;
  bt::TreeState state_;
};

}  // namespace

base::Result<std::unique_ptr<TreePlay>> TreePlay::create(const PlaySetup& setup) {
  base::Result<bt::TreeTable> table = bt::loadTrees(setup.tree);
  base::Diagnostics problems = table.diagnostics();
  base::Result<LeafScript> script = LeafScript();
  if (!setup.script.empty()) {
    script = ScriptReader(setup.script).read();
    base::append(problems, script.diagnostics());
  }
  if (!table) {
    return problems;
  }
  const bt::NodeLibrary library = bt::humanNodes().withLeaves({answer, answer, noteHalt});
  const base::Result<std::shared_ptr<const bt::Program>> program = bt::compile(*table, library);
  base::append(problems, program.diagnostics());
  if (!program || !script) {
    return problems;
  }
  base::append(problems, unusedNames(**program, *script));
  return {std::make_unique<ScriptedPlay>(setup, *std::move(table), *std::move(script), *program),
          std::move(problems)};
}

}  // namespace app
