#include "editor/panels/MetricsFeed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace editor {

namespace {

constexpr double kMinGap = 0.25;  // Minimum interval between points of a curve [s].
constexpr double kGapShare = 1.0 / 80.0;
constexpr std::size_t kMaxFrames = 500;   // Maximum number of frames per update of the panel.
constexpr std::size_t kNearFrames = 100;  // Values this recent stay visible during playback.
constexpr std::size_t kNoIndex = std::numeric_limits<std::size_t>::max();

int decimalsOf(const std::string& unit) {
  if (unit == "s" || unit == "%") {
    return 1;
  }
  return unit == "rad" || unit == "rad/s" ? 3 : 2;
}

std::vector<metrics::MetricResult> withoutValues(std::vector<metrics::MetricResult> results) {
  for (metrics::MetricResult& result : results) {
    result.value = {};
  }
  return results;
}

}  // namespace

QString metricText(const metrics::MetricResult& result) {
  const metrics::MetricValue& value = result.value;
  if (!value.value) {
    return QStringLiteral("–");
  }
  if (std::isinf(*value.value)) {
    return *value.value > 0.0 ? QStringLiteral("∞") : QStringLiteral("−∞");
  }
  switch (result.info.kind) {
    case metrics::Kind::Boolean:
      return *value.value != 0.0 ? QStringLiteral("yes") : QStringLiteral("no");
    case metrics::Kind::Count:
      return QString::number(std::llround(*value.value));
    case metrics::Kind::Number:
      break;
  }
  return QString::number(*value.value, 'f', decimalsOf(result.info.unit));
}

/// Used by one thread at a time: by the worker while it is busy, else by the GUI thread.
struct MetricsFeed::Work {
  std::unique_ptr<metrics::FrameEvaluation> live;
  std::set<int> known;        // People already passed to the metrics.
  std::size_t events = 0;     // Number of events already passed to the metrics.
  std::vector<double> times;  // Times of all frames [s].
  bool hasTracks = true;
  bool isCut = false;  // A state was dropped before it was measured.
  std::map<std::string, MetricCurve> tracks;
  double nextPoint = 0.0;

  void meet(const std::vector<sim2d::TraceHuman>& humans) {
    live->addHumans(humans);
    for (const sim2d::TraceHuman& human : humans) {
      known.insert(human.id);
    }
  }

  void note(double time, const std::vector<metrics::MetricResult>& results) {
    for (const metrics::MetricResult& result : results) {
      MetricCurve& track = tracks[result.info.key];
      track.times.push_back(time);
      track.values.push_back(result.value.value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    nextPoint = time + std::max(kMinGap, time * kGapShare);
  }

  /// Returns false if the next state has been dropped.
  bool takeNext(const sim2d::Recording& recording) {
    const FramePtr frame = recording.frameIfKept(times.size());
    if (frame == nullptr) {
      isCut = true;
      return false;
    }
    const std::vector<int>& ids = frame->humans.id;
    if (!std::all_of(ids.begin(), ids.end(), [this](int id) { return known.count(id) > 0; })) {
      meet(recording.header()->humans);  // A source has spawned a person.
    }
    const std::size_t happened = recording.events().size();
    for (; events < happened && recording.events()[events].first <= frame->step; ++events) {
      const auto& [step, event] = recording.events()[events];
      live->note(static_cast<double>(step) * recording.header()->dt, event);
    }
    live->append(*frame);
    times.push_back(frame->time);
    if (hasTracks && frame->time >= nextPoint - 1e-9) {
      note(frame->time, live->values());
    }
    return true;
  }

  MetricSnapshot append(const sim2d::Recording& recording) {
    const std::size_t end = std::min(recording.size(), times.size() + kMaxFrames);
    while (!isCut && times.size() < end && takeNext(recording)) {
    }
    MetricSnapshot snapshot;
    snapshot.isCut = isCut;
    snapshot.frames = isCut ? recording.size() : times.size();
    snapshot.results = isCut ? withoutValues(live->values()) : live->values();
    for (const metrics::MetricResult& result : snapshot.results) {
      const std::optional<metrics::Series>& series = result.value.series;
      snapshot.curves[result.info.key] = series && series->values.size() == times.size()
                                             ? MetricCurve{times, series->values}
                                             : tracks[result.info.key];
    }
    return snapshot;
  }
};

MetricsFeed::MetricsFeed(const ScenarioDocument& document, SimulationRunner& runner)
    : document_(document),
      runner_(runner),
      task_([this](MetricSnapshot snapshot) { deliver(std::move(snapshot)); }),
      pastTask_([this](Past past) { deliverPast(std::move(past)); }) {
  connect(&runner_, &SimulationRunner::frameShown, this, &MetricsFeed::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &MetricsFeed::follow);
}

MetricsFeed::~MetricsFeed() {
  stopPast();
  task_.abandon();
  pastTask_.abandon();
}

/// A recorded run contains its own metric setup.
base::Result<app::MetricsSetup> MetricsFeed::setup() const {
  if (!runner_.isRecorded()) {
    return app::metricsSetupOf(document_.scenario(), document_.path().toStdString());
  }
  app::MetricsSetup setup;
  base::Diagnostics problems = app::readMetricsSetup(*runner_.recording()->header(), setup);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::move(setup), std::move(problems)};
}

metrics::Selection MetricsFeed::selection() const {
  if (selection_) {
    return *selection_;
  }
  const base::Result<app::MetricsSetup> found = setup();
  return found ? found->selection : metrics::Selection();
}

void MetricsFeed::setSelection(std::optional<metrics::Selection> selection) {
  selection_ = std::move(selection);
  if (recording_) {
    begin();
    follow();
  }
}

void MetricsFeed::setRobot(int id) {
  if (id == robot_) {
    return;
  }
  robot_ = id;
  if (recording_) {
    begin();
    follow();
  }
}

std::vector<std::pair<int, std::string>> MetricsFeed::robots() const {
  std::vector<std::pair<int, std::string>> robots;
  if (recording_) {
    for (const sim2d::TraceRobot& robot : recording_->header()->robots) {
      robots.emplace_back(robot.id, robot.name);
    }
  }
  return robots;
}

int MetricsFeed::robot() const {
  const auto all = robots();
  const bool isThere = std::any_of(all.begin(), all.end(),
                                   [this](const auto& each) { return each.first == robot_; });
  return isThere ? robot_ : -1;
}

bool MetricsFeed::isCurrent() const {
  const std::optional<std::size_t> past = pastIndex();
  const bool isOfShown = !past || (past_ && past_->index == *past);
  return !task_.isBusy() && !pastTask_.isBusy() &&
         (!work_ || (snapshot_.frames == recording_->size() && isOfShown));
}

void MetricsFeed::begin() {
  work_.reset();
  stopPast();
  task_.finish();
  pastTask_.finish();
  pastWork_.reset();
  past_.reset();
  snapshot_ = MetricSnapshot();
  Q_EMIT cleared();
  if (recording_ == nullptr) {
    return;
  }
  const base::Result<app::MetricsSetup> found = setup();
  if (!found) {
    Q_EMIT failed(found.diagnostics());
    return;
  }
  metrics::Selection wanted = selection();
  wanted.window = {};  // Cumulative values for all people.
  wanted.behaviors = false;
  wanted.robotId = robot();
  makeWork_ = [wanted, header = recording_->header(), parameters = found->parameters] {
    auto work = std::make_shared<Work>();
    work->live = std::make_unique<metrics::FrameEvaluation>(*header, wanted, parameters);
    work->meet(header->humans);
    return work;
  };
  work_ = makeWork_();
}

/// The shown state if it is not the newest one.
std::optional<std::size_t> MetricsFeed::pastIndex() const {
  const FramePtr frame = runner_.shownFrame();
  const bool isPast = runner_.isLookingBack() || runner_.isRecorded();
  if (!work_ || frame == nullptr || !isPast || frame->step == runner_.newestFrame()->step) {
    return {};
  }
  return recording_->indexAt(frame->step);
}

const std::vector<metrics::MetricResult>& MetricsFeed::shown() const {
  return past_ && pastIndex() ? past_->results : snapshot_.results;
}

void MetricsFeed::stopPast() {
  pastStop_->stop();
  pastStop_ = std::make_shared<base::StopFlag>();
}

/// Drops values of another time unless playback continues from there.
void MetricsFeed::dropOtherPast(std::size_t index) {
  const bool isNear = past_ && (past_->index == kNoIndex ||
                                (index >= past_->index && index - past_->index <= kNearFrames));
  if (isNear) {
    return;
  }
  past_ = Past{kNoIndex, withoutValues(snapshot_.results)};
  Q_EMIT updated();
}

void MetricsFeed::lookBack() {
  const std::optional<std::size_t> index = pastIndex();
  if (!index) {
    if (past_) {
      past_.reset();
      Q_EMIT updated();
    }
    return;
  }
  if (past_ && past_->index == *index) {
    return;
  }
  if (*index < pastWanted_) {
    stopPast();  // It is already past the requested state.
  }
  pastWanted_ = *index;
  dropOtherPast(*index);
  // Only one task at a time uses the work; begin() waits for it.
  pastTask_.start([this, index = *index, recording = recording_, make = makeWork_,
                   stop = base::StopFlagPtr(pastStop_)] {
    if (pastWork_ == nullptr || pastWork_->isCut || pastWork_->times.size() > index + 1) {
      pastWork_ = make();
      pastWork_->hasTracks = false;
    }
    while (pastWork_->times.size() <= index) {
      stop->check();
      if (!pastWork_->takeNext(*recording)) {  // The start of the run has been dropped.
        return Past{index, {}};
      }
    }
    return Past{index, pastWork_->live->values()};
  });
}

void MetricsFeed::deliverPast(Past past) {
  if (past.results.empty()) {  // The states have been dropped.
    past.results = withoutValues(snapshot_.results);
  }
  past_ = std::move(past);
  Q_EMIT updated();
}

void MetricsFeed::follow() {
  if (runner_.recording() != recording_) {
    recording_ = runner_.recording();
    begin();
  }
  startNextBatch();
  lookBack();
}

void MetricsFeed::startNextBatch() {
  if (work_ && !task_.isBusy() && snapshot_.frames < recording_->size()) {
    task_.start([work = work_, recording = recording_] { return work->append(*recording); });
  }
}

void MetricsFeed::deliver(MetricSnapshot snapshot) {
  const bool isNewlyCut = snapshot.isCut && !snapshot_.isCut;
  snapshot_ = std::move(snapshot);
  Q_EMIT updated();
  if (isNewlyCut) {
    Q_EMIT failed({base::warning("run.metrics-cut")});
  }
  startNextBatch();
}

}  // namespace editor
