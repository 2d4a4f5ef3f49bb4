#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// Stanford Drone Dataset, annotations.txt: boxes in pixels, 30 frames per second.
namespace sim2d {

namespace {

constexpr double kRate = 30.0;
constexpr std::size_t kWidth = 10;  // id xmin ymin xmax ymax frame lost occluded generated label

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
  forEachRow(input, kWidth, "id xmin ymin xmax ymax frame lost occluded generated label",
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
  TrackFile file = tracks.finish(input.path, input.rateOr(kRate));
  file.lengthUnit = unit;
  return file;
}

FormatMatch matchFormat(const FilePreview& preview) {
  const bool isBox = preview.row.size() == kWidth && preview.row.back().text.front() == '"';
  return isBox ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addSdd(TrackFormats& to) {
  to.add({"sdd", 7, matchFormat, readAnnotations});
}

}  // namespace sim2d
