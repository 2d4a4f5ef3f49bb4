#pragma once

#include "editor/canvas/Tool.h"

namespace editor {

/// Press places a person, drag turns it.
class PersonTool : public Tool {
  Q_OBJECT
 public:
  PersonTool(ScenarioDocument& document, MapScene& scene, QObject* parent);

  QString name() const override { return tr("Person"); }
  QString iconName() const override { return QStringLiteral("tool-person"); }
  QKeySequence shortcut() const override { return QKeySequence(Qt::Key_P); }
  QString statusText() const override;
  void press(const CanvasMouse& mouse) override;
  void move(const CanvasMouse& mouse) override;
  void release(const CanvasMouse& mouse) override;
  void cancel() override;

  /// What new people are like (behaviour, kind, speed …); place, name and id are given by the tool.
  void setPrototype(const sim2d::Human& human) { prototype_ = human; }
  const sim2d::Human& prototype() const { return prototype_; }

 private:
  void preview();
  sim2d::Human prototype_;
  std::optional<sim2d::Human> placing_;
  Vec2 from_ = Vec2::Zero();
};

/// A person with the values of a new one, all written out so that other programs read them too.
sim2d::Human newPerson();

}  // namespace editor
