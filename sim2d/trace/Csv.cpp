#include "sim2d/trace/Csv.h"

namespace sim2d {

void appendCsvField(std::string& to, std::string_view field) {
  if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
    to += field;
    return;
  }
  to += '"';
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

}  // namespace sim2d
