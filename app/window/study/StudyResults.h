#pragma once

#include <QtWidgets>

#include "app/window/study/StudyRows.h"

namespace app {

/// The results of a running study: a comparison of options with intervals, and all runs. GUI
/// thread.
class StudyResults : public QWidget {
  Q_OBJECT
 public:
  explicit StudyResults(QWidget* parent);

  /// Clears both tables. `paths`: value paths, one column each in the runs table; `compared`: the
  /// path that is compared, empty: scenarios.
  void begin(const QStringList& paths, const QString& compared);
  void add(const std::vector<StudyRow>& rows);
  void compare();  // updates the comparison immediately instead of delayed
  const StudyRunsModel& runs() const { return runs_; }
  QTableWidget& comparison() const { return *comparison_; }

 Q_SIGNALS:
  void playRequested(int run);

 private:
  QWidget* makeComparison();
  void makeRuns();
  void showPage();
  void fillHead();
  void fillColumn(int column, const StudyMetric& metric,
                  const std::vector<std::pair<QString, std::vector<const StudyRow*>>>& options);

  StudyRunsModel runs_;
  QSortFilterProxyModel sorted_;
  QString compared_;
  QTimer compareSoon_;
  QTabBar* tabs_ = new QTabBar(this);
  QStackedWidget* pages_ = new QStackedWidget(this);
  QTableWidget* comparison_ = new QTableWidget(this);
  QTableView* runTable_ = new QTableView(this);
};

}  // namespace app
