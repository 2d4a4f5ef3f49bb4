#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QProcess>

#include "app/run/Experiment.h"

namespace app {

/// What is known of one run of a batch after its process has ended.
struct BatchRow {
  bool ok = false;
  std::string reason;                          // of a failure
  std::string simulated;                       // [s], as text; empty when not known
  std::map<std::string, std::string> metrics;  // key -> CSV field
};

/// Runs the runs of an experiment as child processes of this program, `jobs` at a time (Box2D keeps
/// process-wide statics, so worlds in parallel are processes). Rows are in the order of the runs,
/// whatever the order they end in.
class BatchRunner : public QObject {
  Q_OBJECT

 public:
  /// `runsFolder`: each run writes into <runsFolder>/<run>; which of them stay is up to the
  /// experiment.
  BatchRunner(const Experiment& experiment, std::string runsFolder, int jobs);

  /// Returns when all runs have ended, or `wantsStop` says so (running children are ended then).
  /// `onProgress` is called with the number of finished runs.
  void execute(const std::function<bool()>& wantsStop,
               const std::function<void(std::size_t finished)>& onProgress);

  const std::vector<std::optional<BatchRow>>& rows() const { return rows_; }

 private:
  void startMore();
  void start(std::size_t run);
  void onFinished(QProcess* process, std::size_t run);
  QStringList arguments(std::size_t run) const;
  std::string folderOf(std::size_t run) const;
  void keepOrRemove(std::size_t run, const BatchRow& row) const;
  void removeFolder(std::size_t run) const;
  void stopChildren();

  const Experiment& experiment_;
  std::string runsFolder_;
  int jobs_;
  std::size_t next_ = 0, finished_ = 0;
  bool stopping_ = false;
  std::vector<QProcess*> children_;
  std::vector<std::optional<BatchRow>> rows_;
  std::function<void(std::size_t)> onProgress_;
};

}  // namespace app
