#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <QTemporaryDir>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackImport.h"

/// Files of other programs, written for a test.
namespace foreign {

using sim2d::Trace;
using sim2d::Track;
using sim2d::TrackFile;
using sim2d::TrackImportOptions;
using sim2d::TrackOptions;

/// A file in a folder of its own.
class Written {
 public:
  std::string add(const char* name, const std::string& text) {
    const std::string path = folder_.path().toStdString() + "/" + name;
    written_ = base::writeFileAtomically(path, text).empty() && written_;
    return written_ ? path : std::string();
  }

 private:
  QTemporaryDir folder_;
  bool written_ = true;
};

inline base::Result<TrackFile> read(const std::string& path,
                                    const TrackImportOptions& options = {}) {
  return sim2d::importTracks(path, options);
}

inline base::Result<Trace> traceOf(const std::string& path, const TrackImportOptions& options = {},
                                   const TrackOptions& tracks = {}) {
  const base::Result<TrackFile> file = sim2d::importTracks(path, options);
  return file ? sim2d::traceOfTracks(*file, tracks) : base::Result<Trace>(file.diagnostics());
}

inline TrackImportOptions withColumns(const char* text) {
  TrackImportOptions options;
  options.columns = *sim2d::parseColumns(text);
  return options;
}

inline bool isNear(double a, double b) {
  return std::fabs(a - b) < 1e-9;
}

inline bool tells(const base::Diagnostics& problems, const char* code) {
  return std::any_of(problems.begin(), problems.end(),
                     [code](const base::Diagnostic& each) { return each.code == code; });
}

inline const Track* trackOf(const TrackFile& file, int id) {
  for (const Track& track : file.tracks) {
    if (track.id == id) {
      return &track;
    }
  }
  return nullptr;
}

}  // namespace foreign
