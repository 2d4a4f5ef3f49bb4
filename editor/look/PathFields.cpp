#include "editor/look/PathFields.h"

#include <algorithm>

#include <QtWidgets>

namespace editor {

namespace {

constexpr int kTextMargin = 2;  // Of QLineEdit on both sides [px].
constexpr const char* kPathProperty = "hunavPath";

QStyleOptionFrame panelOf(const QLineEdit& field) {
  QStyleOptionFrame panel;
  panel.initFrom(&field);
  panel.rect = field.rect();
  panel.lineWidth = field.hasFrame() ? field.style()->pixelMetric(QStyle::PM_DefaultFrameWidth) : 0;
  panel.state |= QStyle::State_Sunken;
  return panel;
}

/// Between the buttons of the field.
QRect textRectOf(const QLineEdit& field, const QStyleOptionFrame& panel) {
  QRect place = field.style()
                    ->subElementRect(QStyle::SE_LineEditContents, &panel, &field)
                    .marginsRemoved(field.textMargins());
  for (const auto* button :
       field.findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (button->isVisible() && button->x() > field.width() / 2) {
      place.setRight(std::min(place.right(), button->x() - 1));
    } else if (button->isVisible()) {
      place.setLeft(std::max(place.left(), button->geometry().right() + 1));
    }
  }
  return place.adjusted(kTextMargin, 0, -kTextMargin, 0);
}

/// Paints the field, which owns it.
class PathEnds : public QObject {
 public:
  explicit PathEnds(QLineEdit& field) : QObject(&field), field_(field) {
    field.installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool isPainted = watched == &field_ && event->type() == QEvent::Paint &&
                           !field_.hasFocus() && !pathShownInPart(field_).isEmpty();
    if (isPainted) {
      paint();
    }
    return isPainted;
  }

 private:
  void paint() {
    const QStyleOptionFrame panel = panelOf(field_);
    const QRect place = textRectOf(field_, panel);
    QPainter painter(&field_);
    QStyle& style = *field_.style();
    style.drawPrimitive(QStyle::PE_PanelLineEdit, &panel, &painter, &field_);
    style.drawItemText(&painter, place, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextSingleLine,
                       field_.palette(), field_.isEnabled(),
                       field_.fontMetrics().elidedText(field_.text(), Qt::ElideLeft, place.width()),
                       QPalette::Text);
  }

  QLineEdit& field_;
};

}  // namespace

void showEndOfPaths(QLineEdit& field) {
  // The field owns it: NOLINTNEXTLINE(clang-analyzer-cplusplus.NewDeleteLeaks)
  new PathEnds(field);
  field.setProperty(kPathProperty, true);
}

QString pathShownInPart(const QWidget& widget) {
  const auto* field = qobject_cast<const QLineEdit*>(&widget);
  if (field == nullptr || !field->property(kPathProperty).toBool() ||
      !field->text().contains(QLatin1Char('/'))) {
    return {};
  }
  const int room = textRectOf(*field, panelOf(*field)).width();
  return field->fontMetrics().horizontalAdvance(field->text()) > room ? field->text() : QString();
}

}  // namespace editor
