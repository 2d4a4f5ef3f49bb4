#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

namespace sim2d {
namespace {

class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  /// None: the text is not WKT.
  std::optional<std::vector<Outline>> read() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (base::isLetter(c)) {
        readWord();
      } else if (c == '(') {
        ++depth_;
        ++at_;
        rings_ = beginsNumber() ? rings_ : 0;
        if (beginsNumber() && !readRing()) {
          return std::nullopt;
        }
      } else if (c == ')' && depth_ > 0) {
        --depth_;
        ++at_;
      } else if (c == ',' || c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ';') {
        ++at_;
      } else {
        return std::nullopt;
      }
    }
    return depth_ == 0 ? std::optional(std::move(outlines_)) : std::nullopt;
  }

 private:
  void readWord() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && base::isLetter(text_[at_])) {
      ++at_;
    }
    const std::string word = base::toLower(text_.substr(begin, at_ - begin));
    if (word != "z" && word != "m" && word != "zm" && word != "empty") {
      isPolygon_ = word == "polygon" || word == "multipolygon";
      rings_ = 0;
    }
  }

  bool beginsNumber() const {
    const std::size_t next = text_.find_first_not_of(" \t\r\n", at_);
    return next != std::string_view::npos &&
           std::string_view("+-.0123456789").find(text_[next]) != std::string_view::npos;
  }

  /// Reads points up to the closing bracket; the first ring of a polygon is its border.
  bool readRing() {
    const std::size_t end = text_.find_first_of("()", at_);
    if (end == std::string_view::npos || text_[end] == '(') {
      return false;
    }
    std::vector<Vec2> points;
    for (const std::string& point : base::split(text_.substr(at_, end - at_), ',')) {
      TextRows words(point, '\0');
      std::vector<Word> row;
      words.next(row);
      const auto x = row.size() >= 2 ? base::parseDouble(row[0].text) : std::nullopt;
      const auto y = row.size() >= 2 ? base::parseDouble(row[1].text) : std::nullopt;
      if (!x || !y || !(std::fabs(*x) <= kFarthestPosition) ||
          !(std::fabs(*y) <= kFarthestPosition)) {
        return false;
      }
      points.emplace_back(*x, *y);
    }
    at_ = end;
    if (isPolygon_) {
      addRing(std::move(points));
    }
    return true;
  }

  void addRing(std::vector<Vec2> points) {
    points = withoutRepeats(points);
    if (points.size() > 1 && points.front() == points.back()) {
      points.pop_back();
    }
    const bool isBorder = rings_++ == 0;
    if (points.size() < 3) {
      return;
    }
    const bool isCounterClockwise = signedArea(points) > 0.0;
    if (isCounterClockwise == isBorder) {
      std::reverse(points.begin(), points.end());
    }
    outlines_.push_back({std::move(points)});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int rings_ = 0;  // rings of the current polygon
  bool isPolygon_ = false;
  std::vector<Outline> outlines_;
};

}  // namespace

base::Result<std::vector<Outline>> walkableOutlines(const std::string& wkt) {
  std::optional<std::vector<Outline>> outlines = WktReader(wkt).read();
  if (!outlines || outlines->empty()) {
    return base::error("tracks.bad-geometry");
  }
  return *std::move(outlines);
}

void addWalkableArea(const std::string& wkt, double unit, const TrackInput& input,
                     TrackFile& file) {
  if (base::trimmed(wkt).empty()) {
    return;
  }
  base::Result<std::vector<Outline>> outlines = walkableOutlines(wkt);
  if (!outlines) {
    input.warning("tracks.bad-geometry");
    return;
  }
  for (Outline& outline : *outlines) {
    for (Vec2& point : outline.points) {
      point *= unit;
    }
  }
  TraceObstacle walls;
  walls.name = kRecordedMap;
  walls.outlines = *std::move(outlines);
  file.obstacles.push_back(std::move(walls));
}

}  // namespace sim2d
