#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

bool isWalker(EntityId id) {
  return id.kind == EntityKind::Human || id.kind == EntityKind::Robot;
}

/// Click goals in the order in which the selected people visit them. Enter, a double click or
/// another tool applies the route; Escape discards it, Backspace removes the last goal.
class RouteTool : public Tool {
  Q_DECLARE_TR_FUNCTIONS(editor::RouteTool)
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (!refusal_.isEmpty() && document().selection() == refusedFor_) {
      return refusal_;
    }
    if (walkers().empty()) {
      return tr("Click the person or robot that follows the route (Shift adds more)");
    }
    if (goals_.empty()) {
      return tr("Click the goals in visiting order");
    }
    QStringList numbers;
    for (const int goal : goals_) {
      numbers << QString::number(goal);
    }
    return tr("Route %1 · Enter applies · Backspace removes the last goal · Esc cancels")
        .arg(numbers.join(QStringLiteral(" → ")));
  }

  void activate() override { cancel(); }
  void deactivate() override { commit(); }
  void pressOther(Qt::MouseButton button) override {
    if (button == Qt::RightButton) {
      commit();
    }
  }
  void press(const CanvasMouse& mouse) override {
    const EntityId hit = scene().entityAt(mouse.world);
    refusal_.clear();
    if (isWalker(hit)) {
      if (mouse.modifiers.testFlag(Qt::ShiftModifier)) {
        document().toggleSelected(hit);
      } else {
        commit();
        document().setSelection({hit});
      }
    } else {
      addGoal(document().goal(hit));
    }
    preview();
  }

  void move(const CanvasMouse& mouse) override {
    scene().setHovered(scene().entityAt(mouse.world));
    const sim2d::GlobalGoal* last =
        goals_.empty() ? nullptr : document().scenario().goal(goals_.back());
    if (last != nullptr) {
      marks().line = {last->position, mouse.world};
    }
  }

  void release(const CanvasMouse&) override {}
  void doubleClick(const CanvasMouse&) override { commit(); }
  void cancel() override {
    goals_.clear();
    refusal_.clear();
    scene().setHovered({});
    clearMarks();
  }

  bool keyPress(const QKeyEvent& event) override {
    refusal_.clear();
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
      commit();
    } else if (event.key() == Qt::Key_Backspace) {
      if (!goals_.empty()) {
        goals_.pop_back();
      }
      preview();
    } else {
      return false;
    }
    return true;
  }

 private:
  /// The selected people and robots.
  std::vector<EntityId> walkers() const {
    std::vector<EntityId> ids = document().selection();
    ids.erase(std::remove_if(ids.begin(), ids.end(), [](EntityId id) { return !isWalker(id); }),
              ids.end());
    return ids;
  }

  /// Null: no goal at the mouse position.
  void addGoal(const sim2d::GlobalGoal* goal) {
    refusedFor_ = document().selection();
    if (walkers().empty()) {
      refusal_ = tr("Nothing is selected: click a person or robot first");
    } else if (goal == nullptr) {
      refusal_ = tr("No goal here: click the pin of a goal, or press G to add goals");
    } else if (!goals_.empty() && goals_.back() == goal->id) {
      refusal_ = tr("%1 is already the last goal of the route").arg(goalName(goal->id));
    } else {
      goals_.push_back(goal->id);
    }
  }

  void preview() {
    scene().setPreview(goals_.empty() ? std::vector<Entity>()
                                      : withRoute(document(), walkers(), goals_));
    marks() = {};
    Q_EMIT statusTextChanged();
  }

  void commit() {
    const std::vector<int> goals = goals_;
    cancel();
    if (!goals.empty()) {
      pushRoute(document(), walkers(), goals);
    }
  }

  std::vector<int> goals_;
  QString refusal_;                   // Reason why the last click had no effect.
  std::vector<EntityId> refusedFor_;  // The selection at that time.
};

}  // namespace

void addRouteTool(ToolRegistry& to) {
  to.add<RouteTool>({60, QObject::tr("Route"), QStringLiteral("tool-route"), Qt::Key_R});
}

}  // namespace editor
