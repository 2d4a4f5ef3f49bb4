#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// Data sets of pedestrians as rows of numbers.
namespace sim2d {

namespace {

// ATC shopping centre (Brscic et al. 2013), one file per day: time [s], id, x, y, z [mm], speed
// [mm/s], direction of motion and heading [rad].

constexpr double kMillimetre = 1e-3;  // [m]
constexpr double kUnixTime = 1e8;     // [s]

TrackFile readDay(const TrackInput& input) {
  std::map<int, Track> tracks;
  double begin = 0.0;
  forEachRow(input, 8, "time id x y z speed direction facing",
             [&](WordReader& words, const std::vector<Word>& row) {
               const std::optional<double> time = words.finite(row[0], "the time");
               const std::optional<int> id = idOf(words, row[1]);
               const std::optional<double> x = words.finite(row[2], "x");
               const std::optional<double> y = words.finite(row[3], "y");
               const std::optional<double> speed = words.finite(row[5], "the speed");
               const std::optional<double> way = words.finite(row[6], "the direction");
               const std::optional<double> facing = words.finite(row[7], "the facing");
               if (!time || !id || !x || !y || !speed || !way || !facing) {
                 return;
               }
               begin = tracks.empty() ? *time : begin;
               Track& track = tracks[*id];
               track.id = *id;
               TrackPoint& point = track.points.emplace_back(  // Unix times exceed the precision
                   pointAt(row[0], *time - begin, kMillimetre * Vec2(*x, *y)));
               point.velocity = kMillimetre * *speed * base::directionOf(*way);
               point.heading = *facing;
             });
  TrackFile file;
  file.lengthUnit = kMillimetre;
  file.tracks = tracksOf(std::move(tracks));
  return file;
}

FormatMatch matchAtc(const FilePreview& preview) {
  const bool isDay = preview.isNumbers && preview.row.size() == 8 && preview.endsWith(".csv") &&
                     base::parseDouble(preview.row.front().text).value_or(0.0) > kUnixTime;
  return isDay ? FormatMatch::ByContent : FormatMatch::None;
}

// ETH and UCY data sets: obsmat files.

TrackFile readObsmat(const TrackInput& input) {
  FrameTracks tracks;
  forEachRow(input, 8, "frame id x z y vx vz vy",
             [&](WordReader& words, const std::vector<Word>& row) {
               TrackPoint* point = tracks.add(words, row[0], row[1], row[2], row[4]);
               const std::optional<double> vx = words.finite(row[5], "vx");
               const std::optional<double> vy = words.finite(row[7], "vy");
               if (point != nullptr && vx && vy) {
                 point->velocity = Vec2(*vx, *vy);
               }
             });
  TrackFile file = tracks.finish(input.path, input.rateOr(statedRate(leadingComments(input.text))));
  readGroupsFile(input, file);
  return file;
}

FormatMatch matchEth(const FilePreview& preview) {
  return preview.isNumbers && preview.row.size() == 8 && !preview.endsWith(".csv")
             ? FormatMatch::ByContent
             : FormatMatch::None;
}

// Stanford Drone Dataset, annotations.txt: boxes in pixels, 30 frames per second.

constexpr double kSddRate = 30.0;
constexpr std::size_t kSddWidth = 10;  // id xmin ymin xmax ymax frame lost occluded generated label

std::string_view unquoted(std::string_view text) {
  const bool isQuoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return isQuoted ? text.substr(1, text.size() - 2) : text;
}

bool isPerson(std::string_view label) {
  return label == "Pedestrian" || label == "Biker" || label == "Skater";
}

/// Adds the centre of a box, y upwards.
void addBox(const std::vector<Word>& row, double unit, WordReader& words, FrameTracks& to) {
  double corners[4] = {};
  bool isWhole = true;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::optional<double> value = words.finite(row[k + 1], "a corner");
    isWhole = isWhole && value.has_value();
    corners[k] = value.value_or(0.0);
  }
  const std::optional<int> id = idOf(words, row[0]);
  const std::optional<long long> frame = words.whole(row[5], "the frame");
  if (isWhole && id && frame) {
    const Vec2 centre(0.5 * (corners[0] + corners[2]), -0.5 * (corners[1] + corners[3]));
    to.add(*id, *frame, unit * centre, row[5].line, row[5].column);
  }
}

TrackFile readAnnotations(const TrackInput& input) {
  const double unit = input.options.lengthUnit;
  if (!(unit > 0.0)) {
    input.error("tracks.no-scale");
    return {};
  }
  FrameTracks tracks;
  std::set<std::string> others;
  std::set<std::string_view> left;
  forEachRow(input, kSddWidth, "id xmin ymin xmax ymax frame lost occluded generated label",
             [&](WordReader& words, const std::vector<Word>& row) {
               const std::string_view label = unquoted(row[9].text);
               if (!isPerson(label)) {
                 others.insert(std::string(label));
                 left.insert(row[0].text);
               } else if (row[6].text != "1") {  // 1: outside the image
                 addBox(row, unit, words, tracks);
               }
             });
  if (!left.empty()) {
    const std::vector<std::string> names(others.begin(), others.end());
    input.warning("tracks.not-people", {left.size(), base::join(names, ", ")});
  }
  TrackFile file = tracks.finish(input.path, input.rateOr(kSddRate));
  file.lengthUnit = unit;
  return file;
}

FormatMatch matchSdd(const FilePreview& preview) {
  const bool isBox = preview.row.size() == kSddWidth && preview.row.back().text.front() == '"';
  return isBox ? FormatMatch::ByContent : FormatMatch::None;
}

// SocNavBench: four lines with frames, ids, x and y.

TrackFile readSocnavbench(const TrackInput& input) {
  constexpr double kDefaultRate = 25.0;  // [1/s] of the source videos
  WordReader words(input.path, input.problems);
  TextRows reader(input.text);
  std::vector<std::vector<Word>> rows;
  for (std::vector<Word> row; rows.size() <= 4 && reader.next(row);) {
    rows.push_back(row);
  }
  FrameTracks tracks;
  const bool fits = rows.size() == 4 && rows[1].size() == rows[0].size() &&
                    rows[2].size() == rows[0].size() && rows[3].size() == rows[0].size();
  if (!fits) {
    input.error("tracks.four-lines");
    return {};
  }
  const std::vector<std::size_t> order =
      numberedColumns(input, {"frame", "id", "x", "y"}, rows.size());
  for (std::size_t k = 0; words.isUsable() && k < rows[0].size(); ++k) {
    tracks.add(words, rows[order[0]][k], rows[order[1]][k], rows[order[2]][k], rows[order[3]][k]);
  }
  return tracks.finish(input.path, input.rateOr(kDefaultRate));
}

FormatMatch matchSocnavbench(const FilePreview& preview) {
  constexpr std::size_t kMaxColumns = 12;  // of a table with a header
  return preview.isNumbers && preview.row.size() > kMaxColumns && preview.endsWith(".csv")
             ? FormatMatch::ByContent
             : FormatMatch::None;
}

}  // namespace

void addDataSets(TrackFormats& to) {
  to.add({"atc", 8, matchAtc, readDay});
  to.add({"eth", 1, matchEth, readObsmat});
  to.add({"sdd", 7, matchSdd, readAnnotations});
  to.add({"socnavbench", 4, matchSocnavbench, readSocnavbench, false, true});
}

}  // namespace sim2d
