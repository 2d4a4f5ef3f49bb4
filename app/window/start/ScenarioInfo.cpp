#include "app/window/start/ScenarioInfo.h"

#include <algorithm>

#include "editor/look/Form.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

QString spaced(QString name) {
  return editor::capitalized(name.replace(QLatin1Char('_'), QLatin1Char(' ')));
}

QString cardText(const std::optional<std::string>& text) {
  return QString::fromStdString(text.value_or(std::string()));
}

QString difficultyText(std::optional<sim2d::Difficulty> difficulty) {
  if (!difficulty) {
    return {};
  }
  switch (*difficulty) {
    case sim2d::Difficulty::Easy:
      return QObject::tr("easy");
    case sim2d::Difficulty::Normal:
      return QObject::tr("normal");
    case sim2d::Difficulty::Hard:
      break;
  }
  return QObject::tr("hard");
}

QString detailsOf(const sim2d::ScenarioCard& card) {
  QStringList lines;
  const auto add = [&lines](const QString& label, const std::optional<std::string>& text) {
    if (text && !text->empty()) {
      lines << label.arg(QString::fromStdString(*text));
    }
  };
  add(QObject::tr("Robot: %1"), card.robotTask);
  add(QObject::tr("People: %1"), card.people);
  add(QObject::tr("Expected: %1"), card.outcome);
  add(QObject::tr("Source: %1"), card.source);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

QString ScenarioInfo::contents() const {
  if (people < 0) {
    return {};
  }
  QStringList parts = {editor::counted(static_cast<std::size_t>(people), QObject::tr("person"),
                                       QObject::tr("people"))};
  if (robots > 0) {
    parts << (robots == 1 ? QObject::tr("robot") : QObject::tr("%1 robots").arg(robots));
  }
  return parts.join(QStringLiteral(" · "));
}

bool ScenarioInfo::contains(const QString& words) const {
  const QString all =
      QStringList({name, title, family, purpose, details, difficulty}).join(QLatin1Char('\n'));
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(wanted.begin(), wanted.end(), [&all](const QString& word) {
    return all.contains(word, Qt::CaseInsensitive);
  });
}

ScenarioInfo infoOf(const QString& path, const sim2d::ScenarioCard& card) {
  const QFileInfo file(path);
  QString base = file.completeBaseName();
  base.remove(QStringLiteral("_agents"));
  const QString folder = file.absoluteDir().dirName();
  ScenarioInfo info;
  info.name = file.completeBaseName();
  info.title = card.title ? cardText(card.title) : spaced(base);
  info.family = card.family ? cardText(card.family) : spaced(folder);
  info.purpose = cardText(card.purpose);
  info.details = detailsOf(card);
  info.difficulty = difficultyText(card.difficulty);
  return info;
}

ScenarioInfo infoOfFile(const QString& path) {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  return infoOf(path, text ? sim2d::cardOf(*text) : sim2d::ScenarioCard());
}

}  // namespace app
