#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "metrics/statistics/Summary.h"

/// Helpers for HTML, XML, LaTeX and CSV text.
namespace report {

/// Replaces & < > " ' by entities, for text and attributes of XML and HTML. Bytes that are not
/// allowed in XML become U+FFFD.
std::string escaped(std::string_view text);
/// Escapes JSON for a script element of a well-formed page.
std::string scriptSafe(std::string_view json);
/// Escapes LaTeX's special characters.
std::string latexText(std::string_view text);

/// Formats a number with exactly this many decimals and a typographic minus sign: "−1.50". NaN:
/// "–".
std::string numberText(double value, int decimals);
/// As numberText, with a plus sign above 0: "+1.50".
std::string signedNumberText(double value, int decimals);
/// An interval: "[1.21, 1.80]"; empty if undefined. Its ends are multiplied by `scale` (100: shares
/// in percent).
std::string intervalText(const statistics::Interval& interval, int decimals, double scale = 1.0);
/// Replaces typographic minus signs by ASCII ones.
std::string withAsciiMinus(std::string_view text);
/// As numberText with an ASCII minus, for files: "-1.50". NaN: empty.
std::string plainNumber(double value, int decimals);
std::string percentText(double share);  // "95 %"
/// A p value: "< 0.001", "0.012", "1".
std::string pValueText(double p);
/// An XML element: "<name attributes>content</name>", or "<name attributes/>" without content.
std::string element(const char* name, const std::string& attributes, const std::string& content);
/// Plain text as a <p> element; `attributes` start with a space.
std::string paragraph(const std::string& words, const std::string& attributes = {});
/// Replaces each placeholder {{name}} of a template by its value. Values are not searched for
/// placeholders; a placeholder without a value is kept.
std::string filled(std::string_view pattern,
                   const std::vector<std::pair<std::string_view, std::string>>& values);
/// A count with its noun: "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& word);

/// A table that can be written as HTML, CSV, LaTeX and Markdown.
struct Table {
  struct Column {
    std::string title;
    std::string unit;
    bool isNumber = true;  // right-aligned, sorted numerically
  };
  struct Cell {
    std::string text;        // as displayed
    std::string below = {};  // small, second line: an interval
    std::string sort = {};   // sort key; empty: text
    std::string mark = {};   // "†", explained in the caption
    bool bold = false;
    std::string note = {};    // small, third line
    std::string markup = {};  // replaces text, unescaped: a button
    std::string csv = {};     // replaces text in CSV: all digits
  };
  std::string name;     // file name: "results"
  std::string caption;  // plain text
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};
/// A cell with a number: sorted by its value, without a value last.
Table::Cell numberCell(const std::string& text, double value);
/// A cell with a command line; `button`: markup before it.
Table::Cell commandCell(const std::string& command, const std::string& button = {});
/// `number`: "Table 3." before the caption; 0: none.
std::string tableHtml(const Table& table, const std::string& htmlClass = {},
                      std::size_t number = 0);
std::string tableLatex(const Table& table);  // booktabs
/// A GitHub table: the caption in bold, then the rows; numbers are right-aligned.
std::string tableMarkdown(const Table& table);
/// ASCII minus, no marks; intervals and notes in separate columns; a missing value, "–", is empty.
std::string tableCsv(const Table& table);

/// Formats rows of plain fields as CSV.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

}  // namespace report
