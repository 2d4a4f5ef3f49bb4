#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "metrics/MapFields.h"
#include "metrics/TermStatistics.h"

/// Intrusion of the robot into personal and group space.
namespace metrics {

namespace {

std::vector<double> inPercent(std::vector<double> values) {
  for (double& value : values) {
    value *= 100.0;
  }
  return values;
}

double largest(const TermStatistics& shares) {
  return 100.0 * shares.largest();
}

/// Weighted by time; 0 if undefined at all samples.
double average(const TermStatistics& shares) {
  return std::fmax(100.0 * shares.timeMean(), 0.0);
}

MetricValue averageWithSeries(const TermStatistics& shares) {
  return withSeries(average(shares), inPercent(shares.series()));
}

/// Exponent of the personal space at the robot's position, 0 at its centre.
double outsideness(const Pedestrian& person, const Robot& robot) {
  const Vec2 offset = robot.position - person.position;
  const Vec2 local(person.pair.ahead.dot(offset), base::cross(person.pair.ahead, offset));
  return personalSpaceOf(person.speed).outsideness(local);
}

/// A lower bound of outsideness(): uses the largest variance, which is the one ahead.
double leastOutsideness(const Pedestrian& person, const Robot& robot) {
  constexpr double kSlack = 1.0 - 1e-9;
  return kSlack * (robot.position - person.position).squaredNorm() /
         (2.0 * personalSpaceOf(person.speed).ahead);
}

/// Deepest intrusion of a sample; NaN without people.
double deepestInPerson(const Instant& at) {
  const Robot& robot = at.now.robot;
  double least = std::numeric_limits<double>::infinity();
  for (const Pedestrian& person : at.now.people) {
    if (leastOutsideness(person, robot) < least) {
      least = std::min(least, outsideness(person, robot));
    }
  }
  return at.now.people.empty() ? kNaN : std::exp(-least);
}

MetricValue averageInPerson(const TermStatistics& depths) {
  const double mean = depths.time() > 0.0 ? 100.0 * depths.integral() / depths.time() : 0.0;
  return withSeries(mean, inPercent(depths.series()));
}

double smallest(const TermStatistics& depths) {
  return 100.0 * depths.least();
}

/// Share of the time with people.
class DeepIntrusionTime : public Accumulator {
 public:
  void add(const Instant& at) override {
    const double depth = at.term(deepestInPerson);
    peopled_.take(at, !std::isnan(depth));
    deep_.take(at, depth > at.parameters.gaussianThreshold);
  }
  double share() const { return deep_.percentOf(peopled_.time()); }

 private:
  ConditionTime peopled_, deep_;
};

using Members = std::vector<const Pedestrian*>;

/// Calls visit(id, members) for the groups with enough members, by id.
template <class Visit>
void forEachGroup(const Instant& at, Visit visit) {
  Members all;
  for (const Pedestrian& person : at.now.people) {
    if (person.group != -1) {
      all.push_back(&person);
    }
  }
  std::sort(all.begin(), all.end(), [](const Pedestrian* a, const Pedestrian* b) {
    return a->group != b->group ? a->group < b->group : a < b;
  });
  Members members;
  for (auto first = all.begin(); first != all.end();) {
    const auto end = std::find_if(first, all.end(), [first](const Pedestrian* person) {
      return person->group != (*first)->group;
    });
    members.assign(first, end);
    if (static_cast<double>(members.size()) >= at.parameters.groupMinimumMembers) {
      visit(members.front()->group, members);
    }
    first = end;
  }
}

/// A quarter of the extent of the members along the direction, including their radii.
double quarterSpan(const Members& members, const Vec2& direction) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Pedestrian* member : members) {
    const double along = direction.dot(member->position);
    low = std::min(low, along - member->radius);
    high = std::max(high, along + member->radius);
  }
  return (high - low) / 4.0;
}

/// 1 at the centre of the members, decreasing along the axes of their arrangement.
double groupIntrusion(const Members& members, const Vec2& position) {
  Vec2 centre = Vec2::Zero();
  for (const Pedestrian* member : members) {
    centre += member->position / static_cast<double>(members.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Pedestrian* member : members) {
    const Vec2 from = member->position - centre;
    xx += from.x() * from.x();
    xy += from.x() * from.y();
    yy += from.y() * from.y();
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);  // of the long axis
  const Vec2 along(std::cos(angle), std::sin(angle));
  const Vec2 aside(-along.y(), along.x());
  const double u = along.dot(position - centre) / quarterSpan(members, along);
  const double w = aside.dot(position - centre) / quarterSpan(members, aside);
  return std::exp(-(u * u + w * w) / 2.0);
}

double deepestInGroup(const Instant& at) {
  double value = kNaN;
  forEachGroup(at, [&](int /*group*/, const Members& members) {
    const double one = groupIntrusion(members, at.now.robot.position);
    value = one <= value ? value : one;
  });
  return value;
}

double largestInGroup(const TermStatistics& depths) {
  return std::fmax(100.0 * depths.largest(), 0.0);
}

/// Side of the line from a to b: left if > 0.
double side(const Vec2& a, const Vec2& b, const Vec2& point) {
  return base::cross(b - a, point - a);
}

/// Whether the robot passed between two members since the previous sample. Members must not have
/// jumped.
bool passesBetween(const Sample& before, const Sample& now, const Seam& seam, const Pedestrian& a,
                   const Pedestrian& b) {
  const Vec2 line = b.position - a.position;
  const double place = line.dot(now.robot.position - a.position);
  if (!(place >= 0.0 && place <= line.squaredNorm())) {
    return false;
  }
  const Pedestrian* const a0 = findPerson(before, a.id);
  const Pedestrian* const b0 = findPerson(before, b.id);
  if (a0 == nullptr || b0 == nullptr || hasJumped(a0->position, a, seam) ||
      hasJumped(b0->position, b, seam)) {
    return false;
  }
  const double then = side(a0->position, b0->position, before.robot.position);
  const double after = side(a.position, b.position, now.robot.position);
  return (then > 0.0) != (after > 0.0);
}

/// Whether the position is inside the convex hull: no line through two members has all members on
/// one side and the position on the other.
bool isInside(const Members& members, const Vec2& position) {
  if (members.size() < 3) {
    return false;
  }
  for (const Pedestrian* a : members) {
    for (const Pedestrian* b : members) {
      const bool isEdge =
          a != b && std::all_of(members.begin(), members.end(), [&](const Pedestrian* other) {
            return side(a->position, b->position, other->position) >= 0.0;
          });
      if (isEdge && side(a->position, b->position, position) < 0.0) {
        return false;
      }
    }
  }
  return true;
}

bool isCrossing(const Instant& at, const Members& members) {
  const Sample& now = at.now;
  if (isInside(members, now.robot.position)) {
    return true;
  }
  for (std::size_t k = 0; at.before != nullptr && k < members.size(); ++k) {
    for (std::size_t m = k + 1; m < members.size(); ++m) {
      if (passesBetween(*at.before, now, at.context.seam, *members[k], *members[m])) {
        return true;
      }
    }
  }
  return false;
}

class GroupCrossings : public Accumulator {
 public:
  void add(const Instant& at) override {
    forEachGroup(at, [&](int group, const Members& members) {
      const bool now = isCrossing(at, members);
      bool& crossed = crossed_[group];
      count_ += now && !crossed ? 1.0 : 0.0;
      crossed = now;
    });
  }
  double count() const { return count_; }

 private:
  std::map<int, bool> crossed_;
  double count_ = 0.0;
};

double gaussian(double x, double sigma) {
  return std::exp(-x * x / (2.0 * sigma * sigma));
}

/// Factor for speed and distance, an upper bound of the disturbance.
double presence(const Pedestrian& person, const Robot& robot, const MetricParameters& parameters) {
  const double separation = distance(robot, person);
  const double near = (robot.radius + parameters.disturbanceRadius) / separation;
  const double fast = robot.speed / parameters.disturbanceSpeed;
  return separation > 0.0 ? std::fmin(fast, 1.0) * std::fmin(near, 1.0) : 0.0;
}

/// How much the robot's heading disturbs the person: it points at the person and is visible to
/// them.
double disturbance(const Pedestrian& person, const Robot& robot, const Vec2& heading,
                   const MetricParameters& parameters) {
  const auto toLocal = [&person](const Vec2& vector) {
    return Vec2(person.pair.ahead.dot(vector), base::cross(person.pair.ahead, vector));
  };
  const Vec2 place = toLocal(robot.position - person.position);
  const Vec2 aim = toLocal(heading);
  const double way = -place.x() / aim.x();  // along the heading to the line across the person
  if (!std::isfinite(way) || way < 0.0) {
    return 0.0;
  }
  const double offset = place.y() + way * aim.y();
  return gaussian(offset, parameters.disturbanceRadius / 2.0) *
         gaussian(base::headingOf(place), parameters.disturbanceFieldOfView / 4.0);
}

double strongestDisturbance(const Instant& at) {
  const Robot& robot = at.now.robot;
  double value = at.now.people.empty() ? kNaN : 0.0;
  const Vec2 heading = base::directionOf(robot.heading);
  for (const Pedestrian& person : at.now.people) {
    const double most = presence(person, robot, at.parameters);
    if (most > value) {
      value = std::fmax(value, most * disturbance(person, robot, heading, at.parameters));
    }
  }
  return value;
}

constexpr char kIntrusionsMetrics[] = R"(
= Social Behavior|lower|robot, people|SRPB (Kirby's model)
personal_space_intrusion_gaussian|Intrusion into the Gaussian personal space|%|[0, 100]|time-weighted mean over the samples with people of the largest
  over a of 100 exp(-(x^2/(2 Vx) + y^2/(2 Vs))), 0 if there are none; x ahead and y to the left = p - q in the person's frame, Vf = max(2 |u|, 0.5), Vs =
  2/3 Vf, Vx = Vf if x > 0, else Vf/2 (m^2, u in m/s)
personal_space_intrusion_gaussian_min|Intrusion into the Gaussian personal space, smallest|%|[0, 100]|min over the samples with people of the same
personal_space_intrusion_gaussian_max|Intrusion into the Gaussian personal space, largest|%|[0, 100]|max over the samples with people of the same
personal_space_intrusion_gaussian_above|Time inside the Gaussian personal space|%|[0, 100]|100 * time at which the value of
  personal_space_intrusion_gaussian at the sample is > 100 gaussian_threshold / time of the samples with people, 0 without people
= Social Behavior|lower|robot, people, groups|SRPB
formation_space_intrusion|Intrusion into the space of groups|%|[0, 100]|time-weighted mean over the samples with groups of the largest over groups of
  100 exp(-(x^2/(2 X^2) + y^2/(2 Y^2))), 0 if there are none; x, y = p - m along and across the axis of the arrangement, X, Y = a quarter of the span
  along these (METRICS.md, Groups and crowds)
formation_space_intrusion_max|Intrusion into the space of groups, largest|%|[0, 100]|max over the samples of the same, 0 without groups
= Social Behavior|lower|robot, people, groups|Katyal et al. 2022; Okal and Arras 2016
group_crossings|Group crossings||0, 1, ...|number of pairs of a sample i and a group that the robot crosses at i and did not at the last sample before at which it had
  enough members (group_minimum_members), if there is one: it is inside the convex hull of its members (3 or more, the border included), or passed between two members a, b since
  i-1: 0 <= (b - a)(p - a) <= |b - a|^2 at i, cross(b - a, p - a) > 0 holds at one of i-1 and i only, both were present at i-1 and have not jumped
= Social Behavior|lower|robot, people|SRPB
heading_direction_disturbance|Disturbance by the robot's heading|%|[0, 100]|time-weighted mean over the samples with people of the largest over a of
  100 G(y + k m_y; disturbance_radius/2) * G(atan2(y, x); disturbance_field_of_view/4) * min(s/disturbance_speed, 1) * min((r_r +
  disturbance_radius)/d, 1); x ahead, y left = p - q and m = the robot's heading (unit vector), both in the person's frame, k = -x/m_x (where the line
  of its heading meets the line across the person; 0 for the whole if k < 0 or not finite, or d = 0), G(z; g) = exp(-z^2/(2 g^2)); 0 without people
heading_direction_disturbance_max|Disturbance by the robot's heading, largest|%|[0, 100]|max over the samples with people of the same
)";

}  // namespace

void addIntrusions(MetricRegistry& to) {
  to.add(
      kIntrusionsMetrics,
      {{"personal_space_intrusion_gaussian", seriesStatisticsOf<deepestInPerson>(averageInPerson)},
       {"personal_space_intrusion_gaussian_min",
        statisticsOf<deepestInPerson>(smallest, kNoPeople)},
       {"personal_space_intrusion_gaussian_max", statisticsOf<deepestInPerson>(largest, kNoPeople)},
       {"personal_space_intrusion_gaussian_above",
        metricOf<DeepIntrusionTime>(&DeepIntrusionTime::share)},
       {"formation_space_intrusion", statisticsOf<deepestInGroup>(average)},
       {"formation_space_intrusion_max", statisticsOf<deepestInGroup>(largestInGroup)},
       {"group_crossings", metricOf<GroupCrossings>(&GroupCrossings::count)},
       {"heading_direction_disturbance",
        seriesStatisticsOf<strongestDisturbance>(averageWithSeries)},
       {"heading_direction_disturbance_max",
        statisticsOf<strongestDisturbance>(largest, kNoPeople)}});
}

}  // namespace metrics
