#pragma once

#include <QAbstractItemView>
#include <QTableView>

namespace editor {

/// Holds a list and gives it as much of its height as whole rows need, so that the last one is
/// never cut. The rows of the list have one height.
class WholeRows : public QWidget {
 public:
  WholeRows(QAbstractItemView& list, int rowHeight, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QAbstractItemView& list_;
  int rowHeight_;
};

/// Rows of a table get as many lines as the text in this column needs. `margin` is what cell and
/// icon take of the width.
void fitRowHeights(QTableView& table, int column, int margin, int leastHeight);

}  // namespace editor
