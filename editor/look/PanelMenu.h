#pragma once

#include <QMenu>
#include <QPointer>

namespace editor {

/// The menu that a panel has open, one at a time. It is deleted once it is closed. The panel closes
/// it when its subject is replaced: a run that continues meanwhile may select another person.
class PanelMenu {
 public:
  /// Replaces the menu by an empty one; `owner` is its parent.
  QMenu& begin(QWidget& owner);
  void close();

 private:
  QPointer<QMenu> menu_;
};

}  // namespace editor
