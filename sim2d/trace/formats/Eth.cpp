#include "sim2d/trace/ForeignReaders.h"

/// Rows of the obsmat files of ETH and UCY.
namespace sim2d {

namespace {

TrackFile readObsmat(const ForeignInput& input) {
  FrameTracks tracks;
  forEachRow(input, 8, "frame id x z y vx vz vy",
             [&](WordReader& words, const std::vector<Word>& row) {
               const std::optional<long long> frame = words.whole(row[0], "the frame");
               const std::optional<int> id = idOf(words, row[1]);
               const std::optional<double> x = words.finite(row[2], "x");
               const std::optional<double> y = words.finite(row[4], "y");
               const std::optional<double> vx = words.finite(row[5], "vx");
               const std::optional<double> vy = words.finite(row[7], "vy");
               if (frame && id && x && y && vx && vy) {
                 tracks.add(*id, *frame, Vec2(*x, *y), row[0].line, row[0].column).velocity =
                     Vec2(*vx, *vy);
               }
             });
  TrackFile file = tracks.finish(input.path, input.options.framesPerSecond);
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
