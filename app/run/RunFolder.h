#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/OutputFolder.h"
#include "metrics/PlanningTime.h"
#include "metrics/RunningEvaluation.h"
#include "sim2d/base/Files.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"

namespace app {

/// Takes a run beside its writer and makes more files of it.
class RunCompanion : public sim2d::FrameSink {
 public:
  /// A file could not be written: there is no use in going on.
  virtual bool hasFailed() const = 0;
  /// The run is over, once: what is left may be made beside what follows. `header`: of all of it.
  virtual void conclude(const sim2d::TraceHeader& header) = 0;
  /// After that: the rest of its files, in the staging folder.
  virtual base::Diagnostics finish(OutputFolder& output) = 0;
};

/// Takes a run while it goes on: trajectory, events and tree changes go into the files of its
/// folder, the metrics are fed. Of past steps nothing stays in memory but their times.
class RunWriter : public sim2d::FrameSink {
 public:
  /// An empty folder: no files. The world must outlive the writer. `known`: routes of runs before.
  /// `header`: of the record as it will be in the end, the world's own mostly.
  RunWriter(const std::string& folder, const sim2d::World& world, const sim2d::TraceHeader& header,
            const metrics::Selection& selection, const metrics::MetricParameters& parameters,
            const std::shared_ptr<metrics::KnownRoutes>& known = nullptr);
  void append(const sim2d::Frame& frame) override;
  /// It gets every frame too, and lives as long as this.
  void setCompanion(RunCompanion* companion) { companion_ = companion; }
  RunCompanion* companion() const { return companion_; }  // null: there is none

  /// Once, at the end. Its results have no series: those are for writeSteps().
  base::Result<metrics::Evaluation> evaluation();
  /// steps.csv of a robot of the evaluation.
  base::Diagnostics writeSteps(const std::string& path, const metrics::Evaluation& ofRobot);
  bool hasInputs() const { return files_[Inputs].has_value(); }  // something came from outside
  bool hasScans() const { return files_[Scans].has_value(); }    // a robot records its lidar
  /// A file could not be written: there is no use in going on.
  bool hasFailed() const;
  /// Puts the files in their places in the folder; nothing of them is there before.
  base::Diagnostics finish();

 private:
  enum File { Trajectory, Events, Trees, Inputs, Scans };
  void begin(File file, std::string_view head);
  void meet(const sim2d::Frame& frame);
  void write(const sim2d::Frame& frame, bool isRecorded);
  void writeScans(const std::vector<sim2d::RecordedScan>& scans);
  struct Column {
    std::string robot, key;
    metrics::Kind kind = metrics::Kind::Number;
    metrics::StoredNumbers values;
  };

  const sim2d::World& world_;
  double dt_;
  int recordEvery_ = 1;
  const std::string folder_;
  // inputs and scans once there were some
  std::array<std::optional<base::GrowingFile>, 5> files_;
  metrics::FrameEvaluation evaluation_;
  RunCompanion* companion_ = nullptr;
  std::set<int> known_;  // people that the metrics have been told of
  metrics::NumberStore store_;
  std::vector<Column> columns_;  // in the store
};

/// The run that another one goes on from.
struct RunBefore {
  std::string folder;
  double time = 0.0;  // [s]
  std::int64_t step = 0;
  std::uint64_t seed = 1;  // of what is drawn from there on
};

/// All that is known after a run, beside the files that were written while it went on.
struct FinishedRun {
  sim2d::TraceHeader header;
  sim2d::RunResult result;
  metrics::PlanningTime planning;
  base::Result<metrics::Evaluation> evaluation;
  std::string effectsCsv;   // of the run without robots; empty = there was none
  bool totalsOnly = false;  // nothing per step is written
  std::optional<RunBefore> before;
  std::vector<std::string> robotReports;  // World::robotReports
};

/// The files of a run (FORMAT.md), beside those that `writer` makes in the staging folder of the
/// output, put in their places together; those of a former run are taken away.
base::Diagnostics writeRunFolder(OutputFolder& output, const FinishedRun& run, RunWriter& writer,
                                 const Bundle& bundle, const std::vector<std::string>& commandLine);
/// All that a run may write. `robots`: their names, as metrics::robotNames gives them.
std::vector<std::string> runFileNames(const std::vector<std::string>& robots, bool totalsOnly);
/// After a run was read: its files are those that its manifest lists.
base::Diagnostics checkParts(const std::string& runFolder);
/// The run of a folder. Errors, beside those of the files: it was not written to its end, its files
/// are of different runs.
base::Result<sim2d::Trace> readRun(const std::string& runFolder);

/// The files that a bundle is made of, those that trees include too, each once.
std::vector<std::string> inputsOf(const Bundle& bundle);

/// Whether all that is in the folder of a run is of a run (`isOurs`: its files are of an earlier
/// batch; else only those that were cut short count): nothing else would be lost with it. What is
/// not, by its name; a link is of somebody else.
std::optional<std::string> strangerIn(const std::string& runFolder, bool isOurs);
/// Removes the files of a run, and the folder when nothing else is in it. From its begin on no
/// reader takes what is left for a run.
base::Diagnostics removeRun(const std::string& runFolder);

}  // namespace app
