#pragma once

#include <functional>
#include <optional>

#include <QPainter>

#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// The marks A and B of the part that is looped, on a timeline: painted, taken and dragged.
class LoopMarks {
 public:
  /// Where a time is [px], and back [s].
  struct Scale {
    std::function<double(double)> xOf, timeAt;
  };
  LoopMarks(SimulationRunner& runner, Scale scale) : runner_(runner), scale_(std::move(scale)) {}

  void paint(QPainter& painter, const Theme& theme) const;
  /// Whether the mouse has something of the loop now; `fresh`: a new part is drawn from there.
  bool press(const QPointF& at, bool fresh);
  bool drag(double x);  // whether it was dragged
  void release() { held_ = Held::Nothing; }
  bool isOver(const QPointF& at) const { return markAt(at) != Held::Nothing; }

 private:
  enum class Held { Nothing, From, To };
  Held markAt(const QPointF& at) const;

  SimulationRunner& runner_;
  Scale scale_;
  Held held_ = Held::Nothing;
  double anchor_ = 0.0;  // [s] the other end
};

}  // namespace editor
