#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/trace/TrackTable.h"

/// The line of column names of a track table; private to the folder.
namespace sim2d {

std::string_view withoutBlanks(std::string_view text);
/// A unit in lower case, without blanks and the brackets around it: "[m]", "(s)".
std::string unitWord(std::string_view text);
/// A number with a decimal comma, which may stand beside semicolons, with a point; else as it is.
std::string withPoint(std::string_view word, char separator);

/// The quantities and units of the columns of a table. Problems are noted in the input.
class TableColumns {
 public:
  enum Column { Time, Frame, Id, X, Y, Heading, Vx, Vy, Omega, Group, Radius, Kind, Active, Count };

  TableColumns(const ForeignInput& input, const TableLayout& layout)
      : input_(input), layout_(layout) {}

  void read(const CsvRow& header);

  bool has(Column column) const { return places_[column] != kNone; }
  std::size_t operator[](Column column) const { return places_[column]; }
  std::size_t width() const { return names_.size(); }
  /// The line consists of numbers, and the user gave the numbers of the columns, from 1.
  bool isHeaderless() const { return isHeaderless_; }

  /// Words where the numbers of time and place are expected.
  bool isRowOfUnits(const CsvRow& row) const;
  void takeUnits(const CsvRow& row);
  /// [m], [s], [m/s], [rad] or [rad/s] of a column; `usual` without a unit. One that is unknown
  /// and that no option replaces is an error.
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

  const ForeignInput& input_;
  const TableLayout& layout_;
  CsvRow header_;
  std::vector<std::string> names_, units_;  // by column
  std::size_t places_[Count] = {};
  bool isHeaderless_ = false;
  bool isBare_ = false;  // numbers without names, which is an error
};

}  // namespace sim2d
