#include "app/window/start/ScenarioInfo.h"

#include "editor/look/Form.h"

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

/// A scenario alone in its folder belongs to the family of places.
ScenarioInfo infoOfFile(const QString& name, const QString& path) {
  QString base = name;
  base.remove(QStringLiteral("_agents"));
  const QString folder = QFileInfo(path).absoluteDir().dirName();
  ScenarioInfo info;
  info.title = spaced(base);
  info.family = base == folder ? QObject::tr("Places") : spaced(folder);
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
