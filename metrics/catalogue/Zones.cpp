#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "metrics/Motion.h"
#include "metrics/TermSums.h"

/// The zones round people after Hall: how long the robot is in them, how often it enters.
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
constexpr std::size_t kBandCount = std::size(kBands);

bool isInBand(double distance, const Band& band, const MetricParameters& parameters) {
  const double inner = band.inner != nullptr ? parameters.*band.inner : 0.0;
  return distance >= inner && distance < parameters.*band.outer;
}

/// The samples whose distance lies in each of the bands; NaN, nobody there, is in none.
class BandCounts : public Accumulator {
 public:
  MetricValue value(std::size_t band, const Instant& last) const {
    const double share = 100.0 / static_cast<double>(last.count()) * counts_[band].sum();
    return withSeries(share, counts_[band].terms(), Kind::Count);
  }

 protected:
  void count(const Instant& at, double distance) {
    for (std::size_t k = 0; k < kBandCount; ++k) {
      counts_[k].add(at, isInBand(distance, kBands[k], at.parameters) ? 1.0 : 0.0);
    }
  }

 private:
  std::array<SeriesSum, kBandCount> counts_;
};

class GapBands : public BandCounts {
 public:
  void add(const Instant& at) override { count(at, at.term(closestGapTerm)); }
};

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
class GroupDistances : public BandCounts {
 public:
  void add(const Instant& at) override {
    const std::map<int, Centre> centres = centresOf(at.now, at.parameters);
    if (!at.isOriginal()) {
      count(at, nearestOf(centres, at));
      return;
    }
    if (at.before == nullptr) {
      for (const auto& [id, centre] : centres) {
        groups_.insert(id);
      }
    }
    count(at, nearestOfFirst(centres, at.now));
  }

  MetricValue value(std::size_t band, const Instant& last) const {
    if (last.isOriginal() && groups_.empty()) {
      return 0.0;
    }
    return failure_.empty() ? BandCounts::value(band, last) : undefinedValue(failure_);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  static double nearestOf(const std::map<int, Centre>& centres, const Instant& at) {
    double nearest = kFar;
    for (const auto& [id, centre] : centres) {
      if (centre.members >= at.parameters.groupMinimumMembers) {
        nearest = std::min(nearest, distanceTo(centre, at.now.robot));
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

  std::set<int> groups_;  // of the first sample
  std::string failure_;
};

void addBand(MetricRegistry& to, std::size_t index) {
  const Band& band = kBands[index];
  const std::string name = band.name;
  to.add(
      {name + "_space_intrusions", "Intrusions into the " + name + " space", "%", Category::Social,
       Better::Lower, Needs{true, true}, "100/N * samples with c_i in the " + name + " band",
       "Perez-Higueras, Caballero, Merino, IJSR 2018; Hall 1966", "[0, 100]", Kind::Number,
       band.hunav},
      streamOfPart<GapBands>(index));
  to.add({"group_" + name + "_space_intrusions", "Intrusions into the " + name + " space of groups",
          "%", Category::Social, Better::Lower, Needs{true, true, true},
          "100/N * samples with x_i in the " + name +
              " band; x_i = max(0, min over groups of |p_i - centre| - r_r)",
          "Perez-Higueras, Caballero, Merino, IJSR 2018, after Okal and Arras 2016", "[0, 100]",
          Kind::Number, band.hunavGroup},
         streamOfPart<GroupDistances>(index));
}

template <double MetricParameters::*kLimit>
void addZone(MetricRegistry& to, const std::string& zone) {
  const auto add = [&](const char* part, const std::string& who, const char* how, Stream stream) {
    to.add({zone + "_zone_entries" + part, "Entries " + who + "into the " + zone + " zone", "",
            Category::Social, Better::Lower, Needs{true, true},
            "number of times a person's gap falls below " + zone + "_distance" + how,
            "SEAN 2.0 (distance violations)", "0, 1, ...", Kind::Count},
           std::move(stream));
  };
  using Entries = ContactsWithin<kLimit>;
  add("", "", "", streamOf<Entries>(&Contacts::count));
  add("_by_robot", "of the robot ", ", the robot closing in faster",
      streamOf<Entries>(&Contacts::byRobot));
  add("_by_person", "of people ", ", the person closing in faster",
      streamOf<Entries>(&Contacts::byPerson));
}

}  // namespace

void addZones(MetricRegistry& to) {
  for (std::size_t band = 0; band < kBandCount; ++band) {
    addBand(to, band);
  }
  addZone<&MetricParameters::intimateDistance>(to, "intimate");
  addZone<&MetricParameters::personalDistance>(to, "personal");
}

}  // namespace metrics
