#include "app/window/start/Thumbnails.h"

#include <algorithm>

#include "app/run/DataPaths.h"
#include "editor/canvas/MapScene.h"
#include "editor/canvas/RouteModel.h"
#include "editor/look/DeferredActions.h"

namespace app {

using editor::Role;

namespace {

constexpr double kThumbnailScale = 1.75;   // lines are thinner than on the canvas
constexpr double kThumbnailMargin = 10.0;  // [px]
constexpr int kMostFiles = 500;            // kept, newest first

constexpr const char* kPeopleText = "people";  // texts of the kept pictures
constexpr const char* kRobotsText = "robots";

/// Renders the scenario as on the canvas, fitted to the size.
Thumbnail thumbnailOf(const Thumbnails::Request& request, const editor::Theme& theme) {
  editor::ScenarioDocument document;
  if (base::hasErrors(document.open(request.path))) {
    return {};
  }
  editor::MapScene scene(document, theme);
  editor::CanvasOptions options;
  options.names = false;
  options.grid = false;
  options.goals = false;  // pins are as large as people; routes show the goals
  scene.setOptions(options);
  scene.routes().finish();
  const QRectF content = scene.contentRect();
  const QSizeF large = QSizeF(request.size) * kThumbnailScale;  // line widths are constant
  const double margin = 2.0 * kThumbnailMargin * kThumbnailScale;
  const double scale = std::min((large.width() - margin) / content.width(),
                                (large.height() - margin) / content.height());
  scene.setPixelsPerMetre(scale);
  QImage picture((large * request.ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  picture.setDevicePixelRatio(request.ratio);
  picture.fill(theme.color(Role::CanvasOutside));
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  const QSizeF drawn = content.size() * scale;
  const QPointF corner((large.width() - drawn.width()) / 2.0,
                       (large.height() - drawn.height()) / 2.0);
  scene.render(&painter, QRectF(corner, drawn), content);
  painter.end();
  QImage small =
      picture.scaled(request.size * request.ratio, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  small.setDevicePixelRatio(request.ratio);
  const sim2d::Scenario& scenario = document.scenario();
  return {small, static_cast<int>(scenario.humans.size()),
          static_cast<int>(scenario.robots.size())};
}

/// Null picture: not kept.
Thumbnail keptThumbnail(const QString& file, double ratio) {
  Thumbnail kept;
  kept.picture = file.isEmpty() ? QImage() : QImage(file);
  if (!kept.picture.isNull()) {
    kept.picture.setDevicePixelRatio(ratio);
    kept.people = kept.picture.text(QString::fromLatin1(kPeopleText)).toInt();
    kept.robots = kept.picture.text(QString::fromLatin1(kRobotsText)).toInt();
  }
  return kept;
}

}  // namespace

Thumbnails::Thumbnails(QString folder, QObject* parent)
    : QObject(parent), folder_(std::move(folder)) {
  if (folder_.isEmpty()) {
    return;
  }
  const QDir kept(folder_);
  const QStringList files = kept.entryList({QStringLiteral("*.png")}, QDir::Files, QDir::Time);
  for (const QString& old : files.mid(kMostFiles)) {
    QFile::remove(kept.filePath(old));
  }
}

void Thumbnails::request(const Request& request) {
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                [&](const Request& each) { return each.path == request.path; }),
                 waiting_.end());
  waiting_.push_front(request);
  schedule();
}

void Thumbnails::setTheme(const editor::Theme& theme) {
  theme_ = theme;
  waiting_.clear();
}

void Thumbnails::schedule() {
  if (!waiting_.empty() && !std::exchange(isScheduled_, true)) {
    editor::later(*this, [this] { next(); });
  }
}

/// The name changes with the scenario file, the size, the theme and the program. A map that is
/// changed later does not count.
QString Thumbnails::fileOf(const Request& request) const {
  if (folder_.isEmpty()) {
    return {};
  }
  const QFileInfo file(request.path);
  const QString all =
      QStringList({file.absoluteFilePath(), file.lastModified().toString(Qt::ISODateWithMs),
                   QString::number(file.size()), QString::number(request.size.width()),
                   QString::number(request.size.height()), QString::number(request.ratio),
                   theme_.isDark() ? QStringLiteral("dark") : QStringLiteral("light"),
                   QString::fromStdString(programVersion() + programCommit())})
          .join(QLatin1Char('\n'));
  const QByteArray hash = QCryptographicHash::hash(all.toUtf8(), QCryptographicHash::Sha1).toHex();
  return QDir(folder_).filePath(QString::fromLatin1(hash) + QStringLiteral(".png"));
}

void Thumbnails::next() {
  isScheduled_ = false;
  if (waiting_.empty()) {
    return;
  }
  const Request request = waiting_.front();
  waiting_.pop_front();
  const QString file = fileOf(request);
  Thumbnail thumbnail = keptThumbnail(file, request.ratio);
  if (thumbnail.picture.isNull()) {
    thumbnail = thumbnailOf(request, theme_);
    ++drawn_;
    if (!thumbnail.picture.isNull() && !file.isEmpty() && QDir().mkpath(folder_)) {
      QImage kept = thumbnail.picture;
      kept.setText(QString::fromLatin1(kPeopleText), QString::number(thumbnail.people));
      kept.setText(QString::fromLatin1(kRobotsText), QString::number(thumbnail.robots));
      kept.save(file, "PNG");  // on failure it is drawn again at the next start
    }
  }
  Q_EMIT ready(request.path, thumbnail);
  schedule();
}

}  // namespace app
