#include "sim2d/trace/TrackFormats.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == ',';
}

bool beginsNumber(std::string_view text, std::size_t minus) {
  const char next = minus + 1 < text.size() ? text[minus + 1] : ' ';
  return (next >= '0' && next <= '9') || next == '.';
}

/// Step lengths of the bodies under one interpretation of the rows.
class StepLengths {
 public:
  void add(double body, double frame, const Vec2& place) {
    const auto [at, isNew] = last_.try_emplace(body, Last{frame, place});
    if (!isNew) {
      isForward_ = isForward_ && frame > at->second.frame;
      sum_ += (place - at->second.place).norm();
      ++count_;
      at->second = {frame, place};
    }
  }
  bool isForward() const { return isForward_; }
  std::size_t count() const { return count_; }
  double mean() const { return sum_ / static_cast<double>(count_); }

 private:
  struct Last {
    double frame = 0.0;
    Vec2 place = Vec2::Zero();
  };
  std::map<double, Last> last_;
  double sum_ = 0.0;
  std::size_t count_ = 0;
  bool isForward_ = true;
};

}  // namespace

std::string_view TextRows::withoutComment(std::string_view line) const {
  for (std::size_t k = line.find(comment_); k != std::string_view::npos;
       k = line.find(comment_, k + 1)) {
    const bool inWord =
        comment_ == '-' && (beginsNumber(line, k) || (k > 0 && !isBlank(line[k - 1])));
    if (!inWord) {
      return line.substr(0, k);
    }
  }
  return line;
}

bool TextRows::next(std::vector<Word>& row) {
  row.clear();
  while (row.empty() && position_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    const std::string_view line = withoutComment(text_.substr(position_, end - position_));
    position_ = end + 1;
    ++line_;
    for (std::size_t k = 0; k < line.size();) {
      if (isBlank(line[k])) {
        ++k;
        continue;
      }
      const std::size_t begin = k;
      while (k < line.size() && !isBlank(line[k])) {
        ++k;
      }
      row.push_back({line.substr(begin, k - begin), line_, static_cast<int>(begin) + 1});
    }
  }
  return !row.empty();
}

void WordReader::error(const Word& at, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_, at.line, at.column));
}

std::optional<double> WordReader::finite(const Word& word, const char* name) {
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !std::isfinite(*value)) {
    error(word, "trace.not-finite", {name, word.text});
    return std::nullopt;
  }
  return value;
}

std::optional<long long> WordReader::whole(const Word& word, const char* name) {
  constexpr double kLargest = 2e9;
  const std::optional<double> value = base::parseDouble(word.text);
  if (!value || !(std::fabs(*value) <= kLargest) || *value != std::floor(*value)) {
    error(word, "trace.not-whole", {name, word.text});
    return std::nullopt;
  }
  return static_cast<long long>(*value);
}

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  const std::size_t end = text.find_last_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

std::string unitWord(std::string_view text) {
  text = withoutBlanks(text);
  while (text.size() > 1 && (text.front() == '[' || text.front() == '(')) {
    text = withoutBlanks(text.substr(1, text.size() - 2));
  }
  return base::toLower(text);
}

std::string withPoint(std::string_view word, char separator) {
  const std::size_t comma = word.find(',');
  std::string text(word);
  if (separator == ';' && comma != std::string_view::npos &&
      word.find('.') == std::string_view::npos) {
    text[comma] = '.';
  }
  return base::parseDouble(text) ? text : std::string(word);
}

std::optional<double> lengthUnitOf(std::string_view word) {
  static const std::map<std::string_view, double> kUnits = {{"m", 1.0},
                                                            {"metre", 1.0},
                                                            {"metres", 1.0},
                                                            {"meter", 1.0},
                                                            {"meters", 1.0},
                                                            {"cm", 1e-2},
                                                            {"centimetre", 1e-2},
                                                            {"centimetres", 1e-2},
                                                            {"centimeter", 1e-2},
                                                            {"centimeters", 1e-2},
                                                            {"mm", 1e-3},
                                                            {"millimetre", 1e-3},
                                                            {"millimetres", 1e-3},
                                                            {"millimeter", 1e-3},
                                                            {"millimeters", 1e-3},
                                                            {"km", 1e3},
                                                            {"ft", 0.3048},
                                                            {"foot", 0.3048},
                                                            {"feet", 0.3048},
                                                            {"inch", 0.0254}};
  const auto found = kUnits.find(word);
  return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> timeUnitOf(std::string_view word) {
  static const std::map<std::string_view, double> kUnits = {
      {"s", 1.0},       {"sec", 1.0},          {"secs", 1.0},          {"second", 1.0},
      {"seconds", 1.0}, {"ms", 1e-3},          {"msec", 1e-3},         {"millisecond", 1e-3},
      {"us", 1e-6},     {"\xC2\xB5s", 1e-6},   {"microseconds", 1e-6}, {"milliseconds", 1e-3},
      {"ns", 1e-9},     {"nanoseconds", 1e-9}, {"min", 60.0},          {"minutes", 60.0},
      {"h", 3600.0}};
  const auto found = kUnits.find(word);
  return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> lengthUnitIn(std::string_view text) {
  const auto isPart = [](char c) { return (c >= 'a' && c <= 'z') || base::isDigit(c); };
  for (std::size_t k = 0; k < text.size(); ++k) {
    const std::size_t begin = k;
    while (k < text.size() && isPart(text[k])) {
      ++k;
    }
    if (const auto unit = lengthUnitOf(text.substr(begin, k - begin))) {
      return unit;
    }
  }
  return std::nullopt;
}

std::vector<std::string> leadingComments(std::string_view text, char mark) {
  std::vector<std::string> comments;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = base::trimmed(text.substr(begin, end - begin));
    if (!line.empty() && line.front() != mark) {
      break;
    }
    comments.push_back(base::toLower(base::trimmed(line.empty() ? line : line.substr(1))));
    begin = end + 1;
  }
  return comments;
}

double statedRate(const std::vector<std::string>& comments) {
  constexpr const char* kNames[] = {"framerate", "frame rate",        "frame_rate",   "frame-rate",
                                    "fps",       "frames per second", "sampling rate"};
  for (const std::string& line : comments) {
    const std::size_t separator = line.find_first_of(":=");  // "frame rate [1/s]: 25"
    const std::size_t begin =
        line.find_first_of("0123456789.", separator == std::string::npos ? 0 : separator);
    if (begin == std::string::npos) {
      continue;
    }
    const std::size_t end = std::min(line.find_first_not_of("0123456789.", begin), line.size());
    const std::string rest = base::trimmed(line.substr(end));
    const bool isNamed = std::any_of(std::begin(kNames), std::end(kNames), [&](const char* name) {
      return base::startsWith(line, name);
    });
    if (isNamed || (begin == 0 && rest == "fps")) {
      return base::parseDouble(line.substr(begin, end - begin)).value_or(0.0);
    }
  }
  return 0.0;
}

TrackPoint pointAt(const Word& place, double time, const Vec2& position) {
  TrackPoint point;
  point.time = time;
  point.position = position;
  point.line = place.line;
  point.column = place.column;
  return point;
}

std::vector<Track> tracksOf(std::map<int, Track> byId) {
  std::vector<Track> tracks;
  tracks.reserve(byId.size());
  for (auto& entry : byId) {
    tracks.push_back(std::move(entry.second));
  }
  return tracks;
}

TrackPoint& FrameTracks::add(int id, long long frame, const Vec2& position, int line, int column) {
  Track& track = tracks_[id];
  track.id = id;
  TrackPoint& point =
      track.points.emplace_back(pointAt({{}, line, column}, static_cast<double>(frame), position));
  const std::size_t count = track.points.size();
  backwards_ += count > 1 && !(track.points[count - 2].time < point.time) ? 1U : 0U;
  return point;
}

std::optional<int> idOf(WordReader& words, const Word& word) {
  const std::optional<long long> id = words.whole(word, "the id");
  if (id && *id < 0) {
    words.error(word, "tracks.negative-id");
    return std::nullopt;
  }
  return id ? std::make_optional(static_cast<int>(*id)) : std::nullopt;
}

TrackPoint* FrameTracks::add(WordReader& words, const Word& frame, const Word& id, const Word& x,
                             const Word& y) {
  const std::optional<long long> itsFrame = words.whole(frame, "the frame");
  const std::optional<int> itsId = idOf(words, id);
  const std::optional<double> itsX = words.finite(x, "x");
  const std::optional<double> itsY = words.finite(y, "y");
  const bool isWhole = itsFrame && itsId && itsX && itsY;
  return isWhole ? &add(*itsId, *itsFrame, {*itsX, *itsY}, frame.line, frame.column) : nullptr;
}

TrackFile FrameTracks::finish(const std::string& path, double framesPerSecond) {
  TrackFile file;
  file.file = path;
  file.tracks = tracksOf(std::move(tracks_));
  framesToSeconds(file, framesPerSecond);
  return file;
}

void framesToSeconds(TrackFile& file, double framesPerSecond) {
  const double median = medianInterval(file.tracks);
  const double step = median > 0.0 ? median : 1.0;
  file.hasFrameTimes = true;
  file.step = framesPerSecond > 0.0 ? step / framesPerSecond : kAnnotationStep;
  for (Track& track : file.tracks) {
    for (TrackPoint& point : track.points) {
      point.time = point.time * file.step / step;
    }
  }
}

bool hasIdsFirst(std::string_view text) {
  constexpr int kMaxRows = 4000;
  constexpr std::size_t kFewSteps = 3;  // of a single body
  StepLengths idsFirst;
  StepLengths framesFirst;
  TextRows rows(text);
  std::vector<Word> row;
  for (int k = 0; k < kMaxRows && rows.next(row); ++k) {
    double values[4] = {};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto value = i < row.size() ? base::parseDouble(row[i].text) : std::nullopt;
      if (!value || !std::isfinite(*value) || (i < 2 && *value != std::floor(*value))) {
        return false;
      }
      values[i] = *value;
    }
    idsFirst.add(values[0], values[1], {values[2], values[3]});
    framesFirst.add(values[1], values[0], {values[2], values[3]});
  }
  if (!idsFirst.isForward() || idsFirst.count() == 0) {
    return false;
  }
  if (framesFirst.count() == 0) {
    return idsFirst.count() >= kFewSteps;
  }
  return !framesFirst.isForward() || idsFirst.mean() < 0.5 * framesFirst.mean();
}

std::vector<std::size_t> numberedColumns(const TrackInput& input,
                                         const std::vector<const char*>& names, std::size_t most) {
  const auto problem = [&input](std::string_view code, base::ProblemValues values) {
    input.error(code, std::move(values));
  };
  std::vector<std::size_t> columns(names.size());
  for (std::size_t k = 0; k < names.size(); ++k) {
    columns[k] = k;
  }
  for (const auto& [name, word] : input.options.columns) {
    const auto at = std::find(names.begin(), names.end(), name);
    const std::optional<long long> number = base::parseInt(word);
    if (at == names.end()) {
      problem("tracks.not-numbered", {name});
    } else if (!number || *number < 1 || *number > static_cast<long long>(most)) {
      problem("tracks.bad-column-number", {name, most, word});
    } else {
      columns[static_cast<std::size_t>(at - names.begin())] = static_cast<std::size_t>(*number) - 1;
    }
  }
  return columns;
}

double rateOf(const TrackInput& input, double stated) {
  const double rate = input.rateOr(stated);
  if (!(rate > 0.0)) {
    input.error("tracks.no-rate");
  }
  return rate;
}

std::string siblingPath(const std::string& path, const std::string& name) {
  return std::filesystem::path(path).replace_filename(name).string();
}

void reportAssignedIds(const TrackInput& input, const std::vector<const Track*>& numbered) {
  constexpr std::size_t kMaxTold = 5;
  std::vector<std::string> told;
  for (const Track* track : numbered) {
    if (told.size() == kMaxTold) {
      break;
    }
    told.push_back(track->name + " = " + std::to_string(track->id));
  }
  if (!told.empty()) {
    input.warning("tracks.ids-numbered",
                  {base::join(told, ", ") + (numbered.size() > kMaxTold ? " …" : "")});
  }
}

void readGroupsFile(const TrackInput& input, TrackFile& file) {
  const std::string path = siblingPath(input.path, "groups.txt");
  const base::Result<std::string> text = base::readTextFile(path, base::kMaxRecord);
  if (!text) {
    return;  // optional file
  }
  std::multimap<long long, Track*> byId;
  for (Track& track : file.tracks) {
    byId.emplace(track.id, &track);
  }
  WordReader words(path, input.problems);
  TextRows rows(*text);
  std::vector<Word> row;
  for (int group = 1; words.isUsable() && rows.next(row); ++group) {
    for (const Word& word : row) {
      const std::optional<long long> id = words.whole(word, "an id of a group");
      const auto range = id ? byId.equal_range(*id) : std::pair(byId.end(), byId.end());
      for (auto at = range.first; at != range.second; ++at) {
        at->second->group = group;
      }
    }
  }
}

}  // namespace sim2d
