#include "editor/look/WrappedToolTips.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QTextDocument>
#include <QToolTip>

#include "editor/look/PathFields.h"

namespace editor {

namespace {

constexpr int kLongLine = 70;  // Characters.

/// The tooltip at a position of the widget; of a list, that of the row.
QString toolTipAt(const QWidget& widget, const QPoint& at) {
  const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
  if (view != nullptr && view->viewport() == &widget) {
    return view->indexAt(at).data(Qt::ToolTipRole).toString();
  }
  return widget.toolTip();
}

bool hasLongLine(const QString& text) {
  const QStringList lines = text.split(QLatin1Char('\n'));
  return std::any_of(lines.begin(), lines.end(),
                     [](const QString& line) { return line.size() > kLongLine; });
}

}  // namespace

bool WrappedToolTips::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = event->type() == QEvent::ToolTip ? qobject_cast<QWidget*>(watched) : nullptr;
  if (widget == nullptr) {
    return false;
  }
  const auto& help = static_cast<const QHelpEvent&>(*event);
  QString text = toolTipAt(*widget, help.pos());
  const QString path = pathShownInPart(*widget);
  if (Qt::mightBeRichText(text) || (path.isEmpty() && !hasLongLine(text))) {
    return false;
  }
  if (!path.isEmpty()) {
    text.prepend(text.isEmpty() ? path : path + QLatin1Char('\n'));
  }
  QToolTip::showText(help.globalPos(), Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal),
                     widget);
  return true;
}

}  // namespace editor
