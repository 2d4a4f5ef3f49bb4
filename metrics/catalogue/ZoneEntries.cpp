#include "metrics/ContactEvents.h"

namespace metrics {

namespace {

using Culprit = const std::vector<double>& (ContactEvents::*)() const;

ContactReader entries() {
  return [](const ContactEvents& events, const Recording& /*recording*/,
            const MetricParameters& /*parameters*/) { return countValue(events.count()); };
}

ContactReader entriesBy(Culprit culprit) {
  return [culprit](const ContactEvents& events, const Recording& /*recording*/,
                   const MetricParameters& /*parameters*/) {
    const std::vector<double>& series = (events.*culprit)();
    return withSeries(countValue(sumOf(series)), series, Kind::Count);
  };
}

void addZone(MetricRegistry& to, const std::string& zone, double MetricParameters::*limit) {
  const Needs needs{true, true};
  const std::string source = "SEAN 2.0 (distance violations)";
  const std::string formula = "number of times a person's gap falls below " + zone + "_distance";
  to.addStream({zone + "_zone_entries", "Entries into the " + zone + " zone", "", Category::Social,
                Better::Lower, needs, formula, source, "0, 1, ...", Kind::Count, 0, ""},
               contactStream(limit, zone, entries()));
  to.addStream({zone + "_zone_entries_by_robot", "Entries of the robot into the " + zone + " zone",
                "", Category::Social, Better::Lower, needs,
                formula + ", the robot closing in faster", source, "0, 1, ...", Kind::Count, 0, ""},
               contactStream(limit, zone, entriesBy(&ContactEvents::byRobot)));
  to.addStream(
      {zone + "_zone_entries_by_person", "Entries of people into the " + zone + " zone", "",
       Category::Social, Better::Lower, needs, formula + ", the person closing in faster", source,
       "0, 1, ...", Kind::Count, 0, ""},
      contactStream(limit, zone, entriesBy(&ContactEvents::byPerson)));
}

}  // namespace

void addZoneEntries(MetricRegistry& to) {
  addZone(to, "intimate", &MetricParameters::intimateDistance);
  addZone(to, "personal", &MetricParameters::personalDistance);
}

}  // namespace metrics
