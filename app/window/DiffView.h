#pragma once

#include <QAbstractScrollArea>

#include "editor/document/LineDiff.h"
#include "editor/look/Theme.h"

namespace app {

/// The lines of two texts with what was taken out and put in; long equal parts are folded.
class DiffView : public QAbstractScrollArea {
  Q_OBJECT
 public:
  explicit DiffView(const editor::Theme& theme, QWidget* parent = nullptr);
  void setTexts(const std::string& left, const std::string& right);
  int removedCount() const { return removed_; }
  int addedCount() const { return added_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    editor::DiffLine line;
    int folded = 0;  // > 0: stands for so many equal lines
  };
  void updateBars();
  int rowHeight() const;
  int gutterWidth() const;
  void paintRow(QPainter& painter, const Row& row, int top) const;

  editor::Theme theme_;
  std::vector<Row> rows_;
  int removed_ = 0, added_ = 0, widest_ = 0;
};

}  // namespace app
