#include "sim2d/trace/ForeignReaders.h"

/// Rows of the obsmat files of ETH and UCY.
namespace sim2d {

namespace {

TrackFile readObsmat(const ForeignInput& input) {
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
  const double given = input.options.framesPerSecond;
  TrackFile file =
      tracks.finish(input.path, given > 0.0 ? given : statedRate(leadingComments(input.text)));
  readGroupsBeside(input, file);
  return file;
}

Claim claim(const FirstLook& look) {
  return look.isNumbers && look.row.size() == 8 && !look.endsWith(".csv") ? Claim::ByContent
                                                                          : Claim::None;
}

}  // namespace

void addEth(TrackFormats& to) {
  to.add({"eth", 1, claim, readObsmat});
}

}  // namespace sim2d
