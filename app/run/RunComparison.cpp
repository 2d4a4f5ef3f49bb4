#include "app/run/RunComparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim2d/base/Find.h"

namespace app {

namespace {

constexpr double kMinCurveGap = 0.25;  // [s] between two values so far
constexpr double kMaxCurvePoints = 120.0;
constexpr double kSameTime = 1e-9;  // [s]

/// Metrics that are only meaningful at the end of a run.
constexpr const char* kOutcomeKeys[] = {"success",
                                        "completed",
                                        "timeout",
                                        "time_to_reach_goal",
                                        "total_time",
                                        "spl",
                                        "stl",
                                        "final_distance_to_target",
                                        "targ_dist_norm",
                                        "goal_traversal_ratio"};

std::map<int, base::Vec2> positionsOf(const sim2d::Frame& frame) {
  std::map<int, base::Vec2> places;
  for (const sim2d::BodyColumns* columns :
       {static_cast<const sim2d::BodyColumns*>(&frame.humans), &frame.robots}) {
    for (std::size_t k = 0; k < columns->size(); ++k) {
      places[columns->id[k]] = {columns->x[k], columns->y[k]};
    }
  }
  return places;
}

bool areApart(const sim2d::Frame& first, const sim2d::Frame& second, double apart) {
  const std::map<int, base::Vec2> here = positionsOf(first), there = positionsOf(second);
  return here.size() != there.size() ||
         std::any_of(here.begin(), here.end(), [&](const auto& each) {
           const auto other = there.find(each.first);
           return other == there.end() || (other->second - each.second).norm() > apart;
         });
}

/// The frame without the other people.
sim2d::Frame withOnly(int person, sim2d::Frame frame) {
  const std::vector<int> ids = frame.humans.id;
  sim2d::forEachColumn(frame.humans, [&](auto& column) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < ids.size() && k < column.size(); ++k) {
      if (ids[k] == person) {
        column[kept++] = column[k];
      }
    }
    column.resize(kept);
  });
  frame.forces = {};
  return frame;
}

metrics::Selection cumulative(metrics::Selection selection) {
  selection.window = {};  // values so far, of all pedestrians
  selection.behaviors = false;
  return selection;
}

}  // namespace

std::string MetricTimeSeries::meaning() const {
  return !isPerSample ? "so far" : kind == metrics::Kind::Number ? "per step" : "count per step";
}

std::string MetricTimeSeries::axisUnit() const {
  return isPerSample && kind != metrics::Kind::Number ? meaning() : unit;
}

RecordingMeasurer::RecordingMeasurer(const sim2d::TraceHeader& header, metrics::Selection selection,
                                     const metrics::MetricParameters& parameters,
                                     std::function<double(double time)> gap,
                                     std::optional<int> person)
    : evaluation_(header, cumulative(std::move(selection)), parameters),
      gap_(std::move(gap)),
      person_(person),
      known_(header) {}

void RecordingMeasurer::addValues(double time) {
  for (const metrics::MetricResult& result : evaluation_.values()) {
    MetricTimeSeries& curve = soFar_[result.info.key];
    curve.times.push_back(time);
    curve.values.push_back(result.value.value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  next_ = time + gap_(time);
}

/// Events of robots and doors are always measured.
bool RecordingMeasurer::isMeasured(const sim2d::Event& event) const {
  const auto isOther = [this](bool has, int id) { return has && id >= 0 && id != *person_; };
  return !person_ || (!isOther(event.hasId, event.id) && !isOther(event.hasOther, event.other));
}

bool RecordingMeasurer::takeNext(const sim2d::Recording& recording) {
  const sim2d::FramePtr frame = recording.frameIfKept(times_.size());
  if (frame == nullptr) {
    return false;
  }
  if (known_.addNew(*frame)) {  // a source spawned an agent
    evaluation_.addHumans(recording.header()->humans);
  }
  const std::size_t happened = recording.events().size();
  for (; events_ < happened && recording.events()[events_].first <= frame->step; ++events_) {
    const auto& [step, event] = recording.events()[events_];
    if (isMeasured(event)) {
      evaluation_.note(static_cast<double>(step) * recording.header()->dt, event);
    }
  }
  evaluation_.append(person_ ? withOnly(*person_, *frame) : *frame);
  times_.push_back(frame->time);
  if (gap_ && frame->time >= next_ - 1e-9) {
    addValues(frame->time);
  }
  return true;
}

std::map<std::string, MetricTimeSeries> RecordingMeasurer::curves(
    const std::vector<metrics::MetricResult>& results) const {
  std::map<std::string, MetricTimeSeries> found;
  for (const metrics::MetricResult& result : results) {
    const std::optional<metrics::Series>& series = result.value.series;
    const auto soFar = soFar_.find(result.info.key);
    MetricTimeSeries& curve = found[result.info.key];
    if (series && series->values.size() == times_.size()) {
      const bool isNumber = series->kind == metrics::Kind::Number;
      curve = {times_, series->values, isNumber ? result.info.unit : std::string(), true,
               series->kind};
    } else if (soFar != soFar_.end()) {
      curve = soFar->second;
      curve.unit = result.info.unit;
      curve.kind = result.info.kind;
    }
  }
  return found;
}

RecordingMetrics measureRun(const sim2d::Recording& recording, const MetricsSetup& setup,
                            const base::StopFlagPtr& stop, double until) {
  RecordingMetrics none;
  none.isCut = true;
  std::size_t size = recording.size();
  if (size == 0 || recording.first() > 0) {
    return none;
  }
  if (until < recording.timeOf(size - 1)) {
    size = recording.indexAtTime(until + kSameTime) + 1;
  }
  const double gap = std::max(kMinCurveGap, recording.timeOf(size - 1) / kMaxCurvePoints);
  RecordingMeasurer measurer(*recording.header(), setup.selection, setup.parameters,
                             [gap](double /*time*/) { return gap; });
  while (measurer.taken() < size) {
    stop->check();
    if (!measurer.takeNext(recording)) {
      return none;
    }
  }
  RecordingMetrics all;
  all.results = measurer.results();
  all.curves = measurer.curves(all.results);
  return all;
}

std::optional<double> ComparedMetric::difference(std::size_t run) const {
  const std::optional<double>& first = values.front();
  const std::optional<double>& other = values[run];
  const bool isKnown = first && other && std::isfinite(*first) && std::isfinite(*other);
  return isKnown ? std::optional(*other - *first) : std::nullopt;
}

std::vector<ComparedMetric> compareRecordingMetrics(const std::vector<RecordingMetrics>& runs) {
  std::vector<ComparedMetric> rows;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const metrics::MetricResult& result : runs[run].results) {
      ComparedMetric* row = base::findIf(
          rows, [&](const ComparedMetric& each) { return each.info.key == result.info.key; });
      if (row == nullptr) {
        row = &rows.emplace_back();
        *row = {result.info, std::vector<std::optional<double>>(runs.size())};
      }
      row->values[run] = result.value.value;
    }
  }
  return rows;
}

std::vector<ComparedMetric> compareRecordingMetrics(
    const std::vector<RecordingMetrics>& wholeRuns,
    const std::vector<RecordingMetrics>& upToCommonEnd) {
  const std::vector<ComparedMetric> whole = compareRecordingMetrics(wholeRuns);
  std::vector<ComparedMetric> rows = compareRecordingMetrics(upToCommonEnd);
  for (ComparedMetric& row : rows) {
    row.isWholeRun = std::find(std::begin(kOutcomeKeys), std::end(kOutcomeKeys), row.info.key) !=
                     std::end(kOutcomeKeys);
    const ComparedMetric* const same = base::findIf(
        whole, [&](const ComparedMetric& each) { return each.info.key == row.info.key; });
    if (row.isWholeRun && same != nullptr) {
      row.values = same->values;
    }
  }
  return rows;
}

std::optional<double> commonEnd(const std::vector<const sim2d::Recording*>& runs) {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  double step = 0.0;
  for (const sim2d::Recording* run : runs) {
    const double end = run->size() == 0 ? 0.0 : run->timeOf(run->size() - 1);
    shortest = std::min(shortest, end);
    longest = std::max(longest, end);
    step = std::max(step, run->header()->dt);
  }
  return longest - shortest > step + kSameTime ? std::optional(shortest) : std::nullopt;
}

std::optional<double> divergenceTime(const sim2d::Recording& first, const sim2d::Recording& second,
                                     double apart) {
  for (std::size_t index = 0; index < first.size(); ++index) {
    const std::int64_t step = first.stepOf(index);
    if (second.size() == 0 || step > second.stepOf(second.size() - 1)) {
      break;
    }
    const std::size_t other = second.indexAt(step);
    if (second.stepOf(other) != step) {
      continue;
    }
    const sim2d::FramePtr here = first.frameIfKept(index), there = second.frameIfKept(other);
    if (here != nullptr && there != nullptr && areApart(*here, *there, apart)) {
      return first.timeOf(index);
    }
  }
  return std::nullopt;
}

}  // namespace app
