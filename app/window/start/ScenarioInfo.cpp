#include "app/window/start/ScenarioInfo.h"

#include "editor/look/Form.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

constexpr const char* kTitle = "title";
constexpr const char* kFamily = "family";
constexpr const char* kPurpose = "purpose";
constexpr const char* kDifficulty = "difficulty";
constexpr const char* kPeople = "people";
constexpr const char* kRobots = "robots";

QString spaced(QString name) {
  return editor::capitalized(name.replace(QLatin1Char('_'), QLatin1Char(' ')));
}

void setCard(ScenarioInfo& info, const sim2d::ScenarioCard& card) {
  const auto set = [](QString& to, const std::optional<std::string>& text) {
    to = text ? QString::fromStdString(*text) : to;
  };
  set(info.title, card.title);
  set(info.family, card.family);
  set(info.purpose, card.purpose);
  if (card.difficulty) {
    const QString words[] = {QObject::tr("easy"), QObject::tr("normal"), QObject::tr("hard")};
    info.difficulty = words[static_cast<int>(*card.difficulty)];
  }
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
  const QString all = QStringList({title, family, purpose, difficulty}).join(QLatin1Char('\n'));
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(wanted.begin(), wanted.end(), [&all](const QString& word) {
    return all.contains(word, Qt::CaseInsensitive);
  });
}

/// The card of the file takes precedence. A scenario alone in its folder belongs to the family of
/// places.
ScenarioInfo infoOfFile(const QString& name, const QString& path) {
  QString base = name;
  base.remove(QStringLiteral("_agents"));
  const QString folder = QFileInfo(path).absoluteDir().dirName();
  ScenarioInfo info;
  info.title = spaced(base);
  info.family = base == folder ? QObject::tr("Places") : spaced(folder);
  if (const base::Result<std::string> text = base::readTextFile(path.toStdString())) {
    setCard(info, sim2d::cardOf(*text));
  }
  return info;
}

void addContents(ScenarioInfo& info, const sim2d::Scenario& scenario) {
  info.people = static_cast<int>(scenario.humans.size());
  info.robots = static_cast<int>(scenario.robots.size());
}

void writeInfo(QImage& image, const ScenarioInfo& info) {
  image.setText(QString::fromLatin1(kTitle), info.title);
  image.setText(QString::fromLatin1(kFamily), info.family);
  image.setText(QString::fromLatin1(kPurpose), info.purpose);
  image.setText(QString::fromLatin1(kDifficulty), info.difficulty);
  image.setText(QString::fromLatin1(kPeople), QString::number(info.people));
  image.setText(QString::fromLatin1(kRobots), QString::number(info.robots));
}

ScenarioInfo readInfo(const QImage& image) {
  const auto text = [&image](const char* key) { return image.text(QString::fromLatin1(key)); };
  ScenarioInfo info;
  info.title = text(kTitle);
  info.family = text(kFamily);
  info.purpose = text(kPurpose);
  info.difficulty = text(kDifficulty);
  info.people = text(kPeople).isEmpty() ? -1 : text(kPeople).toInt();
  info.robots = text(kRobots).toInt();
  return info;
}

}  // namespace app
