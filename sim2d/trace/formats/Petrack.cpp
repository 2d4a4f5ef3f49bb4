#include <algorithm>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// Text files of PeTrack, JuPedSim and the Pedestrian Dynamics Data Archive: id, frame, x, y and
/// optional columns; a comment with the column names may state another order and the unit. A
/// comment "framerate: 25" states the frame rate.
namespace sim2d {

namespace {

const std::vector<const char*> kNames = {"id", "frame", "x", "y"};

/// The words of letters and digits.
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

/// The quantity of a column name in the comment, as an index of kNames.
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

/// Positions of id, frame, x and y in the comment; none unless each occurs once.
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

/// [m] per unit: from the last comment with the column names, else from "unit: cm" or "in cm".
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
    const bool isUnit = base::startsWith(line, "unit") || (!words.empty() && words.front() == "in");
    ofLine = isUnit && unit ? unit : ofLine;
  }
  return ofColumns ? ofColumns : ofLine;
}

std::vector<std::size_t> orderOf(const TrackInput& input,
                                 const std::vector<std::string>& comments) {
  constexpr std::size_t kMaxColumns = 100;
  std::vector<std::size_t> order = numberedColumns(input, kNames, kMaxColumns);
  for (const std::string& line : comments) {
    const auto stated = input.options.columns.empty() ? orderIn(line) : std::nullopt;
    order = stated ? *stated : order;
  }
  return order;
}

TrackFile readPetrack(const TrackInput& input) {
  const std::vector<std::string> comments = leadingComments(input.text);
  const std::optional<double> unit = statedUnit(comments);
  const bool isUnknown = !unit && !(input.options.lengthUnit > 0.0);
  const double stated = statedRate(comments);
  if (isUnknown && !(stated > 0.0) && !(input.options.framesPerSecond > 0.0)) {
    input.error("tracks.no-rate-or-unit");
    return {};
  }
  const double rate = rateOf(input, stated);
  const std::vector<std::size_t> order = orderOf(input, comments);
  if (base::hasErrors(input.problems)) {
    return {};
  }
  if (isUnknown) {
    input.warning("tracks.no-unit");
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

FormatMatch matchFormat(const FilePreview& preview) {
  constexpr std::size_t kMost = 7;  // columns of files without comments
  if (!preview.isNumbers || preview.row.size() < kNames.size()) {
    return FormatMatch::None;
  }
  const bool isStated = preview.mentions("PeTrack") || preview.mentions("jpscore") ||
                        preview.mentions("JuPedSim") ||
                        statedRate(leadingComments(preview.text)) > 0.0;
  const bool isBare =
      preview.row.size() <= kMost && !preview.endsWith(".csv") && hasIdsFirst(preview.text);
  return isStated || isBare ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addPetrack(TrackFormats& to) {
  to.add({"petrack", 5, matchFormat, readPetrack, false, true});
}

}  // namespace sim2d
