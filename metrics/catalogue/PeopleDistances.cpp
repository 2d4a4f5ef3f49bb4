#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MetricValue nobody(const Instant& last) {
  return undefinedValue(last.isOriginal() ? "ValueError: nobody in the record"
                                          : "nobody in the record");
}

/// The original's series leaves out samples without people.
MetricValue averageDistance(const Figures& closest, const Instant& last) {
  std::vector<double> series = closest.series();
  if (last.isOriginal()) {
    series.erase(std::remove_if(series.begin(), series.end(),
                                [](double distance) { return std::isnan(distance); }),
                 series.end());
  }
  const double divisor = last.isOriginal() ? static_cast<double>(last.count()) : closest.count();
  MetricValue value =
      divisor > 0.0 ? numberValue(closest.sum() / divisor) : undefinedValue("nobody in the record");
  return withSeries(std::move(value), std::move(series));
}

MetricValue minimumDistance(const Figures& closest, const Instant& last) {
  return closest.count() > 0.0 ? numberValue(closest.least()) : nobody(last);
}

double farthestGap(const Sample& sample, const MetricParameters& /*parameters*/) {
  double farthest = kNaN;
  for (const Person& person : sample.people) {
    const double value = gap(sample.robot, person);
    farthest = value <= farthest ? farthest : value;
  }
  return farthest;
}

MetricValue maximumDistance(const Figures& farthest, const Instant& last) {
  if (!(farthest.count() > 0.0)) {
    return nobody(last);
  }
  return numberValue(last.isOriginal() ? farthest.largest() : std::max(farthest.largest(), 0.0));
}

}  // namespace

void addPeopleDistances(MetricRegistry& to) {
  const Needs needs{true, true};
  const char source[] = "Perez-Higueras, Caballero, Merino, IJSR 2018";
  to.add({"avg_distance_to_closest_person", "Mean distance to the closest person", "m",
          Category::Social, Better::Higher, needs,
          "mean of c_i over the samples with people; c_i = min over a of max(gap(i,a), 0)", source,
          "[0, inf)", Kind::Number, 4, ""},
         figuresOf<closestGapTerm>(averageDistance));
  to.add({"minimum_distance_to_people", "Smallest distance to people", "m", Category::Social,
          Better::Higher, needs, "min over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 5, ""},
         figuresOf<closestGapTerm>(minimumDistance));
  to.add({"maximum_distance_to_people", "Largest distance to people", "m", Category::Navigation,
          Better::Neutral, needs, "max over i, a of max(gap(i,a), 0)", source, "[0, inf)",
          Kind::Number, 6, ""},
         figuresOf<farthestGap>(maximumDistance));
}

}  // namespace metrics
