#include "editor/document/EditCommands.h"
#include "editor/document/FreeNames.h"
#include "editor/look/Fields.h"
#include "editor/tools/Crowd.h"
#include "editor/tools/CrowdOptions.h"
#include "editor/tools/Drawing.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

constexpr int kKindCount = 4;
constexpr int kPatternId = 0;        // those who walk themselves count from 1
constexpr double kSourceRate = 0.5;  // people per second of a new source

/// Areas: sources, sinks, waiting areas and exits. A drag makes a rectangle, clicks any polygon;
/// 1 to 4 choose the kind. A source needs somebody whom its people are like: the selected person,
/// else the first one; without people it brings a pattern of its own that takes no part itself.
class AreaTool : public ShapeDrawing {
 public:
  using ShapeDrawing::ShapeDrawing;

  bool keyPress(const QKeyEvent& event) override {
    const int index = event.key() - Qt::Key_1;
    if (index >= 0 && index < kKindCount && event.modifiers() == Qt::NoModifier) {
      setKind(static_cast<sim2d::AreaKind>(index));
      return true;
    }
    return ShapeDrawing::keyPress(event);
  }

  QWidget* makeOptions(QWidget* parent) override {
    auto* row = new OptionsRow(parent);
    ChoiceField* box = addChoice(
        *row, tr("Kind"),
        {tr("Source: people come in"), tr("Sink: people leave"), tr("Waiting area"), tr("Exit")},
        static_cast<int>(kind_), [this](int at) { setKind(static_cast<sim2d::AreaKind>(at)); });
    connect(this, &Tool::statusTextChanged, box,
            [this, box] { box->setCurrentIndex(static_cast<int>(kind_)); });
    return row;
  }

 protected:
  QString idleText() const override {
    switch (kind_) {
      case sim2d::AreaKind::Source:
        return tr("Drag where people come in, or click the corners · 1 to 4 choose the kind");
      case sim2d::AreaKind::Sink:
        return tr("Drag where people leave after their last goal, or click the corners");
      case sim2d::AreaKind::Wait:
        return tr("Drag where people wait, or click the corners · trees name it as their area");
      case sim2d::AreaKind::Exit:
        break;
    }
    return tr("Drag an exit that people flee to, or click the corners");
  }

  Entity shapeOf(const Corners& corners) const override {
    sim2d::Area area;
    area.key = ghostOf(EntityKind::Area);
    area.kind = kind_;
    area.points = sim2d::polygonOutline(corners).points;
    return area;
  }

  void make(const Corners& corners) override {
    if (kind_ == sim2d::AreaKind::Source) {
      makeSource(std::get<sim2d::Area>(shapeOf(corners)));
    } else {
      ShapeDrawing::make(corners);
    }
  }

 private:
  void setKind(sim2d::AreaKind kind) {
    if (kind != kind_) {
      kind_ = kind;
      Q_EMIT statusTextChanged();
    }
  }

  const sim2d::Human* pattern() const {
    for (const EntityId id : document().selection()) {
      if (const sim2d::Human* human = document().human(id)) {
        return human;
      }
    }
    const std::vector<sim2d::Human>& humans = document().scenario().humans;
    return humans.empty() ? nullptr : &humans.front();
  }

  void makeSource(sim2d::Area area) {
    area.rate = kSourceRate;
    if (const sim2d::Human* human = pattern()) {
      area.like = human->name;
      addDrawn(document(), std::move(area));
      return;
    }
    sim2d::Human visitor = newPerson();
    visitor.name = FreeNames(document().scenario()).name("visitor");
    visitor.id = kPatternId;
    visitor.listed = false;
    visitor.cyclicGoals = false;
    visitor.initPose.position = *positionOf(area);
    if (!document().scenario().goals.empty()) {
      visitor.goals = {document().scenario().goals.front().id};
    }
    area.like = visitor.name;
    area.name = FreeNames(document().scenario()).name("source");
    const std::vector<EntityId> ids =
        pushAdd(document(), std::vector<Entity>{visitor, area}, tr("Add source"));
    document().setSelection({ids.back()});
  }

  sim2d::AreaKind kind_ = sim2d::AreaKind::Source;
};

}  // namespace

void addAreaTool(ToolRegistry& to) {
  to.add<AreaTool>({120, QObject::tr("Area"), QStringLiteral("tool-area"), Qt::Key_A});
}

}  // namespace editor
