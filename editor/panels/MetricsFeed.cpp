#include "editor/panels/MetricsFeed.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace editor {

namespace {

constexpr double kLeastGap = 0.25;  // of points of a curve [s]
constexpr double kGapShare = 1.0 / 80.0;

int decimalsOf(const std::string& unit) {
  if (unit == "s" || unit == "%") {
    return 1;
  }
  return unit == "rad" || unit == "rad/s" ? 3 : 2;
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
  switch (value.kind) {
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
  std::unique_ptr<metrics::LiveMetrics> live;
  std::vector<sim2d::TraceHuman> newcomers;  // to be told before the next frames
  std::vector<double> times;                 // of all frames [s]
  std::map<std::string, MetricCurve> tracks;
  double nextPoint = 0.0;

  void note(double time, const std::vector<metrics::MetricResult>& results) {
    for (const metrics::MetricResult& result : results) {
      MetricCurve& track = tracks[result.info.key];
      track.times.push_back(time);
      track.values.push_back(result.value.value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    nextPoint = time + std::max(kLeastGap, time * kGapShare);
  }

  MetricSnapshot append(const std::vector<FramePtr>& frames) {
    if (!newcomers.empty()) {
      live->addHumans(newcomers);
      newcomers.clear();
    }
    MetricSnapshot snapshot;
    for (const FramePtr& frame : frames) {
      live->append(*frame);
      times.push_back(frame->time);
      if (frame->time >= nextPoint - 1e-9) {
        note(frame->time, live->values());
      }
    }
    snapshot.time = times.empty() ? 0.0 : times.back();
    snapshot.frames = times.size();
    snapshot.results = live->values();
    for (const metrics::MetricResult& result : snapshot.results) {
      const std::optional<metrics::Series>& series = result.value.series;
      snapshot.curves[result.info.key] = series && series->values.size() == times.size()
                                             ? MetricCurve{times, series->values}
                                             : tracks[result.info.key];
    }
    return snapshot;
  }
};

MetricsFeed::MetricsFeed(const ScenarioDocument& document, SimulationRunner& runner,
                         QObject* parent)
    : QObject(parent),
      document_(document),
      runner_(runner),
      task_([this](MetricSnapshot snapshot) { deliver(std::move(snapshot)); }) {
  connect(&runner_, &SimulationRunner::frameShown, this, &MetricsFeed::follow);
  connect(&runner_, &SimulationRunner::stateChanged, this, &MetricsFeed::follow);
  connect(&runner_, &SimulationRunner::traceReady, this, &MetricsFeed::takeTrace);
}

MetricsFeed::~MetricsFeed() {
  task_.finish();
}

metrics::Selection MetricsFeed::selection() const {
  if (selection_) {
    return *selection_;
  }
  const base::Result<app::MetricsSetup> setup =
      app::metricsSetupOf(document_.scenario(), document_.path().toStdString());
  return setup ? setup->selection : metrics::Selection();
}

void MetricsFeed::setSelection(std::optional<metrics::Selection> selection) {
  selection_ = std::move(selection);
  if (first_) {
    begin();
    follow();
  }
}

bool MetricsFeed::isCurrent() const {
  return snapshot_.frames == runner_.history().size() && !task_.isBusy();
}

void MetricsFeed::begin() {
  task_.finish();
  work_.reset();
  known_.clear();
  fed_ = 0;
  snapshot_ = MetricSnapshot();
  traceWanted_ = false;
  Q_EMIT cleared();
}

void MetricsFeed::follow() {
  const std::vector<FramePtr>& frames = runner_.history();
  const FramePtr first = frames.empty() ? FramePtr() : frames.front();
  if (first != first_) {
    first_ = first;
    begin();
  }
  if (!first) {
    return;
  }
  if (!work_ && !traceWanted_) {
    traceWanted_ = true;
    runner_.requestTrace();
  }
  pump();
}

void MetricsFeed::takeTrace(const TracePtr& trace) {
  if (!trace || !first_ || !traceWanted_) {
    return;
  }
  traceWanted_ = false;
  if (!work_) {
    const base::Result<app::MetricsSetup> setup =
        app::metricsSetupOf(document_.scenario(), document_.path().toStdString());
    if (!setup) {
      traceWanted_ = true;  // not asked for again: the settings are wrong for this run
      Q_EMIT failed(setup.diagnostics());
      return;
    }
    work_ = std::make_shared<Work>();
    work_->live =
        std::make_unique<metrics::LiveMetrics>(trace->header, selection(), setup->parameters);
  } else {
    task_.finish();
    for (const sim2d::TraceHuman& human : trace->header.humans) {
      if (known_.count(human.id) == 0) {
        work_->newcomers.push_back(human);
      }
    }
  }
  for (const sim2d::TraceHuman& human : trace->header.humans) {
    known_.insert(human.id);
  }
  pump();
}

std::vector<FramePtr> MetricsFeed::nextFrames() {
  const std::vector<FramePtr>& frames = runner_.history();
  std::vector<FramePtr> next;
  for (; fed_ < frames.size(); ++fed_) {
    const std::vector<int>& ids = frames[fed_]->humans.id;
    const bool stranger =
        std::any_of(ids.begin(), ids.end(), [this](int id) { return known_.count(id) == 0; });
    if (stranger) {  // somebody came from a source: ask who it is
      if (!traceWanted_) {
        traceWanted_ = true;
        runner_.requestTrace();
      }
      break;
    }
    next.push_back(frames[fed_]);
  }
  return next;
}

void MetricsFeed::pump() {
  if (!work_ || task_.isBusy()) {
    return;
  }
  std::vector<FramePtr> frames = nextFrames();
  if (frames.empty()) {
    return;
  }
  task_.start([work = work_, frames = std::move(frames)] { return work->append(frames); });
}

void MetricsFeed::deliver(MetricSnapshot snapshot) {
  snapshot_ = std::move(snapshot);
  Q_EMIT updated();
  pump();
}

}  // namespace editor
