#pragma once

#include <functional>
#include <string>

#include "app/cli/PictureFiles.h"
#include "app/cli/RunPicture.h"
#include "sim2d/base/Result.h"

/// Writes runs as pictures and films, for the command `render` and for the window.
namespace app {

constexpr double kPixelsPerMm = 96.0 / 25.4;  // as in CSS
constexpr double kVectorWidth = 170.0;        // [mm] of two columns, by default
constexpr double kPictureHeight = 1000.0;     // [px] by default
constexpr double kFilmWidth = 1280.0;         // [px] by default
constexpr double kMaxGifRate = 50.0;          // maximum frame rate of GIF viewers [1/s]

/// The bytes of a figure of a run. `ending`: ".svg", ".pdf", otherwise PNG. `scale`: pixels of a
/// PNG per pixel of the figure.
std::string runFigureFile(const RunFigure& figure, const Paint& paint, const std::string& ending,
                          const std::string& title, double scale = 1.0);

/// The frames of a film.
struct FilmTiming {
  double from = 0.0, to = 0.0;    // [s] of the run
  double framesPerSecond = 20.0;  // of the film
  double speed = 1.0;             // relative to real time

  long long frameCount() const;
  double timeOf(long long frame) const;  // [s] of the run; the last frame shows `to`
  double duration() const;               // [s] of the film
};

/// One frame of a film, with even sides, as encoders require.
QImage filmFrame(RunPicture& picture, double time);

/// Writes a film; the format follows from the file extension, as for Movie. `progress` is called
/// before each frame with its number from 1 and the count; it returns false to stop. False:
/// stopped, and no file was written. One thread.
base::Result<bool> writeFilm(const std::string& path, RunPicture& picture, const FilmTiming& timing,
                             const std::function<bool(long long, long long)>& progress);

}  // namespace app
