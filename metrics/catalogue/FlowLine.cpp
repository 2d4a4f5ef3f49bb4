#include "metrics/MetricRegistry.h"

/// People through a line, with or without a robot.
namespace metrics {

namespace {

struct Line {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};

/// The way from a to b meets the line between its ends.
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

  void add(const Recording& recording, std::size_t sample) override {
    if (sample == 0 || !isSet()) {
      return;
    }
    const std::vector<Person>& before = recording.samples[sample - 1].people;
    std::size_t next = 0;
    for (const Person& person : recording.samples[sample].people) {
      const Person* then =
          findInOrder(before, next, [&](const Person& other) { return other.id == person.id; });
      count_ += then != nullptr && crosses(then->position, person.position, line_) ? 1.0 : 0.0;
    }
  }

  MetricValue count() const {
    return isSet() ? countValue(count_) : undefinedValue("no line is set (flow_line_x1 ...)");
  }
  MetricValue flow(const Recording& recording) const {
    if (!isSet()) {
      return count();
    }
    return recording.duration() > 0.0
               ? numberValue(count_ / recording.duration() / lengthOf(line_.to - line_.from))
               : undefinedValue("the record has no duration");
  }

 private:
  bool isSet() const { return line_.from != line_.to; }

  Line line_;
  double count_ = 0.0;
};

using Reader = MetricValue (*)(const LineCrossings&, const Recording&, const MetricParameters&);

void addLine(MetricRegistry& to, MetricInfo info, Reader read) {
  info.category = Category::Social;
  info.better = Better::Neutral;
  info.needs = Needs{false, true};
  info.source = "Seyfried et al. 2005";
  to.addStream(std::move(info),
               streamOf<LineCrossings>("line", read, [](const MetricParameters& parameters) {
                 return std::make_unique<LineCrossings>(parameters);
               }));
}

}  // namespace

void addFlowLine(MetricRegistry& to) {
  MetricInfo crossings;
  crossings.key = "line_crossings";
  crossings.name = "People through the line";
  crossings.formula = "number of steps of people that cross the line (flow_line_x1 ...), both ways";
  crossings.range = "0, 1, ...";
  crossings.kind = Kind::Count;
  addLine(to, crossings,
          [](const LineCrossings& line, const Recording& /*recording*/,
             const MetricParameters& /*parameters*/) { return line.count(); });
  MetricInfo flow;
  flow.key = "line_flow";
  flow.name = "Flow through the line";
  flow.unit = "1/(m s)";
  flow.formula = "line_crossings / T / length of the line";
  flow.range = "[0, inf)";
  addLine(to, flow,
          [](const LineCrossings& line, const Recording& recording,
             const MetricParameters& /*parameters*/) { return line.flow(recording); });
}

}  // namespace metrics
