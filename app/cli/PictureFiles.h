#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <QColor>
#include <QImage>
#include <QSizeF>
#include <QString>

#include "app/report/Figure.h"
#include "sim2d/base/Result.h"

class QPainter;

/// Renders pictures to the bytes of a file, which are reproducible. Pixels are those of CSS, 96 per
/// inch. One thread; requires a QGuiApplication.
namespace app {

/// The extension of a file in lower case: ".png".
std::string endingOf(const std::string& path);

using Paint = std::function<void(QPainter&)>;

/// Throws std::bad_alloc if it is too large for memory.
std::string pngOf(const QSizeF& size, const Paint& paint, const QColor& ground = Qt::white);
std::string svgOf(const QSizeF& size, const QString& title, const Paint& paint);
/// One page of that size, with embedded fonts.
std::string pdfOf(const QSizeF& size, const Paint& paint);

/// The size of a figure of a report, and a function that paints it.
std::pair<QSizeF, Paint> paintingOf(const report::Figure& figure);
/// The bytes of such a figure as ".svg", ".pdf" or ".png". `scale`: image pixels per pixel.
std::string figureFile(const report::Figure& figure, const std::string& ending, double scale = 1.0);

/// A film that is written frame by frame. The output file appears only at finish(), complete. One
/// thread.
class Movie {
 public:
  /// The format follows from the file extension: ".gif" by giflib, ".mp4" (H.264), ".webm" (VP9)
  /// and ".webp" by the program `ffmpeg`. Error: ffmpeg is not installed, or the folder is not
  /// writable.
  static base::Result<std::unique_ptr<Movie>> begin(const std::string& path,
                                                    double framesPerSecond);
  /// Whether the program that writes this format is installed: ".gif" needs none.
  static bool isAvailable(const std::string& ending);

  Movie() = default;
  virtual ~Movie() = default;
  Q_DISABLE_COPY_MOVE(Movie)

  /// All frames of the same size, with even sides.
  virtual base::Diagnostics add(const QImage& frame) = 0;
  virtual base::Diagnostics finish() = 0;
};

}  // namespace app
