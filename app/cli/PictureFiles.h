#pragma once

#include <functional>
#include <memory>
#include <string>

#include <QSizeF>
#include <QString>

#include "sim2d/base/Result.h"

class QPainter;

/// Renders pictures to the bytes of a file, which are reproducible. Pixels are those of CSS, 96 per
/// inch. One thread; requires a QGuiApplication.
namespace app {

using Paint = std::function<void(QPainter&)>;

/// Throws std::bad_alloc if it is too large for memory.
std::string pngOf(const QSizeF& size, const Paint& paint);
std::string svgOf(const QSizeF& size, const QString& title, const Paint& paint);
/// One page of that size, with embedded fonts.
std::string pdfOf(const QSizeF& size, const Paint& paint);

}  // namespace app

class QImage;

namespace app {

/// A film that is written frame by frame. The output file appears only at finish(), complete. One
/// thread.
class Movie {
 public:
  /// The format follows from the file extension: ".gif" by giflib, ".mp4" (H.264), ".webm" (VP9)
  /// and ".webp" by the program `ffmpeg`. Error: ffmpeg is not installed, or the folder is not
  /// writable.
  static base::Result<std::unique_ptr<Movie>> begin(const std::string& path,
                                                    double framesPerSecond);
  static bool isSupported(const std::string& ending);

  Movie() = default;
  virtual ~Movie() = default;
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;
  Movie(Movie&&) = delete;
  Movie& operator=(Movie&&) = delete;

  /// All frames of the same size, with even sides.
  virtual base::Diagnostics add(const QImage& frame) = 0;
  virtual base::Diagnostics finish() = 0;
};

}  // namespace app
