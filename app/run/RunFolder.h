#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/OutputFolder.h"
#include "metrics/IncrementalEvaluation.h"
#include "metrics/RunResults.h"
#include "sim2d/base/Files.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"

namespace app {

/// Receives a run in addition to its writer and produces additional files.
class AdditionalRunWriter : public sim2d::FrameSink {
 public:
  /// A file could not be written, so the run should stop.
  virtual bool hasFailed() const = 0;
  /// Called once when the run has ended; remaining files may be produced in parallel with what
  /// follows. `header`: the complete one.
  virtual void conclude(const sim2d::TraceHeader& header) = 0;
  /// Called afterwards: writes the remaining files to the staging folder.
  virtual base::Diagnostics finish(OutputFolder& output) = 0;
};

/// Writes trajectory, events and tree changes of a run into its folder and feeds the metrics, step
/// by step. Of past steps only the times stay in memory.
class RunWriter : public sim2d::FrameSink {
 public:
  /// Empty `folder`: no files. The world must outlive the writer. `known`: routes of earlier runs.
  /// `header`: of the recording, usually that of the world.
  RunWriter(const std::string& folder, const sim2d::World& world, const sim2d::TraceHeader& header,
            const metrics::Selection& selection, const metrics::MetricParameters& parameters,
            const std::shared_ptr<metrics::ShortestPathCache>& known = nullptr);
  void append(const sim2d::Frame& frame) override;
  /// It receives every frame too and must outlive the writer.
  void setAdditionalWriter(AdditionalRunWriter* additionalWriter) {
    additionalWriter_ = additionalWriter;
  }
  AdditionalRunWriter* additionalWriter() const {
    return additionalWriter_;
  }  // null if there is none

  /// Call once, at the end. The results have no series; writeSteps() writes those.
  base::Result<metrics::Evaluation> evaluation();
  /// Writes steps.csv of one robot of the evaluation.
  base::Diagnostics writeSteps(const std::string& path, const metrics::Evaluation& ofRobot);
  /// A file could not be written, so the run should stop.
  bool hasFailed() const;
  /// Closes the files and renames them to their final names, which do not exist before.
  base::Diagnostics finish();

 private:
  enum File { Trajectory, Events, Trees, Inputs, Scans, FileCount };
  void begin(File file);
  void write(const sim2d::Frame& frame, bool isRecorded);
  struct Column {
    std::string robot, key;
    metrics::Kind kind = metrics::Kind::Number;
    metrics::StoredSeries values;
  };

  const sim2d::World& world_;
  double dt_;
  int recordEvery_ = 1;
  const std::string folder_;
  // inputs and scans after the first one
  std::array<std::optional<base::AtomicFileWriter>, FileCount> files_;
  metrics::FrameEvaluation evaluation_;
  AdditionalRunWriter* additionalWriter_ = nullptr;
  sim2d::KnownPeople known_;  // to the metrics
  metrics::SeriesStorage store_;
  std::vector<Column> columns_;  // in the store
};

/// The run that another run continues.
struct RunOrigin {
  std::string folder;
  double time = 0.0;  // [s]
  std::int64_t step = 0;
  std::uint64_t seed = 1;  // of all random numbers from this step on
};

/// The results of a run, in addition to the files written during the run.
struct FinishedRun {
  sim2d::TraceHeader header;
  sim2d::RunResult result;
  metrics::PlanningTime planning;
  base::Result<metrics::Evaluation> evaluation;
  std::string effectsCsv;   // of the run without robots; empty = none
  bool totalsOnly = false;  // no files per step
  std::optional<RunOrigin> origin;
  std::vector<std::string> plannerReports;  // World::plannerReports
};

/// Completes the run folder (FORMAT.md): writes the files that `writer` does not write and commits
/// all of them; files of an earlier run are removed.
base::Diagnostics writeRunFolder(OutputFolder& output, const FinishedRun& run, RunWriter& writer,
                                 const Bundle& bundle, const std::vector<std::string>& commandLine);
/// All files that a run can write. `robots`: names as of metrics::robotNames.
std::vector<std::string> runFileNames(const std::vector<std::string>& robots, bool totalsOnly);
/// Checks the files of a run that was read against its manifest.
base::Diagnostics checkRunFiles(const std::string& runFolder);
/// Reads the run of a folder. Errors: file problems, an incomplete run, or files of different runs.
base::Result<sim2d::Trace> readRun(const std::string& runFolder);

/// The files that a bundle was read from, including files that trees include, each once.
std::vector<std::string> inputsOf(const Bundle& bundle);

/// The first path in a run folder that does not belong to a run, which removeRunFolder() would not
/// remove; nullopt if there is none. `ofEarlierBatch`: the folder belongs to an earlier batch;
/// otherwise only temporary files count as part of a run. Links never do.
std::optional<std::string> foreignEntryIn(const std::string& runFolder, bool ofEarlierBatch);
/// Removes the files of a run, and the folder if it is empty. The first file removed is one without
/// which no reader accepts the rest as a run.
base::Diagnostics removeRunFolder(const std::string& runFolder);

}  // namespace app
