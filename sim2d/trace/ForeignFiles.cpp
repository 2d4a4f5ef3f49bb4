#include "sim2d/trace/ForeignFiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"
#include "sim2d/trace/TrackCheck.h"

namespace sim2d {
namespace {

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

bool FirstLook::mentions(std::string_view words) const {
  constexpr std::size_t kLooked = 4096;
  return text.substr(0, kLooked).find(words) != std::string_view::npos;
}

const TrackFormat* TrackFormats::formatOf(const std::string& path, const std::string& text,
                                          Claim least) const {
  FirstLook look{path, text, {}, false};
  constexpr std::size_t kFirstRow = std::size_t{1} << 20U;  // [B]: JSON may be one line
  TextRows(std::string_view(text).substr(0, kFirstRow)).next(look.row);
  look.isNumbers = isNumberRow(look.row);
  const TrackFormat* best = nullptr;
  Claim highest = Claim::None;
  for (const TrackFormat& format : formats_) {
    if (const Claim claim = format.claim(look); claim >= least && claim > highest) {
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

void scaleSurroundings(double length, TrackFile& file) {
  if (length == 1.0) {
    return;
  }
  for (TraceObstacle& obstacle : file.obstacles) {
    for (Outline& outline : obstacle.outlines) {
      for (Vec2& point : outline.points) {
        point *= length;
      }
    }
  }
  if (const OccupancyGrid map = file.map; !map.isEmpty()) {
    const Pose2 origin{length * map.origin().position, map.origin().heading};
    file.map =
        OccupancyGrid(map.width(), map.height(), length * map.resolution(), origin, map.cells());
  }
  if (file.robotGoal) {
    file.robotGoal->position *= length;
    file.robotGoal->radius *= length;
  }
}

/// What the user says of the file counts instead of what its format says.
void applyUnits(const ForeignOptions& options, TrackFile& file) {
  const double length = options.lengthUnit > 0.0 ? options.lengthUnit / file.lengthUnit : 1.0;
  const double time = options.timeUnit > 0.0 ? options.timeUnit / file.timeUnit : 1.0;
  const double angle = options.degrees ? base::kPi / 180.0 : 1.0;
  scaleSurroundings(length, file);
  for (Track& track : file.tracks) {
    if (track.radius) {
      *track.radius *= length;
    }
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

/// Nobody runs that fast: probably a unit is another. An infinite speed is a place out of reach,
/// which is an error of its own.
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
  if (*middle > kFastest && std::isfinite(*middle)) {
    problems.push_back(
        base::warning("tracks.too-fast", {base::formatDouble(std::round(*middle))}, file.file));
  }
}

}  // namespace

base::Result<TrackFile> readForeign(const std::string& path, const ForeignOptions& options,
                                    const TrackFormats& formats) {
  const base::Result<std::string> text = base::readTextFile(path, base::kMostRecord);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  const std::string plain = withoutMark(*text);
  const ForeignInput input{path, plain, options, problems};
  const TrackFormat* format =
      options.format.empty() ? formats.formatOf(path, plain) : formats.find(options.format);
  if (format == nullptr) {
    return base::error("tracks.unknown-format", {base::join(formats.names(), ", ")}, path);
  }
  TrackFile file = format->read(input);
  file.file = path;
  if (base::hasErrors(problems)) {
    problems = shortened(problems);
    const TrackFormat* looks = formats.formatOf(path, plain, Claim::ByContent);
    if (looks != nullptr && looks != format) {
      problems.push_back(base::error("tracks.other-format", {looks->name}, path));
    }
    return problems;
  }
  if (options.timeUnit > 0.0 && file.isByFrames) {
    return base::error("tracks.time-unit-of-frames", {}, path);
  }
  if (options.degrees && !format->takesDegrees) {
    return base::error("tracks.fixed-angles", {format->name}, path);
  }
  if (!options.columns.empty() && !format->takesColumns) {
    return base::error("tracks.fixed-columns", {format->name}, path);
  }
  if (options.framesPerSecond > 0.0 && !file.isByFrames) {
    problems.push_back(base::warning("tracks.no-frames", {}, path));
  }
  applyUnits(options, file);
  warnOfSpeeds(file, problems);
  return {std::move(file), std::move(problems)};
}

}  // namespace sim2d
