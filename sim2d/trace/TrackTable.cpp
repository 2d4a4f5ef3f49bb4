#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

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

/// Assigns quantities and units to the columns of a table. Problems are reported in the input.
class Columns {
 public:
  enum Column { Time, Frame, Id, X, Y, Heading, Vx, Vy, Omega, Group, Radius, Kind, Active, Count };

  Columns(const TrackInput& input, const TableLayout& layout) : input_(input), layout_(layout) {}

  void read(const CsvRow& header) {
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

  bool has(Column column) const { return places_[column] != kNone; }
  std::size_t operator[](Column column) const { return places_[column]; }
  std::size_t width() const { return names_.size(); }
  /// The first line has numbers, and the user gave column numbers, from 1.
  bool isHeaderless() const { return isHeaderless_; }

  /// Whether the time and position columns contain words instead of numbers.
  bool isRowOfUnits(const CsvRow& row) const {
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
  void takeUnits(const CsvRow& row) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      const std::string word = unitWord(row[k].text);
      units_[k] = word.empty() ? units_[k] : word;
    }
    header_ = row;  // place for errors about units
  }
  /// [m], [s], [m/s], [rad] or [rad/s] per unit of a column; `usual` if it has none. An unknown
  /// unit without a replacing option is an error.
  double unitOf(Column column, double usual) const {
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

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr const char* kQuantities[Count] = {"time",    "frame", "id",    "x",     "y",
                                                     "heading", "vx",    "vy",    "omega", "group",
                                                     "radius",  "kind",  "active"};

  bool isAllNumbers() const {
    return std::all_of(header_.begin(), header_.end(), [](const CsvField& field) {
      return base::parseDouble(withoutBlanks(field.text)).has_value();
    });
  }
  bool areNumbered() const {
    const auto isNumber = [this](const auto& given) {
      const std::optional<long long> number = base::parseInt(given.second);
      return number && *number >= 1 && *number <= static_cast<long long>(header_.size());
    };
    const auto& given = input_.options.columns;
    return isAllNumbers() && !given.empty() && std::all_of(given.begin(), given.end(), isNumber);
  }
  bool isGiven(Column column) const {
    return input_.options.columns.count(kQuantities[column]) > 0;
  }
  void find(Column column) {
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
  std::size_t columnNamed(const std::string& name) const {
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
  void checkTimes() {
    if (has(Time) && !isGiven(Frame)) {
      places_[Frame] = kNone;
    }
    if (!has(Time) && !has(Frame) && !isGiven(Time) && !isGiven(Frame)) {
      isBare_ = isAllNumbers();
      problem(isBare_ ? "tracks.no-header" : "tracks.no-times");
    }
  }
  void problem(const char* code, base::ProblemValues values = {}) {
    input_.error(code, std::move(values), layout_.firstLine, 1);
  }

  const TrackInput& input_;
  const TableLayout& layout_;
  CsvRow header_;
  std::vector<std::string> names_, units_;  // by column
  std::size_t places_[Count] = {};
  bool isHeaderless_ = false;
  bool isBare_ = false;  // no header and no column numbers: an error
};

class TableReader {
 public:
  TableReader(const TrackInput& input, const TableLayout& layout)
      : input_(input),
        layout_(layout),
        words_(input.path, input.problems),
        reader_(layout.text, layout.separator, layout.firstLine),
        columns_(input, layout) {}

  TrackFile read() {
    if (!reader_.next(header_)) {
      input_.error("tracks.file-empty");
      return {};
    }
    columns_.read(header_);
    if (base::hasErrors(input_.problems)) {
      return {};
    }
    bool isFirst = true;
    if (columns_.isHeaderless()) {
      row_ = header_;
      takeRow(std::exchange(isFirst, false));
    }
    while (words_.isUsable() && reader_.next(row_)) {
      const bool isEmpty = row_.size() == 1 && base::trimmed(row_.front().text).empty();
      if (!isEmpty && row_.size() != columns_.width()) {
        words_.error(wordOf(row_.size() - 1), "trace.field-count", {row_.size(), columns_.width()});
      } else if (!isEmpty) {
        takeRow(isFirst);
        isFirst = false;
      }
    }
    return finish();
  }

 private:
  void takeRow(bool isFirst) {
    const bool isUnits = isFirst && columns_.isRowOfUnits(row_);
    if (isUnits) {
      columns_.takeUnits(row_);
    }
    if (isFirst) {
      readUnits();
    }
    if (!isUnits && isActive()) {
      readRow();
    }
  }

  void readUnits() {
    const double ofX = columns_.unitOf(Columns::X, 1.0);
    length_ = columns_.unitOf(Columns::Y, ofX);
    if (length_ != ofX && !(input_.options.lengthUnit > 0.0)) {
      words_.error(wordOf(columns_[Columns::Y]), "tracks.two-units");
    }
    time_ = columns_.unitOf(Columns::Time, 1.0);
    radius_ = columns_.unitOf(Columns::Radius, length_);
    speed_ = columns_.unitOf(Columns::Vx, length_ / time_);
    columns_.unitOf(Columns::Vy, speed_);
    angle_ = columns_.unitOf(Columns::Heading, 1.0);
    turning_ = columns_.unitOf(Columns::Omega, angle_ / time_);
  }

  Word wordOf(std::size_t column) const {
    const CsvField& field = row_[column];
    return {withoutBlanks(field.text), field.line, field.column};
  }

  bool isActive() const {
    return !columns_.has(Columns::Active) ||
           base::parseDouble(wordOf(columns_[Columns::Active]).text) != 0.0;
  }

  std::optional<double> number(std::size_t column, const char* name) {
    const Word word = wordOf(column);
    if (layout_.separator != ';') {
      return words_.finite(word, name);
    }
    const std::string text = withPoint(word.text, layout_.separator);
    return words_.finite({text, word.line, word.column}, name);
  }

  /// Reads a column that may be missing or empty.
  bool readOptional(Columns::Column column, const char* name, double unit,
                    std::optional<double>& value) {
    if (!columns_.has(column) || wordOf(columns_[column]).text.empty()) {
      return true;
    }
    value = number(columns_[column], name);
    if (value) {
      *value *= unit;
    }
    return value.has_value();
  }

  void readRow() {
    TrackPoint point;
    Track body;
    const bool isPlaced = readPlace(point);
    const bool isKnown = readId(body);
    if (!readMotion(point) || !isPlaced || !isKnown || !readBody(body)) {
      return;
    }
    if (body.id < 0 && !body.isRobot) {
      words_.error(wordOf(columns_[Columns::Id]), "tracks.negative-person-id");
      return;
    }
    const std::string name(wordOf(columns_[Columns::Id]).text);
    const std::optional<double> number = base::parseDouble(name);
    const std::string id = number ? base::formatDouble(*number) : name;  // "1.0" is 1
    const auto [place, isNew] = numbers_.try_emplace({body.isRobot, id}, tracks_.size());
    if (isNew) {
      tracks_.push_back({name, {}});
    }
    Track& track = tracks_[place->second].second;
    body.points = std::move(track.points);
    body.radius = body.radius ? body.radius : track.radius;  // empty fields do not reset it
    body.group = body.group >= 0 ? body.group : track.group;
    track = std::move(body);
    track.points.push_back(point);
  }

  /// Ids that are not numbers are numbered in finish().
  bool readId(Track& body) {
    const Word word = wordOf(columns_[Columns::Id]);
    const bool isWord = !word.text.empty() && !base::parseDouble(word.text);
    hasWords_ = hasWords_ || isWord;
    const std::optional<long long> id = isWord ? std::optional(0LL) : words_.whole(word, "the id");
    body.id = static_cast<int>(id.value_or(0));
    return id.has_value();
  }

  bool readPlace(TrackPoint& point) {
    const bool byFrame = columns_.has(Columns::Frame);
    const std::size_t column = columns_[byFrame ? Columns::Frame : Columns::Time];
    const std::optional<double> time = number(column, byFrame ? "the frame" : "the time");
    const std::optional<double> x = number(columns_[Columns::X], "x");
    const std::optional<double> y = number(columns_[Columns::Y], "y");
    if (!time || !x || !y) {
      return false;
    }
    point.time = *time * (byFrame ? 1.0 : time_);
    point.position = length_ * Vec2(*x, *y);
    point.line = row_[column].line;
    point.column = row_[column].column;
    return true;
  }

  bool readMotion(TrackPoint& point) {
    std::optional<double> vx;
    std::optional<double> vy;
    bool good = readOptional(Columns::Heading, "the heading", angle_, point.heading);
    good = readOptional(Columns::Omega, "omega", turning_, point.angularSpeed) && good;
    good = readOptional(Columns::Vx, "vx", speed_, vx) && good;
    good = readOptional(Columns::Vy, "vy", speed_, vy) && good;
    if (vx && vy) {
      point.velocity = Vec2(*vx, *vy);
    }
    return good;
  }

  bool readBody(Track& body) {
    std::optional<double> group;
    std::optional<double> radius;
    bool good = readOptional(Columns::Group, "the group", 1.0, group);
    good = readOptional(Columns::Radius, "the radius", radius_, radius) && good;
    if (radius && !(*radius > 0.0)) {
      words_.error(wordOf(columns_[Columns::Radius]), "tracks.bad-radius");
      good = false;
    }
    body.radius = radius;
    body.group = group ? static_cast<int>(std::clamp(*group, -1.0, 1e9)) : body.group;
    return readKind(body.isRobot) && good;
  }

  bool readKind(bool& isRobot) {
    if (!columns_.has(Columns::Kind)) {
      return true;
    }
    const Word word = wordOf(columns_[Columns::Kind]);
    const std::string kind = base::toLower(word.text);
    isRobot = kind == "robot";
    if (!isRobot && kind != "human" && kind != "person" && kind != "pedestrian") {
      words_.error(word, "trace.bad-kind", {kind});
      return false;
    }
    return true;
  }

  TrackFile finish() {
    TrackFile file;
    for (auto& [name, track] : tracks_) {
      if (hasWords_) {
        track.id = static_cast<int>(file.tracks.size()) + 1;
        track.name = name;
      }
      file.tracks.push_back(std::move(track));
    }
    if (hasWords_) {
      std::vector<const Track*> all;
      for (const Track& track : file.tracks) {
        all.push_back(&track);
      }
      reportAssignedIds(input_, all);
    }
    file.lengthUnit = length_;
    file.timeUnit = time_;
    if (columns_.has(Columns::Frame)) {
      file.timeUnit = 1.0;
      framesToSeconds(file, rateOf(input_, layout_.rate));
    }
    return file;
  }

  const TrackInput& input_;
  const TableLayout& layout_;
  WordReader words_;
  CsvReader reader_;
  CsvRow header_, row_;
  Columns columns_;
  double length_ = 1.0, time_ = 1.0, radius_ = 1.0;    // units of the columns: [m], [s], [m]
  double speed_ = 1.0, angle_ = 1.0, turning_ = 1.0;   // [m/s], [rad], [rad/s]
  std::vector<std::pair<std::string, Track>> tracks_;  // with the id as written
  std::map<std::pair<bool, std::string>, std::size_t> numbers_;  // index in tracks_, by kind and id
  bool hasWords_ = false;                                        // some ids are not numbers
};

}  // namespace

std::map<std::string, std::vector<std::string>> ownColumnNames() {
  std::map<std::string, std::vector<std::string>> names;
  for (const char* name : {"time", "frame", "id", "x", "y", "heading", "vx", "vy", "omega", "group",
                           "radius", "kind"}) {
    names[name] = {name};
  }
  return names;
}

char separatorIn(std::string_view line) {
  for (const char separator : {',', ';', '\t'}) {
    if (line.find(separator) != std::string_view::npos) {
      return separator;
    }
  }
  return ',';
}

TrackFile readTrackTable(const TrackInput& input, const TableLayout& layout) {
  return TableReader(input, layout).read();
}

}  // namespace sim2d
