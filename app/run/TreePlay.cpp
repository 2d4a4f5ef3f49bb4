#include "app/run/TreePlay.h"

#include <algorithm>

#include "app/run/PlayView.h"
#include "bt/human/HumanContext.h"
#include "bt/human/HumanNodes.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using base::NodeStatus;

/// The host of a played tree. Decorators and controls of people's trees take it for the context of
/// a person, which it is.
class TreePlayer : public bt::HumanContext {
 public:
  TreePlayer(bt::Society& society, const PlayView& view, sim2d::Intents& intents)
      : HumanContext(society, view, intents, 0) {}

  void prepare(const bt::Program& program, const LeafScript& script) {
    answers_.resize(static_cast<std::size_t>(program.nodeCount()));
    for (int node = 0; node < program.nodeCount(); ++node) {
      const LeafScript::Entry* named = script.find(program.label(node));
      answers_[static_cast<std::size_t>(node)].entry =
          named ? named : script.find(program.manifest(node).id);
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

bool isScripted(const bt::Program& program, int node) {
  return program.node(node).code == bt::NodeCode::Stateful;
}

/// Names of the script that no leaf has: most likely a slip.
base::Diagnostics unusedNames(const bt::Program& program, const LeafScript& script) {
  std::vector<std::string> names;
  for (int node = 0; node < program.nodeCount(); ++node) {
    if (isScripted(program, node)) {
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

}  // namespace

struct TreePlay::Inside {
  Inside(const PlaySetup& setup, bt::TreeTable files, LeafScript answers,
         std::shared_ptr<const bt::Program> program)
      : table(std::move(files)),
        script(std::move(answers)),
        view(setup.dt, setup.seed, setup.compatibility),
        controls(1),
        intents(controls),
        player(society, view, intents),
        state(std::move(program)) {
    society.minds.resize(1);
    society.groups.assign(1, -1);
    player.prepare(state.program(), script);
    state.set(state.program().hostSlot(0), view.constants(0).id);
    state.set(state.program().hostSlot(1), setup.dt);
  }

  bt::TreeTable table;
  LeafScript script;
  PlayView view;
  bt::Society society;
  std::vector<sim2d::HumanControl> controls;
  sim2d::Intents intents;
  TreePlayer player;
  bt::TreeState state;
};

TreePlay::TreePlay(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
TreePlay::~TreePlay() = default;

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
  const bt::NodeLibrary library = bt::humanNodes().withLeaves({answer, answer, noteHalt});
  const base::Result<std::shared_ptr<const bt::Program>> program = bt::compile(*table, library);
  base::append(problems, program.diagnostics());
  if (!program || !script) {
    return problems;
  }
  base::append(problems, unusedNames(**program, *script));
  auto inside = std::make_unique<Inside>(setup, *std::move(table), *std::move(script), *program);
  return {std::unique_ptr<TreePlay>(new TreePlay(std::move(inside))), std::move(problems)};
}

NodeStatus TreePlay::tick() {
  inside_->view.beginStep();
  inside_->player.beginStep();
  // As its base: that is what the nodes take the host for.
  bt::HumanContext* const host = &inside_->player;
  return inside_->state.tickOnce({inside_->view.step(), inside_->view.dt(), host});
}

const std::vector<LeafCall>& TreePlay::calls() const {
  return inside_->player.calls();
}

const bt::Program& TreePlay::program() const {
  return inside_->state.program();
}

base::Diagnostics TreePlay::fault() const {
  const bt::TreeFault* const fault = inside_->state.fault();
  if (fault == nullptr) {
    return {};
  }
  const bt::TreeTable::Entry* tree = inside_->table.find(program().treeOf(fault->node));
  return {base::within(
      fault->path, base::error("run.tree-stops", {fault->message},
                               tree ? tree->file : std::string(), program().lineOf(fault->node)))};
}

}  // namespace app
