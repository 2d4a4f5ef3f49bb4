#pragma once

#include <optional>

#include <QtWidgets>

#include "editor/look/Fields.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/nav2/Nav2Form.h"

namespace editor {

/// The dock with the Nav2 parameters of a robot: the selected one if Nav2 drives it, otherwise the
/// one chosen last. Each edit is one command of the document.
class Nav2Panel : public QWidget {
  Q_OBJECT
 public:
  explicit Nav2Panel(PanelContext& context);

  Nav2Form& form() const { return *form_; }
  QComboBox& robots() const { return *robots_; }
  QToolButton& saveButton() const { return *save_; }
  /// Writes the parameters with their changed values to a new file, which the robot then reads;
  /// comments and order of its file are kept. Values that the file cannot contain remain in the
  /// scenario. False: not written, the problems are in the problem list.
  bool saveAs(const QString& path);
  void useFile(const QString& path);  // As the parameter file of the robot.

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void makeHead();
  void followSelection();
  void refresh();
  void fillRobots();
  void askFile();
  void askOtherFile();
  QString entryOf(const QString& path) const;
  void apply(const QString& text, const std::function<void(sim2d::Robot&)>& change);
  const sim2d::Robot* robot() const;

  PanelContext& context_;
  QStackedLayout* stack_ = new QStackedLayout(this);
  Nav2Form* form_ = new Nav2Form(this);
  QComboBox* robots_ = new ChoiceField(this);
  ElidedLabel* file_ = new ElidedLabel(this);
  QToolButton *other_ = nullptr, *resetAll_ = nullptr, *save_ = nullptr;
  std::optional<EntityId> robot_;
};

}  // namespace editor
