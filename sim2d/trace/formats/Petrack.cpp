#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Text of PeTrack, of JuPedSim and of the Pedestrian Dynamics Data Archive: id, frame, x, y and
/// perhaps more; a comment that names the columns may state another order. The rate is in a
/// comment "framerate: 25", the unit in that of the columns.
namespace sim2d {

namespace {

const std::vector<const char*> kNames = {"id", "frame", "x", "y"};

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

/// The quantity that a word in the comment of the columns means, as an index of kNames.
std::optional<std::size_t> quantityOf(const std::string& word) {
  static const std::vector<std::vector<std::string>> kWords = {
      {"id", "persid", "personid", "pedid", "agentid", "trackid", "number"},
      {"frame", "frames", "fr", "framenumber"},
      {"x"},
      {"y"}};
  for (std::size_t k = 0; k < kWords.size(); ++k) {
    if (std::find(kWords[k].begin(), kWords[k].end(), word) != kWords[k].end()) {
      return k;
    }
  }
  return std::nullopt;
}

/// Positions of id, frame, x and y in the comment of the columns; none unless it has each once.
std::optional<std::vector<std::size_t>> orderIn(const std::string& line) {
  std::vector<std::size_t> order(kNames.size());
  std::vector<bool> isFound(kNames.size(), false);
  std::size_t position = 0;
  for (const std::string& word : wordsOf(line)) {
    if (word == "in" || lengthUnitOf(word)) {
      continue;  // belongs to the previous column
    }
    if (const std::optional<std::size_t> quantity = quantityOf(word)) {
      if (isFound[*quantity]) {
        return std::nullopt;
      }
      isFound[*quantity] = true;
      order[*quantity] = position;
    }
    ++position;
  }
  const bool isWhole = std::find(isFound.begin(), isFound.end(), false) == isFound.end();
  return isWhole ? std::optional(order) : std::nullopt;
}

/// [m] of the unit in the last line that names the columns, else in a line "unit: cm" or "in cm".
std::optional<double> statedUnit(const std::vector<std::string>& comments) {
  std::optional<double> ofColumns;
  std::optional<double> ofLine;
  for (const std::string& line : comments) {
    const std::vector<std::string> words = wordsOf(line);
    const auto holds = [&words](const char* word) {
      return std::find(words.begin(), words.end(), word) != words.end();
    };
    const std::optional<double> unit = lengthUnitIn(line);
    ofColumns = holds("x") && holds("y") && unit ? unit : ofColumns;
    const bool isUnit =
        line.compare(0, 4, "unit") == 0 || (!words.empty() && words.front() == "in");
    ofLine = isUnit && unit ? unit : ofLine;
  }
  return ofColumns ? ofColumns : ofLine;
}

std::vector<std::size_t> orderOf(const ForeignInput& input,
                                 const std::vector<std::string>& comments) {
  constexpr std::size_t kMostColumns = 100;
  std::vector<std::size_t> order = numberedColumns(input, kNames, kMostColumns);
  for (const std::string& line : comments) {
    const auto stated = input.options.columns.empty() ? orderIn(line) : std::nullopt;
    order = stated ? *stated : order;
  }
  return order;
}

TrackFile readPetrack(const ForeignInput& input) {
  const std::vector<std::string> comments = leadingComments(input.text);
  const std::optional<double> unit = statedUnit(comments);
  const bool isUnknown = !unit && !(input.options.lengthUnit > 0.0);
  const double stated = statedRate(comments);
  if (isUnknown && !(stated > 0.0) && !(input.options.framesPerSecond > 0.0)) {
    input.problems.push_back(base::error("tracks.no-rate-or-unit", {}, input.path));
    return {};
  }
  const double rate = rateOf(input, stated);
  const std::vector<std::size_t> order = orderOf(input, comments);
  if (base::hasErrors(input.problems)) {
    return {};
  }
  if (isUnknown) {
    input.problems.push_back(base::warning("tracks.no-unit", {}, input.path));
  }
  const std::size_t width = *std::max_element(order.begin(), order.end()) + 1;
  FrameTracks tracks;
  WordReader words(input.path, input.problems);
  TextRows rows(input.text);
  std::vector<Word> row;
  while (words.isUsable() && tracks.isUsable() && rows.next(row)) {
    if (row.size() < width) {
      words.error(row.back(), "tracks.number-count", {row.size(), width, "id frame x y"});
    } else if (TrackPoint* point =
                   tracks.add(words, row[order[1]], row[order[0]], row[order[2]], row[order[3]])) {
      point->position *= unit.value_or(1.0);
    }
  }
  TrackFile file = tracks.finish(input.path, rate);
  file.lengthUnit = unit.value_or(1.0);
  return file;
}

Claim claim(const FirstLook& look) {
  constexpr std::size_t kMost = 7;  // columns of rows without a comment
  if (!look.isNumbers || look.row.size() < kNames.size()) {
    return Claim::None;
  }
  const bool isStated = look.mentions("PeTrack") || look.mentions("jpscore") ||
                        look.mentions("JuPedSim") || statedRate(leadingComments(look.text)) > 0.0;
  const bool isBare = look.row.size() <= kMost && !look.endsWith(".csv") && beginWithIds(look.text);
  return isStated || isBare ? Claim::ByContent : Claim::None;
}

}  // namespace

void addPetrack(TrackFormats& to) {
  to.add({"petrack", 5, claim, readPetrack, false, true});
}

}  // namespace sim2d
