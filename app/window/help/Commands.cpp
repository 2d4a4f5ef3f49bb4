#include "app/window/help/Commands.h"

#include <algorithm>

#include "app/window/WindowActions.h"
#include "app/window/settings/Language.h"

namespace app {

namespace {

/// The text of a command, constant for commands with changing text.
QString lastingText(const QAction& action) {
  const QString lasting = action.property(WindowActions::kNameProperty).toString();
  return lasting.isEmpty() ? action.text() : lasting;
}

/// Without mnemonic, ellipsis and the key of a tool.
QString plainName(const QString& text) {
  return text.section(QLatin1Char('\t'), 0, 0).remove(QLatin1Char('&')).remove(QChar(0x2026));
}

/// The name in English. Tools add their key to the translated name.
QString sourceName(const QAction& action) {
  const QString text = lastingText(action);
  const QString source = sourceText(text);
  return plainName(source == text ? sourceText(text.section(QLatin1Char('\t'), 0, 0)) : source);
}

const QString& commandSeparator() {
  static const QString kSeparator = QStringLiteral(" › ");
  return kSeparator;
}

}  // namespace

QString commandName(const QAction& action) {
  return plainName(lastingText(action));
}

QString commandKeys(const QAction& action) {
  const QString heard = action.text().section(QLatin1Char('\t'), 1);
  return heard.isEmpty() ? QKeySequence::listToString(action.shortcuts(), QKeySequence::NativeText)
                         : heard;
}

namespace {

/// Adds the commands of a menu. `path`, `sourcePath`: its name with those of its parents, as shown
/// and in English.
void addMenu(QMenu& menu, const QString& path, const QString& sourcePath, bool refresh,
             std::vector<Command>& to) {
  if (refresh) {
    Q_EMIT menu.aboutToShow();
  }
  for (QAction* action : menu.actions()) {
    const bool isListed = std::any_of(to.begin(), to.end(), [action](const Command& command) {
      return command.action == action;  // in another menu
    });
    if (isListed || action->isSeparator() || !action->isVisible()) {
      continue;
    }
    const QString id = sourcePath + commandSeparator() + sourceName(*action);
    if (action->menu() != nullptr) {
      addMenu(*action->menu(), path + commandSeparator() + commandName(*action), id, refresh, to);
    } else {
      to.push_back({action, commandName(*action), path, id});
    }
  }
}

constexpr int kWordStart = 8;  // points for a letter that begins a word
constexpr int kAdjacent = 8;   // for a letter directly after the one before
constexpr int kLetter = 1;
constexpr int kWhole = 40;    // for a text that begins with the query
constexpr int kInside = 20;   // for a text that contains the query
constexpr int kPoint = 100;   // of the result
constexpr int kLongest = 80;  // letters; between equal matches, the shorter text is better

bool beginsWord(const QString& text, int at) {
  return at == 0 || !text.at(at - 1).isLetterOrNumber();
}

constexpr int kNoMatch = -1;

/// The best sums of points of a text by the position of its last matched letter; kNoMatch: none.
using Points = std::vector<int>;

/// One step of bestAlignment(): `before` are the sums of the letters before `letter`.
Points alignLetter(QChar letter, bool isFirst, const QString& text, const Points& before) {
  Points now(before.size(), kNoMatch);
  int best = isFirst ? 0 : kNoMatch;  // of the letters before, anywhere to the left
  int adjacent = kNoMatch;            // of the letters before, directly to the left
  for (std::size_t at = 0; at < before.size(); ++at) {
    const int t = static_cast<int>(at);
    if (text.at(t) == letter && best != kNoMatch) {
      const int sum = adjacent == kNoMatch ? best : std::max(best, adjacent + kAdjacent);
      now[at] = sum + kLetter + (beginsWord(text, t) ? kWordStart : 0);
    }
    adjacent = before[at];
    best = std::max(best, adjacent);
  }
  return now;
}

/// The best sum of points for the letters of `query` in `text`, both in lower case.
/// Dynamic programming over the position of the last matched letter.
int bestAlignment(const QString& query, const QString& text) {
  Points points(static_cast<std::size_t>(text.size()), kNoMatch);
  for (int q = 0; q < query.size(); ++q) {
    points = alignLetter(query.at(q), q == 0, text, points);
  }
  return points.empty() ? kNoMatch : *std::max_element(points.begin(), points.end());
}

}  // namespace

std::vector<Command> commandsOf(const QMenuBar& menus, bool refresh) {
  std::vector<Command> all;
  for (const QAction* top : menus.actions()) {
    if (top->menu() != nullptr) {
      addMenu(*top->menu(), commandName(*top), sourceName(*top), refresh, all);
    }
  }
  return all;
}

std::optional<int> fuzzyScore(const QString& query, const QString& text) {
  const QString whole = text.toLower();
  const QString typed = query.simplified().toLower();
  QString letters = typed;
  letters.remove(QLatin1Char(' '));
  if (letters.isEmpty()) {
    return 0;
  }
  const int points = bestAlignment(letters, whole);
  if (points < 0) {
    return std::nullopt;
  }
  const int bonus = whole.startsWith(typed) ? kWhole : whole.contains(typed) ? kInside : 0;
  return kPoint * (points + bonus) + kLongest - std::min(kLongest, static_cast<int>(whole.size()));
}

}  // namespace app
