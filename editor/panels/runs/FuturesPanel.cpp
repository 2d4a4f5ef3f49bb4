#include "editor/panels/runs/FuturesPanel.h"

#include <cmath>

#include "editor/look/Form.h"
#include "editor/panels/runs/Playback.h"

namespace editor {

namespace {

constexpr int kBarPx = 4;
constexpr int kFuturesMargin = 12;

QString percent(double share) {
  return QStringLiteral("%1 %").arg(std::lround(100.0 * share));
}

}  // namespace

FuturesPanel::FuturesPanel(PanelContext& context) : context_(context), process_(this) {
  auto fan = std::make_unique<FuturesLayer>(context.view.mapScene());
  futuresLayer_ = fan.get();
  context.view.mapScene().addRunLayer(std::move(fan));
  auto* rows = configuredLayout(new QVBoxLayout(this), {}, 0, {makeHead(), dividerLine(this)});
  says_->setWordWrap(true);
  says_->setContentsMargins(kFuturesMargin, 6, kFuturesMargin, 0);
  says_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  rows->addWidget(says_);
  rows->addWidget(plot_, 1);
  connect(start_, &QPushButton::clicked, this, [this] { isRunning() ? cancel() : start(); });
  connect(&process_, &FuturesProcess::futureReceived, this, &FuturesPanel::take);
  connect(&process_, &FuturesProcess::ended, this, &FuturesPanel::finish);
  connect(&context.runner, &SimulationRunner::frameShown, this, &FuturesPanel::follow);
  connect(&context.runner, &SimulationRunner::stateChanged, this, &FuturesPanel::follow);
  connect(&context, &PanelContext::themeChanged, plot_, &ContactProbabilityPlot::setTheme);
  connectExport(*plot_, context);
  follow();
}

FuturesPanel::~FuturesPanel() {
  process_.disconnect(this);
}

QWidget* FuturesPanel::makeHead() {
  auto* head = new QWidget(this);
  auto* row = configuredLayout(new QHBoxLayout(head), {kFuturesMargin, 6, kFuturesMargin, 6}, 8,
                               {start_, count_, secondaryLabel(tr("seeds,"), head), horizon_,
                                secondaryLabel(tr("long, people ±"), head), spread_});
  count_->setRange(1, app::kMaxFutures);
  count_->setValue(app::FuturesOptions().count);
  count_->setAccessibleName(tr("Number of futures"));
  count_->setToolTip(tr("Number of simulated futures, each with its own seed"));
  horizon_->show(app::FuturesOptions().horizon, false);
  horizon_->setAccessibleName(tr("Length of the futures"));
  horizon_->setToolTip(tr("Duration of each future"));
  spread_->show(app::FuturesOptions().spread, false);
  spread_->setAccessibleName(tr("Velocity uncertainty"));
  spread_->setToolTip(
      tr("Velocity uncertainty: once a second each walking person is pushed by a random velocity "
         "of this standard deviation. 0: only the variation of the scenario applies"));
  progress_->setTextVisible(false);
  progress_->setFixedHeight(kBarPx);
  progress_->hide();
  row->addWidget(progress_, 1);
  row->addStretch(1);
  start_->setToolTip(tr("Simulate from the displayed step, in the background"));
  return head;
}

void FuturesPanel::start() {
  SimulationRunner& runner = context_.runner;
  const FramePtr shown = runner.shownFrame();
  const std::function<RunRequest()> again = runner.again();
  if (shown == nullptr || !again) {
    return;
  }
  runner.pause();
  const RunRequest run = again();
  if (run.bundle == nullptr) {
    return;
  }
  app::FuturesRequest request;
  request.bundle = *run.bundle;
  request.branches = app::branchesUntil(run.branches, shown->step);
  request.inputs = runner.recording()->inputsUntil(shown->step);
  request.at = shown->step;
  sim2d::appendTrajectoryRows(request.state, *shown);
  request.options.count = count_->value();
  request.options.horizon = horizon_->value();
  request.options.spread = spread_->value();
  request.options.jobs = std::max(1, QThread::idealThreadCount());
  asked_ = request.options;
  from_ = shown->time;
  of_ = runner.recording();
  futures_ = std::make_shared<std::vector<app::Future>>();
  isComplete_ = false;
  process_.ask(request);
  progress_->setRange(0, asked_.count);
  showAll();
  follow();
}

void FuturesPanel::cancel() {
  process_.cancel();
  showAll();
  follow();
}

void FuturesPanel::take(const app::Future& future) {
  auto all = std::make_shared<std::vector<app::Future>>(*futures_);  // The map uses the old list.
  all->insert(std::upper_bound(
                  all->begin(), all->end(), future,
                  [](const app::Future& a, const app::Future& b) { return a.number < b.number; }),
              future);
  futures_ = std::move(all);
  showAll();
}

void FuturesPanel::finish(const QString& problems) {
  isComplete_ = problems.isEmpty();
  showAll();
  if (!problems.isEmpty()) {
    says_->setText(problems);
  }
  follow();
}

/// Discards the futures of a run that is no longer shown.
void FuturesPanel::forget() {
  process_.cancel();
  futures_ = std::make_shared<std::vector<app::Future>>();
  of_.reset();
  showAll();
}

void FuturesPanel::follow() {
  SimulationRunner& runner = context_.runner;
  const FramePtr shown = runner.shownFrame();
  if (of_ != nullptr && runner.recording() != of_) {
    forget();
  }
  const bool canAsk = shown != nullptr && runner.again() != nullptr;
  start_->setEnabled(isRunning() || canAsk);
  start_->setText(isRunning() ? tr("Cancel") : tr("Simulate futures"));
  progress_->setVisible(isRunning());
  if (of_ == nullptr) {
    says_->setText(canAsk ? tr("Simulates the run from the displayed step with other random "
                               "values.")
                   : shown != nullptr
                       ? tr("This run cannot be replayed: its inputs are not known.")
                       : tr("Start a run and pause it to simulate its futures from there."));
  }
  if (shown != nullptr) {
    plot_->setCursor(shown->time);
  }
}

QString FuturesPanel::countText() const {
  const auto n = static_cast<int>(futures_->size());
  return isComplete_   ? tr("%1 futures").arg(n)
         : isRunning() ? tr("%1 of %2 futures so far").arg(n).arg(asked_.count)
                       : tr("%1 of %2 futures, cancelled").arg(n).arg(asked_.count);
}

void FuturesPanel::showAll() {
  const std::vector<app::ContactChance> chances =
      app::contactChances(*futures_, from_, asked_.horizon);
  const std::optional<double> decisive = app::medianContactTime(*futures_);
  plot_->show(futures_->empty() ? std::vector<app::ContactChance>() : chances, decisive);
  progress_->setValue(static_cast<int>(futures_->size()));
  futuresLayer_->show(isVisible() && !futures_->empty() ? futures_ : nullptr);
  if (of_ == nullptr) {
    return;
  }
  QString words = tr("From %1: %2.").arg(clockText(from_), countText());
  if (!futures_->empty()) {
    const app::ContactChance& last = chances.back();
    words += QLatin1Char(' ') + (last.contacts == 0
                                     ? tr("No contact in any run (%1, 95 % CI at most %2).")
                                           .arg(percent(0.0), percent(last.interval.high))
                                     : tr("%1 have a contact (%2, 95 % CI %3 to %4).")
                                           .arg(last.contacts)
                                           .arg(percent(last.chance), percent(last.interval.low),
                                                percent(last.interval.high)));
    if (decisive) {
      words += QLatin1Char(' ') + tr("Median time %1.").arg(clockText(*decisive));
    }
  }
  const auto broken = std::count_if(futures_->begin(), futures_->end(),
                                    [](const app::Future& each) { return !each.failure.empty(); });
  if (broken > 0) {
    words += QLatin1Char(' ') + tr("%1 ended early.").arg(broken);
  }
  says_->setText(words);
}

void FuturesPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showAll();
  follow();
}

void FuturesPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  futuresLayer_->show(nullptr);  // Clears the map.
}

void addFuturesPanel(PanelRegistry& to) {
  to.add(closedBottomPanel(74, QObject::tr("Futures")),
         [](PanelContext& context) { return new FuturesPanel(context); });
}

}  // namespace editor
