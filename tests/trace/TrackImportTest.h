#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include <QTemporaryDir>

#include "sim2d/base/Find.h"
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

/// Options of which one is set.
template <class Member, class Value>
TrackImportOptions with(Member TrackImportOptions::*member, const Value& value) {
  TrackImportOptions options;
  options.*member = value;
  return options;
}

inline TrackImportOptions withColumns(const char* text) {
  return with(&TrackImportOptions::columns, *sim2d::parseColumns(text));
}

inline bool isNear(double a, double b) {
  return std::fabs(a - b) < 1e-9;
}

inline bool tells(const base::Diagnostics& problems, const char* code) {
  return base::findBy(problems, &base::Diagnostic::code, std::string_view(code)) != nullptr;
}

inline std::string textOf(const base::Diagnostics& problems) {
  std::string all;
  for (const base::Diagnostic& problem : problems) {
    all += problem.text() + "\n";
  }
  return all;
}

inline const Track* trackOf(const TrackFile& file, int id) {
  return base::findBy(file.tracks, &Track::id, id);
}

}  // namespace foreign
