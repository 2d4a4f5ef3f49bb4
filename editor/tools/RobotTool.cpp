#include "editor/canvas/Layers.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/Tool.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/ToolRegistry.h"

namespace editor {

namespace {

constexpr EntityId kGhost{EntityKind::Robot, -1};

double headingTo(const Vec2& from, const CanvasMouse& mouse) {
  return snappedAngle(base::headingOf(mouse.world - from), base::kPi / 180.0);
}

/// Press and drag sets where the robot starts and looks; the next click is its goal (a point, or a
/// goal of the map). Changes the selected robot, else the first one; Shift makes another.
class RobotTool : public Tool {
 public:
  using Tool::Tool;

  QString statusText() const override {
    if (document().contains(waitsForGoal_) && waitsForGoal_) {
      return tr("Click the robot's goal · Esc: no change of the goal");
    }
    return tr("Press where the robot starts, drag to turn it · Shift makes another robot");
  }

  void activate() override { waitsForGoal_ = {}; }
  void press(const CanvasMouse& mouse) override {
    if (mouse.button != Qt::LeftButton) {
      return;
    }
    if (waitsForGoal_ && document().contains(waitsForGoal_)) {
      setGoal(mouse);
      return;
    }
    from_ = snapToGrid(mouse);
    placing_ = robotFor(mouse);
    placing_->start.position = from_;
    scene().setPreview({*placing_});
  }

  void move(const CanvasMouse& mouse) override {
    if (waitsForGoal_) {
      const std::optional<Entity> robot = document().entity(waitsForGoal_);
      if (robot) {
        scene().toolLayer().setLine({*positionOf(*robot), mouse.world});
      }
    } else if (placing_ && isDrag(from_, mouse)) {
      placing_->start.heading = headingTo(from_, mouse);
      scene().setPreview({*placing_});
      scene().toolLayer().setArrow(from_, mouse.world);
      scene().toolLayer().setTag(mouse.world, headingText(placing_->start.heading));
    }
  }

  void release(const CanvasMouse& mouse) override {
    if (mouse.button != Qt::LeftButton || !placing_) {
      return;
    }
    if (isDrag(from_, mouse)) {
      placing_->start.heading = headingTo(from_, mouse);
    }
    const sim2d::Robot robot = *placing_;
    endGesture();
    if (robot.key == kGhost) {
      waitsForGoal_ = pushAdd(document(), robot);
    } else {
      pushEdit(document(), {robot}, tr("Place %1").arg(QString::fromStdString(robot.name)));
      waitsForGoal_ = robot.key;
    }
    document().setSelection({waitsForGoal_});
    Q_EMIT statusTextChanged();
  }

  void cancel() override {
    waitsForGoal_ = {};
    endGesture();
  }

 private:
  sim2d::Robot robotFor(const CanvasMouse& mouse) const {
    const std::vector<sim2d::Robot>& robots = document().scenario().robots;
    const bool another = mouse.modifiers.testFlag(Qt::ShiftModifier);
    for (const sim2d::Robot& robot : robots) {
      if (!another && document().isSelected(robot.key)) {
        return robot;
      }
    }
    if (!another && !robots.empty()) {
      return robots.front();
    }
    sim2d::Robot robot;
    robot.key = kGhost;
    return robot;
  }

  void setGoal(const CanvasMouse& mouse) {
    const EntityId robot = waitsForGoal_;
    const sim2d::GlobalGoal* goal = document().goal(scene().entityAt(mouse.world));
    waitsForGoal_ = {};
    endGesture();
    if (goal != nullptr) {
      pushRoute(document(), {robot}, {goal->id});
    } else {
      pushChange<sim2d::Robot>(document(), robot, tr("Goal of the robot"),
                               [&](sim2d::Robot& value) {
                                 value.goal.goals.clear();
                                 value.goal.point = snapToGrid(mouse);
                               });
    }
  }

  void endGesture() {
    placing_.reset();
    clearMarks();
  }

  std::optional<sim2d::Robot> placing_;
  EntityId waitsForGoal_;  // the robot whose start was just set
  Vec2 from_ = Vec2::Zero();
};

}  // namespace

void addRobotTool(ToolRegistry& to) {
  to.add<RobotTool>({130, QObject::tr("Robot"), QStringLiteral("tool-robot"), Qt::Key_B});
}

}  // namespace editor
