#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Text of PeTrack, of JuPedSim and of the Pedestrian Dynamics Data Archive: id, frame, x, y and
/// perhaps more. The rate stands in a comment "framerate: 25", the unit in that of the columns.
namespace sim2d {

namespace {

/// The lines before the first row: lowered, without the mark of comments.
std::vector<std::string> commentsOf(std::string_view text) {
  std::vector<std::string> comments;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = base::trimmed(text.substr(begin, end - begin));
    if (!line.empty() && line.front() != '#') {
      break;
    }
    comments.push_back(base::lowered(base::trimmed(line.empty() ? line : line.substr(1))));
    begin = end + 1;
  }
  return comments;
}

bool beginsWith(const std::string& text, std::string_view word) {
  return text.compare(0, word.size(), word) == 0;
}

/// The number of the line "framerate: 25 fps"; 0: there is none.
double toldRate(const std::vector<std::string>& comments) {
  for (const std::string& line : comments) {
    const bool isRate =
        beginsWith(line, "framerate") || beginsWith(line, "frame rate") || beginsWith(line, "fps");
    const std::size_t begin = line.find_first_of("0123456789.");
    if (isRate && begin != std::string::npos) {
      const std::size_t end = std::min(line.find_first_not_of("0123456789.", begin), line.size());
      return base::parseDouble(line.substr(begin, end - begin)).value_or(0.0);
    }
  }
  return 0.0;
}

/// Of letters and digits.
std::vector<std::string> wordsOf(std::string line) {
  std::replace_if(
      line.begin(), line.end(),
      [](char c) { return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')); }, ' ');
  std::vector<std::string> words;
  for (std::string& word : base::split(line, ' ')) {
    if (!word.empty()) {
      words.push_back(std::move(word));
    }
  }
  return words;
}

/// [m] of the first unit in the line.
std::optional<double> unitIn(const std::string& line) {
  for (const std::string& word : wordsOf(line)) {
    if (word == "m" || word == "cm" || word == "mm") {
      return word == "m" ? 1.0 : word == "cm" ? 0.01 : 0.001;
    }
  }
  return std::nullopt;
}

/// [m] as the last line that names the columns says, else a line "unit: cm" or "in cm".
double toldUnit(const std::vector<std::string>& comments) {
  double unit = 1.0;
  std::string columns;
  for (const std::string& line : comments) {
    const std::vector<std::string> words = wordsOf(line);
    const auto holds = [&words](const char* word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    columns = holds("x") && holds("y") ? line : columns;
    const bool isUnit = beginsWith(line, "unit") || (!words.empty() && words.front() == "in");
    unit = isUnit ? unitIn(line).value_or(unit) : unit;
  }
  return unitIn(columns).value_or(unit);
}

TrackFile readPetrack(const ForeignInput& input) {
  const std::vector<std::string> comments = commentsOf(input.text);
  const double given = input.options.framesPerSecond;
  const double rate = given > 0.0 ? given : toldRate(comments);
  if (!(rate > 0.0)) {
    input.problems.push_back(base::error("tracks.no-rate", {}, input.path));
    return {};
  }
  const double unit = toldUnit(comments);
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
  const bool isTold = look.mentions("PeTrack") || look.mentions("jpscore") ||
                      look.mentions("JuPedSim") || toldRate(commentsOf(look.text)) > 0.0;
  return isTold && look.isNumbers && look.row.size() >= 4 ? Claim::ByContent : Claim::None;
}

}  // namespace

void addPetrack(TrackFormats& to) {
  to.add({"petrack", 5, claim, readPetrack});
}

}  // namespace sim2d
