#include "editor/panels/LoopMarks.h"

#include <algorithm>
#include <cmath>

#include <QPainterPath>

namespace editor {

namespace {

constexpr double kMarkTop = 20.0;     // below the groove [px]
constexpr double kMarkHeight = 15.0;  // of a flag
constexpr double kMarkWidth = 13.0;
constexpr double kShortest = 0.1;  // [s] of a loop

}  // namespace

void LoopMarks::paint(QPainter& painter, const Theme& theme) const {
  const auto& loop = runner_.loop();
  if (!loop) {
    return;
  }
  const double a = scale_.xOf(loop->from), b = scale_.xOf(loop->to);
  painter.fillRect(QRectF(a, 9.0, b - a, 16.0), theme.color(Role::Accent, 0.16));
  painter.setFont(theme.font(8.0, QFont::DemiBold));
  for (const bool isFirst : {true, false}) {
    const double x = isFirst ? a : b;
    const double side = isFirst ? -1.0 : 1.0;  // flags stand outside of the part
    painter.setPen(QPen(theme.color(Role::Accent), 2.0));
    painter.drawLine(QPointF(x, 8.0), QPointF(x, kMarkTop + kMarkHeight));
    QRectF flag(x, kMarkTop, side * kMarkWidth, kMarkHeight);
    flag = flag.normalized();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.color(Role::Accent));
    painter.drawRoundedRect(flag, 2.0, 2.0);
    painter.setPen(theme.color(Role::Panel));
    painter.drawText(flag, Qt::AlignCenter, isFirst ? QStringLiteral("A") : QStringLiteral("B"));
  }
}

LoopMarks::Held LoopMarks::markAt(const QPointF& at) const {
  const auto& loop = runner_.loop();
  if (!loop || at.y() < kMarkTop) {
    return Held::Nothing;
  }
  constexpr double kReach = 4.0;
  const double a = scale_.xOf(loop->from), b = scale_.xOf(loop->to);
  if (at.x() >= a - kMarkWidth - kReach && at.x() <= a + kReach) {
    return Held::From;
  }
  return at.x() >= b - kReach && at.x() <= b + kMarkWidth + kReach ? Held::To : Held::Nothing;
}

bool LoopMarks::press(const QPointF& at, bool fresh) {
  held_ = fresh ? Held::To : markAt(at);
  if (held_ == Held::Nothing) {
    return false;
  }
  anchor_ = fresh                 ? scale_.timeAt(at.x())
            : held_ == Held::From ? runner_.loop()->to
                                  : runner_.loop()->from;
  return true;
}

bool LoopMarks::drag(double x) {
  if (held_ == Held::Nothing) {
    return false;
  }
  const double time = scale_.timeAt(x);
  const SimulationRunner::Part part{std::min(time, anchor_), std::max(time, anchor_)};
  if (part.to - part.from >= kShortest) {
    runner_.setLoop(part);
  }
  return true;
}

}  // namespace editor
