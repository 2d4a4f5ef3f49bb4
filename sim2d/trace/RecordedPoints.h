#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Types.h"

namespace sim2d {

/// Obstacle points near people and the robot from the source of a record (`closest_obs` of
/// hunav_msgs). Where a record has them, they replace those computed from outlines.
class RecordedPoints {
 public:
  /// Adds the points of a body at a step; without points nothing is stored. In any order; call
  /// `sort` before `of`.
  void add(std::int64_t step, int id, bool isRobot, const std::vector<base::Vec2>& points);
  void sort();

  /// Range of the points of a body at a step, empty: none.
  struct Range {
    const base::Vec2* first = nullptr;
    const base::Vec2* last = nullptr;
    const base::Vec2* begin() const { return first; }
    const base::Vec2* end() const { return last; }
  };
  Range of(std::int64_t step, int id, bool isRobot) const;
  bool isEmpty() const { return entries_.empty(); }
  bool hasPeople() const { return hasPeople_; }  // a person has points at a step
  bool hasRobot() const { return hasRobot_; }

  /// The text of obstacle_points.csv.
  std::string csv() const;

 private:
  struct Entry {
    std::int64_t step = 0;
    int id = 0;
    bool isRobot = false;
    std::size_t begin = 0, end = 0;  // in points_
  };
  static bool isBefore(const Entry& a, const Entry& b);

  std::vector<Entry> entries_;
  std::vector<base::Vec2> points_;  // [m], world frame
  bool hasPeople_ = false, hasRobot_ = false;
};

/// Name of the file in the folder of a record, beside trajectory.csv.
constexpr char kPointsFile[] = "obstacle_points.csv";

/// `file` is named in the problems.
base::Result<RecordedPoints> parseRecordedPoints(const std::string& text, const std::string& file);
/// The points in the folder of a record; none where it has no such file.
base::Result<RecordedPoints> readRecordedPoints(const std::string& directory);

}  // namespace sim2d
