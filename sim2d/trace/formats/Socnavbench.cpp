#include "sim2d/trace/TrackFormats.h"

/// SocNavBench: four lines with frames, ids, x and y.
namespace sim2d {

namespace {

TrackFile readSocnavbench(const TrackInput& input) {
  constexpr double kDefaultRate = 25.0;  // [1/s] of the source videos
  WordReader words(input.path, input.problems);
  TextRows reader(input.text);
  std::vector<std::vector<Word>> rows;
  for (std::vector<Word> row; rows.size() <= 4 && reader.next(row);) {
    rows.push_back(row);
  }
  FrameTracks tracks;
  const bool fits = rows.size() == 4 && rows[1].size() == rows[0].size() &&
                    rows[2].size() == rows[0].size() && rows[3].size() == rows[0].size();
  if (!fits) {
    input.error("tracks.four-lines");
    return {};
  }
  const std::vector<std::size_t> order =
      numberedColumns(input, {"frame", "id", "x", "y"}, rows.size());
  for (std::size_t k = 0; words.isUsable() && k < rows[0].size(); ++k) {
    tracks.add(words, rows[order[0]][k], rows[order[1]][k], rows[order[2]][k], rows[order[3]][k]);
  }
  return tracks.finish(input.path, input.rateOr(kDefaultRate));
}

FormatMatch matchFormat(const FilePreview& preview) {
  constexpr std::size_t kMaxColumns = 12;  // of a table with a header
  return preview.isNumbers && preview.row.size() > kMaxColumns && preview.endsWith(".csv")
             ? FormatMatch::ByContent
             : FormatMatch::None;
}

}  // namespace

void addSocnavbench(TrackFormats& to) {
  to.add({"socnavbench", 4, matchFormat, readSocnavbench, false, true});
}

}  // namespace sim2d
