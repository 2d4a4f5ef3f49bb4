#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim2d/base/Result.h"

class QImage;

namespace app {

/// A film that is written frame by frame. Nothing stands in its place before finish(), and nothing
/// but the whole film after it. One thread.
class Movie {
 public:
  /// By the ending of the name: ".gif" by giflib, ".mp4" (H.264), ".webm" (VP9) and ".webp" by the
  /// program `ffmpeg`. Error: it is not installed, the folder cannot be written to.
  static base::Result<std::unique_ptr<Movie>> begin(const std::string& path, double perSecond);
  static bool isName(const std::string& ending);

  Movie() = default;
  virtual ~Movie() = default;
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;
  Movie(Movie&&) = delete;
  Movie& operator=(Movie&&) = delete;

  /// All of one size, with even sides.
  virtual base::Diagnostics add(const QImage& frame) = 0;
  virtual base::Diagnostics finish() = 0;
};

}  // namespace app
