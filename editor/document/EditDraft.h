#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityLists.h"
#include "editor/document/PersonTree.h"

namespace editor {

/// Values by entity while a command is being put together: the document's, unless edited before.
class Draft {
 public:
  explicit Draft(const ScenarioDocument& document) : document_(document) {}

  void set(Entity value, int index = -1) {
    const EntityId id = idOf(value);
    slotOf(id) = {std::move(value), index};
  }
  void remove(EntityId id) { slotOf(id) = {}; }

  /// Calls `change` for every entity of type T in the document that is not removed by the draft.
  template <class T, class Change>
  void forEach(Change&& change) {
    for (const T& original : listOf<T>(document_.scenario())) {
      const auto found = find(original.key);
      if (found != edits_.end() && !found->slot.value) {
        continue;
      }
      T value = found == edits_.end() ? original : std::get<T>(*found->slot.value);
      change(value);
      if (!(value == original)) {
        set(std::move(value));
      }
    }
  }

  void push(ScenarioDocument& document, const QString& text, Merge merge = Merge::Never) {
    const auto isIdle = [&](const EntityEdit& edit) {
      return edit.slot.value == document.entity(edit.entity) &&
             (edit.slot.index < 0 || edit.slot.index == document.indexOf(edit.entity));
    };
    edits_.erase(std::remove_if(edits_.begin(), edits_.end(), isIdle), edits_.end());
    if (edits_.empty()) {
      return;
    }
    std::vector<TreeEdit> trees = followingTrees(document);
    if (trees.empty()) {
      document.undoStack().push(new EditEntity(document, std::move(edits_), text, merge));
      return;
    }
    document.undoStack().beginMacro(text);
    document.undoStack().push(new EditEntity(document, std::move(edits_), text, merge));
    document.undoStack().push(new EditTree(document, std::move(trees), text));
    document.undoStack().endMacro();
  }

 private:
  /// Trees with blocks keep up with the behaviour and the goals of their people.
  std::vector<TreeEdit> followingTrees(const ScenarioDocument& document) const {
    std::vector<TreeEdit> trees;
    for (const EntityEdit& edit : edits_) {
      const auto* human = edit.slot.value ? std::get_if<sim2d::Human>(&*edit.slot.value) : nullptr;
      if (human == nullptr) {
        continue;
      }
      if (std::optional<std::string> xml = followedTree(document, *human)) {
        trees.push_back({edit.entity, std::move(xml)});
      }
    }
    return trees;
  }

  std::vector<EntityEdit>::iterator find(EntityId id) {
    const auto found = places_.find(id);
    return found == places_.end() ? edits_.end()
                                  : edits_.begin() + static_cast<std::ptrdiff_t>(found->second);
  }
  EntitySlot& slotOf(EntityId id) {
    const auto [place, isNew] = places_.emplace(id, edits_.size());
    if (isNew) {
      edits_.push_back({id, {}});
    }
    return edits_[place->second].slot;
  }

  const ScenarioDocument& document_;
  std::vector<EntityEdit> edits_;
  std::map<EntityId, std::size_t> places_;  // in edits_
};

}  // namespace editor
