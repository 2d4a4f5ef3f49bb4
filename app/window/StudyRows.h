#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QAbstractTableModel>
#include <QString>
#include <QStringList>

#include "app/run/Experiment.h"

namespace app {

/// A finished run of a study, as `batch --rows` tells it.
struct StudyRow {
  int run = 0;
  QString scenario;
  qlonglong seed = 0;
  std::map<QString, QString> values;  // by path
  bool isOk = true;
  QString reason;                     // how it ended
  std::map<QString, double> metrics;  // by column; what is undefined is left out
};

/// Nothing: the line is no row.
std::optional<StudyRow> studyRowOf(const QByteArray& line);

/// What the same says first: how many runs there are, and how many were finished before.
struct StudyBegin {
  std::size_t runs = 0, finished = 0;
};
std::optional<StudyBegin> studyBeginOf(const QByteArray& line);

/// The value path whose options a study compares: a planner, else the first list of several values;
/// empty: scenarios are compared.
QString comparedPath(const Experiment& experiment);

/// "Planner" of "robot1.planner"; other paths as they are.
QString pathTitle(const QString& path);

/// A metric that the study panel shows.
struct StudyMetric {
  QString key, title, unit;
  bool isRate = false;      // shown in per cent, with Wilson's interval
  QString heading() const;  // "Path length [m]"
};
const std::vector<StudyMetric>& studyMetrics();

/// Mean of a metric over rows, with its 95 % interval: "12.3 [11.8, 12.9]", for up to 300 values
/// that of the report (BCa), beyond, where both are alike, Student's, which costs nothing. A failed
/// run succeeds in nothing and has no other value. Empty: no row has one.
QString estimateText(const StudyMetric& metric, const std::vector<const StudyRow*>& rows);

/// The finished runs of a study by number, as they come: a row each. GUI thread.
class StudyRunsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void begin(const QStringList& paths);  // empties it
  void add(StudyRow row);                // replaces the one of its number
  const std::vector<StudyRow>& rows() const { return rows_; }
  /// Rows by the value of a path; empty: by scenario. Options in the order in which they came.
  std::vector<std::pair<QString, std::vector<const StudyRow*>>> byOption(const QString& path) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant shown(const StudyRow& row, int column) const;

  QStringList paths_;
  std::vector<StudyRow> rows_;
};

}  // namespace app
