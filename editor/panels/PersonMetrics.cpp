#include "editor/panels/PersonMetrics.h"

namespace editor {

namespace {

/// Those metrics of a selection that depend on people, without values per sample.
metrics::Selection ofPeople(metrics::Selection selection) {
  metrics::Selection::Keys keys;
  for (const metrics::MetricEntry& entry : metrics::standardRegistry().entries()) {
    const bool isMeant = selection.selects(entry.info) && entry.info.needs.people;
    if (entry.info.hunav > 0 && !isMeant) {
      keys.off.insert(entry.info.key);
    } else if (entry.info.hunav == 0 && isMeant) {
      keys.on.insert(entry.info.key);
    }
  }
  selection.keys = std::move(keys);
  selection.own.clear();
  selection.series = false;
  return selection;
}

}  // namespace

/// One measurement per person, extended as the run continues and begun anew for an earlier step.
struct PersonMetrics::Work {
  RecordingPtr recording;
  app::MetricsSetup setup;
  std::vector<int> people;
  std::vector<std::unique_ptr<app::RecordingMeasurer>> measurers;

  void begin() {
    measurers.clear();
    for (const int person : people) {
      measurers.push_back(std::make_unique<app::RecordingMeasurer>(
          *recording->header(), setup.selection, setup.parameters, nullptr, person));
    }
  }

  Values upTo(std::size_t index, const base::StopFlagPtr& stop) {
    if (measurers.empty() || measurers.front()->taken() > index + 1) {
      begin();
    }
    Values values;
    values.index = index;
    for (std::size_t k = 0; k < people.size(); ++k) {
      app::RecordingMeasurer& measurer = *measurers[k];
      bool isThere = true;
      while (isThere && measurer.taken() <= index) {
        stop->check();
        isThere = measurer.takeNext(*recording);  // The start of the run may have been dropped.
      }
      if (isThere) {
        values.results[people[k]] = measurer.results();
      }
    }
    return values;
  }
};

PersonMetrics::PersonMetrics(const MetricsFeed& feed, SimulationRunner& runner)
    : feed_(feed), runner_(runner), task_([this](Values values) {
        values_ = std::move(values);
        Q_EMIT updated();
        follow();
      }) {
  connect(&feed_, &MetricsFeed::cleared, this, &PersonMetrics::restart);
  connect(&runner_, &SimulationRunner::frameShown, this, &PersonMetrics::follow);
}

PersonMetrics::~PersonMetrics() {
  stop_->stop();
  task_.abandon();
}

void PersonMetrics::setPeople(std::vector<int> ids) {
  if (ids != people_) {
    people_ = std::move(ids);
    restart();
  }
}

const metrics::MetricResult* PersonMetrics::find(int person, const std::string& key) const {
  if (!values_) {
    return nullptr;
  }
  const auto found = values_->results.find(person);
  return found == values_->results.end() ? nullptr : metrics::findResult(found->second, key);
}

bool PersonMetrics::isCurrent() const {
  const std::optional<std::size_t> index = shownIndex();
  return people_.empty() || !index || (values_ && values_->index == *index && !task_.isBusy());
}

/// Another run, other metrics or other people.
void PersonMetrics::restart() {
  stop_->stop();
  stop_ = std::make_shared<base::StopFlag>();
  task_.forget();
  work_.reset();
  if (std::exchange(values_, std::nullopt)) {
    Q_EMIT updated();
  }
  follow();
}

std::shared_ptr<PersonMetrics::Work> PersonMetrics::makeWork() const {
  base::Result<app::MetricsSetup> setup = feed_.setup();
  if (!setup) {
    return nullptr;  // The feed has reported the problems.
  }
  setup->selection = ofPeople(feed_.selection());
  setup->selection.robotId = feed_.robot();
  auto work = std::make_shared<Work>();
  work->recording = recording_;
  work->setup = *std::move(setup);
  work->people = people_;
  return work;
}

std::optional<std::size_t> PersonMetrics::shownIndex() const {
  const FramePtr frame = runner_.shownFrame();
  return recording_ != nullptr && frame != nullptr ? std::optional(recording_->indexAt(frame->step))
                                                   : std::nullopt;
}

void PersonMetrics::follow() {
  if (runner_.recording() != recording_) {
    recording_ = runner_.recording();
    restart();
    return;
  }
  const std::optional<std::size_t> index = shownIndex();
  if (people_.empty() || !index || (values_ && values_->index == *index)) {
    return;
  }
  if (work_ == nullptr) {
    work_ = makeWork();
  }
  if (work_ != nullptr) {
    task_.start([work = work_, index = *index, stop = base::StopFlagPtr(stop_)] {
      return work->upTo(index, stop);
    });
  }
}

}  // namespace editor
