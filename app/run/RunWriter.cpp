#include "app/run/RunWriter.h"

#include <algorithm>
#include <filesystem>

#include "metrics/ReportFiles.h"
#include "sim2d/trace/Trace.h"

namespace app {

namespace {

std::string pathIn(const std::string& folder, const char* name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace

RunWriter::Files::Files(const std::string& path)
    : folder(path),
      trajectory(pathIn(folder, "trajectory.csv")),
      events(pathIn(folder, "events.csv")),
      trees(pathIn(folder, "trees.csv")) {
  trajectory.append(sim2d::headLine(sim2d::kTrajectoryColumns));
  events.append(sim2d::headLine(sim2d::kEventColumns));
  trees.append(sim2d::headLine(sim2d::kTreeColumns));
}

std::vector<base::GrowingFile*> RunWriter::files() const {
  if (!files_) {
    return {};
  }
  std::vector<base::GrowingFile*> all = {&files_->trajectory, &files_->events, &files_->trees};
  if (files_->inputs) {
    all.push_back(&*files_->inputs);
  }
  return all;
}

RunWriter::RunWriter(const std::string& folder, const sim2d::World& world,
                     const metrics::Selection& selection,
                     const metrics::MetricParameters& parameters)
    : world_(world),
      dt_(world.dt()),
      files_(folder.empty() ? nullptr : std::make_unique<Files>(folder)),
      evaluation_(world.header(), selection, parameters) {
  const sim2d::TraceHeader header = world.header();
  recordEvery_ = header.recordEvery;
  for (const sim2d::TraceHuman& human : header.humans) {
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

void RunWriter::write(const sim2d::Frame& frame, bool isRecorded) {
  std::string rows;
  if (isRecorded) {
    sim2d::appendTrajectoryRows(rows, frame);
    files_->trajectory.append(rows);
  }
  rows.clear();
  for (const sim2d::Event& event : frame.events) {
    sim2d::appendEventRow(rows, frame.step, dt_, event);
  }
  files_->events.append(rows);
  rows.clear();
  sim2d::appendTreeRows(rows, frame.step, frame.treeChanges);
  files_->trees.append(rows);
  if (!frame.inputs.empty() && !files_->inputs) {
    files_->inputs.emplace(pathIn(files_->folder, "inputs.csv"));
    files_->inputs->append(sim2d::inputsHead());
  }
  for (const sim2d::Input& input : frame.inputs) {
    rows.clear();
    sim2d::appendInputRow(rows, frame.step, input);
    files_->inputs->append(rows);
  }
}

void RunWriter::append(const sim2d::Frame& frame) {
  const bool isRecorded = frame.step % recordEvery_ == 0;
  for (const sim2d::Event& event : frame.events) {
    evaluation_.note(static_cast<double>(frame.step) * dt_, event);
  }
  if (isRecorded) {
    meet(frame);
    evaluation_.append(frame);
  }
  if (files_) {
    write(frame, isRecorded);
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
    return {base::error("metrics.series-lost", {}, path)};
  }
  return file.finish();
}

bool RunWriter::hasFailed() const {
  const std::vector<base::GrowingFile*> all = files();
  return std::any_of(all.begin(), all.end(),
                     [](const base::GrowingFile* file) { return file->hasFailed(); });
}

base::Diagnostics RunWriter::complete() {
  base::Diagnostics problems;
  for (base::GrowingFile* file : files()) {
    base::append(problems, file->complete());
  }
  return problems;
}

base::Diagnostics RunWriter::finish() {
  base::Diagnostics problems;
  for (base::GrowingFile* file : files()) {
    base::append(problems, file->finish());
  }
  files_.reset();
  return problems;
}

}  // namespace app
