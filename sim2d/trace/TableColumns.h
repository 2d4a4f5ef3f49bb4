#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/trace/TrackTable.h"

/// The header line of a trajectory table. Private to the folder.
namespace sim2d {

std::string_view withoutBlanks(std::string_view text);
/// A unit in lower case, without blanks and brackets: "[m]", "(s)".
std::string unitWord(std::string_view text);
/// Replaces a decimal comma, which is possible with semicolon separators; other words are
/// unchanged.
std::string withPoint(std::string_view word, char separator);

/// Assigns quantities and units to the columns of a table. Problems are reported in the input.
class TableColumns {
 public:
  enum Column { Time, Frame, Id, X, Y, Heading, Vx, Vy, Omega, Group, Radius, Kind, Active, Count };

  TableColumns(const TrackInput& input, const TableLayout& layout)
      : input_(input), layout_(layout) {}

  void read(const CsvRow& header);

  bool has(Column column) const { return places_[column] != kNone; }
  std::size_t operator[](Column column) const { return places_[column]; }
  std::size_t width() const { return names_.size(); }
  /// The first line has numbers, and the user gave column numbers, from 1.
  bool isHeaderless() const { return isHeaderless_; }

  /// Whether the time and position columns contain words instead of numbers.
  bool isRowOfUnits(const CsvRow& row) const;
  void takeUnits(const CsvRow& row);
  /// [m], [s], [m/s], [rad] or [rad/s] per unit of a column; `usual` if it has none. An unknown
  /// unit without a replacing option is an error.
  double unitOf(Column column, double usual) const;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  bool isAllNumbers() const;
  bool areNumbered() const;
  bool isGiven(Column column) const;
  void find(Column column);
  std::size_t columnNamed(const std::string& name) const;
  void checkTimes();
  void problem(const char* code, base::ProblemValues values = {});

  const TrackInput& input_;
  const TableLayout& layout_;
  CsvRow header_;
  std::vector<std::string> names_, units_;  // by column
  std::size_t places_[Count] = {};
  bool isHeaderless_ = false;
  bool isBare_ = false;  // no header and no column numbers: an error
};

}  // namespace sim2d
