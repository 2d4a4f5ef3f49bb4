#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QtWidgets>

#include "app/report/Comparison.h"
#include "app/run/Experiment.h"

namespace app {

/// A finished run of a study, as output by `batch --rows`.
struct StudyRow {
  int run = 0;
  QString scenario;
  qlonglong seed = 0;
  std::map<QString, QString> values;  // by path
  bool isOk = true;
  QString reason;                     // end reason
  std::map<QString, double> metrics;  // by column; defined values only
};

/// Parses a row. Nothing: not a row.
std::optional<StudyRow> studyRowOf(const QByteArray& line);

/// The first line of the output: number of runs, and number finished before.
struct StudyHeader {
  std::size_t runs = 0, finished = 0;
};
std::optional<StudyHeader> studyHeaderOf(const QByteArray& line);

/// The value path that a study compares: a planner, otherwise the first list with several values;
/// empty: scenarios.
QString comparedPath(const Experiment& experiment);

/// The title of a path: "Planner" for "robot1.planner", otherwise the path.
QString pathTitle(const QString& path);

/// A metric displayed in the study panel.
struct StudyMetric {
  QString key, title, unit;
  bool isRate = false;      // in per cent, with Wilson interval
  QString heading() const;  // "Path length [m]"
};
const std::vector<StudyMetric>& studyMetrics();

/// The mean of a metric with its 95 % interval. Up to 300 values: BCa as in the report; above,
/// Student's t, which is almost equal and fast; for a rate, Wilson's. For a failed run, success is
/// 0 and other values are undefined. NaN: no values.
report::Estimate estimateOf(const StudyMetric& metric, const std::vector<const StudyRow*>& rows);
/// "12.3 [11.8, 12.9]" or "50 % [15, 85]"; empty: no values.
QString estimateText(const StudyMetric& metric, const report::Estimate& estimate);

/// A table model of the finished runs of a study, ordered by number. GUI thread.
class StudyRunsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void begin(const QStringList& paths);  // clears the model
  void add(StudyRow row);                // replaces the row with the same number
  const std::vector<StudyRow>& rows() const { return rows_; }
  /// The scenario of a row without the folder that all rows share and without its suffix.
  QString scenarioName(const QString& scenario) const;
  /// Rows grouped by the value of a path; empty: by scenario. Groups are in order of first
  /// appearance.
  std::vector<std::pair<QString, std::vector<const StudyRow*>>> byOption(const QString& path) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant shown(const StudyRow& row, int column) const;
  void takeFolderOf(const QString& scenario);

  QStringList paths_;
  std::optional<QString> commonFolder_;  // with a slash at its end; null: no rows
  std::vector<StudyRow> rows_;
};

/// A duration: "48 s", "12 min", "3 h 20 min".
QString studyTimeText(double seconds);
/// The size of a study: "2 scenarios × 3 planners × 30 seeds = 180 runs".
QString sizeText(const Experiment& experiment);
/// "error: this went wrong" -> "This went wrong".
QString withoutSeverity(const QString& line);

}  // namespace app
