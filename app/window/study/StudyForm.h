#pragma once

#include <QtWidgets>

#include "app/run/Experiment.h"
#include "editor/panels/PanelRegistry.h"

namespace app {

/// A form for an experiment: scenarios, planners, values and seeds. GUI thread.
class StudyForm : public QWidget {
  Q_OBJECT
 public:
  explicit StudyForm(editor::PanelContext& context);

  /// The experiment as YAML; scenarios below `folder` have relative paths.
  QString yamlFor(const QString& folder) const;
  void show(const Experiment& experiment);
  void addScenario(const QString& path);  // ignored if present
  QStringList scenarios() const;          // absolute paths, or names of shipped scenarios
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
  void addItem(const QString& path);
  void fitScenarios();
  void askScenarios();
  QString plannerPath() const;
  void addPlanner(const QString& name, const QString& help);
  QStringList chosenPlanners() const;
  void showPlanners(const QStringList& chosen);

  editor::PanelContext& context_;
  QListWidget* scenarios_;
  QLabel* emptyLabel_;
  QListWidget* planners_;
  QLineEdit* seeds_;
  QLineEdit* duration_;
  QComboBox* record_;
  QPlainTextEdit* values_;
  QAbstractButton* addThis_ = nullptr;
  QString plannerPath_;       // planner path in the opened file
  QStringList plannerOrder_;  // planners in file order
  QStringList others_;        // lines of the file without a field
  bool isLoading_ = false;
};

}  // namespace app
