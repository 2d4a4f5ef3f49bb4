#include "app/window/DiffView.h"

#include <algorithm>

#include <QFontDatabase>
#include <QPainter>
#include <QScrollBar>

namespace app {

using editor::DiffLine;
using editor::Role;

namespace {

constexpr int kContext = 3;  // equal lines shown around a change
constexpr int kSignWidth = 16;
constexpr int kPadding = 8;

}  // namespace

DiffView::DiffView(const editor::Theme& theme, QWidget* parent)
    : QAbstractScrollArea(parent), theme_(theme) {
  QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  fixed.setStyleHint(QFont::Monospace);
  fixed.setFixedPitch(true);
  fixed.setPointSizeF(theme.font().pointSizeF());
  setFont(fixed);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Differences"));
  viewport()->setBackgroundRole(QPalette::Base);
}

void DiffView::setTexts(const std::string& left, const std::string& right) {
  const std::vector<DiffLine> lines = editor::lineDiff(left, right);
  std::vector<bool> shown(lines.size(), false);
  removed_ = added_ = widest_ = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].kind == DiffLine::Kind::Same) {
      continue;
    }
    ++(lines[i].kind == DiffLine::Kind::Removed ? removed_ : added_);
    const std::size_t first = i > kContext ? i - kContext : 0;
    for (std::size_t k = first; k < std::min(lines.size(), i + kContext + 1); ++k) {
      shown[k] = true;
    }
  }
  rows_.clear();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (shown[i]) {
      rows_.push_back({lines[i], 0});
      const QString text = QString::fromStdString(lines[i].text);
      widest_ = std::max(widest_, fontMetrics().horizontalAdvance(text));
    } else if (!rows_.empty() && rows_.back().folded > 0) {
      ++rows_.back().folded;
    } else {
      rows_.push_back({{}, 1});
    }
  }
  updateBars();
  verticalScrollBar()->setValue(0);
  viewport()->update();
}

int DiffView::rowHeight() const {
  return fontMetrics().height() + 2;
}

int DiffView::gutterWidth() const {
  return 2 * fontMetrics().horizontalAdvance(QStringLiteral("0000")) + 3 * kPadding;
}

void DiffView::updateBars() {
  const int height = static_cast<int>(rows_.size()) * rowHeight() + 2 * kPadding;
  verticalScrollBar()->setRange(0, std::max(0, height - viewport()->height()));
  verticalScrollBar()->setPageStep(viewport()->height());
  verticalScrollBar()->setSingleStep(rowHeight());
  const int width = gutterWidth() + kSignWidth + widest_ + 2 * kPadding;
  horizontalScrollBar()->setRange(0, std::max(0, width - viewport()->width()));
  horizontalScrollBar()->setPageStep(viewport()->width());
  horizontalScrollBar()->setSingleStep(20);
}

void DiffView::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  updateBars();
}

void DiffView::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  painter.fillRect(viewport()->rect(), theme_.color(Role::Field));
  int top = kPadding - verticalScrollBar()->value();
  for (const Row& row : rows_) {
    if (top + rowHeight() >= 0 && top <= viewport()->height()) {
      paintRow(painter, row, top);
    }
    top += rowHeight();
  }
}

void DiffView::paintRow(QPainter& painter, const Row& row, int top) const {
  const QRect whole(0, top, viewport()->width(), rowHeight());
  const int gutter = gutterWidth();
  const QColor pale = theme_.color(Role::TextSecondary);
  if (row.folded > 0) {
    painter.fillRect(whole, theme_.color(Role::RowHover));
    painter.setPen(pale);
    painter.drawText(whole.adjusted(gutter + kSignWidth, 0, 0, 0), Qt::AlignVCenter,
                     row.folded == 1 ? tr("1 equal line") : tr("%1 equal lines").arg(row.folded));
    return;
  }
  const bool isRemoved = row.line.kind == DiffLine::Kind::Removed;
  const bool isAdded = row.line.kind == DiffLine::Kind::Added;
  const Role mark = isRemoved ? Role::Error : Role::Ok;
  if (isRemoved || isAdded) {
    painter.fillRect(whole, theme_.color(mark, theme_.isDark() ? 0.22 : 0.13));
  }
  const auto number = [&](int value, int left) {
    if (value > 0) {
      painter.drawText(QRect(left, top, gutter / 2 - kPadding, rowHeight()),
                       Qt::AlignRight | Qt::AlignVCenter, QString::number(value));
    }
  };
  painter.setPen(theme_.color(Role::Text));
  painter.save();
  painter.setClipRect(QRect(gutter, top, whole.width() - gutter, rowHeight()));
  const int left = gutter - horizontalScrollBar()->value();
  if (isRemoved || isAdded) {
    painter.setPen(theme_.color(mark));
    painter.drawText(QRect(left, top, kSignWidth, rowHeight()), Qt::AlignVCenter,
                     isRemoved ? QStringLiteral("−") : QStringLiteral("+"));
    painter.setPen(theme_.color(Role::Text));
  }
  painter.drawText(left + kSignWidth, top + fontMetrics().ascent() + 1,
                   QString::fromStdString(row.line.text));
  painter.restore();
  painter.setPen(pale);
  number(row.line.left, 0);
  number(row.line.right, gutter / 2 - kPadding / 2);
}

}  // namespace app
