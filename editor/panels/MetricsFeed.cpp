#include "editor/panels/MetricsFeed.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  if (result.info.kind == metrics::Kind::Boolean) {
    return *value.value != 0.0 ? QObject::tr("yes") : QObject::tr("no");
  }
  if (result.info.kind == metrics::Kind::Count) {
    return QString::number(std::llround(*value.value));
  }
  return QString::number(*value.value, 'f', decimalsOf(result.info.unit));
}

/// Used by one thread at a time: by the worker while it is busy, else by the GUI thread.
struct MetricsFeed::Work {
  app::RecordingMeasurer measurer;
  bool isCut = false;  // A state was dropped before it was measured.

  /// Returns false if the next state has been dropped.
  bool takeNext(const sim2d::Recording& recording) {
    isCut = !measurer.takeNext(recording);
    return !isCut;
  }

  MetricSnapshot append(const sim2d::Recording& recording) {
    const std::size_t end = std::min(recording.size(), measurer.taken() + kMaxFrames);
    while (!isCut && measurer.taken() < end && takeNext(recording)) {
    }
    MetricSnapshot snapshot;
    snapshot.isCut = isCut;
    snapshot.frames = isCut ? recording.size() : measurer.taken();
    snapshot.results = isCut ? withoutValues(measurer.results()) : measurer.results();
    snapshot.curves = measurer.curves(snapshot.results);
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
  restart();
}

void MetricsFeed::setRobot(int id) {
  if (std::exchange(robot_, id) != id) {
    restart();
  }
}

void MetricsFeed::restart() {
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
  wanted.robotId = robot();
  makeWork_ = [wanted, header = recording_->header(),
               parameters = found->parameters](const CurveGap& gap) {
    return std::make_shared<Work>(Work{{*header, wanted, parameters, gap}});
  };
  work_ = makeWork_([](double time) { return std::max(kMinGap, time * kGapShare); });
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
    if (pastWork_ == nullptr || pastWork_->isCut || pastWork_->measurer.taken() > index + 1) {
      pastWork_ = make({});
    }
    while (pastWork_->measurer.taken() <= index) {
      stop->check();
      if (!pastWork_->takeNext(*recording)) {  // The start of the run has been dropped.
        return Past{index, {}};
      }
    }
    return Past{index, pastWork_->measurer.results()};
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
