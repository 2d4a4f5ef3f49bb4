#include "app/run/RunWriter.h"

#include <algorithm>
#include <filesystem>

#include "metrics/ReportFiles.h"
#include "sim2d/trace/TraceRows.h"

namespace app {

namespace {

std::string pathIn(const std::string& folder, const char* name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

RunWriter::Files::Files(const std::string& folder)
    : trajectory(pathIn(folder, "trajectory.csv")),
      events(pathIn(folder, "events.csv")),
      trees(pathIn(folder, "trees.csv")) {
  trajectory.append(sim2d::trajectoryHead());
  events.append(sim2d::eventsHead());
  trees.append(sim2d::treesHead());
}

RunWriter::RunWriter(const std::string& folder, const sim2d::World& world,
                     const metrics::Selection& selection,
                     const metrics::MetricParameters& parameters)
    : world_(world),
      dt_(world.dt()),
      files_(folder.empty() ? nullptr : std::make_unique<Files>(folder)),
      evaluation_(world.header(), selection, parameters) {
  for (const sim2d::TraceHuman& human : world.header().humans) {
    known_.insert(human.id);
  }
}

/// Somebody came from a source: the metrics ask who it is.
void RunWriter::meet(const sim2d::Frame& frame) {
  const std::vector<int>& ids = frame.humans.id;
  if (std::all_of(ids.begin(), ids.end(), [this](int id) { return known_.count(id) > 0; })) {
    return;
  }
  const std::vector<sim2d::TraceHuman> humans = world_.header().humans;
  evaluation_.addHumans(humans);
  for (const sim2d::TraceHuman& human : humans) {
    known_.insert(human.id);
  }
}

void RunWriter::write(const sim2d::RecordedStep& step) {
  std::string rows;
  if (step.frame != nullptr) {
    sim2d::appendTrajectoryRows(rows, *step.frame);
    files_->trajectory.append(rows);
  }
  rows.clear();
  for (const sim2d::Event& event : step.events) {
    sim2d::appendEventRow(rows, step.step, dt_, event);
  }
  files_->events.append(rows);
  files_->trees.append(step.treeRows);
}

void RunWriter::take(const sim2d::RecordedStep& step) {
  for (const sim2d::Event& event : step.events) {
    evaluation_.note(static_cast<double>(step.step) * dt_, event);
  }
  if (step.frame != nullptr) {
    meet(*step.frame);
    evaluation_.append(*step.frame);
  }
  if (files_) {
    write(step);
  }
  if (keepsTrace_) {
    for (const sim2d::Event& event : step.events) {
      trace_.events.emplace_back(step.step, event);
    }
    if (step.frame != nullptr) {
      trace_.frames.push_back(*step.frame);
    }
  }
}

base::Result<metrics::Evaluation> RunWriter::evaluation() {
  return evaluation_.finish([this](const metrics::MetricInfo& info, const metrics::Series& series) {
    Column& column = columns_.emplace_back();
    column.key = info.key;
    column.kind = series.kind;
    for (const double value : series.values) {
      column.values.add(value, &store_);
    }
  });
}

base::Diagnostics RunWriter::writeSteps(const std::string& path, const std::vector<double>& times) {
  std::vector<metrics::StepColumn> columns;
  for (const Column& column : columns_) {
    if (column.values.size() == times.size()) {
      columns.push_back({column.key, column.kind,
                         [reader = metrics::StoredNumbersReader(column.values)]() mutable {
                           return reader.next();
                         }});
    }
  }
  base::GrowingFile file(path);
  metrics::writeSteps(times, std::move(columns),
                      [&file](std::string_view rows) { file.append(rows); });
  if (store_.hasFailed()) {
    return {base::makeError("series in a temporary file could not be read back", path)};
  }
  return file.finish();
}

bool RunWriter::hasFailed() const {
  return files_ && (files_->trajectory.hasFailed() || files_->events.hasFailed() ||
                    files_->trees.hasFailed());
}

base::Diagnostics RunWriter::complete() {
  base::Diagnostics problems;
  if (files_) {
    base::append(problems, files_->trajectory.complete());
    base::append(problems, files_->events.complete());
    base::append(problems, files_->trees.complete());
  }
  return problems;
}

base::Diagnostics RunWriter::finish() {
  base::Diagnostics problems;
  if (files_) {
    base::append(problems, files_->trajectory.finish());
    base::append(problems, files_->events.finish());
    base::append(problems, files_->trees.finish());
    files_.reset();
  }
  return problems;
}

}  // namespace app
