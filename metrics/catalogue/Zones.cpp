#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

/// Hall's proxemic zones of people: time of the robot in them, number of entries.
namespace metrics {

namespace {

/// A band of Hall's proxemics, including its inner edge and excluding its outer edge.
struct Band {
  double MetricParameters::*inner;  // null: from 0
  double MetricParameters::*outer;
};

constexpr Band kBands[] = {
    {nullptr, &MetricParameters::intimateDistance},
    {&MetricParameters::intimateDistance, &MetricParameters::personalDistance},
    {&MetricParameters::personalDistance, &MetricParameters::socialDistance},
};
constexpr std::size_t kBandCount = std::size(kBands);

bool isInBand(double distance, const Band& band, const MetricParameters& parameters) {
  const double inner = band.inner != nullptr ? parameters.*band.inner : 0.0;
  return distance >= inner && distance < parameters.*band.outer;
}

/// Samples whose distance lies in each band; NaN (no people) is in none.
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
  void add(const Instant& at) override { count(at, at.term(smallestGapTerm)); }
};

/// Sum and number of the members' interaction points.
struct Centre {
  Vec2 sum = Vec2::Zero();
  int members = 0;
};

std::map<int, Centre> centresOf(const Sample& sample, const MetricParameters& parameters) {
  std::map<int, Centre> centres;
  for (const Pedestrian& person : sample.people) {
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

/// Distance to the nearest group at each sample. HuNavSim's evaluator uses the groups of the first
/// sample, including single members, for the whole run.
class GroupDistances : public BandCounts {
 public:
  void add(const Instant& at) override {
    const std::map<int, Centre> centres = centresOf(at.now, at.parameters);
    if (!at.usesHunavProfile()) {
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
    if (last.usesHunavProfile() && groups_.empty()) {
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
        failure_ = now.people.empty() ? "ValueError: no people at a sample"
                                      : "ZeroDivisionError: a group has no members";
      }
    }
    return nearest;
  }

  std::set<int> groups_;  // at the first sample
  std::string failure_;
};

using IntimateEntries = ContactsWithin<&MetricParameters::intimateDistance>;
using PersonalEntries = ContactsWithin<&MetricParameters::personalDistance>;

constexpr char kZonesMetrics[] = R"(
= Social Behavior|lower|robot, people|Perez-Higueras, Caballero, Merino, IJSR 2018; Hall 1966
7 intimate_space_intrusions|Intrusions into the intimate space|%|[0, 100]|share of samples with c_i in the intimate band (intimate_distance): surface to
  surface, whereas Hall measured between people
8 personal_space_intrusions|Intrusions into the personal space|%|[0, 100]|share of samples with c_i in the personal band (intimate_distance, personal_distance):
  surface to surface, whereas Hall measured between people
9 social_space_intrusions|Intrusions into the social space|%|[0, 100]|share of samples with c_i in the social band (personal_distance, social_distance): surface
  to surface, whereas Hall measured between people
= Social Behavior|lower|robot, people, groups|Perez-Higueras, Caballero, Merino, IJSR 2018, after Okal and Arras 2016
10 group_intimate_space_intrusions|Intrusions into the intimate space of groups|%|[0, 100]|share of samples with x_i in the intimate band
  (intimate_distance), x_i from the centre of the nearest group to the surface of the robot; 0 without groups
11 group_personal_space_intrusions|Intrusions into the personal space of groups|%|[0, 100]|share of samples with x_i in the personal band
  (intimate_distance, personal_distance), x_i from the centre of the nearest group to the surface of the robot; 0 without groups
12 group_social_space_intrusions|Intrusions into the social space of groups|%|[0, 100]|share of samples with x_i in the social band
  (personal_distance, social_distance), x_i from the centre of the nearest group to the surface of the robot; 0 without groups
= Social Behavior|lower|robot, people|SEAN 2.0 (distance violations)
intimate_zone_entries|Entries into the intimate zone||0, 1, ...|number of times a person's gap falls below intimate_distance
intimate_zone_entries_by_robot|Entries of the robot into the intimate zone||0, 1, ...|those of intimate_zone_entries caused by the robot or by both, according
  to who approaches faster (intimate_distance; METRICS.md, Distances and zones)
intimate_zone_entries_by_person|Entries of people into the intimate zone||0, 1, ...|those of intimate_zone_entries caused by the person or by both, according to
  who approaches faster (intimate_distance)
personal_zone_entries|Entries into the personal zone||0, 1, ...|number of times a person's gap falls below personal_distance
personal_zone_entries_by_robot|Entries of the robot into the personal zone||0, 1, ...|those of personal_zone_entries caused by the robot or by both, according
  to who approaches faster (personal_distance; METRICS.md, Distances and zones)
personal_zone_entries_by_person|Entries of people into the personal zone||0, 1, ...|those of personal_zone_entries caused by the person or by both, according to
  who approaches faster (personal_distance)
)";

}  // namespace

void addZones(MetricRegistry& to) {
  to.add(kZonesMetrics,
         {{"intimate_space_intrusions", metricOfPart<GapBands>(0)},
          {"group_intimate_space_intrusions", metricOfPart<GroupDistances>(0)},
          {"personal_space_intrusions", metricOfPart<GapBands>(1)},
          {"group_personal_space_intrusions", metricOfPart<GroupDistances>(1)},
          {"social_space_intrusions", metricOfPart<GapBands>(2)},
          {"group_social_space_intrusions", metricOfPart<GroupDistances>(2)},
          {"intimate_zone_entries", metricOf<IntimateEntries>(&Contacts::count)},
          {"intimate_zone_entries_by_robot", metricOf<IntimateEntries>(&Contacts::byRobot)},
          {"intimate_zone_entries_by_person", metricOf<IntimateEntries>(&Contacts::byPerson)},
          {"personal_zone_entries", metricOf<PersonalEntries>(&Contacts::count)},
          {"personal_zone_entries_by_robot", metricOf<PersonalEntries>(&Contacts::byRobot)},
          {"personal_zone_entries_by_person", metricOf<PersonalEntries>(&Contacts::byPerson)}});
}

}  // namespace metrics
