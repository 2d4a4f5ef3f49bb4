#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// ATC shopping centre (Brscic et al. 2013), one file per day: time [s], id, x, y, z [mm], speed
/// [mm/s], direction of motion and heading [rad].
namespace sim2d {

namespace {

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

FormatMatch matchFormat(const FilePreview& preview) {
  const bool isDay = preview.isNumbers && preview.row.size() == 8 && preview.endsWith(".csv") &&
                     base::parseDouble(preview.row.front().text).value_or(0.0) > kUnixTime;
  return isDay ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addAtc(TrackFormats& to) {
  to.add({"atc", 8, matchFormat, readDay});
}

}  // namespace sim2d
