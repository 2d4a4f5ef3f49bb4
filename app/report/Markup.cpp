#include "app/report/Markup.h"

#include <cmath>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace report {

namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// The length of the UTF-8 character at `at`; 0: invalid.
std::size_t characterLength(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t length = byte < 0x80   ? 1
                             : byte < 0xC2 ? 0
                             : byte < 0xE0 ? 2
                             : byte < 0xF0 ? 3
                             : byte < 0xF5 ? 4
                                           : 0;
  if (length == 0 || at + length > text.size()) {
    return 0;
  }
  for (std::size_t k = 1; k < length; ++k) {
    if ((static_cast<unsigned char>(text[at + k]) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  return length;
}

std::string entityOf(char c) {
  constexpr std::pair<char, const char*> kEntities[] = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  if (const auto* const entity = base::findBy(kEntities, &std::pair<char, const char*>::first, c)) {
    return entity->second;
  }
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r'
             ? kReplacement
             : std::string(1, c);
}

std::string rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  const double whole = std::round(value * scale);
  if (std::abs(whole) > 1e15) {
    return base::formatDouble(value);
  }
  const bool isNegative = whole < 0.0;
  std::string digits = std::to_string(static_cast<long long>(std::abs(whole)));
  const auto places = static_cast<std::size_t>(decimals);
  if (places > 0) {
    digits.insert(0, digits.size() <= places ? places + 1 - digits.size() : 0, '0');
    digits.insert(digits.size() - places, ".");
  }
  return (isNegative ? "-" : "") + digits;
}

/// Replaces each text that is the first of a pair by the second of it.
template <class Pairs>
std::string substituted(std::string_view text, const Pairs& pairs) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto* const found = base::findIf(
        pairs, [&](const auto& pair) { return base::startsWith(text.substr(at), pair.first); });
    if (found == nullptr) {
      result += text[at++];
    } else {
      result += found->second;
      at += found->first.size();
    }
  }
  return result;
}

using TextPair = std::pair<std::string_view, std::string_view>;

constexpr TextPair kAsciiMinus[] = {{"−", "-"}};
constexpr TextPair kInScripts[] = {{"<", "\\u003c"}, {">", "\\u003e"}, {"&", "\\u0026"}};
constexpr TextPair kInLatex[] = {{"&", "\\&"},
                                 {"%", "\\%"},
                                 {"$", "\\$"},
                                 {"#", "\\#"},
                                 {"_", "\\_"},
                                 {"{", "\\{"},
                                 {"}", "\\}"},
                                 {"~", "\\textasciitilde{}"},
                                 {"^", "\\textasciicircum{}"},
                                 {"\\", "\\textbackslash{}"},
                                 {"<", "$<$"},
                                 {">", "$>$"},
                                 {"−", "$-$"},
                                 {"–", "--"},
                                 {"²", "$^2$"},
                                 {"³", "$^3$"},
                                 {"†", "$^\\dagger$"},
                                 {"δ", "$\\delta$"},
                                 {"×", "$\\times$"},
                                 {"χ", "$\\chi$"},
                                 {"∞", "$\\infty$"}};

std::string cellHtml(const Table::Cell& cell, const Table::Column& column) {
  std::string content = cell.markup.empty() ? escaped(cell.text) : cell.markup;
  if (cell.bold) {
    content = element("b", "", content);
  }
  if (!cell.mark.empty()) {
    content += element("sup", "", escaped(cell.mark));
  }
  if (!cell.below.empty()) {
    content += element("small", "", escaped(cell.below));
  }
  if (!cell.note.empty()) {
    content += element("small", "", escaped(cell.note));
  }
  std::string attributes = column.isNumber ? " class=\"n\"" : "";
  if (!cell.sort.empty()) {
    attributes += " data-sort=\"" + escaped(cell.sort) + "\"";
  }
  return element("td", attributes, content.empty() ? "–" : content);
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = characterLength(text, at);
    if (length <= 1) {
      result += length == 0 ? kReplacement : entityOf(text[at]);
      ++at;
    } else {
      result += text.substr(at, length);
      at += length;
    }
  }
  return result;
}

std::string scriptSafe(std::string_view json) {
  return substituted(json, kInScripts);
}

std::string latexText(std::string_view text) {
  return substituted(text, kInLatex);
}

std::string numberText(double value, int decimals) {
  if (std::isnan(value)) {
    return "–";
  }
  std::string text = rounded(value, decimals);
  return text[0] == '-' ? "−" + text.substr(1) : text;
}

std::string signedNumberText(double value, int decimals) {
  return (value > 0.0 ? "+" : "") + numberText(value, decimals);
}

std::string intervalText(const statistics::Interval& interval, int decimals, double scale) {
  return interval.isDefined() ? "[" + numberText(scale * interval.low, decimals) + ", " +
                                    numberText(scale * interval.high, decimals) + "]"
                              : std::string();
}

std::string withAsciiMinus(std::string_view text) {
  return substituted(text, kAsciiMinus);
}

std::string plainNumber(double value, int decimals) {
  return std::isnan(value) ? std::string() : rounded(value, decimals);
}

std::string percentText(double share) {
  return numberText(100.0 * share, 0) + " %";
}

std::string pValueText(double p) {
  if (std::isnan(p)) {
    return "–";
  }
  return p < 0.001 ? "< 0.001" : p >= 0.9995 ? "1" : rounded(p, 3);
}

std::string element(const char* name, const std::string& attributes, const std::string& content) {
  const std::string begin = std::string("<") + name + attributes;
  return content.empty() ? begin + "/>" : begin + ">" + content + "</" + name + ">";
}

std::string paragraph(const std::string& words, const std::string& attributes) {
  return element("p", attributes, escaped(words)) + "\n";
}

std::string filled(std::string_view pattern,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::vector<std::pair<std::string, std::string_view>> pairs;
  pairs.reserve(values.size());
  for (const auto& [name, value] : values) {
    pairs.emplace_back("{{" + std::string(name) + "}}", value);
  }
  return substituted(pattern, pairs);
}

std::string counted(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

Table::Cell numberCell(const std::string& text, double value) {
  Table::Cell cell{text};
  cell.sort = std::isnan(value) ? "–" : base::formatDouble(value);
  return cell;
}

Table::Cell commandCell(const std::string& command, const std::string& button) {
  Table::Cell cell{command};
  cell.markup = button + element("code", "", escaped(command));
  return cell;
}

std::string tableHtml(const Table& table, const std::string& htmlClass, std::size_t number) {
  std::string head;
  for (const Table::Column& column : table.columns) {
    std::string title = escaped(column.title);
    if (!column.unit.empty()) {
      title += " " + element("i", "", escaped(column.unit));
    }
    head += element("th", column.isNumber ? " class=\"n\" scope=\"col\"" : " scope=\"col\"",
                    title.empty() ? "&#160;" : title);
  }
  std::string rows;
  for (const std::vector<Table::Cell>& row : table.rows) {
    std::string cells;
    for (std::size_t k = 0; k < row.size(); ++k) {
      cells += cellHtml(row[k], table.columns[k]);
    }
    rows += element("tr", "", cells) + "\n";
  }
  const std::string label =
      number > 0 ? element("b", "", "Table " + std::to_string(number) + ".") + " " : std::string();
  constexpr std::size_t kMostOnPaper = 10;  // columns that fit on paper
  const char* const many = table.columns.size() > kMostOnPaper ? " many" : "";
  return "<div class=\"wide\"><table class=\"sortable " + htmlClass + many + "\">\n" +
         element("caption", "", label + escaped(table.caption)) +
         element("thead", "", element("tr", "", head)) + "\n<tbody>\n" + rows +
         "</tbody></table></div>\n";
}

namespace {

std::string cellLatex(const Table::Cell& cell) {
  const std::string words = latexText(cell.text);
  std::string text = cell.bold ? "\\textbf{" + words + "}" : words;
  text += latexText(cell.mark);
  for (const std::string& small : {cell.below, cell.note}) {
    if (!small.empty()) {
      text += " {\\footnotesize " + latexText(small) + "}";
    }
  }
  // After \\ LaTeX reads a bracket as row spacing.
  return base::startsWith(text, "[") ? "{}" + text : text;
}

}  // namespace

std::string tableLatex(const Table& table) {
  std::string text = "% \\usepackage{booktabs}\n\\begin{table}\n  \\centering\n  \\caption{" +
                     latexText(table.caption) + "}\n  \\begin{tabular}{";
  std::string head;
  for (const Table::Column& column : table.columns) {
    text += column.isNumber ? 'r' : 'l';
    head += (head.empty() ? "" : " & ") + latexText(column.title) +
            (column.unit.empty() ? "" : " [" + latexText(column.unit) + "]");
  }
  text += "}\n    \\toprule\n    " + head + " \\\\\n    \\midrule\n";
  for (const std::vector<Table::Cell>& row : table.rows) {
    std::string line;
    for (const Table::Cell& cell : row) {
      line += (&cell == &row.front() ? "" : " & ") + cellLatex(cell);
    }
    text += "    " + line + " \\\\\n";
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

namespace {

/// Escapes what would end a cell or change its text.
std::string markdownText(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (std::string_view("|*_`<[\\").find(letter) != std::string_view::npos) {
      escaped += '\\';
    }
    escaped += letter == '\n' ? ' ' : letter;
  }
  return escaped;
}

std::string cellMarkdown(const Table::Cell& cell) {
  const std::string words = markdownText(cell.text);
  std::string text = cell.bold && !words.empty() ? "**" + words + "**" : words;
  text += markdownText(cell.mark);
  for (const std::string& small : {cell.below, cell.note}) {
    text += small.empty() ? "" : " " + markdownText(small);
  }
  return text;
}

}  // namespace

std::string tableMarkdown(const Table& table) {
  std::string head = "|";
  std::string rule = "|";
  for (const Table::Column& column : table.columns) {
    head += " " +
            markdownText(column.title + (column.unit.empty() ? "" : " [" + column.unit + "]")) +
            " |";
    rule += column.isNumber ? " ---: |" : " --- |";
  }
  std::string text = "**" + markdownText(table.caption) + "**\n\n" + head + "\n" + rule + "\n";
  for (const std::vector<Table::Cell>& row : table.rows) {
    text += "|";
    for (const Table::Cell& cell : row) {
      text += " " + cellMarkdown(cell) + " |";
    }
    text += "\n";
  }
  return text;
}

namespace {

/// A missing value, shown as a dash, is an empty field, as in the other CSV files.
std::string fieldOf(const Table::Cell& cell) {
  if (!cell.csv.empty()) {
    return cell.csv;
  }
  return cell.text == "–" ? std::string() : withAsciiMinus(cell.text);
}

}  // namespace

std::string tableCsv(const Table& table) {
  std::vector<bool> hasBelow(table.columns.size(), false);
  std::vector<bool> hasNote(table.columns.size(), false);
  for (const std::vector<Table::Cell>& row : table.rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      hasBelow[k] = hasBelow[k] || !row[k].below.empty();
      hasNote[k] = hasNote[k] || !row[k].note.empty();
    }
  }
  std::vector<std::vector<std::string>> rows(1);
  const auto add = [&](std::size_t k, const std::string& text, const std::string& below,
                       const std::string& note) {
    rows.back().push_back(text);
    if (hasBelow[k]) {
      rows.back().push_back(below);
    }
    if (hasNote[k]) {
      rows.back().push_back(note);
    }
  };
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Table::Column& column = table.columns[k];
    add(k, column.title + (column.unit.empty() ? "" : " [" + column.unit + "]"),
        column.title + " interval", column.title + " note");
  }
  for (const std::vector<Table::Cell>& row : table.rows) {
    rows.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k) {
      add(k, fieldOf(row[k]), withAsciiMinus(row[k].below), row[k].note);
    }
  }
  return csvText(rows);
}

std::string csvText(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      text += k > 0 ? "," : "";
      sim2d::appendCsvField(text, row[k]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace report
