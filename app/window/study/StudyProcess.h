#pragma once

#include <string>

#include "app/run/ManifestFiles.h"
#include "app/window/study/StudyRows.h"

namespace app {

/// Runs `hunavsim batch` as a child process, so that a crash does not affect the window. GUI
/// thread.
class StudyProcess : public QObject {
  Q_OBJECT
 public:
  enum class Begin { Resume, Restart };

  explicit StudyProcess(QObject* parent);
  /// Interrupts the process and waits; finished runs are kept.
  ~StudyProcess() override;
  Q_DISABLE_COPY_MOVE(StudyProcess)

  void setProgram(const QString& path) { program_ = path; }  // replaces this program
  const QString& program() const { return program_; }
  bool isRunning() const { return process_.state() != QProcess::NotRunning; }
  void start(const QString& experiment, const QString& folder, int jobs, Begin begin,
             bool allowCode);
  void stop();  // as Ctrl-C; `ended` is emitted

 Q_SIGNALS:
  void began(const app::StudyHeader& begin);
  void rowsReceived(const std::vector<app::StudyRow>& rows);  // batched
  /// All runs are finished; otherwise `problems` is the text of standard error.
  void ended(bool isComplete, const QString& problems);

 private:
  void read();
  void reportEnd();

  QString program_;
  QProcess process_;
  bool isStopped_ = false;
};

/// Existing results in the folder of a study.
struct RestoredStudy {
  std::vector<StudyRow> rows;
  QStringList paths;                      // value paths
  std::size_t runs = 0;                   // number of runs, finished or not
  std::optional<std::string> experiment;  // experiment text, if the results contain it
  QString trouble;                        // why results could not be read
  std::string experimentPath;             // as the batch was given it
  std::vector<InputHash> inputs;          // files that the runs have read
};

/// Reads the database, otherwise results.csv; neither is changed. Without a folder there are no
/// rows.
RestoredStudy restoredStudyIn(const QString& folder);

/// The name of an input file whose content differs from that of the runs; empty: none. `file`: the
/// experiment file; relative paths are those of the folder in which the batch was started, as far
/// as it follows from the path of this file. Missing files are no difference. Reads all files.
QString changedInputOf(const std::string& experimentPath, std::vector<InputHash> inputs,
                       const QString& file);

/// Whether a batch has written its results into the folder.
bool isBatchFolder(const QString& folder);
/// The experiment file of the batch in the folder; empty: not found (see experimentFileOf).
QString experimentOfBatch(const QString& folder);
/// Why there is no such file.
base::Diagnostic missingExperimentOf(const QString& folder);

/// The reason why this experiment cannot be resumed with the results in the folder. Empty: it can,
/// or there are no results.
QString resumeObstacle(const QString& folder, const std::string& experiment);
/// The process that is writing results into the folder; empty: none.
QString folderWriter(const QString& folder);

}  // namespace app
