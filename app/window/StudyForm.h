#pragma once

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>

#include "app/run/Experiment.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// An experiment as fields: which scenarios, planners, values and seeds. GUI thread.
class StudyForm : public QWidget {
  Q_OBJECT
 public:
  explicit StudyForm(editor::PanelContext& context);

  /// The experiment as a file says it; scenarios below `folder` by their way from there.
  QString textFor(const QString& folder) const;
  void show(const Experiment& experiment);
  void addScenario(const QString& path);  // once
  QStringList scenarios() const;          // absolute files, or names of shipped ones
  void setEditable(bool editable);

 Q_SIGNALS:
  void changed();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makeScenarios();
  QWidget* makePlanners();
  QLayout* makeNumbers();
  void styleValues();
  void addItem(const QString& shown, const QString& path);
  void fitScenarios();
  void askScenarios();
  QString plannerPath() const;
  void addPlanner(const QString& name, const QString& help);
  QStringList chosenPlanners() const;
  void showPlanners(const QStringList& chosen);

  editor::PanelContext& context_;
  QListWidget* scenarios_;
  QLabel* none_;
  QListWidget* planners_;
  QLineEdit* seeds_;
  QLineEdit* duration_;
  QComboBox* record_;
  QPlainTextEdit* values_;
  QAbstractButton* addThis_ = nullptr;
  QString robotPath_;    // of the planner in a file that was opened
  QStringList planned_;  // in its order
  QStringList others_;   // lines of the file that have no field
  bool showing_ = false;
};

}  // namespace app
