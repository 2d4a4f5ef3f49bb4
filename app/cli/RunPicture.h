#pragma once

#include <memory>
#include <optional>

#include <QPainter>
#include <QSizeF>

#include "app/cli/FigureStyle.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// The picture of a run for a paper: map and obstacles on white, trajectories fading from light to
/// full in time, starts as rings, goals as pins, legend and scale. One thread; needs a
/// QGuiApplication, and the trace as long as it lives.
class RunPicture {
 public:
  RunPicture(const sim2d::Trace& trace, const PictureLayout& layout);
  ~RunPicture();
  RunPicture(const RunPicture&) = delete;
  RunPicture& operator=(const RunPicture&) = delete;
  RunPicture(RunPicture&&) = delete;
  RunPicture& operator=(RunPicture&&) = delete;

  QSizeF size() const;  // [px]
  /// As it was at this time [s]; none: the whole run, everybody where they were seen last.
  void paint(QPainter& painter, std::optional<double> time = {});

 private:
  class Painting;
  std::unique_ptr<Painting> painting_;
};

}  // namespace app
