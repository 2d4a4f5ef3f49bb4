#include "metrics/MetricRegistry.h"

/// People who cross a line, with or without a robot.
namespace metrics {

namespace {

struct Line {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};

/// Whether the segment from a to b intersects the line between its ends.
bool crosses(const Vec2& a, const Vec2& b, const Line& line) {
  const Vec2 along = line.to - line.from;
  const double before = base::cross(along, a - line.from);
  const double after = base::cross(along, b - line.from);
  if ((before > 0.0) == (after > 0.0)) {
    return false;
  }
  const Vec2 point = a + before / (before - after) * (b - a);
  const double place = along.dot(point - line.from);
  return place >= 0.0 && place <= along.squaredNorm();
}

class LineCrossings : public Accumulator {
 public:
  explicit LineCrossings(const MetricParameters& parameters)
      : line_{Vec2(parameters.flowLineX1, parameters.flowLineY1),
              Vec2(parameters.flowLineX2, parameters.flowLineY2)} {}

  void add(const Instant& at) override {
    if (at.before == nullptr || !isSet()) {
      return;
    }
    const std::vector<Pedestrian>& before = at.before->people;
    std::size_t next = 0;
    for (const Pedestrian& person : at.now.people) {
      const Pedestrian* then = findInOrder(before, next, person.id);
      const bool hasWalked = then != nullptr && !person.isNew;
      count_ +=
          hasWalked && hasCrossed(then->position, person.position, at.context.seam) ? 1.0 : 0.0;
    }
  }

  MetricValue count() const {
    return isSet() ? count_ : undefinedValue("no line is set (flow_line_x1 ...)");
  }
  MetricValue flow(const Instant& last) const {
    if (!isSet()) {
      return count();
    }
    return last.elapsed() > 0.0 ? count_ / last.elapsed() / lengthOf(line_.to - line_.from)
                                : undefinedValue("the recording has no duration");
  }

 private:
  bool isSet() const { return line_.from != line_.to; }
  /// Over the seam a step continues beyond one end and starts beyond the other.
  bool hasCrossed(const Vec2& before, const Vec2& now, const Seam& seam) const {
    const Vec2 goingOn = seam.nearest(now, before);
    return crosses(before, goingOn, line_) ||
           (goingOn != now && crosses(before - (goingOn - now), now, line_));
  }

  Line line_;
  double count_ = 0.0;
};

constexpr char kFlowLineMetrics[] = R"(
= Social Behavior|neutral|people|Seyfried et al. 2005
line_crossings|Line crossings by people||0, 1, ...|number of steps from q_(i-1) to q_i of people (present at both, without event enter since) that cross the
  line from A = (flow_line_x1, flow_line_y1) to B = (flow_line_x2, flow_line_y2), in both directions: cross(B - A, q - A) > 0 holds at one end only, and the
  crossing point is between A and B, ends included; over the seam the step continues beyond either end; undefined if A = B
line_flow|Flow through the line|1/(m s)|[0, inf)|line_crossings / T / |B - A|
)";

}  // namespace

void addFlowLine(MetricRegistry& to) {
  to.add(kFlowLineMetrics, {{"line_crossings", metricOf<LineCrossings>(&LineCrossings::count)},
                            {"line_flow", metricOf<LineCrossings>(&LineCrossings::flow)}});
}

}  // namespace metrics
