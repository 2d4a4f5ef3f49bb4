#include "app/window/start/Thumbnails.h"

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

/// Renders the scenario as on the canvas, fitted to the size.
QImage pictureOf(const Thumbnails::Request& request, const editor::Theme& theme,
                 ScenarioInfo& info) {
  editor::ScenarioDocument document;
  if (base::hasErrors(document.open(request.path))) {
    return {};
  }
  addContents(info, document.scenario());
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
  return small;
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

void Thumbnails::request(std::deque<Request> requests, const editor::Theme& theme) {
  waiting_ = std::move(requests);
  theme_ = theme;
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
  ScenarioInfo info = request.info;
  QImage picture = file.isEmpty() ? QImage() : QImage(file);
  if (!picture.isNull()) {
    info = readInfo(picture);
    picture.setDevicePixelRatio(request.ratio);
  } else {
    picture = pictureOf(request, theme_, info);
    ++drawn_;
    if (!picture.isNull() && !file.isEmpty() && QDir().mkpath(folder_)) {
      writeInfo(picture, info);
      picture.save(file, "PNG");  // on failure it is drawn again at the next start
    }
  }
  Q_EMIT ready(request.path, picture, info);
  if (!waiting_.empty() && !std::exchange(isScheduled_, true)) {
    editor::later(*this, [this] { next(); });
  }
}

}  // namespace app
