#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "metrics/SeriesMetric.h"

namespace metrics {

namespace {

/// A band of Hall's proxemics: inner edge included, outer edge not.
struct Band {
  const char* name;
  double MetricParameters::*inner;  // null: from 0 on
  double MetricParameters::*outer;
  int hunav;       // number of the metric of persons
  int hunavGroup;  // and of groups
};

constexpr Band kBands[] = {
    {"intimate", nullptr, &MetricParameters::intimateDistance, 7, 10},
    {"personal", &MetricParameters::intimateDistance, &MetricParameters::personalDistance, 8, 11},
    {"social", &MetricParameters::personalDistance, &MetricParameters::socialDistance, 9, 12},
};

bool isInBand(double distance, const Band& band, const MetricParameters& parameters) {
  const double inner = band.inner != nullptr ? parameters.*band.inner : 0.0;
  return distance >= inner && distance < parameters.*band.outer;
}

MetricValue percentage(std::vector<double> series) {
  const double share = 100.0 / static_cast<double>(series.size()) * sumOf(series);
  return withSeries(numberValue(share), std::move(series), Kind::Count);
}

MetricValue intrusions(const std::vector<double>& closest, const MetricParameters& parameters,
                       const Band& band) {
  std::vector<double> series;
  series.reserve(closest.size());
  for (const double distance : closest) {  // NaN, nobody there, is in no band
    series.push_back(isInBand(distance, band, parameters) ? 1.0 : 0.0);
  }
  return percentage(std::move(series));
}

/// Sum and number of the members' interaction points.
struct Centre {
  Vec2 sum = Vec2::Zero();
  int members = 0;
};

std::map<int, Centre> centresOf(const Sample& sample, const MetricParameters& parameters) {
  std::map<int, Centre> centres;
  for (const Person& person : sample.people) {
    if (person.group != -1) {
      Centre& centre = centres[person.group];
      centre.sum +=
          person.position + parameters.groupInteractionDistance * base::directionOf(person.heading);
      ++centre.members;
    }
  }
  return centres;
}

double distanceTo(const Centre& centre, const Robot& robot) {
  const Vec2 middle = centre.sum / static_cast<double>(centre.members);
  return std::max(lengthOf(robot.position - middle) - robot.radius, 0.0);
}

MetricValue groupIntrusions(const Recording& recording, const MetricParameters& parameters,
                            const Band& band) {
  std::vector<double> series;
  for (const Sample& sample : recording.samples) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [id, centre] : centresOf(sample, parameters)) {
      if (centre.members >= parameters.groupMinimumMembers) {
        nearest = std::min(nearest, distanceTo(centre, sample.robot));
      }
    }
    series.push_back(isInBand(nearest, band, parameters) ? 1.0 : 0.0);
  }
  return percentage(std::move(series));
}

/// The original takes the groups of the first sample, singles too, for the whole run.
MetricValue originalGroupIntrusions(const Recording& recording, const MetricParameters& parameters,
                                    const Band& band) {
  std::set<int> groups;
  for (const Person& person : recording.samples.front().people) {
    if (person.group != -1) {
      groups.insert(person.group);
    }
  }
  if (groups.empty()) {
    return numberValue(0.0);
  }
  std::vector<double> series;
  for (const Sample& sample : recording.samples) {
    if (sample.people.empty()) {
      return undefinedValue("ValueError: nobody at a sample");
    }
    const std::map<int, Centre> centres = centresOf(sample, parameters);
    double nearest = std::numeric_limits<double>::infinity();
    for (const int group : groups) {
      const auto found = centres.find(group);
      if (found == centres.end()) {
        return undefinedValue("ZeroDivisionError: a group lost its members");
      }
      nearest = std::min(nearest, distanceTo(found->second, sample.robot));
    }
    series.push_back(isInBand(nearest, band, parameters) ? 1.0 : 0.0);
  }
  return percentage(std::move(series));
}

void addBand(MetricRegistry& to, const Band& band) {
  const std::string name = band.name;
  addSeriesMetric(
      to,
      {name + "_space_intrusions", "Intrusions into the " + name + " space", "%", Category::Social,
       Better::Lower, Needs{true, true}, "100/N * samples with c_i in the " + name + " band",
       "Perez-Higueras, Caballero, Merino, IJSR 2018; Hall 1966", "[0, 100]", Kind::Number,
       band.hunav, ""},
      closestGapTerm,
      [&band](const std::vector<double>& closest, const Recording& /*recording*/,
              const MetricParameters& parameters) {
        return intrusions(closest, parameters, band);
      });
  to.add({"group_" + name + "_space_intrusions", "Intrusions into the " + name + " space of groups",
          "%", Category::Social, Better::Lower, Needs{true, true, true},
          "100/N * samples with x_i in the " + name +
              " band; x_i = max(0, min over groups of |p_i - centre| - r_r)",
          "Perez-Higueras, Caballero, Merino, IJSR 2018, after Okal and Arras 2016", "[0, 100]",
          Kind::Number, band.hunavGroup, ""},
         [&band](const Recording& recording, const MetricParameters& parameters) {
           return parameters.profile == Profile::Hunav2
                      ? originalGroupIntrusions(recording, parameters, band)
                      : groupIntrusions(recording, parameters, band);
         });
}

}  // namespace

void addProxemics(MetricRegistry& to) {
  for (const Band& band : kBands) {
    addBand(to, band);
  }
}

}  // namespace metrics
