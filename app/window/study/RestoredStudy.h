#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/window/study/StudyRows.h"

namespace app {

/// Existing results in the folder of a study.
struct RestoredStudy {
  std::vector<StudyRow> rows;
  QStringList paths;                      // value paths
  std::size_t runs = 0;                   // number of runs, finished or not
  std::optional<std::string> experiment;  // experiment text, if the results contain it
  QString trouble;                        // why results could not be read
};

/// Reads the database, otherwise results.csv; neither is changed. Without a folder there are no
/// rows.
RestoredStudy restoredStudyIn(const QString& folder);

/// The reason why this experiment cannot be resumed with the results in the folder. Empty: it can,
/// or there are no results.
QString resumeObstacle(const QString& folder, const std::string& experiment);
/// The process that is writing results into the folder; empty: none.
QString folderWriter(const QString& folder);

}  // namespace app
