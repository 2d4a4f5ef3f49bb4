#include "sim2d/trace/Csv.h"

#include <cmath>

namespace sim2d {

namespace {

constexpr char kMark = '\'';

bool isNumber(std::string_view field) {
  constexpr std::string_view kPercent = " %";
  const bool isShare =
      field.size() > kPercent.size() && field.substr(field.size() - kPercent.size()) == kPercent;
  return base::parseDouble(isShare ? field.substr(0, field.size() - kPercent.size()) : field)
      .has_value();
}

/// Whether a spreadsheet would treat the text as a formula, possibly after ' marks; numbers are not
/// formulas.
bool looksLikeFormula(std::string_view field) {
  const std::size_t first = field.find_first_not_of(kMark);
  return first != std::string_view::npos &&
         std::string_view("=+-@").find(field[first]) != std::string_view::npos &&
         (first > 0 || !isNumber(field));
}

}  // namespace

void removeFormulaMark(std::string& field) {
  if (!field.empty() && field.front() == kMark && looksLikeFormula(field)) {
    field.erase(0, 1);
  }
}

void appendCsvField(std::string& to, std::string_view field) {
  const bool isMarked = looksLikeFormula(field);
  if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
    to += isMarked ? std::string_view(&kMark, 1) : std::string_view();
    to += field;
    return;
  }
  to += '"';
  if (isMarked) {
    to += kMark;
  }
  for (const char c : field) {
    if (c == '"') {
      to += '"';
    }
    to += c;
  }
  to += '"';
}

void CsvReader::advance() {
  if (text_[position_] == '\n') {
    ++line_;
    lineStart_ = position_ + 1;
  }
  ++position_;
}

void CsvReader::readQuoted(std::string& field) {
  advance();  // opening quote
  while (position_ < text_.size()) {
    const char c = text_[position_];
    advance();
    if (c != '"') {
      field += c;
    } else if (position_ < text_.size() && text_[position_] == '"') {
      field += '"';
      advance();
    } else {
      return;
    }
  }
  truncated_ = true;
}

bool CsvReader::readField(CsvField& field) {
  field.text.clear();
  field.line = line_;
  field.column = static_cast<int>(position_ - lineStart_) + 1;
  if (position_ < text_.size() && text_[position_] == '"') {
    readQuoted(field.text);
  }
  std::size_t end = text_.find_first_of(std::string_view(ends_.data(), ends_.size()), position_);
  if (end == std::string_view::npos) {
    end = text_.size();
    truncated_ = true;
  }
  field.text += text_.substr(position_, end - position_);
  position_ = end;
  const bool isLast = end == text_.size() || text_[end] == '\n';
  if (isLast && !field.text.empty() && field.text.back() == '\r') {
    field.text.pop_back();
  }
  if (end < text_.size()) {
    advance();
  }
  return !isLast;
}

bool CsvReader::next(CsvRow& row) {
  if (position_ >= text_.size()) {
    row.clear();
    return false;
  }
  std::size_t count = 0;
  bool more = true;
  while (more) {
    if (row.size() == count) {
      row.emplace_back();
    }
    more = readField(row[count++]);
  }
  row.resize(count);
  return true;
}

void CsvTable::error(const CsvField& field, std::string_view code, base::ProblemValues values) {
  problems_.push_back(base::error(code, std::move(values), file_, field.line, field.column));
}

bool CsvTable::readColumns(const std::string& columns) {
  std::string found;
  if (reader_.next(names_)) {
    for (const CsvField& name : names_) {
      found += (found.empty() ? "" : ",") + name.text;
    }
  }
  if (found != columns) {
    problems_.push_back(base::error("trace.first-line", {columns}, file_, 1, 1));
  }
  return found == columns;
}

bool CsvTable::next() {
  while (reader_.next(row_)) {
    if (reader_.isTruncated()) {
      error(row_.back(), "trace.cut-line");
    } else if (row_.size() != names_.size()) {
      error(row_.back(), "trace.field-count", {row_.size(), names_.size()});
    } else {
      for (CsvField& field : row_) {
        removeFormulaMark(field.text);
      }
      return true;
    }
  }
  return false;
}

bool CsvTable::readNumber(std::size_t column, double& value) {
  const std::optional<double> parsed = base::parseDouble(row_[column].text);
  if (!parsed || !std::isfinite(*parsed)) {
    error(column, "trace.not-finite", {names_[column].text, row_[column].text});
    return false;
  }
  value = *parsed;
  return true;
}

}  // namespace sim2d
