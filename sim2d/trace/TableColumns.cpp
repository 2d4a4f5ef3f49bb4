#include "sim2d/trace/TableColumns.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

/// [m/s] per "m/s", "mm/s", "km/h".
std::optional<double> speedUnitOf(const std::string& word) {
  const std::size_t slash = word.find('/');
  const auto length = lengthUnitOf(word.substr(0, slash));
  const auto time = slash == std::string::npos ? std::nullopt : timeUnitOf(word.substr(slash + 1));
  return length && time ? std::optional(*length / *time) : std::nullopt;
}

/// [rad] per "deg" or "rad", also with "/s".
std::optional<double> angleUnitOf(const std::string& word) {
  const std::string angle = word.substr(0, word.find('/'));
  if (angle == "rad" || angle == "radians") {
    return 1.0;
  }
  const bool isDegree = angle == "deg" || angle == "degree" || angle == "degrees" ||
                        angle == "\xC2\xB0" || angle == "\xB0";
  return isDegree ? std::optional(base::kPi / 180.0) : std::nullopt;
}

/// Splits a column name and its unit, if any: "x [mm]", "t(s)", "x/m".
std::pair<std::string, std::string> nameAndUnit(std::string_view field) {
  const std::string_view text = withoutBlanks(field);
  const std::size_t open = text.find_first_of("[(");
  const bool isClosed = !text.empty() && (text.back() == ']' || text.back() == ')');
  if (open != std::string_view::npos && open > 0 && isClosed) {
    return {std::string(withoutBlanks(text.substr(0, open))), unitWord(text.substr(open))};
  }
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos && slash > 0) {
    const std::string unit = unitWord(text.substr(slash + 1));
    if (lengthUnitOf(unit) || timeUnitOf(unit) || speedUnitOf(unit) || angleUnitOf(unit)) {
      return {std::string(withoutBlanks(text.substr(0, slash))), unit};
    }
  }
  return {std::string(text), std::string()};
}

constexpr const char* kQuantities[TableColumns::Count] = {
    "time", "frame", "id",    "x",      "y",    "heading", "vx",
    "vy",   "omega", "group", "radius", "kind", "active"};

}  // namespace

std::string_view withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  const std::size_t end = text.find_last_not_of(kBlanks);
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

std::string unitWord(std::string_view text) {
  text = withoutBlanks(text);
  while (text.size() > 1 && (text.front() == '[' || text.front() == '(')) {
    text = withoutBlanks(text.substr(1, text.size() - 2));
  }
  return base::toLower(text);
}

std::string withPoint(std::string_view word, char separator) {
  const std::size_t comma = word.find(',');
  std::string text(word);
  if (separator == ';' && comma != std::string_view::npos &&
      word.find('.') == std::string_view::npos) {
    text[comma] = '.';
  }
  return base::parseDouble(text) ? text : std::string(word);
}

void TableColumns::read(const CsvRow& header) {
  header_ = header;
  isHeaderless_ = areNumbered();
  for (const CsvField& field : header) {
    const std::string_view text = field.text;
    const bool isFirst = names_.empty() && base::startsWith(text, layout_.prefix);
    auto [name, unit] = nameAndUnit(isFirst ? text.substr(layout_.prefix.size()) : text);
    const auto apart = layout_.units.find(base::toLower(name));
    units_.push_back(apart != layout_.units.end() && unit.empty() ? apart->second : unit);
    names_.push_back(isHeaderless_ ? std::to_string(names_.size() + 1) : std::move(name));
  }
  for (std::size_t k = 0; k < Count; ++k) {
    find(static_cast<Column>(k));
  }
  checkTimes();
  for (const Column column : {Id, X, Y}) {
    if (!has(column) && !isGiven(column) && !isBare_) {
      problem("tracks.no-column",
              {layout_.names.at(kQuantities[column]).front(), kQuantities[column]});
    }
  }
  if (has(Vx) != has(Vy)) {
    problem("tracks.half-velocity");
  }
}

bool TableColumns::areNumbered() const {
  const auto isNumber = [this](const auto& given) {
    const std::optional<long long> number = base::parseInt(given.second);
    return number && *number >= 1 && *number <= static_cast<long long>(header_.size());
  };
  const auto& given = input_.options.columns;
  return isAllNumbers() && !given.empty() && std::all_of(given.begin(), given.end(), isNumber);
}

bool TableColumns::isAllNumbers() const {
  return std::all_of(header_.begin(), header_.end(), [](const CsvField& field) {
    return base::parseDouble(withoutBlanks(field.text)).has_value();
  });
}

bool TableColumns::isRowOfUnits(const CsvRow& row) const {
  bool isAnyUnit = false;
  for (const Column column : {has(Time) ? Time : Frame, X, Y}) {
    const std::string word = unitWord(row[places_[column]].text);
    if (base::parseDouble(withPoint(word, layout_.separator))) {
      return false;
    }
    isAnyUnit = isAnyUnit || !word.empty();
  }
  return isAnyUnit;
}

void TableColumns::takeUnits(const CsvRow& row) {
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::string word = unitWord(row[k].text);
    units_[k] = word.empty() ? units_[k] : word;
  }
  header_ = row;  // place for errors about units
}

double TableColumns::unitOf(Column column, double usual) const {
  const std::string word = has(column) ? units_[places_[column]] : std::string();
  std::optional<double> unit;
  bool isGivenByUser = false;
  const char* option = "--unit METRES";
  switch (column) {
    case X:
    case Y:
    case Radius:
      unit = lengthUnitOf(word);
      isGivenByUser = input_.options.lengthUnit > 0.0;
      break;
    case Time:
      unit = timeUnitOf(word);
      isGivenByUser = input_.options.timeUnit > 0.0;
      option = "--time-unit UNIT";
      break;
    case Vx:
    case Vy:
      unit = speedUnitOf(word);
      break;
    default:
      unit = input_.options.degrees ? std::optional(1.0) : angleUnitOf(word);
      option = "--degrees";
  }
  if (!word.empty() && !unit && !isGivenByUser) {
    const CsvField& place = header_[places_[column]];
    input_.error("tracks.unknown-unit", {word, kQuantities[column], option}, place.line,
                 place.column);
  }
  return word.empty() ? usual : unit.value_or(usual);
}

void TableColumns::find(Column column) {
  const auto given = input_.options.columns.find(kQuantities[column]);
  if (given != input_.options.columns.end()) {
    places_[column] = columnNamed(given->second);
    if (!has(column)) {
      problem("tracks.unknown-column", {given->second, base::nearestName(given->second, names_)});
    }
    return;
  }
  places_[column] = kNone;
  const auto known = layout_.names.find(kQuantities[column]);
  if (known == layout_.names.end() || isHeaderless_) {
    return;
  }
  for (const std::string& name : known->second) {
    places_[column] = has(column) ? places_[column] : columnNamed(name);
  }
}

/// The column with exactly this name, with or without its unit; else ignoring case.
std::size_t TableColumns::columnNamed(const std::string& name) const {
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (names_[k] == name || (!isHeaderless_ && withoutBlanks(header_[k].text) == name)) {
      return k;
    }
  }
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (base::toLower(names_[k]) == base::toLower(name)) {
      return k;
    }
  }
  return kNone;
}

void TableColumns::checkTimes() {
  if (has(Time) && !isGiven(Frame)) {
    places_[Frame] = kNone;
  }
  if (!has(Time) && !has(Frame) && !isGiven(Time) && !isGiven(Frame)) {
    isBare_ = isAllNumbers();
    problem(isBare_ ? "tracks.no-header" : "tracks.no-times");
  }
}

bool TableColumns::isGiven(Column column) const {
  return input_.options.columns.count(kQuantities[column]) > 0;
}

void TableColumns::problem(const char* code, base::ProblemValues values) {
  input_.error(code, std::move(values), layout_.firstLine, 1);
}

}  // namespace sim2d
