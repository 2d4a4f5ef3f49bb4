#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"

namespace sim2d {

/// Appends a field as RFC 4180 wants it: in quotes when it holds a comma, a quote or a line end. A
/// text that a spreadsheet would work out as a formula (it begins with = + - @, and is no number)
/// gets a ' in front, as does one that looks as if it had got one.
void appendCsvField(std::string& to, std::string_view field);
/// Takes that ' away again.
void takeMarkFromCsvField(std::string& field);

struct CsvField {
  std::string text;
  int line = 1;    // of its first character
  int column = 1;  // idem, from 1, in bytes
};
using CsvRow = std::vector<CsvField>;

/// Reads rows of RFC 4180 text one after the other; line ends are \n or \r\n. The text must outlive
/// the reader.
class CsvReader {
 public:
  /// `firstLine`: number of the line with which the text begins.
  explicit CsvReader(std::string_view text, char separator = ',', int firstLine = 1)
      : text_(text), ends_{separator, '\n'}, line_(firstLine) {}
  /// False at the end of the text. `row` is reused; empty lines are rows with one empty field.
  bool next(CsvRow& row);
  /// The last row was cut: no line end after it, or an open quote.
  bool isTruncated() const { return truncated_; }

 private:
  void readQuoted(std::string& field);
  bool readField(CsvField& field);  // false: it was the last of its row
  void advance();

  std::string_view text_;
  std::array<char, 2> ends_;  // of a field
  std::size_t position_ = 0;
  int line_ = 1;
  std::size_t lineStart_ = 0;
  bool truncated_ = false;
};

/// One of our own CSV files: rows, numbers by column, problems with their place.
class CsvTable {
 public:
  CsvTable(const std::string& text, std::string file, base::Diagnostics& problems)
      : reader_(text), file_(std::move(file)), problems_(problems) {}

  /// False when the first line is not the one of this file.
  bool readColumns(const std::string& columns);
  /// The next row with the right number of fields; rows with another number are noted and left out.
  bool next();
  const CsvField& operator[](std::size_t column) const { return row_[column]; }
  void error(std::size_t column, std::string_view code, base::ProblemValues values = {}) {
    error(row_[column], code, std::move(values));
  }
  void error(const CsvField& field, std::string_view code, base::ProblemValues values = {});
  /// The numbers from a column on; false when one is none, or no finite one.
  template <class... Numbers>
  bool read(std::size_t column, Numbers&... numbers) {
    bool isGood = true;
    ((isGood = readNumber(column++, numbers) && isGood), ...);
    return isGood;
  }

 private:
  bool readNumber(std::size_t column, double& value);
  template <class Integer>
  bool readNumber(std::size_t column, Integer& value) {
    const std::optional<long long> parsed = base::parseInt(row_[column].text);
    if (!parsed || *parsed < std::numeric_limits<Integer>::min() ||
        *parsed > std::numeric_limits<Integer>::max()) {
      error(column, "trace.not-whole", {names_[column].text, row_[column].text});
      return false;
    }
    value = static_cast<Integer>(*parsed);
    return true;
  }

  CsvReader reader_;
  std::string file_;
  base::Diagnostics& problems_;
  CsvRow names_, row_;
};

}  // namespace sim2d
