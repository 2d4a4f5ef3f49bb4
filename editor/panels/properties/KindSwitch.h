#pragma once

#include <map>

#include <QtWidgets>

#include "editor/document/Entity.h"

namespace editor {

/// "robot", "3 goals", "10 people": entities of one kind.
QString kindText(EntityKind kind, std::size_t count);

/// Buttons that choose one of the selected kinds: "10 people", "3 goals", "robot". Hidden if fewer
/// than two kinds are selected. The kind with the most entities is chosen at first, and among
/// equals the kind selected last; a kind chosen by the user stays chosen while it is selected.
class KindSwitch : public QWidget {
  Q_OBJECT
 public:
  explicit KindSwitch(QWidget* parent);
  /// Shows the kinds of a selection that is not empty. Returns the chosen kind.
  EntityKind setSelection(const std::vector<EntityId>& selection);

 Q_SIGNALS:
  void chosen();  // By the user.

 private:
  void choose(EntityKind kind);

  std::map<EntityKind, QPushButton*> buttons_;  // One per kind, in the order of the lists.
  QGridLayout* grid_;
  EntityKind byUser_ = EntityKind::None;
};

}  // namespace editor
