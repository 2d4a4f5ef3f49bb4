#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"

namespace sim2d {

/// Obstacle points near people and the robot as stored in the source of a recording (`closest_obs`
/// of hunav_msgs). They replace those computed from outlines.
class RecordedPoints {
 public:
  /// Adds the points of a body at a step; empty lists are ignored. Call `sort` before `of`.
  void add(std::int64_t step, int id, bool isRobot, const std::vector<base::Vec2>& points);
  void sort();

  /// The points of a body at a step; may be empty.
  struct Range {
    const base::Vec2* first = nullptr;
    const base::Vec2* last = nullptr;
    const base::Vec2* begin() const { return first; }
    const base::Vec2* end() const { return last; }
  };
  Range of(std::int64_t step, int id, bool isRobot) const;
  bool isEmpty() const { return entries_.empty(); }
  bool hasPeople() const { return hasPeople_; }  // at least one person has points
  bool hasRobot() const { return hasRobot_; }

  /// Content of obstacle_points.csv.
  std::string csv() const;

 private:
  struct Entry {
    std::int64_t step = 0;
    int id = 0;
    bool isRobot = false;
    std::size_t begin = 0, end = 0;  // range in points_
  };
  static bool isBefore(const Entry& a, const Entry& b);

  std::vector<Entry> entries_;
  std::vector<base::Vec2> points_;  // [m], world frame
  bool hasPeople_ = false, hasRobot_ = false;
};

/// File name in the folder of a recording.
constexpr char kPointsFile[] = "obstacle_points.csv";

/// `file` is the file name in messages.
base::Result<RecordedPoints> parseRecordedPoints(const std::string& text, const std::string& file);
/// Reads the points of a recording; empty if it has no such file.
base::Result<RecordedPoints> readRecordedPoints(const std::string& directory);

}  // namespace sim2d
