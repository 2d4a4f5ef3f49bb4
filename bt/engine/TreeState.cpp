#include "bt/engine/TreeState.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "bt/engine/Ticker.h"

namespace bt {
namespace {

/// Room for three events of every stateful leaf; a tick seldom has more.
std::size_t roomForEvents(const Program& program) {
  const auto count =
      std::count_if(program.nodes().begin(), program.nodes().end(), [](const Program::Node& node) {
        return node.code == NodeCode::Stateful || node.code == NodeCode::Sleep;
      });
  return 3 * static_cast<std::size_t>(count);
}

std::size_t stackSize(const Program& program) {
  int depth = 0;
  for (const Script& script : program.scripts()) {
    depth = std::max(depth, script.depth);
  }
  return static_cast<std::size_t>(depth);
}

}  // namespace

TreeState::TreeState(std::shared_ptr<const Program> program) : program_(std::move(program)) {
  assert(program_);
  const auto nodes = static_cast<std::size_t>(program_->nodeCount());
  stored_.resize(nodes);
  returned_[0].resize(nodes);
  returned_[1].resize(nodes);
  memory_.resize(static_cast<std::size_t>(program_->memoryBytes()) / sizeof(std::uint64_t));
  slots_ = program_->initialSlots();
  changes_.reserve(nodes);
  events_.reserve(roomForEvents(*program_));
  stack_.resize(stackSize(*program_));
}

void TreeState::reset() {
  std::fill(stored_.begin(), stored_.end(), base::NodeStatus::Idle);
  clearReturned();
  std::fill(memory_.begin(), memory_.end(), 0U);
  slots_ = program_->initialSlots();
  changes_.clear();
  changesKnown_ = true;
  events_.clear();
  fault_.reset();
}

base::NodeStatus TreeState::tickOnce(const TickInput& input) {
  using base::NodeStatus;
  now_ = !now_;
  clearReturned();
  changesKnown_ = false;
  events_.clear();
  NodeStatus status = NodeStatus::Idle;
  if (!fault_) {
    Ticker ticker(*program_, *this, input);
    status = ticker.tickNode(0);
    if (fault_) {
      for (int node = 0; node < program_->nodeCount(); ++node) {
        ticker.resetChild(node);  // a parent may not have been marked RUNNING yet
      }
      clearReturned();
      status = NodeStatus::Idle;
    } else if (status == NodeStatus::Success || status == NodeStatus::Failure) {
      stored_[0] = NodeStatus::Idle;
    }
  }
  return status;
}

void TreeState::clearReturned() {
  std::vector<base::NodeStatus>& returned = returned_[now_ ? 1 : 0];
  std::fill(returned.begin(), returned.end(), base::NodeStatus::Idle);
}

const std::vector<int>& TreeState::changes() {
  if (!changesKnown_) {
    changesKnown_ = true;
    changes_.clear();
    const std::vector<base::NodeStatus>& before = returned_[now_ ? 0 : 1];
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (statuses()[i] != before[i]) {
        changes_.push_back(static_cast<int>(i));
      }
    }
  }
  return changes_;
}

void TreeState::halt(const TickInput& input) {
  Ticker(*program_, *this, input).resetChild(0);
}

std::vector<TreeState::EntryText> TreeState::entries() const {
  std::vector<EntryText> all;
  for (const Program::Entry& entry : program_->entries()) {
    const Value& value = get(entry.slot);
    if (value.type != ValueType::Unset) {
      all.push_back({entry.key, value.toText()});
    }
  }
  return all;
}

}  // namespace bt
