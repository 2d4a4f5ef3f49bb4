#pragma once

#include <optional>
#include <vector>

#include <QtWidgets>

namespace app {

/// A command of the window as it is listed for users. The texts are the current ones: the text of
/// Undo names the last change.
struct Command {
  QPointer<QAction> action;
  QString name;  // without mnemonic, ellipsis and key; constant for commands with changing text
  QString path;  // the menus that contain it: "View › Layers"
  QString id;    // path and name in English, whatever the language of the window
};

/// The name of a command without mnemonic, undo text, ellipsis and the key of its tool.
QString commandName(const QAction& action);

/// The keys of the command or of its tool; empty: none.
QString commandKeys(const QAction& action);

/// All commands of the menus, in menu order, each one once. With `refresh`, menus that are filled
/// or enabled when they open are brought up to date first.
std::vector<Command> commandsOf(const QMenuBar& menus, bool refresh = false);

/// How well `text` matches what the user typed: all letters must occur in this order, without
/// regard to case and spaces. Higher is better: beginnings of words and adjacent letters count
/// most. Nothing: no match. An empty query matches everything equally.
std::optional<int> fuzzyScore(const QString& query, const QString& text);

}  // namespace app
