#include "editor/look/ActionText.h"

namespace editor {

void describe(QAction& action, const QString& says) {
  QString name = action.text().section(QLatin1Char('\t'), 0, 0);  // a key that a tool hears follows
  name.remove(QLatin1Char('&')).remove(QStringLiteral("…"));
  const QString key = action.shortcut().toString(QKeySequence::NativeText);
  action.setStatusTip(says);
  action.setToolTip(key.isEmpty() ? name + QLatin1Char('\n') + says
                                  : QStringLiteral("%1 (%2)\n%3").arg(name, key, says));
}

}  // namespace editor
