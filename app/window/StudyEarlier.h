#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/window/StudyRows.h"

namespace app {

/// Results that lie in the folder of a study already.
struct StudyEarlier {
  std::vector<StudyRow> rows;
  QStringList paths;                      // of values
  std::size_t runs = 0;                   // of the study, finished or not
  std::optional<std::string> experiment;  // its text, where the results tell it
  QString trouble;                        // why they cannot be read, or not all of them
};

/// Those of the database, else of results.csv; neither is changed. No folder: no rows.
StudyEarlier earlierIn(const QString& folder);

/// Why a study of this text cannot go on with what lies in the folder; empty: it can, or nothing
/// lies there.
QString whyNotGoOn(const QString& folder, const std::string& experiment);
/// Who writes results into the folder now; empty: nobody.
QString whoWritesInto(const QString& folder);

}  // namespace app
