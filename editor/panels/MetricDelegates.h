#pragma once

#include "editor/look/Theme.h"
#include "editor/panels/MetricsFeed.h"

namespace editor {

/// Draws the names of metrics in a tree with several levels; rows are as tall as the wrapped name.
class MetricNameDelegate : public QStyledItemDelegate {
 public:
  explicit MetricNameDelegate(QTreeWidget* tree) : QStyledItemDelegate(tree), tree_(*tree) {}
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int room(const QModelIndex& index) const;
  const QTreeWidget& tree_;
};

/// Draws the curve of a metric since the start as a sparkline.
class SparklineDelegate : public QStyledItemDelegate {
 public:
  SparklineDelegate(const MetricsFeed& feed, QObject* parent)
      : QStyledItemDelegate(parent), feed_(feed) {}
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;

 private:
  const MetricsFeed& feed_;
  Theme theme_;
};

/// Null: the metric has no curve.
const app::MetricTimeSeries* curveOf(const MetricSnapshot& snapshot, const std::string& key);

}  // namespace editor
