#include "sim2d/trace/ForeignFiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

namespace sim2d {
namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == ',';
}

bool beginsNumber(std::string_view text, std::size_t minus) {
  const char next = minus + 1 < text.size() ? text[minus + 1] : ' ';
  return (next >= '0' && next <= '9') || next == '.';
}

constexpr std::array<const char*, 12> kColumns = {
    "time", "frame", "id", "x", "y", "heading", "vx", "vy", "omega", "group", "radius", "kind"};

bool isNumberRow(const std::vector<Word>& row) {
  return std::all_of(row.begin(), row.end(),
                     [](const Word& word) { return base::parseDouble(word.text).has_value(); });
}

/// Without the byte order mark that some programs put before UTF-8.
std::string withoutMark(const std::string& text) {
  const std::string mark = "\xEF\xBB\xBF";
  return text.compare(0, mark.size(), mark) == 0 ? text.substr(mark.size()) : text;
}

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

void addAllTrackFormats(TrackFormats& to);  // written by CMake

const TrackFormats& standardTrackFormats() {
  static const TrackFormats kFormats = [] {
    TrackFormats formats;
    addAllTrackFormats(formats);
    return formats;
  }();
  return kFormats;
}

std::vector<std::string> trackFormatNames() {
  return standardTrackFormats().names();
}

const TrackFormat* TrackFormats::find(const std::string& name) const {
  const auto found = std::find_if(formats_.begin(), formats_.end(),
                                  [&](const TrackFormat& each) { return each.name == name; });
  return found == formats_.end() ? nullptr : &*found;
}

bool FirstLook::beginsWith(std::string_view words) const {
  constexpr std::size_t kLooked = 4096;
  return text.substr(0, kLooked).find(words) != std::string_view::npos;
}

const TrackFormat* TrackFormats::formatOf(const std::string& path, const std::string& text) const {
  FirstLook look{path, text, {}, false};
  TextRows(text).next(look.row);
  look.isNumbers = isNumberRow(look.row);
  const TrackFormat* best = nullptr;
  Claim highest = Claim::None;
  for (const TrackFormat& format : formats_) {
    if (const Claim claim = format.claim(look); claim > highest) {
      best = &format;
      highest = claim;
    }
  }
  return best;
}

std::vector<std::string> TrackFormats::names() const {
  std::vector<TrackFormat> sorted = formats_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const TrackFormat& a, const TrackFormat& b) { return a.order < b.order; });
  std::vector<std::string> names;
  names.reserve(sorted.size());
  for (const TrackFormat& format : sorted) {
    names.push_back(format.name);
  }
  return names;
}

base::Result<std::map<std::string, std::string>> parseColumns(const std::string& text) {
  std::map<std::string, std::string> columns;
  base::Diagnostics problems;
  const std::vector<std::string> known(kColumns.begin(), kColumns.end());
  for (const std::string& pair : base::split(text, ',')) {
    const std::size_t equals = pair.find('=');
    const std::string name = base::trimmed(pair.substr(0, equals));
    if (equals == std::string::npos || name.empty() || equals + 1 == pair.size()) {
      problems.push_back(base::error("tracks.bad-columns", {pair}));
    } else if (std::find(known.begin(), known.end(), name) == known.end()) {
      problems.push_back(
          base::error("tracks.unknown-quantity", {name, base::nearestName(name, known)}));
    } else if (!columns.emplace(name, base::trimmed(pair.substr(equals + 1))).second) {
      problems.push_back(base::error("tracks.quantity-twice", {name}));
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  return columns;
}

namespace {

/// What the user says of the file counts instead of what its format says.
void applyUnits(const ForeignOptions& options, TrackFile& file) {
  const double length = options.lengthUnit > 0.0 ? options.lengthUnit / file.lengthUnit : 1.0;
  const double time = options.timeUnit > 0.0 ? options.timeUnit / file.timeUnit : 1.0;
  const double angle = options.degrees ? base::kPi / 180.0 : 1.0;
  file.step *= time;
  for (Track& track : file.tracks) {
    track.radius = options.radius > 0.0 ? options.radius : track.radius;
    for (TrackPoint& point : track.points) {
      point.time *= time;
      point.position *= length;
      if (point.velocity) {
        *point.velocity *= length / time;
      }
      if (point.heading) {
        *point.heading *= angle;
      }
      if (point.angularSpeed) {
        *point.angularSpeed *= angle / time;
      }
    }
  }
}

/// Nobody runs that fast: probably a unit is another.
void warnOfSpeeds(const TrackFile& file, base::Diagnostics& problems) {
  constexpr double kFastest = 10.0;  // [m/s]
  std::vector<double> speeds;
  for (const Track& track : file.tracks) {
    for (std::size_t k = 1; k < track.points.size(); ++k) {
      const double time = track.points[k].time - track.points[k - 1].time;
      const double way = (track.points[k].position - track.points[k - 1].position).norm();
      if (time > 0.0 && way > 0.0) {  // who stands does so in every unit
        speeds.push_back(way / time);
      }
    }
  }
  if (speeds.empty()) {
    return;
  }
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  if (*middle > kFastest) {
    problems.push_back(
        base::warning("tracks.too-fast", {base::formatDouble(std::round(*middle))}, file.file));
  }
}

}  // namespace

base::Result<TrackFile> readForeign(const std::string& path, const ForeignOptions& options,
                                    const TrackFormats& formats) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  const std::string plain = withoutMark(*text);
  const ForeignInput input{path, plain, options, problems};
  const TrackFormat* format =
      options.format.empty() ? formats.formatOf(path, plain) : formats.find(options.format);
  if (format == nullptr) {
    return base::error("tracks.unknown-format", {}, path);
  }
  TrackFile file = format->read(input);
  file.file = path;
  if (base::hasErrors(problems)) {
    const TrackFormat* looks = formats.formatOf(path, plain);
    if (looks != nullptr && looks != format && looks->name != "csv") {
      problems.push_back(base::error("tracks.other-format", {looks->name}, path));
    }
    return problems;
  }
  if (options.timeUnit > 0.0 && file.isByFrames) {
    return base::error("tracks.time-unit-of-frames", {}, path);
  }
  applyUnits(options, file);
  warnOfSpeeds(file, problems);
  return {std::move(file), std::move(problems)};
}

TrackPoint& FrameTracks::add(int id, long long frame, const Vec2& position, int line, int column) {
  Track& track = tracks_[id];
  track.id = id;
  TrackPoint& point = track.points.emplace_back();
  point.time = static_cast<double>(frame);
  point.position = position;
  point.line = line;
  point.column = column;
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
  for (auto& [id, track] : tracks_) {
    file.tracks.push_back(std::move(track));
  }
  framesToSeconds(file, framesPerSecond);
  return file;
}

void framesToSeconds(TrackFile& file, double framesPerSecond) {
  const double median = medianInterval(file.tracks);
  const double step = median > 0.0 ? median : 1.0;
  file.isByFrames = true;
  file.step = framesPerSecond > 0.0 ? step / framesPerSecond : kAnnotationStep;
  for (Track& track : file.tracks) {
    for (TrackPoint& point : track.points) {
      point.time = point.time * file.step / step;
    }
  }
}

std::string besideFile(const std::string& path, const std::string& name) {
  return std::filesystem::path(path).replace_filename(name).string();
}

void readGroupsBeside(const ForeignInput& input, TrackFile& file) {
  const std::string path = besideFile(input.path, "groups.txt");
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return;  // not every set has one
  }
  WordReader words(path, input.problems);
  TextRows rows(*text);
  std::vector<Word> row;
  for (int group = 1; rows.next(row); ++group) {
    for (const Word& word : row) {
      const std::optional<long long> id = words.whole(word, "an id of a group");
      for (Track& track : file.tracks) {
        track.group = id && track.id == *id ? group : track.group;
      }
    }
  }
}

}  // namespace sim2d
