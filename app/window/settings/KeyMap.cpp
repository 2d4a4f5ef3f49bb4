#include "app/window/settings/KeyMap.h"

#include <algorithm>
#include <iterator>

#include "editor/look/Form.h"
#include "sim2d/base/Find.h"

namespace app {

namespace {

constexpr const char* kStored = "keys/changed";  // keys by command; an empty list: none

QStringList textsOf(const QList<QKeySequence>& keys) {
  QStringList texts;
  for (const QKeySequence& each : keys) {
    texts << each.toString(QKeySequence::PortableText);
  }
  return texts;
}

/// The id under which earlier versions stored the keys of a renamed command; empty: none.
QString formerId(const QString& id) {
  return id == QStringLiteral("Run › Return to editing") ? QStringLiteral("Run › Reset")
                                                         : QString();
}

void setKeys(QAction& action, const QList<QKeySequence>& keys) {
  action.setShortcuts(keys);
  editor::describe(action, action.statusTip());  // the tooltip names the key
}

}  // namespace

KeyMap::KeyMap(const QMenuBar& menus, UserSettings& userSettings, QObject* parent)
    : QObject(parent), userSettings_(userSettings) {
  for (const Command& command : commandsOf(menus)) {
    const QList<QWidget*> places = command.action->associatedWidgets();
    const bool isFile = std::any_of(places.begin(), places.end(), [](const QWidget* place) {
      return place->property(kListsFilesProperty).toBool();
    });
    if (isFile) {
      continue;
    }
    entries_.push_back({command.action, command.id,
                        command.path.section(QStringLiteral(" › "), 0, 0), command.name,
                        command.action->shortcuts(),
                        command.action->text().contains(QLatin1Char('\t'))});
  }
  apply(userSettings_.value(kStored).toMap());
}

void KeyMap::apply(const QVariantMap& stored) {
  for (const Entry& entry : entries_) {
    const QString id = stored.contains(entry.id) ? entry.id : formerId(entry.id);
    if (entry.isFixed || !stored.contains(id)) {
      continue;
    }
    QList<QKeySequence> keys;
    for (const QString& text : stored.value(id).toStringList()) {
      keys << QKeySequence(text, QKeySequence::PortableText);
    }
    setKeys(*entry.action, keys);
  }
}

const KeyMap::Entry* KeyMap::ownerOf(const QKeySequence& keys, const QAction* except) const {
  if (keys.isEmpty()) {
    return nullptr;
  }
  return base::findIf(entries_, [&](const Entry& entry) {
    return entry.action != except && entry.action->shortcuts().contains(keys);
  });
}

QString KeyMap::reasonAgainst(const QKeySequence& keys) {
  constexpr int kUsed[] = {Qt::Key_Escape,      Qt::Key_Tab,  Qt::Key_Return, Qt::Key_Enter,
                           Qt::Key_Left,        Qt::Key_Up,   Qt::Key_Right,  Qt::Key_Down,
                           Qt::Key_Backspace,   Qt::Key_Home, Qt::Key_Menu,   Qt::Key_BracketLeft,
                           Qt::Key_BracketRight};
  const int key = keys.isEmpty() ? 0 : keys[0];
  const bool isUsed = std::find(std::begin(kUsed), std::end(kUsed), key) != std::end(kUsed);
  return isUsed ? tr("%1 is used by fields, lists and tools and cannot be assigned.")
                      .arg(keys.toString(QKeySequence::NativeText))
                : QString();
}

bool KeyMap::isAnyChanged() const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [this](const Entry& entry) { return isChanged(entry); });
}

void KeyMap::take(QAction& action, const QList<QKeySequence>& keys) {
  for (const QKeySequence& each : keys) {
    if (const Entry* owner = ownerOf(each, &action)) {
      QList<QKeySequence> left = owner->action->shortcuts();
      left.removeAll(each);
      setKeys(*owner->action, left);
    }
  }
  setKeys(action, keys);
}

void KeyMap::assign(QAction& action, const QKeySequence& keys) {
  take(action, keys.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{keys});
  store();
}

void KeyMap::reset(QAction& action) {
  const Entry* entry =
      base::findIf(entries_, [&](const Entry& each) { return each.action == &action; });
  if (entry != nullptr) {
    take(action, entry->usual);
    store();
  }
}

void KeyMap::resetAll() {
  for (const Entry& entry : entries_) {
    setKeys(*entry.action, entry.usual);
  }
  store();
}

void KeyMap::store() {
  QVariantMap changes;
  for (const Entry& entry : entries_) {
    if (isChanged(entry)) {
      changes[entry.id] = textsOf(entry.action->shortcuts());
    }
  }
  userSettings_.setValue(kStored, changes);
  Q_EMIT changed();
}

}  // namespace app
