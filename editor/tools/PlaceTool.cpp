#include "editor/document/EditCommands.h"
#include "editor/tools/CrowdGenerator.h"
#include "editor/tools/DrawingTools.h"
#include "editor/tools/ToolRegistry.h"

// Tools for people, robots and docks.
namespace editor {

namespace {

/// A press places an entity; a drag sets its heading in whole degrees (Ctrl: 22.5 degrees, Alt:
/// free). A click reuses the last heading.
class PlacingTool : public Tool {
 public:
  using Tool::Tool;

  void press(const CanvasMouse& mouse) override {
    from_ = snapToGrid(mouse);
    placing_ = somebodyAt(from_, mouse);
    scene().setPreview({*placing_});
    Q_EMIT statusTextChanged();
  }

  void move(const CanvasMouse& mouse) override {
    if (placing_ && isDrag(from_, mouse)) {
      placing_ = withHeading(*placing_, headingTo(mouse));
      scene().setPreview({*placing_});
      marks().arrow = {from_, mouse.world};
      marks().tag = {mouse.world, headingText(*headingOf(*placing_))};
    }
  }

  void release(const CanvasMouse& mouse) override {
    if (placing_) {
      const Entity value =
          isDrag(from_, mouse) ? withHeading(*placing_, headingTo(mouse)) : *placing_;
      cancel();
      lastHeading_ = *headingOf(value);
      place(value);
    }
  }

  void cancel() override {
    placing_.reset();
    clearMarks();
  }

 protected:
  virtual Entity somebodyAt(const Vec2& place, const CanvasMouse& mouse) const = 0;
  virtual void place(const Entity& value) = 0;  // One command.

  bool isPlacing() const { return placing_.has_value(); }
  double lastHeading() const { return lastHeading_; }

 private:
  double headingTo(const CanvasMouse& mouse) const {
    const double heading = base::headingOf(mouse.world - from_);
    if (mouse.modifiers.testFlag(Qt::AltModifier)) {
      return heading;
    }
    return snappedAngle(heading, mouse.modifiers.testFlag(Qt::ControlModifier) ? base::kPi / 8.0
                                                                               : base::kPi / 180.0);
  }

  std::optional<Entity> placing_;
  Vec2 from_ = Vec2::Zero();
  double lastHeading_ = 0.0;
};

class PersonTool : public PlacingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::PersonTool)
 public:
  using PlacingTool::PlacingTool;

  QString statusText() const override {
    return isPlacing() ? tr("Drag to set the heading · Esc cancels")
                       : tr("Click to place a person; drag to set the heading");
  }

 protected:
  Entity somebodyAt(const Vec2& place, const CanvasMouse&) const override {
    sim2d::Human human = newPerson();
    human.key = previewIdOf(EntityKind::Human);
    human.initPose = {place, lastHeading()};
    human.hasInitPose = true;
    return human;
  }

  void place(const Entity& value) override {
    sim2d::Human human = std::get<sim2d::Human>(value);
    human.id = -1;
    document().setSelection({pushAdd(document(), std::move(human))});
  }
};

/// Press and drag set the start pose of the robot; the next click sets its goal (a point, or a goal
/// of the map). Changes the selected robot, else the first one; Shift adds another.
class RobotTool : public PlacingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::RobotTool)
 public:
  using PlacingTool::PlacingTool;

  QString statusText() const override {
    if (document().contains(waitsForGoal_) && waitsForGoal_) {
      return tr("Click the goal of the robot · Esc keeps the current goal");
    }
    return isPlacing() ? tr("Drag to set the heading · Esc cancels")
                       : tr("Click to place the robot; drag to set the heading · Shift adds "
                            "another");
  }

  void activate() override { waitsForGoal_ = {}; }
  void press(const CanvasMouse& mouse) override {
    if (waitsForGoal_ && document().contains(waitsForGoal_)) {
      setGoal(mouse);
    } else {
      PlacingTool::press(mouse);
    }
  }

  void move(const CanvasMouse& mouse) override {
    if (!waitsForGoal_) {
      PlacingTool::move(mouse);
    } else if (const std::optional<Entity> robot = document().entity(waitsForGoal_)) {
      marks().line = {*positionOf(*robot), mouse.world};
    }
  }

  void cancel() override {
    waitsForGoal_ = {};
    PlacingTool::cancel();
  }

 protected:
  Entity somebodyAt(const Vec2& place, const CanvasMouse& mouse) const override {
    const std::vector<sim2d::Robot>& robots = document().scenario().robots;
    sim2d::Robot robot;
    robot.key = previewIdOf(EntityKind::Robot);
    robot.start.heading = lastHeading();
    if (!mouse.modifiers.testFlag(Qt::ShiftModifier) && !robots.empty()) {
      const auto isSelected = [this](const auto& each) { return document().isSelected(each.key); };
      const auto selected = std::find_if(robots.begin(), robots.end(), isSelected);
      robot = selected == robots.end() ? robots.front() : *selected;
    }
    robot.start.position = place;
    return robot;
  }

  void place(const Entity& value) override {
    if (idOf(value) == previewIdOf(EntityKind::Robot)) {
      waitsForGoal_ = pushAdd(document(), value);
    } else {
      pushEdit(document(), {value}, tr("Place %1").arg(displayName(value)));
      waitsForGoal_ = idOf(value);
    }
    document().setSelection({waitsForGoal_});
    Q_EMIT statusTextChanged();
  }

 private:
  void setGoal(const CanvasMouse& mouse) {
    const EntityId robot = waitsForGoal_;
    const sim2d::GlobalGoal* goal = document().goal(scene().entityAt(mouse.world));
    cancel();
    if (goal != nullptr) {
      pushRoute(document(), {robot}, {goal->id});
    } else {
      pushChange<sim2d::Robot>(document(), robot, tr("Set robot goal"), [&](sim2d::Robot& value) {
        value.goal.goals.clear();
        value.goal.point = snapToGrid(mouse);
      });
    }
  }

  EntityId waitsForGoal_;  // The robot whose start was just set.
};

class DockTool : public PlacingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::DockTool)
 public:
  using PlacingTool::PlacingTool;

  QString statusText() const override {
    return isPlacing() ? tr("Drag to set the heading of a docked robot · Esc cancels")
                       : tr("Click the position of a docked robot; drag to set its heading");
  }

 protected:
  Entity somebodyAt(const Vec2& place, const CanvasMouse&) const override {
    sim2d::Dock dock;
    dock.key = previewIdOf(EntityKind::Dock);
    dock.pose = {place, lastHeading()};
    return dock;
  }

  void place(const Entity& value) override {
    document().setSelection({pushAdd(document(), value)});
  }
};

}  // namespace

void addPlaceTool(ToolRegistry& to) {
  to.add<PersonTool>({20, QObject::tr("Person"), QStringLiteral("tool-person"), Qt::Key_P});
  const QString robot = QStringLiteral("robot");
  to.add<RobotTool>({130, QObject::tr("Robot"), QStringLiteral("tool-robot"), Qt::Key_B, robot});
  to.add<DockTool>({135, QObject::tr("Dock"), QStringLiteral("tool-dock"), Qt::Key_U, robot});
}

}  // namespace editor
