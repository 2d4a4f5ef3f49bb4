#include "editor/panels/ElidedLabel.h"

#include <QPainter>
#include <QTextDocument>

namespace editor {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

void ElidedLabel::setWords(const QString& words) {
  setText(words);
  setToolTip(Qt::mightBeRichText(words) ? QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped())
                                        : words);
}

QString ElidedLabel::shownWords() const {
  return fontMetrics().elidedText(text(), Qt::ElideMiddle, contentsRect().width());
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setPen(palette().color(foregroundRole()));
  painter.drawText(contentsRect(), int(alignment()) | Qt::TextSingleLine, shownWords());
}

}  // namespace editor
