#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "metrics/TermSums.h"

namespace metrics {

namespace {

using Members = std::vector<const Person*>;

/// Calls visit(id, members) for the groups with enough members, by id.
template <class Visit>
void forEachGroup(const Sample& sample, const MetricParameters& parameters, Visit visit) {
  Members all;
  for (const Person& person : sample.people) {
    if (person.group != -1) {
      all.push_back(&person);
    }
  }
  std::sort(all.begin(), all.end(), [](const Person* a, const Person* b) {
    return a->group != b->group ? a->group < b->group : a < b;
  });
  Members members;
  for (auto at = all.begin(); at != all.end();) {
    const auto end = std::find_if(
        at, all.end(), [at](const Person* person) { return person->group != (*at)->group; });
    members.assign(at, end);
    if (static_cast<double>(members.size()) >= parameters.groupMinimumMembers) {
      visit(members.front()->group, members);
    }
    at = end;
  }
}

/// Quarter of the room that the members take along the direction, bodies included.
double quarterSpan(const Members& members, const Vec2& direction) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Person* member : members) {
    const double along = direction.dot(member->position);
    low = std::min(low, along - member->radius);
    high = std::max(high, along + member->radius);
  }
  return (high - low) / 4.0;
}

/// 1 at the centre of the members, falling along the axes of their arrangement.
double groupIntrusion(const Members& members, const Vec2& position) {
  Vec2 centre = Vec2::Zero();
  for (const Person* member : members) {
    centre += member->position / static_cast<double>(members.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Person* member : members) {
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

double deepest(const Sample& sample, const MetricParameters& parameters) {
  double value = std::numeric_limits<double>::quiet_NaN();
  forEachGroup(sample, parameters, [&](int /*group*/, const Members& members) {
    const double one = groupIntrusion(members, sample.robot.position);
    value = one <= value ? value : one;
  });
  return value;
}

MetricValue average(const Figures& depths, const Instant& /*last*/) {
  const double mean = depths.timeMean();
  return std::isnan(mean) ? numberValue(0.0) : numberValue(100.0 * mean);
}

MetricValue largest(const Figures& depths, const Instant& /*last*/) {
  return std::isnan(depths.largest()) ? numberValue(0.0) : numberValue(100.0 * depths.largest());
}

/// Left (> 0) or right of the line from a to b.
double side(const Vec2& a, const Vec2& b, const Vec2& point) {
  return base::cross(b - a, point - a);
}

/// Between two samples the robot passed between two members.
bool passesBetween(const Sample& before, const Sample& now, const Person& a, const Person& b) {
  const Vec2 line = b.position - a.position;
  const double place = line.dot(now.robot.position - a.position);
  if (!(place >= 0.0 && place <= line.squaredNorm())) {
    return false;
  }
  const Person* const a0 = findPerson(before, a.id);
  const Person* const b0 = findPerson(before, b.id);
  if (a0 == nullptr || b0 == nullptr) {
    return false;
  }
  const double then = side(a0->position, b0->position, before.robot.position);
  const double after = side(a.position, b.position, now.robot.position);
  return (then > 0.0) != (after > 0.0);
}

/// Inside the hull of the members: no line through two members has all of them on one side and the
/// robot on the other.
bool isInside(const Members& members, const Vec2& position) {
  if (members.size() < 3) {
    return false;
  }
  for (const Person* a : members) {
    for (const Person* b : members) {
      const bool isEdge =
          a != b && std::all_of(members.begin(), members.end(), [&](const Person* other) {
            return side(a->position, b->position, other->position) >= 0.0;
          });
      if (isEdge && side(a->position, b->position, position) < 0.0) {
        return false;
      }
    }
  }
  return true;
}

bool isCrossing(const Sample* before, const Sample& now, const Members& members) {
  if (isInside(members, now.robot.position)) {
    return true;
  }
  for (std::size_t k = 0; before != nullptr && k < members.size(); ++k) {
    for (std::size_t m = k + 1; m < members.size(); ++m) {
      if (passesBetween(*before, now, *members[k], *members[m])) {
        return true;
      }
    }
  }
  return false;
}

class GroupCrossings : public Accumulator {
 public:
  void add(const Instant& at) override {
    forEachGroup(at.now, at.parameters, [&](int group, const Members& members) {
      const bool now = isCrossing(at.before, at.now, members);
      bool& crossed = crossed_[group];
      count_ += now && !crossed ? 1.0 : 0.0;
      crossed = now;
    });
  }
  MetricValue value(const Instant& /*last*/) const { return countValue(count_); }

 private:
  std::map<int, bool> crossed_;
  double count_ = 0.0;
};

}  // namespace

void addGroupSpace(MetricRegistry& to) {
  const Needs needs{true, true, true};
  to.add(
      {"formation_space_intrusion", "Intrusion into the space of groups", "%", Category::Social,
       Better::Lower, needs,
       "time-weighted mean of max over groups of exp(-(u^2/2Vu + w^2/2Vw)), u, w = robot along the "
       "axes of the arrangement of the members, V = (span of the members with their bodies/4)^2",
       "SRPB", "[0, 100]", Kind::Number, 0, ""},
      figuresOf<deepest>(average));
  to.add({"formation_space_intrusion_max", "Intrusion into the space of groups, largest", "%",
          Category::Social, Better::Lower, needs, "max over samples of the same", "SRPB",
          "[0, 100]", Kind::Number, 0, ""},
         figuresOf<deepest>(largest));
  to.add({"group_crossings", "Groups crossed", "", Category::Social, Better::Lower, needs,
          "number of times the robot gets inside the hull of a group or between two of its members",
          "Katyal et al. 2022; Okal and Arras 2016", "0, 1, ...", Kind::Count, 0, ""},
         streamOf<GroupCrossings>(&GroupCrossings::value));
}

}  // namespace metrics
