#pragma once

#include <vector>

#include <QtWidgets>

#include "bt/tree/TreeSpec.h"
#include "editor/look/Fields.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"

namespace editor {

/// The name and the ports of a tree node as fields, shown over the node. Tab and Shift+Tab
/// move between the fields, Return applies all of them, Escape none; leaving the fields applies
/// them.
class NodeFields : public QFrame {
  Q_OBJECT
 public:
  /// `canvas`: the view of the tree, which gets the focus back.
  NodeFields(QWidget& canvas, const Theme& theme);
  void setTheme(const Theme& theme);
  /// `place`: the rectangle of the node in the canvas.
  void open(const bt::NodeSpec& node, const QRect& place);
  /// The node has moved.
  void moveTo(const QRect& place);
  /// Emits `applied` if `apply` is set and a value has changed.
  void close(bool apply);
  bool isOpen() const { return !isHidden(); }
  /// The field of a port; empty key: of the name. Null: none.
  TextField* field(const std::string& key) const;

 Q_SIGNALS:
  void applied(const bt::NodeSpec& edited);  // Only name and ports have changed.

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Row {
    std::string key;
    TextField* field = nullptr;
    TextField::Check check;
  };
  void addRow(const QString& label, const QString& unit, Row row);
  void moveFocus(int by);
  int focusedRow() const;
  bool handleKey(const QKeyEvent& event);
  int invalidRow() const;  // -1 = none.
  void closeIfLeft(const QWidget* focused);

  QWidget& canvas_;
  Theme theme_;
  bt::NodeSpec node_;  // Before the edit.
  std::vector<Row> rows_;
  QWidget* body_ = nullptr;
  QGridLayout* grid_ = nullptr;
};

}  // namespace editor
