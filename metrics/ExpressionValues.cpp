#include <algorithm>
#include <cmath>

#include "metrics/Expression.h"
#include "metrics/RobotMotion.h"
#include "metrics/TermStatistics.h"

namespace metrics {

namespace {

using EvaluationPoint = Expression::EvaluationPoint;
using Value = Expression::Value;
using Aggregate = Expression::Aggregate;

const Sample& sampleAt(const EvaluationPoint& place) {
  return place.at.now;
}

VariableName ofRobot(std::string name, double (*value)(const Robot&)) {
  return {std::move(name), Scope::Sample,
          [value](const EvaluationPoint& place) { return value(sampleAt(place).robot); }, true,
          false};
}
VariableName ofPerson(std::string name, double (*value)(const Pedestrian&)) {
  return {std::move(name), Scope::Pedestrian,
          [value](const EvaluationPoint& place) { return value(*place.person); }, false, true};
}
VariableName ofPair(std::string name, double (*value)(const Robot&, const Pedestrian&)) {
  return {
      std::move(name), Scope::Pedestrian,
      [value](const EvaluationPoint& place) { return value(sampleAt(place).robot, *place.person); },
      true, true};
}

void addRunNames(std::vector<VariableName>& to) {
  const auto count = [](const EvaluationPoint& p) { return static_cast<double>(p.last.count()); };
  to.push_back({"pi", Scope::Run, [](const EvaluationPoint&) { return base::kPi; }});
  to.push_back({"duration", Scope::Run, [](const EvaluationPoint& p) { return p.last.elapsed(); },
                false, false, true});
  to.push_back({"samples", Scope::Run, count, false, false, true});
  for (const ParameterInfo& info : parameterInfos()) {
    to.push_back({info.spec.key, Scope::Run, [member = info.member](const EvaluationPoint& p) {
                    return p.at.parameters.*member;
                  }});
  }
}

void addSampleNames(std::vector<VariableName>& to) {
  const auto people = [](const EvaluationPoint& p) {
    return static_cast<double>(sampleAt(p).people.size());
  };
  const auto gap = [](const EvaluationPoint& p) { return smallestGapTerm(p.at); };
  const auto goal = [](const EvaluationPoint& p) {
    const double distance = distanceToGoals(p.at.context, p.at.now.robot.position);
    return std::isinf(distance) ? kNaN : distance;
  };
  to.push_back({"time", Scope::Sample, [](const EvaluationPoint& p) { return p.at.elapsed(); }});
  to.push_back({"dt", Scope::Sample, [](const EvaluationPoint& p) { return p.dt; }});
  to.push_back({"people", Scope::Sample, people, false, true});
  to.push_back({"gap", Scope::Sample, gap, true, true});
  to.push_back({"goal_distance", Scope::Sample, goal, true});
}

void addRobotNames(std::vector<VariableName>& to) {
  to.insert(to.end(), {ofRobot("x", [](const Robot& r) { return r.position.x(); }),
                       ofRobot("y", [](const Robot& r) { return r.position.y(); }),
                       ofRobot("heading", [](const Robot& r) { return r.heading; }),
                       ofRobot("vx", [](const Robot& r) { return r.velocity.x(); }),
                       ofRobot("vy", [](const Robot& r) { return r.velocity.y(); }),
                       ofRobot("speed", [](const Robot& r) { return r.speed; }),
                       ofRobot("omega", [](const Robot& r) { return r.omega; }),
                       ofRobot("radius", [](const Robot& r) { return r.radius; }),
                       ofRobot("clearance", [](const Robot& r) {
                         return r.obstacleDistance ? *r.obstacleDistance - r.radius : kNaN;
                       })});
}

void addPersonNames(std::vector<VariableName>& to) {
  to.insert(
      to.end(),
      {ofPerson("p.id", [](const Pedestrian& a) { return static_cast<double>(a.id); }),
       ofPerson("p.x", [](const Pedestrian& a) { return a.position.x(); }),
       ofPerson("p.y", [](const Pedestrian& a) { return a.position.y(); }),
       ofPerson("p.heading", [](const Pedestrian& a) { return a.heading; }),
       ofPerson("p.vx", [](const Pedestrian& a) { return a.velocity.x(); }),
       ofPerson("p.vy", [](const Pedestrian& a) { return a.velocity.y(); }),
       ofPerson("p.speed", [](const Pedestrian& a) { return a.speed; }),
       ofPerson("p.omega", [](const Pedestrian& a) { return a.omega; }),
       ofPerson("p.radius", [](const Pedestrian& a) { return a.radius; }),
       ofPerson("p.group", [](const Pedestrian& a) { return static_cast<double>(a.group); }),
       ofPerson("p.behavior", [](const Pedestrian& a) { return static_cast<double>(a.behavior); }),
       ofPerson("p.state", [](const Pedestrian& a) { return static_cast<double>(a.state); }),
       ofPair("p.gap", [](const Robot& r, const Pedestrian& a) { return gap(r, a); }),
       ofPair("p.distance", [](const Robot& r, const Pedestrian& a) { return distance(r, a); }),
       ofPair("p.view", [](const Robot&, const Pedestrian& a) { return a.pair.viewAngle; }),
       ofPair("p.bearing",
              [](const Robot& r, const Pedestrian& a) {
                return base::angleDiff(base::headingOf(a.position - r.position), r.heading);
              }),
       ofPair("p.ttc", [](const Robot&, const Pedestrian& a) { return a.pair.timeToCollision; })});
}

double meanOf(const Aggregate& all) {
  return all.count > 0.0 ? all.sum / all.count : kNaN;
}

}  // namespace

const std::vector<VariableName>& variableNames() {
  static const std::vector<VariableName> kNames = [] {
    std::vector<VariableName> names;
    addRunNames(names);
    addSampleNames(names);
    addRobotNames(names);
    addPersonNames(names);
    return names;
  }();
  return kNames;
}

const std::vector<FunctionName>& functionNames() {
  static const std::vector<FunctionName> kNames = {
      {"abs", 1, [](const double* a) { return std::fabs(a[0]); }},
      {"sqrt", 1, [](const double* a) { return std::sqrt(a[0]); }},
      {"exp", 1, [](const double* a) { return std::exp(a[0]); }},
      {"log", 1, [](const double* a) { return std::log(a[0]); }},
      {"sin", 1, [](const double* a) { return std::sin(a[0]); }},
      {"cos", 1, [](const double* a) { return std::cos(a[0]); }},
      {"atan2", 2, [](const double* a) { return std::atan2(a[0], a[1]); }},
      {"hypot", 2, [](const double* a) { return std::hypot(a[0], a[1]); }},
      {"wrap", 1, [](const double* a) { return base::wrapToPi(a[0]); }},
      {"lesser", 2, [](const double* a) { return a[1] < a[0] ? a[1] : a[0]; }},
      {"greater", 2, [](const double* a) { return a[1] > a[0] ? a[1] : a[0]; }},
      {"if", 3,
       [](const double* a) { return std::isnan(a[0]) ? a[0] : (a[0] != 0.0 ? a[1] : a[2]); }},
      {"defined", 1, [](const double* a) { return std::isnan(a[0]) ? 0.0 : 1.0; }}};
  return kNames;
}

void Expression::Aggregate::take(double value, double weight) {
  if (std::isnan(value)) {
    return;
  }
  sum += value;
  integral += value * weight;
  holding += value != 0.0 ? 1.0 : 0.0;
  first = count > 0.0 ? first : value;
  last = value;
  least = count > 0.0 ? std::min(least, value) : value;
  largest = count > 0.0 ? std::max(largest, value) : value;
  count += 1.0;
}

double aggregateOverPeople(const EvaluationPoint& place, const Value& term,
                           Expression::Result result) {
  Aggregate all;
  for (const Pedestrian& person : sampleAt(place).people) {
    all.take(term({place.at, place.last, place.dt, place.totals, &person}), 1.0);
  }
  return result(all);
}

const std::vector<AggregateName>& aggregateNames() {
  static const std::vector<AggregateName> kNames = {
      {"min", [](const Aggregate& all) { return all.least; }},
      {"max", [](const Aggregate& all) { return all.largest; }},
      {"mean", meanOf},
      {"sum", [](const Aggregate& all) { return all.sum; }},
      {"integral", [](const Aggregate& all) { return all.integral; }},
      {"count", [](const Aggregate& all) { return all.holding; }},
      {"first", [](const Aggregate& all) { return all.first; }},
      {"last", [](const Aggregate& all) { return all.last; }}};
  return kNames;
}

const std::vector<AggregateName>& peopleAggregateNames() {
  static const std::vector<AggregateName> kNames = {
      {"people_min", [](const Aggregate& all) { return all.least; }},
      {"people_max", [](const Aggregate& all) { return all.largest; }},
      {"people_mean", meanOf},
      {"people_sum", [](const Aggregate& all) { return all.sum; }},
      {"people_count", [](const Aggregate& all) { return all.holding; }},
      {"any", [](const Aggregate& all) { return all.holding > 0.0 ? 1.0 : 0.0; }},
      {"all", [](const Aggregate& all) { return all.holding == all.count ? 1.0 : 0.0; }}};
  return kNames;
}

MetricValue Expression::valueOf(const Instant& last, const std::vector<double>& totals) const {
  const double value = result_({last, last, 0.0, totals});
  if (std::isnan(value)) {
    return undefinedValue("the formula is undefined here");
  }
  return std::isinf(value) ? undefinedValue("the formula has no finite value") : value;
}

MetricValue Expression::evaluate(const std::vector<Sample>& samples, const Instant& last) const {
  const auto instantAt = [&](std::size_t i) {
    return Instant{last.context, last.parameters, samples[i], nullptr, nullptr, i, last.begin};
  };
  std::vector<double> totals;
  for (const TimeAggregate& total : totals_) {
    Aggregate collected;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double dt = i + 1 < samples.size() ? samples[i + 1].time - samples[i].time : 0.0;
      collected.take(total.term({instantAt(i), last, dt, totals}), dt);
    }
    totals.push_back(total.result(collected));
  }
  return valueOf(last, totals);
}

/// Adds each sample when the next one defines its duration.
class Expression::TimeSums : public Accumulator {
 public:
  explicit TimeSums(const Expression& expression)
      : expression_(expression), collected_(expression.totals_.size()) {}

  void add(const Instant& at) override {
    if (at.before != nullptr) {
      const Instant then{at.context, at.parameters, *at.before, nullptr,
                         nullptr,    at.index - 1,  at.begin};
      take(then, at.step(), collected_);
    }
  }
  MetricValue value(const Instant& last) const {
    std::vector<Aggregate> collected = collected_;
    take(last, 0.0, collected);
    std::vector<double> totals;
    for (std::size_t k = 0; k < collected.size(); ++k) {
      totals.push_back(expression_.totals_[k].result(collected[k]));
    }
    return expression_.valueOf(last, totals);
  }

 private:
  void take(const Instant& at, double dt, std::vector<Aggregate>& to) const {
    static const std::vector<double> kNoTotals;
    for (std::size_t k = 0; k < to.size(); ++k) {
      to[k].take(expression_.totals_[k].term({at, at, dt, kNoTotals}), dt);
    }
  }

  Expression expression_;
  std::vector<Aggregate> collected_;
};

namespace {

/// For formulas that need all samples at the end of the run.
struct WholeRecord : Accumulator {
  void add(const Instant& at) override { samples.push_back(at.now); }

  std::vector<Sample> samples;
};

}  // namespace

MetricComputation Expression::computation() const {
  if (needsRecord_) {
    return metricOf<WholeRecord>(
        [expression = *this](const WholeRecord& record, const Instant& last) {
          return expression.evaluate(record.samples, last);
        });
  }
  return {[expression = *this](const MetricParameters& /*parameters*/) {
            return std::make_unique<TimeSums>(expression);
          },
          [](const Accumulator& sums, const Instant& last) {
            return static_cast<const TimeSums&>(sums).value(last);
          },
          "", copyOf<TimeSums>};
}

base::Result<MetricEntry> entryOf(const UserMetric& metric) {
  const base::Result<Expression> expression = Expression::parse(metric.expression);
  if (!expression) {
    return expression.diagnostics();
  }
  MetricEntry entry;
  entry.info = {metric.key,        metric.name.empty() ? metric.key : metric.name,
                metric.unit,       Category::Navigation,
                metric.better,     expression->needs(),
                metric.expression, "own",
                "(-inf, inf)"};
  entry.computation = expression->computation();
  if (!expression->needsRecord()) {
    entry.computation.shared = "formula " + metric.key;
  }
  return entry;
}

}  // namespace metrics
