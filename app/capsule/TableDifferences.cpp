#include "app/capsule/TableDifferences.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace capsule {

namespace {

using DiffJson = nlohmann::json;

constexpr std::size_t kMaxShown = 80;  // characters of a value

/// A value in a message: nothing, or long text, is shown as such.
std::string shown(const std::string& value) {
  if (value.empty()) {
    return "empty";
  }
  return value.size() <= kMaxShown ? value : value.substr(0, kMaxShown) + " …";
}

std::vector<std::string> textsOf(const sim2d::CsvRow& row) {
  std::vector<std::string> texts;
  texts.reserve(row.size());
  for (const sim2d::CsvField& field : row) {
    texts.push_back(field.text);
  }
  return texts;
}

std::size_t indexOf(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

const std::string& fieldOf(const ResultTable::Row& row, const std::string& column) {
  static const std::string kNone;
  const auto found = row.fields.find(column);
  return found == row.fields.end() ? kNone : found->second;
}

/// The difference of two rows of CSV files with these columns.
base::Diagnostic rowProblem(const std::vector<std::string>& columns, const sim2d::CsvRow& stored,
                            const sim2d::CsvRow& found, const std::string& file) {
  std::size_t column = 0;
  while (column < stored.size() && column < found.size() &&
         stored[column].text == found[column].text) {
    ++column;
  }
  const auto textAt = [](const sim2d::CsvRow& row, std::size_t index) {
    return index < row.size() ? row[index].text : std::string();
  };
  const std::string name = column < columns.size() ? columns[column] : std::string("the row");
  const int line = stored.empty() ? 0 : stored.front().line;
  const std::size_t step = indexOf(columns, "step"), id = indexOf(columns, "id");
  if (step < columns.size()) {
    const std::string who = id < columns.size() ? textAt(stored, id) : std::string();
    return base::error("capsule.step-differs",
                       {textAt(stored, step), name, who, shown(textAt(stored, column)),
                        shown(textAt(found, column))},
                       file, line);
  }
  return base::error("capsule.line-differs",
                     {name, shown(textAt(stored, column)), shown(textAt(found, column))}, file,
                     line);
}

std::string jsonValueAt(const DiffJson& json, const std::string& pointer) {
  const DiffJson::json_pointer at(pointer);
  return json.contains(at) ? shown(base::jsonText(json.at(at), -1)) : std::string("missing");
}

DiffJson withKeys(const DiffJson& json, const std::vector<std::string>& keys) {
  if (keys.empty() || !json.is_object()) {
    return json;
  }
  DiffJson chosen = DiffJson::object();
  for (const std::string& key : keys) {
    if (json.contains(key)) {
      chosen[key] = json.at(key);
    }
  }
  return chosen;
}

}  // namespace

base::Result<ResultTable> readResultTable(const std::string& text, const std::string& file) {
  ResultTable table;
  base::Diagnostics problems;
  sim2d::CsvReader reader(text);
  sim2d::CsvRow row;
  if (reader.next(row)) {
    table.columns = textsOf(row);
  }
  if (table.columns.empty() || table.columns.front() != "run") {
    return base::error("capsule.no-results", {}, file, 1);
  }
  while (reader.next(row)) {
    const auto run = base::parseInt(row.front().text);
    ResultTable::Row fields;
    fields.line = row.front().line;
    if (!run || row.size() != table.columns.size() || table.rows.count(*run) != 0) {
      problems.push_back(base::error("capsule.bad-row", {row.front().text}, file, fields.line));
      continue;
    }
    for (std::size_t k = 0; k < row.size(); ++k) {
      sim2d::removeFormulaMark(row[k].text);
      fields.fields[table.columns[k]] = row[k].text;
    }
    table.rows.emplace(*run, std::move(fields));
  }
  return base::resultOf(std::move(table), std::move(problems));
}

base::Diagnostics rowDifferences(const ResultTable& stored, const ResultTable& found,
                                 std::string_view code, const std::string& file) {
  std::vector<std::string> columns = stored.columns;
  for (const std::string& column : found.columns) {
    if (indexOf(columns, column) == columns.size()) {
      columns.push_back(column);
    }
  }
  base::Diagnostics problems;
  for (const auto& [run, row] : found.rows) {
    const auto same = stored.rows.find(run);
    if (same == stored.rows.end()) {
      problems.push_back(base::error("capsule.no-row", {run}, file));
      continue;
    }
    for (const std::string& column : columns) {
      const std::string &was = fieldOf(same->second, column), &is = fieldOf(row, column);
      if (was != is) {
        problems.push_back(
            base::error(code, {run, column, shown(was), shown(is)}, file, same->second.line));
      }
    }
  }
  return problems;
}

base::Diagnostics firstCsvDifference(const std::string& stored, const std::string& found,
                                     const std::string& file) {
  if (stored == found) {
    return {};
  }
  sim2d::CsvReader storedReader(stored), foundReader(found);
  sim2d::CsvRow storedRow, foundRow;
  std::vector<std::string> columns;
  int line = 1;
  while (true) {
    const bool hasStored = storedReader.next(storedRow), hasFound = foundReader.next(foundRow);
    if (!hasStored || !hasFound) {
      break;
    }
    if (textsOf(storedRow) != textsOf(foundRow)) {
      return {rowProblem(columns, storedRow, foundRow, file)};
    }
    if (columns.empty()) {
      columns = textsOf(storedRow);
    }
    line = storedRow.front().line;
  }
  return {base::error("capsule.rows-differ", {}, file, line)};
}

base::Diagnostics jsonDifferences(const std::string& stored, const std::string& found,
                                  const std::string& file, const std::vector<std::string>& keys,
                                  std::size_t most) {
  const DiffJson was = withKeys(DiffJson::parse(base::shallowJson(stored), nullptr, false), keys);
  const DiffJson is = withKeys(DiffJson::parse(base::shallowJson(found), nullptr, false), keys);
  if (was.is_discarded()) {
    return {base::error("trace.no-json-object", {}, file)};
  }
  base::Diagnostics problems;
  for (const DiffJson& change : DiffJson::diff(was, is)) {
    if (problems.size() >= most) {
      break;
    }
    const auto pointer = change.at("path").get<std::string>();
    problems.push_back(base::error("capsule.field-differs",
                                   {pointer, jsonValueAt(was, pointer), jsonValueAt(is, pointer)},
                                   file));
  }
  if (problems.empty() && keys.empty() && stored != found) {
    problems.push_back(base::error("capsule.rows-differ", {}, file));
  }
  return problems;
}

}  // namespace capsule
