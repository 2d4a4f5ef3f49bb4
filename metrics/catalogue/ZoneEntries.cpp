#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

/// Number of times each person comes within a gap, with who closes in.
MetricFunction entriesWithin(double MetricParameters::*limit) {
  return [limit](const Recording& recording, const MetricParameters& parameters) {
    return countValue(entryCount(recording, parameters.*limit));
  };
}

MetricFunction entriesBy(double MetricParameters::*limit,
                         std::vector<double> ContactEvents::*culprit) {
  return [limit, culprit](const Recording& recording, const MetricParameters& parameters) {
    ContactEvents events = contactEvents(recording, parameters.*limit);
    const double count = sumOf(events.*culprit);
    return withSeries(countValue(count), std::move(events.*culprit), Kind::Count);
  };
}

void addZone(MetricRegistry& to, const std::string& zone, double MetricParameters::*limit) {
  const Needs needs{true, true};
  const std::string source = "SEAN 2.0 (distance violations)";
  const std::string formula = "number of times a person's gap falls below " + zone + "_distance";
  to.add({zone + "_zone_entries", "Entries into the " + zone + " zone", "", Category::Social,
          Better::Lower, needs, formula, source, "0, 1, ...", Kind::Count, 0, ""},
         entriesWithin(limit));
  to.add({zone + "_zone_entries_by_robot", "Entries of the robot into the " + zone + " zone", "",
          Category::Social, Better::Lower, needs, formula + ", the robot closing in faster", source,
          "0, 1, ...", Kind::Count, 0, ""},
         entriesBy(limit, &ContactEvents::robotOnPerson));
  to.add({zone + "_zone_entries_by_person", "Entries of people into the " + zone + " zone", "",
          Category::Social, Better::Lower, needs, formula + ", the person closing in faster",
          source, "0, 1, ...", Kind::Count, 0, ""},
         entriesBy(limit, &ContactEvents::personOnRobot));
}

}  // namespace

void addZoneEntries(MetricRegistry& to) {
  addZone(to, "intimate", &MetricParameters::intimateDistance);
  addZone(to, "personal", &MetricParameters::personalDistance);
}

}  // namespace metrics
