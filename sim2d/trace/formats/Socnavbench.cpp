#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Four lines: frames, ids, x, y.
namespace sim2d {

namespace {

/// Number of the row with this quantity, from 0.
std::size_t rowOf(const ForeignInput& input, const char* name, std::size_t usual) {
  const auto found = input.options.columns.find(name);
  if (found == input.options.columns.end()) {
    return usual;
  }
  const std::optional<long long> row = base::parseInt(found->second);
  if (!row || *row < 1 || *row > 4) {
    input.problems.push_back(base::error("tracks.bad-row", {name, found->second}));
    return usual;
  }
  return static_cast<std::size_t>(*row) - 1;
}

TrackFile readSocnavbench(const ForeignInput& input) {
  constexpr double kUsualRate = 25.0;  // [1/s] of the films
  WordReader words(input.path, input.problems);
  TextRows reader(input.text);
  std::vector<std::vector<Word>> rows;
  for (std::vector<Word> row; reader.next(row);) {
    rows.push_back(row);
  }
  FrameTracks tracks;
  const bool fits = rows.size() == 4 && rows[1].size() == rows[0].size() &&
                    rows[2].size() == rows[0].size() && rows[3].size() == rows[0].size();
  if (!fits) {
    input.problems.push_back(base::error("tracks.four-lines", {}, input.path));
    return {};
  }
  const std::size_t frameRow = rowOf(input, "frame", 0);
  const std::size_t idRow = rowOf(input, "id", 1);
  const std::size_t xRow = rowOf(input, "x", 2);
  const std::size_t yRow = rowOf(input, "y", 3);
  for (std::size_t k = 0; k < rows[0].size(); ++k) {
    tracks.add(words, rows[frameRow][k], rows[idRow][k], rows[xRow][k], rows[yRow][k]);
  }
  const double rate = input.options.framesPerSecond;
  return tracks.finish(input.path, rate > 0.0 ? rate : kUsualRate);
}

Claim claim(const FirstLook& look) {
  constexpr std::size_t kMostColumns = 12;  // of a table with a header
  return look.isNumbers && look.row.size() > kMostColumns && look.endsWith(".csv")
             ? Claim::ByContent
             : Claim::None;
}

}  // namespace

void addSocnavbench(TrackFormats& to) {
  to.add({"socnavbench", 4, claim, readSocnavbench, false, true});
}

}  // namespace sim2d
