#include "sim2d/trace/Trace.h"

namespace sim2d {
namespace {

template <class Part>
bool areEqualParts(const Part& a, const Part& b) {
  bool same = true;
  Part::eachMember([&](const char*, auto member) { same = same && a.*member == b.*member; });
  return same;
}

}  // namespace

bool operator==(const TraceGoal& a, const TraceGoal& b) {
  return a.id == b.id && a.position == b.position && a.radius == b.radius;
}

bool operator==(const TraceHuman& a, const TraceHuman& b) {
  return areEqualParts(a, b);
}

bool operator==(const TraceRobot& a, const TraceRobot& b) {
  return areEqualParts(a, b);
}

bool operator==(const TraceObstacle& a, const TraceObstacle& b) {
  return areEqualParts(a, b);
}

bool operator==(const TraceMetrics& a, const TraceMetrics& b) {
  return areEqualParts(a, b);
}

bool operator==(const TraceHeader& a, const TraceHeader& b) {
  return areEqualParts(a, b);
}

}  // namespace sim2d
