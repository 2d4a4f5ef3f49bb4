#include "sim2d/trace/TrackTable.h"

#include <algorithm>
#include <optional>

#include "sim2d/base/Text.h"
#include "sim2d/trace/TableColumns.h"

namespace sim2d {
namespace {

using Columns = TableColumns;

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
