#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

MetricValue pathLengthValue(const Recording& recording, const MetricParameters& /*parameters*/) {
  return numberValue(pathLength(recording));
}

MetricValue cumulativeHeadingChanges(const Recording& recording,
                                     const MetricParameters& /*parameters*/) {
  std::vector<double> changes = headingChanges(recording);
  const double sum = sumOf(changes);
  return withSeries(numberValue(sum), std::move(changes));
}

}  // namespace

void addRobotPath(MetricRegistry& to) {
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"path_length", "Path length", "m", Category::Navigation, Better::Lower, Needs{},
          "sum of |p_(i+1) - p_i|", source, "[0, inf)", Kind::Number, 2, ""},
         pathLengthValue);
  to.add({"cumulative_heading_changes", "Cumulative heading changes", "rad", Category::Motion,
          Better::Lower, Needs{}, "sum of |wrap(psi_(i+1) - psi_i)|", source, "[0, inf)",
          Kind::Number, 3, ""},
         cumulativeHeadingChanges);
}

}  // namespace metrics
