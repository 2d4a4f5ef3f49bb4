#include "sim2d/trace/TrackFormats.h"

/// ETH and UCY data sets: obsmat files.
namespace sim2d {

namespace {

TrackFile readObsmat(const TrackInput& input) {
  FrameTracks tracks;
  forEachRow(input, 8, "frame id x z y vx vz vy",
             [&](WordReader& words, const std::vector<Word>& row) {
               TrackPoint* point = tracks.add(words, row[0], row[1], row[2], row[4]);
               const std::optional<double> vx = words.finite(row[5], "vx");
               const std::optional<double> vy = words.finite(row[7], "vy");
               if (point != nullptr && vx && vy) {
                 point->velocity = Vec2(*vx, *vy);
               }
             });
  TrackFile file = tracks.finish(input.path, input.rateOr(statedRate(leadingComments(input.text))));
  readGroupsFile(input, file);
  return file;
}

FormatMatch matchFormat(const FilePreview& preview) {
  return preview.isNumbers && preview.row.size() == 8 && !preview.endsWith(".csv")
             ? FormatMatch::ByContent
             : FormatMatch::None;
}

}  // namespace

void addEth(TrackFormats& to) {
  to.add({"eth", 1, matchFormat, readObsmat});
}

}  // namespace sim2d
