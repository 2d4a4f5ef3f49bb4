#include "editor/look/FocusFrames.h"

#include <QtWidgets>

namespace editor {

namespace {

/// AppStyle or the widget itself marks the focus of these.
bool marksFocus(const QWidget& widget) {
  const auto* const label = qobject_cast<const QLabel*>(&widget);
  const bool isLinkText = label != nullptr && label->textFormat() != Qt::PlainText;
  return isLinkText || qobject_cast<const QPushButton*>(&widget) != nullptr ||
         qobject_cast<const QToolButton*>(&widget) != nullptr ||
         qobject_cast<const QCheckBox*>(&widget) != nullptr ||
         qobject_cast<const QRadioButton*>(&widget) != nullptr ||
         qobject_cast<const QLineEdit*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr ||
         qobject_cast<const QSlider*>(&widget) != nullptr ||
         qobject_cast<const QTabBar*>(&widget) != nullptr ||
         qobject_cast<const QGroupBox*>(&widget) != nullptr ||
         qobject_cast<const QMenuBar*>(&widget) != nullptr || widget.isWindow();
}

}  // namespace

bool FocusFrames::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::FocusOut) {
    hide();
  }
  auto* widget = event->type() == QEvent::FocusIn ? qobject_cast<QWidget*>(watched) : nullptr;
  if (widget == nullptr || marksFocus(*widget)) {
    return false;
  }
  const bool isByMouse = static_cast<const QFocusEvent&>(*event).reason() == Qt::MouseFocusReason;
  if (!isByMouse && widget->window()->testAttribute(Qt::WA_KeyboardFocusChange)) {
    show(*widget);
  }
  return false;
}

void FocusFrames::show(QWidget& widget) {
  if (frame_ == nullptr) {
    frame_ = new QFocusFrame(&widget);
  }
  frame_->setWidget(&widget);
}

void FocusFrames::hide() {
  if (frame_ != nullptr && frame_->widget() != nullptr) {
    frame_->setWidget(nullptr);
  }
}

}  // namespace editor
