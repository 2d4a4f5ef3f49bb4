#pragma once

#include <QtWidgets>

#include "editor/look/Form.h"

/// Texts in a window that are wider or higher than their widget.
namespace cut {

/// Whether the widget can be seen at all: not scrolled out of view, not covered by its parent.
inline bool isSeen(const QWidget& widget) {
  return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

/// Lines of a text, without the mnemonics.
inline int widthOf(const QWidget& widget, const QString& text) {
  return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

/// What the widget lacks to show its text [px]; 0: nothing.
inline int missingOf(const QLabel& label) {
  if (label.text().isEmpty() || dynamic_cast<const editor::ElidedLabel*>(&label) != nullptr) {
    return 0;
  }
  const int height = label.wordWrap() ? label.heightForWidth(label.width()) - label.height() : 0;
  const int width = label.wordWrap() ? 0 : label.sizeHint().width() - label.width();
  return std::max({0, width, height});
}

inline int missingOf(const QAbstractButton& button) {
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (button.text().isEmpty() ||
      (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly)) {
    return 0;
  }
  const bool isBox = qobject_cast<const QCheckBox*>(&button) != nullptr ||
                     qobject_cast<const QRadioButton*>(&button) != nullptr;
  const int frame = isBox ? button.sizeHint().width() - widthOf(button, button.text()) : 8;
  return std::max(0, widthOf(button, button.text()) + frame - button.width());
}

inline int missingOf(const QComboBox& box) {
  constexpr int kMargin = 6;  // beside the field of the style
  QStyleOptionComboBox option;
  option.initFrom(&box);
  option.editable = box.isEditable();
  const int width =
      box.style()
          ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
          .width();
  const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
  return std::max(0, widthOf(box, box.currentText()) + icon - width - kMargin);
}

inline int missingOf(const QTabBar& bar) {
  int most = 0;
  for (int i = 0; i < bar.count(); ++i) {
    most = std::max(most, widthOf(bar, bar.tabText(i)) + 4 - bar.tabRect(i).width());
  }
  return most;
}

template <class Widget>
void addCut(const QWidget& in, QStringList& to) {
  for (const Widget* each : in.findChildren<Widget*>()) {
    const int missing = isSeen(*each) ? missingOf(*each) : 0;
    if (missing > 0) {
      const QVariant text =
          each->property(qobject_cast<const QComboBox*>(each) != nullptr ? "currentText" : "text");
      to << QStringLiteral("%1 '%2' in %3 lacks %4 px")
                .arg(QString::fromUtf8(each->metaObject()->className()), text.toString(),
                     QString::fromUtf8(each->parentWidget()->metaObject()->className()))
                .arg(missing);
    }
  }
}

/// One line for each text that is cut.
inline QStringList textsIn(const QWidget& window) {
  QStringList all;
  addCut<QLabel>(window, all);
  addCut<QAbstractButton>(window, all);
  addCut<QComboBox>(window, all);
  addCut<QTabBar>(window, all);
  all.removeDuplicates();
  return all;
}

}  // namespace cut
