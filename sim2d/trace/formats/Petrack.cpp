#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Text of PeTrack, of JuPedSim and of the Pedestrian Dynamics Data Archive: id, frame, x, y and
/// perhaps more; the rate and the unit stand in comments.
namespace sim2d {

namespace {

/// The number after "framerate:" of a comment; 0: it is not told.
double toldRate(std::string_view text) {
  for (const std::string_view word : {"framerate", "Framerate", "frame rate", "fps"}) {
    const std::size_t at = text.find(word);
    if (at == std::string_view::npos) {
      continue;
    }
    const std::size_t begin = text.find_first_of("0123456789.\n", at + word.size());
    const std::size_t end = text.find_first_not_of("0123456789.", begin);
    const std::size_t length = (end == std::string_view::npos ? text.size() : end) - begin;
    if (begin != std::string_view::npos && text[begin] != '\n') {
      return base::parseDouble(text.substr(begin, length)).value_or(0.0);
    }
  }
  return 0.0;
}

/// The first of its lines, which are comments.
std::string_view commentsOf(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] == '#') {
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return text.substr(0, end);
}

TrackFile readPetrack(const ForeignInput& input) {
  const std::string_view comments = commentsOf(input.text);
  const double given = input.options.framesPerSecond;
  const double rate = given > 0.0 ? given : toldRate(comments);
  if (!(rate > 0.0)) {
    input.problems.push_back(base::error("tracks.no-rate", {}, input.path));
    return {};
  }
  const bool isCentimetres = comments.find("in cm") != std::string_view::npos ||
                             comments.find("/cm") != std::string_view::npos ||
                             comments.find("[cm]") != std::string_view::npos;
  const double unit = isCentimetres ? 0.01 : 1.0;
  FrameTracks tracks;
  WordReader words(input.path, input.problems);
  TextRows rows(input.text);
  std::vector<Word> row;
  while (rows.next(row)) {
    if (row.size() < 4) {
      words.error(row.back(), "tracks.number-count", {row.size(), 4, "id frame x y"});
    } else if (TrackPoint* point = tracks.add(words, row[1], row[0], row[2], row[3])) {
      point->position *= unit;
    }
  }
  TrackFile file = tracks.finish(input.path, rate);
  file.lengthUnit = unit;
  return file;
}

Claim claim(const FirstLook& look) {
  const bool isTold = look.beginsWith("PeTrack") || look.beginsWith("framerate") ||
                      look.beginsWith("jpscore") || look.beginsWith("JuPedSim");
  return isTold && look.isNumbers && look.row.size() >= 4 ? Claim::ByContent : Claim::None;
}

}  // namespace

void addPetrack(TrackFormats& to) {
  to.add({"petrack", 5, claim, readPetrack});
}

}  // namespace sim2d
