#include "metrics/ContactEvents.h"

namespace metrics {

namespace {

template <double MetricParameters::*kLimit>
void addZone(MetricRegistry& to, const std::string& zone) {
  using Contacts = ContactsWithin<kLimit>;
  const Needs needs{true, true};
  const std::string source = "SEAN 2.0 (distance violations)";
  const std::string formula = "number of times a person's gap falls below " + zone + "_distance";
  to.add({zone + "_zone_entries", "Entries into the " + zone + " zone", "", Category::Social,
          Better::Lower, needs, formula, source, "0, 1, ...", Kind::Count, 0, ""},
         streamOf<Contacts>(&Contacts::all));
  to.add({zone + "_zone_entries_by_robot", "Entries of the robot into the " + zone + " zone", "",
          Category::Social, Better::Lower, needs, formula + ", the robot closing in faster", source,
          "0, 1, ...", Kind::Count, 0, ""},
         streamOf<Contacts>(&Contacts::byRobot));
  to.add({zone + "_zone_entries_by_person", "Entries of people into the " + zone + " zone", "",
          Category::Social, Better::Lower, needs, formula + ", the person closing in faster",
          source, "0, 1, ...", Kind::Count, 0, ""},
         streamOf<Contacts>(&Contacts::byPerson));
}

}  // namespace

void addZoneEntries(MetricRegistry& to) {
  addZone<&MetricParameters::intimateDistance>(to, "intimate");
  addZone<&MetricParameters::personalDistance>(to, "personal");
}

}  // namespace metrics
