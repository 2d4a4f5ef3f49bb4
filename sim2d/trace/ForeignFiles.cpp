#include "sim2d/trace/ForeignFiles.h"

#include <algorithm>
#include <array>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

namespace sim2d {

namespace {

constexpr std::array<const char*, 5> kNames = {"csv", "eth", "vsp", "trajnet", "socnavbench"};
constexpr std::array<const char*, 12> kColumns = {
    "time", "frame", "id", "x", "y", "heading", "vx", "vy", "omega", "group", "radius", "kind"};

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool isNumberRow(const std::vector<Word>& row) {
  return std::all_of(row.begin(), row.end(),
                     [](const Word& word) { return base::parseDouble(word.text).has_value(); });
}

/// Without the byte order mark that some programs put before UTF-8.
std::string withoutMark(const std::string& text) {
  const std::string mark = "\xEF\xBB\xBF";
  return text.compare(0, mark.size(), mark) == 0 ? text.substr(mark.size()) : text;
}

/// By the name, then by the first line: numbers only, how many.
ForeignFormat formatOf(const std::string& path, const std::string& text) {
  if (endsWith(path, ".vsp")) {
    return ForeignFormat::Vsp;
  }
  if (endsWith(path, ".ndjson")) {
    return ForeignFormat::Trajnet;
  }
  std::vector<Word> first;
  TextRows(text).next(first);
  if (endsWith(path, ".csv")) {
    return isNumberRow(first) && first.size() > kColumns.size() ? ForeignFormat::Socnavbench
                                                                : ForeignFormat::Csv;
  }
  if (first.size() == 8 && isNumberRow(first)) {
    return ForeignFormat::Eth;
  }
  const bool isJson = !first.empty() && first.front().text.front() == '{';
  return isJson || (first.size() == 4 && isNumberRow(first)) ? ForeignFormat::Trajnet
                                                             : ForeignFormat::Csv;
}

TrackFile readAs(ForeignFormat format, const ForeignInput& input) {
  switch (format) {
    case ForeignFormat::Eth:
      return readObsmat(input);
    case ForeignFormat::Vsp:
      return readVsp(input);
    case ForeignFormat::Trajnet:
      return readTrajnet(input);
    case ForeignFormat::Socnavbench:
      return readSocnavbench(input);
    case ForeignFormat::Csv:
      break;
  }
  return readCsvTracks(input);
}

}  // namespace

const char* foreignFormatName(ForeignFormat format) {
  return kNames[static_cast<std::size_t>(format)];
}

std::optional<ForeignFormat> foreignFormatOf(std::string_view name) {
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  return found == kNames.end()
             ? std::nullopt
             : std::make_optional(static_cast<ForeignFormat>(found - kNames.begin()));
}

base::Result<std::map<std::string, std::string>> parseColumns(const std::string& text) {
  std::map<std::string, std::string> columns;
  base::Diagnostics problems;
  const std::vector<std::string> known(kColumns.begin(), kColumns.end());
  for (const std::string& pair : base::split(text, ',')) {
    const std::size_t equals = pair.find('=');
    const std::string name = base::trimmed(pair.substr(0, equals));
    if (equals == std::string::npos || name.empty() || equals + 1 == pair.size()) {
      problems.push_back(base::makeError("columns are written NAME=THEIRS, not '" + pair + "'"));
    } else if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::optional<std::string> meant = base::nearestName(name, known);
      problems.push_back(base::makeError("unknown column '" + name + "'" +
                                         (meant ? " (did you mean '" + *meant + "'?)" : "")));
    } else if (!columns.emplace(name, base::trimmed(pair.substr(equals + 1))).second) {
      problems.push_back(base::makeError("the column '" + name + "' is given twice"));
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  return columns;
}

base::Result<TrackFile> readForeign(const std::string& path, const ForeignOptions& options) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  const std::string plain = withoutMark(*text);
  const ForeignInput input{path, plain, options, problems};
  TrackFile file = readAs(options.format.value_or(formatOf(path, plain)), input);
  file.file = path;
  if (base::hasErrors(problems)) {
    return problems;
  }
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
  file.step = framesPerSecond > 0.0 ? step / framesPerSecond : kAnnotationStep;
  for (Track& track : file.tracks) {
    for (TrackPoint& point : track.points) {
      point.time = point.time * file.step / step;
    }
  }
}

std::string besideFile(const std::string& path, const std::string& name) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? name : path.substr(0, slash + 1) + name;
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
