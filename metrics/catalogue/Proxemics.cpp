#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>

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

/// Distance to the nearest group at each sample. The original takes the groups of the first sample,
/// singles too, for the whole run.
class GroupDistances : public Accumulator {
 public:
  explicit GroupDistances(const MetricParameters& parameters) : parameters_(parameters) {}

  void add(const Recording& recording, std::size_t sample) override {
    const Sample& now = recording.samples[sample];
    const std::map<int, Centre> centres = centresOf(now, parameters_);
    if (!isOriginal()) {
      nearest_.push_back(nearestOf(centres, now.robot));
      return;
    }
    if (sample == 0) {
      for (const auto& [id, centre] : centres) {
        groups_.insert(id);
      }
    }
    nearest_.push_back(nearestOfFirst(centres, now));
  }

  MetricValue value(const Band& band, const MetricParameters& parameters) const {
    if (isOriginal() && groups_.empty()) {
      return numberValue(0.0);
    }
    return failure_.empty() ? intrusions(nearest_, parameters, band) : undefinedValue(failure_);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  bool isOriginal() const { return parameters_.profile == Profile::Hunav2; }

  double nearestOf(const std::map<int, Centre>& centres, const Robot& robot) const {
    double nearest = kFar;
    for (const auto& [id, centre] : centres) {
      if (centre.members >= parameters_.groupMinimumMembers) {
        nearest = std::min(nearest, distanceTo(centre, robot));
      }
    }
    return nearest;
  }

  double nearestOfFirst(const std::map<int, Centre>& centres, const Sample& now) {
    double nearest = kFar;
    for (const int group : groups_) {
      const auto found = centres.find(group);
      if (found != centres.end()) {
        nearest = std::min(nearest, distanceTo(found->second, now.robot));
      } else if (failure_.empty()) {
        failure_ = now.people.empty() ? "ValueError: nobody at a sample"
                                      : "ZeroDivisionError: a group lost its members";
      }
    }
    return nearest;
  }

  MetricParameters parameters_;
  std::vector<double> nearest_;
  std::set<int> groups_;  // of the first sample
  std::string failure_;
};

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
  to.addStream(
      {"group_" + name + "_space_intrusions", "Intrusions into the " + name + " space of groups",
       "%", Category::Social, Better::Lower, Needs{true, true, true},
       "100/N * samples with x_i in the " + name +
           " band; x_i = max(0, min over groups of |p_i - centre| - r_r)",
       "Perez-Higueras, Caballero, Merino, IJSR 2018, after Okal and Arras 2016", "[0, 100]",
       Kind::Number, band.hunavGroup, ""},
      streamOf<GroupDistances>(
          "distances of groups",
          [&band](const GroupDistances& distances, const Recording& /*recording*/,
                  const MetricParameters& parameters) { return distances.value(band, parameters); },
          [](const MetricParameters& parameters) {
            return std::make_unique<GroupDistances>(parameters);
          }));
}

}  // namespace

void addProxemics(MetricRegistry& to) {
  for (const Band& band : kBands) {
    addBand(to, band);
  }
}

}  // namespace metrics
