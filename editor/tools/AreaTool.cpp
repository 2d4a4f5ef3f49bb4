#include "editor/document/EditCommands.h"
#include "editor/look/Fields.h"
#include "editor/tools/CrowdGenerator.h"
#include "editor/tools/DrawingTools.h"
#include "editor/tools/ToolOptionFields.h"
#include "editor/tools/ToolRegistry.h"
#include "sim2d/map/Outlines.h"

namespace editor {

namespace {

constexpr int kKindCount = 5;
constexpr int kTemplateId = 0;       // The ids of walking people start at 1.
constexpr double kSourceRate = 0.5;  // Rate of a new source [people/s].

/// Draws areas: sources, sinks, waiting areas, exits and speed zones. A drag makes a rectangle,
/// clicks make a polygon; 1 to 5 select the kind. A source needs a template person: the selected
/// person, else the first one; without people the tool adds a template that is switched off.
class AreaTool : public ShapeDrawingTool {
  Q_DECLARE_TR_FUNCTIONS(editor::AreaTool)
 public:
  using ShapeDrawingTool::ShapeDrawingTool;

  bool keyPress(const QKeyEvent& event) override {
    const int index = event.key() - Qt::Key_1;
    if (index >= 0 && index < kKindCount && event.modifiers() == Qt::NoModifier) {
      setKind(static_cast<sim2d::AreaKind>(index));
      return true;
    }
    return ShapeDrawingTool::keyPress(event);
  }

  QWidget* makeOptions(QWidget* parent) override {
    auto* row = new OptionsRow(parent);
    ChoiceField* box = addChoice(*row, tr("Kind"),
                                 {tr("Source: people appear"), tr("Sink: people leave"),
                                  tr("Waiting area"), tr("Exit"), tr("Speed: stairs, travelators")},
                                 static_cast<int>(kind_),
                                 [this](int at) { setKind(static_cast<sim2d::AreaKind>(at)); });
    connect(this, &Tool::statusTextChanged, box,
            [this, box] { box->setCurrentIndex(static_cast<int>(kind_)); });
    return row;
  }

 protected:
  QString idleText() const override {
    static const char* const kTexts[kKindCount] = {
        // By kind.
        QT_TR_NOOP("Drag an area where people appear, or click its corners · 1 to 5 choose the "
                   "kind"),
        QT_TR_NOOP("Drag an area where people leave after their last goal, or click its corners"),
        QT_TR_NOOP("Drag a waiting area, or click its corners · trees refer to it by name"),
        QT_TR_NOOP("Drag an exit that people flee to, or click its corners"),
        QT_TR_NOOP("Drag stairs, a ramp or a travelator, or click its corners · the properties "
                   "set factor and carrying speed")};
    return tr(kTexts[static_cast<int>(kind_)]);
  }

  Entity shapeOf(const Corners& corners) const override {
    sim2d::Area area;
    area.key = previewIdOf(EntityKind::Area);
    area.kind = kind_;
    area.points = sim2d::polygonOutline(corners).points;
    return area;
  }

  void make(const Corners& corners) override {
    if (kind_ == sim2d::AreaKind::Source) {
      makeSource(std::get<sim2d::Area>(shapeOf(corners)));
    } else {
      ShapeDrawingTool::make(corners);
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
      addDrawnEntity(document(), std::move(area));
      return;
    }
    sim2d::Human visitor = newPerson();
    visitor.name = UniqueNames(document().scenario()).name("visitor");
    visitor.id = kTemplateId;
    visitor.listed = false;
    visitor.cyclicGoals = false;
    visitor.initPose.position = *positionOf(area);
    if (!document().scenario().goals.empty()) {
      visitor.goals = {document().scenario().goals.front().id};
    }
    area.like = visitor.name;
    area.name = UniqueNames(document().scenario()).name("source");
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
