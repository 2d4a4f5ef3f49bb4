#pragma once

#include <QStyledItemDelegate>

#include "editor/look/Theme.h"

namespace editor {

/// Data role of the secondary text of a row.
constexpr int kSideTextRole = Qt::UserRole + 101;

/// Rows of 24 px: the name, semibold when selected, and a secondary text at the right end.
class RowDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  explicit RowDelegate(const Theme& theme, QObject* parent = nullptr);
  void setTheme(const Theme& theme) { theme_ = theme; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 protected:
  virtual QString sideText(const QModelIndex& index) const;
  /// Pixels at the right end that stay free [px].
  virtual int rightMargin(const QStyleOptionViewItem&, const QModelIndex&) const { return 12; }
  virtual bool isHeading(const QModelIndex&) const { return false; }
  /// What is switched off is written in the secondary colour.
  virtual bool isPale(const QModelIndex&) const { return false; }

 private:
  Theme theme_;
};

}  // namespace editor
