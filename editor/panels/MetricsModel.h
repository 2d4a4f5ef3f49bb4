#pragma once

#include <QAbstractTableModel>
#include <QStyledItemDelegate>

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

namespace editor {

/// Rows of the live table: metric, now, unit, course. Rows stay when values change.
class MetricsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NameColumn, NowColumn, UnitColumn, CourseColumn, ColumnCount };
  MetricsModel(const MetricsFeed& feed, QObject* parent)
      : QAbstractTableModel(parent), feed_(feed) {}

  void refresh();
  void setTheme(const Theme& theme);
  int rowOf(const std::string& key) const;
  int firstWithCurve() const;  // the first row that has something to plot, else 0
  const metrics::MetricResult* resultAt(int row) const;
  const MetricCurve* curveAt(int row) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex&) const override { return ColumnCount; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString tooltip(const metrics::MetricResult& result) const;
  const MetricsFeed& feed_;
  int rows_ = 0;
  QColor pale_;
};

/// The course since the start as a small line without axes.
class SparklineDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  SparklineDelegate(const MetricsModel& model, const Theme& theme, QObject* parent)
      : QStyledItemDelegate(parent), model_(model), theme_(theme) {}
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 private:
  const MetricsModel& model_;
  Theme theme_;
};

}  // namespace editor
