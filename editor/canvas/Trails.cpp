#include "editor/canvas/Trails.h"

#include <cmath>

#include "editor/canvas/MapScene.h"
#include "editor/canvas/PixelFrame.h"

namespace editor {

namespace {

constexpr double kTrailStep = 0.05;  // Minimum distance between two points [m].
constexpr double kTrailGap = 0.15;   // Time between two points of a recording [s].
constexpr double kTrailPart = 0.6;   // Minimum duration of one shade [s].
constexpr double kTrailShades = 10.0;
constexpr double kTrailDetailPx = 5.0;
constexpr double kLongTrails = 100;  // Bodies; more trails have the same total length.

/// The frame interval between trail points. Points of a recording have fixed times, so that a trail
/// does not depend on which frames were shown.
std::size_t gaitPhase(const sim2d::Recording& recording) {
  const double gap = recording.size() > 1 ? recording.timeOf(1) - recording.timeOf(0) : kTrailGap;
  return gap > 0.0 ? static_cast<std::size_t>(std::max(1L, std::lround(kTrailGap / gap))) : 1;
}

}  // namespace

void Trails::advance(const sim2d::Frame* shown, const sim2d::Frame& next,
                     const sim2d::Recording* recording, double seconds) {
  const bool isOther = std::exchange(seconds_, seconds) != seconds;
  const bool isLater =
      shown != nullptr && next.time >= shown->time && next.time <= shown->time + seconds_;
  if (isOther || !isLater) {
    clear();
  }
  bool isPoint = true;
  if (recording != nullptr && recording->size() > 0) {
    addSkippedFrames(*recording, shown, next);
    isPoint = recording->indexAt(next.step) % gaitPhase(*recording) == 0;
  }
  lengthen(next, isPoint);
  cut(next.time);
}

void Trails::addSkippedFrames(const sim2d::Recording& recording, const sim2d::Frame* shown,
                              const sim2d::Frame& next) {
  const std::size_t stride = gaitPhase(recording);
  const std::size_t end = recording.indexAt(next.step);
  const bool isFirst = shown == nullptr || trails_.empty();
  std::size_t index =
      isFirst ? recording.indexAtTime(next.time - seconds_) : recording.indexAt(shown->step) + 1;
  index = (index + stride - 1) / stride * stride;
  for (; index < end; index += stride) {
    lengthen(*recording.frame(index), true);
  }
}

void Trails::lengthen(const sim2d::Frame& frame, bool isPoint) {
  forEachBody(frame, [&](const sim2d::BodyColumns& columns, std::size_t i) {
    Trail& trail = trails_[columns.id[i]];
    const base::Vec2 at(columns.x[i], columns.y[i]);
    const double step = trail.last ? (at - *trail.last).norm() : 0.0;
    if (step > kFarthestStep) {  // A restart, or a periodic corridor.
      trail.points.clear();
    }
    trail.walked += step > kFarthestStep ? 0.0 : step;
    trail.last = at;
    const bool isApart =
        trail.points.empty() || (at - trail.points.back().second).norm() >= kTrailStep;
    if (isPoint && isApart) {
      trail.points.emplace_back(frame.time, at);
    }
  });
}

void Trails::cut(double time) {
  for (auto& [id, trail] : trails_) {
    while (!trail.points.empty() && trail.points.front().first < time - seconds_) {
      trail.points.pop_front();
    }
  }
}

double trailSeconds(std::size_t bodies, double wanted) {
  return wanted * std::min(1.0, kLongTrails / std::max(1.0, double(bodies)));
}

void paintTrail(QPainter& painter, const Trail& trail, const base::Vec2& end, double time,
                double seconds, QColor color) {
  const auto isOld = [=](const auto& point) { return point.first < time - seconds; };
  const bool isAhead =  // The body is still moving towards the newest point.
      trail.points.size() > 1 && trail.points.back().first >= time;
  const auto last = trail.points.end() - (isAhead ? 1 : 0);
  const auto first = std::partition_point(trail.points.begin(), last - 1, isOld);
  const auto count = last - first;
  const double apart = kTrailDetailPx / pixelsPerMetreOf(painter);
  const auto parts =
      static_cast<std::ptrdiff_t>(std::ceil(std::min(seconds / kTrailPart, kTrailShades)));
  for (std::ptrdiff_t part = 0; part < parts; ++part) {
    const std::ptrdiff_t from = count * part / parts;
    const std::ptrdiff_t to = std::min(count - 1, count * (part + 1) / parts);
    QPolygonF line;
    for (std::ptrdiff_t i = from; i <= to; ++i) {
      const QPointF point = toScene(first[i].second);
      if (i == from || i == to || QLineF(line.last(), point).length() >= apart) {
        line << point;
      }
    }
    if (part + 1 == parts) {
      line << toScene(end);
    }
    color.setAlphaF(0.5 * double(part + 1) / double(parts));
    painter.setPen(cosmetic(QPen(color, 4.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin), painter));
    painter.drawPolyline(line);
  }
}

}  // namespace editor
