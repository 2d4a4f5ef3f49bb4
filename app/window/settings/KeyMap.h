#pragma once

#include "app/window/files/FileDialogs.h"
#include "app/window/help/Commands.h"

namespace app {

/// The keys of all commands in the menus: their defaults and the changes by the user, which are
/// stored between sessions. GUI thread.
class KeyMap : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    QPointer<QAction> action;
    QString id;    // as of the command: "File › Open"
    QString menu;  // "File"
    QString name;
    QList<QKeySequence> usual;  // default keys
    bool isFixed = false;       // handled by a tool, not changeable
  };

  /// Reads the defaults from the menus, then applies the stored changes. Menus with the property
  /// `kListsFilesProperty` are left out.
  KeyMap(const QMenuBar& menus, UserSettings& userSettings, QObject* parent);
  static constexpr const char* kListsFilesProperty = "listsFiles";

  const std::vector<Entry>& entries() const { return entries_; }
  /// The command that has these keys, other than `except`; null: none.
  const Entry* ownerOf(const QKeySequence& keys, const QAction* except = nullptr) const;
  /// Why a command cannot have these keys; empty: it can. Keys of another command are allowed.
  static QString reasonAgainst(const QKeySequence& keys);
  bool isChanged(const Entry& entry) const { return entry.action->shortcuts() != entry.usual; }
  bool isAnyChanged() const;

  /// Gives these keys to the command and removes them from their owner. Empty: no keys.
  void assign(QAction& action, const QKeySequence& keys);
  /// Restores the default keys of the command and removes them from other commands.
  void reset(QAction& action);
  void resetAll();

 Q_SIGNALS:
  void changed();

 private:
  void take(QAction& action, const QList<QKeySequence>& keys);
  void store();
  void apply(const QVariantMap& stored);

  UserSettings& userSettings_;
  std::vector<Entry> entries_;
};

}  // namespace app
