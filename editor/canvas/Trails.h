#pragma once

#include <deque>
#include <map>

#include <QPainter>

#include "sim2d/trace/Recording.h"

namespace editor {

constexpr double kTrailSeconds = 6.0;  // Default length.
constexpr double kFarthestStep = 2.0;  // Per frame [m]; a longer jump starts a new trail.

/// Calls visit(columns, index) for all people, then all robots of a frame.
template <class Visit>
void forEachBody(const sim2d::Frame& frame, Visit visit) {
  for (const sim2d::BodyColumns* columns :
       {static_cast<const sim2d::BodyColumns*>(&frame.humans), &frame.robots}) {
    for (std::size_t i = 0; i < columns->size(); ++i) {
      visit(*columns, i);
    }
  }
}

/// The positions of one body during the last seconds.
struct Trail {
  std::deque<std::pair<double, base::Vec2>> points;  // Time [s], position.
  std::optional<base::Vec2> last;                    // Newest position, even if not a point.
  double walked = 0.0;                               // Walked distance [m] for the foot animation.
};

/// The positions of all bodies of a run during the last seconds.
class Trails {
 public:
  void clear() { trails_.clear(); }
  /// Extends the trails from the shown frame (null: none) to the next one. With a recording they
  /// include skipped frames; otherwise they connect the shown frames. `seconds`: length [s].
  void advance(const sim2d::Frame* shown, const sim2d::Frame& next,
               const sim2d::Recording* recording, double seconds);
  const std::map<int, Trail>& all() const { return trails_; }  // By id, in painting order.
  double walked(int id) const { return trails_.at(id).walked; }

 private:
  void addSkippedFrames(const sim2d::Recording& recording, const sim2d::Frame* shown,
                        const sim2d::Frame& next);
  void lengthen(const sim2d::Frame& frame, bool isPoint);
  void cut(double time);

  std::map<int, Trail> trails_;
  double seconds_ = kTrailSeconds;
};

/// Painted length of the trails [s]; shorter in a crowd, so that people stay visible.
double trailSeconds(std::size_t bodies, double wanted = kTrailSeconds);
/// Draws the last seconds of a trail, paler with age, up to the shown position of the body at this
/// time [s].
void paintTrail(QPainter& painter, const Trail& trail, const base::Vec2& end, double time,
                double seconds, QColor color);

}  // namespace editor
