#pragma once

#include <QtWidgets>

#include "app/run/Export.h"
#include "editor/look/Theme.h"

namespace app {

/// Exports the scenario to another simulator: target, folder, the files to be written with their
/// state, and the information that the target does not support.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(Bundle source, const QString& folder, const editor::Theme& theme,
               QWidget* parent = nullptr);
  const ExportPlan& plan() const { return plan_; }
  QString folder() const { return folder_->text(); }

 private:
  void build();
  QLayout* makeForm();
  QWidget* makeStart();
  void fillTargets();
  void replan();
  void showFiles();
  void showReport();

  Bundle source_;
  ExportPlan plan_;
  editor::Theme theme_;
  QListWidget* targets_;
  QLineEdit* folder_;
  QComboBox* dialect_;
  QComboBox* style_;
  QLabel* summary_;
  QTreeWidget* files_;
  QLabel* reportTitle_;
  QListWidget* report_;
  QWidget* start_ = nullptr;  // the command that starts it in the simulator
  QPlainTextEdit* command_;
  QPushButton* copy_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace app
