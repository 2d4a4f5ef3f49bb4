#include "app/cli/RunExport.h"

#include <algorithm>
#include <cmath>

#include "editor/look/FigurePainter.h"

namespace app {

std::string runFigureFile(const RunFigure& figure, const Paint& paint, const std::string& ending,
                          const std::string& title, double scale) {
  if (ending == ".svg") {
    return svgOf(figure.size(), QString::fromStdString(title), paint);
  }
  if (ending == ".pdf") {
    return pdfOf(figure.size(), paint);
  }
  const auto scaled = [scale, &paint](QPainter& painter) {
    painter.scale(scale, scale);
    paint(painter);
  };
  return pngOf(scale * figure.size(), scaled, figure.ground());
}

long long FilmTiming::frameCount() const {
  const double step = speed / framesPerSecond;
  return static_cast<long long>(std::ceil((to - from) / step - 1e-9)) + 1;
}

double FilmTiming::timeOf(long long frame) const {
  return std::min(to, from + static_cast<double>(frame) * (speed / framesPerSecond));
}

double FilmTiming::duration() const {
  return static_cast<double>(frameCount()) / framesPerSecond;
}

QImage filmFrame(RunPicture& picture, double time) {
  const auto even = [](double side) { return 2 * static_cast<int>(std::ceil(0.5 * side)); };
  QImage image = editor::blankImage({even(picture.size().width()), even(picture.size().height())},
                                    QImage::Format_RGB32);
  image.fill(picture.ground());
  QPainter painter(&image);
  picture.paint(painter, time);
  painter.end();
  return image;
}

base::Result<bool> writeFilm(const std::string& path, RunPicture& picture, const FilmTiming& timing,
                             const std::function<bool(long long, long long)>& progress) {
  base::Result<std::unique_ptr<Movie>> film = Movie::begin(path, timing.framesPerSecond);
  if (!film) {
    return film.diagnostics();
  }
  const long long count = timing.frameCount();
  for (long long frame = 0; frame < count; ++frame) {
    if (!progress(frame + 1, count)) {
      return false;
    }
    const base::Diagnostics problems = (*film)->add(filmFrame(picture, timing.timeOf(frame)));
    if (base::hasErrors(problems)) {
      return problems;
    }
  }
  const base::Diagnostics problems = (*film)->finish();
  return base::hasErrors(problems) ? base::Result<bool>(problems) : base::Result<bool>(true);
}

}  // namespace app
