#pragma once

#include <deque>
#include <map>
#include <optional>
#include <utility>

#include <QColor>
#include <QPainter>

#include "sim2d/trace/Recording.h"

namespace editor {

constexpr double kTrailSeconds = 6.0;  // unless another length is chosen
constexpr double kFarthestStep = 2.0;  // [m] from frame to frame; beyond: set somewhere else

/// Where one body of a run was during the last seconds.
struct Trail {
  std::deque<std::pair<double, base::Vec2>> points;  // time [s], position
  std::optional<base::Vec2> last;                    // the newest place, a point or not
  double walked = 0.0;                               // [m], moves the feet
};

/// Where everybody of a run was during the last seconds.
class Trails {
 public:
  void clear() { trails_.clear(); }
  /// From the next frame on, from its beginning. [s]
  void setSeconds(double seconds);
  /// From the frame that is shown (none: nothing is) to the next one. A recording tells what was
  /// passed over; without one the trails join what was shown.
  void goOn(const sim2d::Frame* shown, const sim2d::Frame& next, const sim2d::Recording* recording);
  const std::map<int, Trail>& all() const { return trails_; }  // by id, painted in this order
  double walked(int id) const { return trails_.at(id).walked; }

 private:
  void addPassed(const sim2d::Recording& recording, const sim2d::Frame* shown,
                 const sim2d::Frame& next);
  void lengthen(const sim2d::Frame& frame, bool isPoint);
  void cut(double time);

  std::map<int, Trail> trails_;
  double seconds_ = kTrailSeconds;
};

/// [s] of every trail that is painted: in a crowd less, so that one sees the people.
double trailSeconds(std::size_t bodies, double wanted = kTrailSeconds);
/// The last seconds of a trail, paler with age, up to where the body is shown at this time [s].
void paintTrail(QPainter& painter, const Trail& trail, const base::Vec2& end, double time,
                double seconds, QColor color);

}  // namespace editor
