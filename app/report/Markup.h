#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Pieces of text of which pages, figures and tables are made.
namespace report {

/// With & < > " ' as entities: for text and attributes of XML and HTML. Bytes that XML does not
/// take become U+FFFD.
std::string escaped(std::string_view text);
/// JSON text that can stand inside a script element of a well-formed page.
std::string scriptSafe(std::string_view json);
/// For LaTeX: what it would take for commands is escaped.
std::string latexText(std::string_view text);

/// Rounded, a true minus sign, exactly so many decimals: "−1.50". NaN: "–".
std::string numberText(double value, int decimals);
/// The same with an ASCII minus, for files: "-1.50"; NaN: empty.
std::string plainNumber(double value, int decimals);
/// Of a p value: "< 0.001", "0.012", "1".
std::string pText(double p);
/// "<name attributes>content</name>"; without content "<name attributes/>".
std::string element(const char* name, const std::string& attributes, const std::string& content);
/// Plain text as a <p>; `attributes` begin with a space.
std::string paragraph(const std::string& words, const std::string& attributes = {});
/// "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& word);

/// A table to be shown, and to be written as CSV and LaTeX.
struct Table {
  struct Column {
    std::string title;
    std::string unit;
    bool isNumber = true;  // right aligned, sorted by number
  };
  struct Cell {
    std::string text;        // as shown
    std::string below = {};  // small, in a second line: an interval
    std::string sort = {};   // what a click sorts by; empty = the text
    std::string mark = {};   // "†": a note of the caption
    bool bold = false;
    std::string note = {};    // small, in a third line
    std::string markup = {};  // instead of text, as it is: a button
    std::string csv = {};     // instead of text in CSV: with all digits
  };
  std::string name;     // of files: "results"
  std::string caption;  // plain text
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};
std::string tableHtml(const Table& table, const std::string& htmlClass = {});
std::string tableLatex(const Table& table);  // booktabs
std::string tableCsv(
    const Table& table);  // ASCII minus, no marks; intervals and notes have columns of their own

/// Rows of plain fields as CSV.
std::string csvText(const std::vector<std::vector<std::string>>& rows);

}  // namespace report
