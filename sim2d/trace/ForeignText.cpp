#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Plain rows of numbers: obsmat of ETH and UCY, rows of TrajNet, columns of SocNavBench.
namespace sim2d {

namespace {

/// Calls `take` with the words of each row that has `width` of them.
template <class Take>
void forEachRow(const ForeignInput& input, std::size_t width, const char* columns, Take take) {
  WordReader words(input.path, input.problems);
  TextRows rows(input.text);
  std::vector<Word> row;
  while (rows.next(row)) {
    if (row.size() == width) {
      take(words, row);
    } else {
      words.error(row.back(), "the line has " + std::to_string(row.size()) +
                                  " numbers instead of " + std::to_string(width) + " (" + columns +
                                  ")");
    }
  }
}

std::optional<int> idOf(WordReader& words, const Word& word) {
  const std::optional<long long> id = words.whole(word, "the id");
  if (id && *id < 0) {
    words.error(word, "an id must not be negative");
    return std::nullopt;
  }
  return id ? std::make_optional(static_cast<int>(*id)) : std::nullopt;
}

}  // namespace

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

namespace {

TrackFile readTrajnetRows(const ForeignInput& input) {
  FrameTracks tracks;
  forEachRow(input, 4, "frame id x y", [&](WordReader& words, const std::vector<Word>& row) {
    const std::optional<long long> frame = words.whole(row[0], "the frame");
    const std::optional<int> id = idOf(words, row[1]);
    const std::optional<double> x = words.finite(row[2], "x");
    const std::optional<double> y = words.finite(row[3], "y");
    if (frame && id && x && y) {
      tracks.add(*id, *frame, Vec2(*x, *y), row[0].line, row[0].column);
    }
  });
  return tracks.finish(input.path, input.options.framesPerSecond);
}

}  // namespace

TrackFile readTrajnet(const ForeignInput& input) {
  const std::size_t first = input.text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && input.text[first] == '{';
  return isJson ? readTrajnetJson(input) : readTrajnetRows(input);
}

namespace {

/// Number of the row with this quantity, from 0.
std::size_t rowOf(const ForeignInput& input, const char* name, std::size_t usual) {
  const auto found = input.options.columns.find(name);
  if (found == input.options.columns.end()) {
    return usual;
  }
  const std::optional<long long> row = base::parseInt(found->second);
  if (!row || *row < 1 || *row > 4) {
    input.problems.push_back(base::makeError(std::string("the column ") + name +
                                             " of this format is a row, 1 to 4, not '" +
                                             found->second + "'"));
    return usual;
  }
  return static_cast<std::size_t>(*row) - 1;
}

}  // namespace

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
    input.problems.push_back(
        base::makeError("needs four lines of as many numbers each: frames, ids, x, y", input.path));
    return {};
  }
  const std::size_t frameRow = rowOf(input, "frame", 0);
  const std::size_t idRow = rowOf(input, "id", 1);
  const std::size_t xRow = rowOf(input, "x", 2);
  const std::size_t yRow = rowOf(input, "y", 3);
  for (std::size_t k = 0; k < rows[0].size(); ++k) {
    const std::optional<long long> frame = words.whole(rows[frameRow][k], "the frame");
    const std::optional<int> id = idOf(words, rows[idRow][k]);
    const std::optional<double> x = words.finite(rows[xRow][k], "x");
    const std::optional<double> y = words.finite(rows[yRow][k], "y");
    if (frame && id && x && y) {
      const Word& place = rows[frameRow][k];
      tracks.add(*id, *frame, Vec2(*x, *y), place.line, place.column);
    }
  }
  const double rate = input.options.framesPerSecond;
  return tracks.finish(input.path, rate > 0.0 ? rate : kUsualRate);
}

}  // namespace sim2d
