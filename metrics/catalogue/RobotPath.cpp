#include "metrics/Motion.h"

namespace metrics {

namespace {

MetricValue pathLength(const RobotWay& way, const Instant& /*last*/) {
  return numberValue(way.length());
}

MetricValue cumulativeHeadingChanges(const RobotWay& way, const Instant& /*last*/) {
  return withSeries(numberValue(way.turning().sum()), way.turning().terms());
}

}  // namespace

void addRobotPath(MetricRegistry& to) {
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"path_length", "Path length", "m", Category::Navigation, Better::Lower, Needs{},
          "sum of |p_(i+1) - p_i|", source, "[0, inf)", Kind::Number, 2, ""},
         streamOf<RobotWay>(pathLength));
  to.add({"cumulative_heading_changes", "Cumulative heading changes", "rad", Category::Motion,
          Better::Lower, Needs{}, "sum of |wrap(psi_(i+1) - psi_i)|", source, "[0, inf)",
          Kind::Number, 3, ""},
         streamOf<RobotWay>(cumulativeHeadingChanges));
}

}  // namespace metrics
