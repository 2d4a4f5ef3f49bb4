#pragma once

#include <map>
#include <string>

#include "sim2d/trace/ForeignFiles.h"
#include "sim2d/trace/TextRows.h"

/// One function per format; for the sources of this folder. Problems are added.
namespace sim2d {

struct ForeignInput {
  const std::string& path;
  const std::string& text;
  const ForeignOptions& options;
  base::Diagnostics& problems;
};

TrackFile readCsvTracks(const ForeignInput& input);
TrackFile readObsmat(const ForeignInput& input);   // ETH, UCY
TrackFile readVsp(const ForeignInput& input);      // UCY
TrackFile readTrajnet(const ForeignInput& input);  // rows or ndjson
TrackFile readTrajnetJson(const ForeignInput& input);
TrackFile readSocnavbench(const ForeignInput& input);

constexpr double kAnnotationStep = 0.4;  // [s] of the ETH, UCY and TrajNet sets

/// Observations by person, numbered by frames of a film.
class FrameTracks {
 public:
  /// `line`, `column`: where it stands in the source. The point, for what else is known of it.
  TrackPoint& add(int id, long long frame, const Vec2& position, int line, int column);
  TrackFile finish(const std::string& path, double framesPerSecond);

 private:
  std::map<int, Track> tracks_;
};

/// Times that count frames become seconds: by the rate, or (0) so that the median step between two
/// observations is kAnnotationStep.
void framesToSeconds(TrackFile& file, double framesPerSecond);

/// The file of this name beside `path`.
std::string besideFile(const std::string& path, const std::string& name);
/// Ids of a group per line, if the file is there; groups are numbered from 1.
void readGroupsBeside(const ForeignInput& input, TrackFile& file);

}  // namespace sim2d
