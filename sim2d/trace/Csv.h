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

/// Appends a field as in RFC 4180: quoted if it contains a comma, a quote or a line end. A text
/// that a spreadsheet would evaluate as a formula (begins with = + - @ and is not a number) is
/// prefixed by ', as is a text that already looks prefixed.
void appendCsvField(std::string& to, std::string_view field);
/// Removes that prefix.
void removeFormulaMark(std::string& field);

struct CsvField {
  std::string text;
  int line = 1;    // of its first character
  int column = 1;  // of its first byte, from 1
};
using CsvRow = std::vector<CsvField>;

/// Reads RFC 4180 text row by row; line ends are \n or \r\n. The text must outlive the reader.
class CsvReader {
 public:
  /// `firstLine`: line number of the start of the text.
  explicit CsvReader(std::string_view text, char separator = ',', int firstLine = 1)
      : text_(text), ends_{separator, '\n'}, line_(firstLine) {}
  /// False: end of the text. `row` is reused; an empty line is a row with one empty field.
  bool next(CsvRow& row);
  /// The last row is incomplete: no line end, or an open quote.
  bool isTruncated() const { return truncated_; }

 private:
  void readQuoted(std::string& field);
  bool readField(CsvField& field);  // false: last field of its row
  void advance();

  std::string_view text_;
  std::array<char, 2> ends_;  // characters that end a field
  std::size_t position_ = 0;
  int line_ = 1;
  std::size_t lineStart_ = 0;
  bool truncated_ = false;
};

/// A CSV file of this program: rows, typed columns, problems with line and column.
class CsvTable {
 public:
  CsvTable(const std::string& text, std::string file, base::Diagnostics& problems)
      : reader_(text), file_(std::move(file)), problems_(problems) {}

  /// False: the header line differs.
  bool readColumns(const std::string& columns);
  /// Reads the next row; rows with a wrong number of fields are reported and skipped.
  bool next();
  const CsvField& operator[](std::size_t column) const { return row_[column]; }
  void error(std::size_t column, std::string_view code, base::ProblemValues values = {}) {
    error(row_[column], code, std::move(values));
  }
  void error(const CsvField& field, std::string_view code, base::ProblemValues values = {});
  /// Reads finite numbers from `column` on; false if one is invalid.
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

/// Reads a whole table: calls take(table, rows) for each row. All problems are reported.
template <class Rows, class Take>
base::Result<Rows> readCsvTable(const std::string& text, const std::string& file,
                                const char* columns, Take take) {
  base::Diagnostics problems;
  Rows rows;
  CsvTable table(text, file, problems);
  if (table.readColumns(columns)) {
    while (table.next()) {
      take(table, rows);
    }
  }
  return base::resultOf(std::move(rows), std::move(problems));
}

}  // namespace sim2d
