#include <array>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// UCY crowds: splines in pixels of the video.
namespace sim2d {

namespace {

constexpr double kDefaultRate = 25.0;                      // [1/s]
constexpr double kHalfWidth = 360.0, kHalfHeight = 288.0;  // [pixel], video size of this data set

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// The homography in H.txt next to the file; without it the user gives the size of a pixel.
std::optional<Matrix3> readHomography(const TrackInput& input, bool& isOfPixels) {
  const std::string path = siblingPath(input.path, "H.txt");
  const base::Result<std::string> text = base::readTextFile(path, base::kMaxRecord);
  if (const double unit = input.options.lengthUnit; !text && unit > 0.0) {
    isOfPixels = true;
    return Matrix3{
        {{0.0, unit, -kHalfWidth * unit}, {-unit, 0.0, kHalfHeight * unit}, {0.0, 0.0, 1.0}}};
  }
  if (!text) {
    base::append(input.problems, text.diagnostics());
    input.error("tracks.no-matrix");
    return std::nullopt;
  }
  WordReader words(path, input.problems);
  TextRows rows(*text);
  Matrix3 matrix{};
  std::vector<Word> row;
  std::size_t count = 0;
  for (; rows.next(row); ++count) {
    for (std::size_t k = 0; k < row.size() && k < 3 && count < 3; ++k) {
      matrix[count][k] = words.finite(row[k], "an element of the matrix").value_or(0.0);
    }
    if (row.size() != 3 || count >= 3) {
      words.error(row.front(), "tracks.bad-matrix");
      return std::nullopt;
    }
  }
  if (count != 3) {
    input.problems.push_back(base::error("tracks.bad-matrix", {}, path));
    return std::nullopt;
  }
  return matrix;
}

/// Converts pixels from the image centre, y upwards, to the world; the homography takes row and
/// column.
Vec2 toWorld(const Matrix3& matrix, double x, double y) {
  const std::array<double, 3> pixel = {kHalfHeight - y, x + kHalfWidth, 1.0};
  std::array<double, 3> world{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) {
      world[r] += matrix[r][k] * pixel[k];
    }
  }
  return {world[0] / world[2], world[1] / world[2]};
}

class VspReader {
 public:
  VspReader(const TrackInput& input, const Matrix3& matrix)
      : input_(input),
        matrix_(matrix),
        words_(input.path, input.problems),
        rows_(input.text, '-'),
        rate_(input.rateOr(kDefaultRate)) {}

  TrackFile read() {
    TrackFile file;
    file.step = kAnnotationStep;
    file.hasFrameTimes = true;
    file.isSparse = true;
    const std::optional<long long> count = readCount("the number of splines");
    for (long long k = 1; count && k <= *count; ++k) {
      Track track;
      track.id = static_cast<int>(k);
      const bool whole = readSpline(track);
      if (!track.points.empty()) {
        file.tracks.push_back(std::move(track));
      }
      if (!whole) {
        break;
      }
    }
    readGroupsFile(input_, file);
    return file;
  }

 private:
  bool nextRow(const char* what) {
    if (rows_.next(row_)) {
      return true;
    }
    input_.error("tracks.cut", {what});
    return false;
  }

  std::optional<long long> readCount(const char* what) {
    if (!nextRow(what)) {
      return std::nullopt;
    }
    const std::optional<long long> count = words_.whole(row_.front(), what);
    if (count && *count < 0) {
      words_.error(row_.front(), "tracks.negative-count", {what});
      return std::nullopt;
    }
    return count;
  }

  bool readSpline(Track& track) {
    const std::optional<long long> count = readCount("the number of control points");
    for (long long k = 0; count && k < *count; ++k) {
      if (!nextRow("a control point")) {
        return false;
      }
      if (row_.size() != 4) {
        words_.error(row_.back(), "tracks.bad-control-point");
        return false;
      }
      const std::optional<double> x = words_.finite(row_[0], "x");
      const std::optional<double> y = words_.finite(row_[1], "y");
      const std::optional<double> frame = words_.finite(row_[2], "the frame");
      words_.finite(row_[3], "the gaze");
      if (x && y && frame) {
        addPoint(track, *frame, toWorld(matrix_, *x, *y));
      }
    }
    return count.has_value();
  }

  void addPoint(Track& track, double frame, const Vec2& position) {
    if (position.allFinite()) {
      track.points.push_back(pointAt(row_.front(), frame / rate_, position));
    } else {
      words_.error(row_.front(), "tracks.nowhere");
    }
  }

  const TrackInput& input_;
  const Matrix3& matrix_;
  WordReader words_;
  TextRows rows_;
  double rate_;  // [1/s]
  std::vector<Word> row_;
};

TrackFile readVsp(const TrackInput& input) {
  bool isOfPixels = false;
  const std::optional<Matrix3> matrix = readHomography(input, isOfPixels);
  TrackFile file = matrix ? VspReader(input, *matrix).read() : TrackFile();
  file.lengthUnit = isOfPixels ? input.options.lengthUnit : 1.0;
  return file;
}

FormatMatch matchFormat(const FilePreview& preview) {
  return preview.endsWith(".vsp") ? FormatMatch::ByName : FormatMatch::None;
}

}  // namespace

void addVsp(TrackFormats& to) {
  to.add({"vsp", 2, matchFormat, readVsp});
}

}  // namespace sim2d
