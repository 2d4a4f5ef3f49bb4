#pragma once

#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>

#include "app/window/StudyRows.h"

namespace app {

/// The results of a study as they come: options side by side with intervals, and every run. GUI
/// thread.
class StudyResults : public QWidget {
  Q_OBJECT
 public:
  explicit StudyResults(QWidget* parent);

  /// Empties both. `paths`: of values, each a column of the runs; `compared`: the one whose options
  /// stand side by side, empty = scenarios.
  void begin(const QStringList& paths, const QString& compared);
  void add(const std::vector<StudyRow>& rows);
  void compare();  // at once what else is done now and then
  const StudyRunsModel& runs() const { return runs_; }
  QTableWidget& comparison() const { return *comparison_; }

 Q_SIGNALS:
  void playWanted(int run);

 private:
  void makeComparison();
  void makeRuns();
  void showPage();

  StudyRunsModel runs_;
  QSortFilterProxyModel sorted_;
  QString compared_;
  QTimer compareSoon_;
  QTabBar* tabs_;
  QWidget* strip_;
  QStackedWidget* pages_;
  QTableWidget* comparison_;
  QTableView* runTable_;
};

}  // namespace app
