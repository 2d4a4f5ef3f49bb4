#include "sim2d/trace/Csv.h"

#include <algorithm>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/ForeignReaders.h"

/// Tables with a header line; which column is what can be told.
namespace sim2d {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The first of them that the header holds.
char separatorOf(std::string_view text) {
  const std::string_view header = text.substr(0, text.find('\n'));
  for (const char separator : {',', ';', '\t'}) {
    if (header.find(separator) != std::string_view::npos) {
      return separator;
    }
  }
  return ',';
}

class CsvTracks {
 public:
  explicit CsvTracks(const ForeignInput& input)
      : input_(input),
        words_(input.path, input.problems),
        reader_(input.text, separatorOf(input.text)) {}

  TrackFile read() {
    if (!reader_.next(row_)) {
      input_.problems.push_back(base::error("tracks.file-empty", {}, input_.path));
      return {};
    }
    findColumns();
    if (base::hasErrors(input_.problems)) {
      return {};
    }
    const std::size_t width = row_.size();
    while (reader_.next(row_)) {
      const bool isEmpty = row_.size() == 1 && base::trimmed(row_.front().text).empty();
      if (!isEmpty && row_.size() != width) {
        words_.error(wordOf(row_.size() - 1), "trace.field-count", {row_.size(), width});
      } else if (!isEmpty) {
        readRow();
      }
    }
    return finish();
  }

 private:
  /// Columns of the quantities by the names given, else by their own.
  void findColumns() {
    const std::map<std::string, std::size_t*> wanted = {
        {"time", &time_},   {"frame", &frame_}, {"id", &id_},         {"x", &x_},
        {"y", &y_},         {"vx", &vx_},       {"vy", &vy_},         {"heading", &heading_},
        {"omega", &omega_}, {"group", &group_}, {"radius", &radius_}, {"kind", &kind_}};
    for (const auto& [name, column] : wanted) {
      const auto given = input_.options.columns.find(name);
      *column = columnNamed(isGiven(name) ? given->second : name);
      if (isGiven(name) && *column == kNone) {
        missing("tracks.unknown-column", {given->second, nearestTo(given->second)});
      }
    }
    if (time_ != kNone && !isGiven("frame")) {
      frame_ = kNone;
    }
    if (time_ == kNone && frame_ == kNone && !isGiven("time") && !isGiven("frame")) {
      missing("tracks.no-times");
    }
    for (const auto& [name, column] :
         {std::pair<const char*, std::size_t>{"id", id_}, {"x", x_}, {"y", y_}}) {
      if (column == kNone && !isGiven(name)) {
        missing("tracks.no-column", {name});
      }
    }
    if ((vx_ == kNone) != (vy_ == kNone)) {
      missing("tracks.half-velocity");
    }
  }

  bool isGiven(const std::string& name) const { return input_.options.columns.count(name) > 0; }

  std::optional<std::string> nearestTo(const std::string& name) const {
    std::vector<std::string> names;
    for (const CsvField& field : row_) {
      names.push_back(base::trimmed(field.text));
    }
    return base::nearestName(name, names);
  }

  std::size_t columnNamed(const std::string& name) const {
    for (std::size_t k = 0; k < row_.size(); ++k) {
      if (base::trimmed(row_[k].text) == name) {
        return k;
      }
    }
    return kNone;
  }

  void missing(const char* code, base::ProblemValues values = {}) {
    input_.problems.push_back(base::error(code, std::move(values), input_.path, 1, 1));
  }

  Word wordOf(std::size_t column) const {
    const CsvField& field = row_[column];
    std::string_view text = field.text;
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
      text.remove_prefix(1);
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
      text.remove_suffix(1);
    }
    return {text, field.line, field.column};
  }

  /// Of a column that may be missing or empty.
  bool readOptional(std::size_t column, const char* name, std::optional<double>& value) {
    if (column == kNone || wordOf(column).text.empty()) {
      return true;
    }
    value = words_.finite(wordOf(column), name);
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
      words_.error(wordOf(id_), "tracks.negative-person-id");
      return;
    }
    const std::string name(wordOf(id_).text);
    const std::optional<double> number = base::parseDouble(name);
    const std::string id = number ? base::formatDouble(*number) : name;  // "1.0" is 1
    const auto [place, isNew] = numbers_.try_emplace({body.isRobot, id}, tracks_.size());
    if (isNew) {
      tracks_.push_back({name, {}});
    }
    Track& track = tracks_[place->second].second;
    body.points = std::move(track.points);
    body.radius = body.radius ? body.radius : track.radius;  // empty fields take nothing back
    body.group = body.group >= 0 ? body.group : track.group;
    track = std::move(body);
    track.points.push_back(point);
  }

  /// A word instead of a number gets one in the end.
  bool readId(Track& body) {
    const Word word = wordOf(id_);
    const bool isWord = !word.text.empty() && !base::parseDouble(word.text);
    hasWords_ = hasWords_ || isWord;
    const std::optional<long long> id = isWord ? std::optional(0LL) : words_.whole(word, "the id");
    body.id = static_cast<int>(id.value_or(0));
    return id.has_value();
  }

  bool readPlace(TrackPoint& point) {
    const bool byFrame = frame_ != kNone;
    const Word timeWord = wordOf(byFrame ? frame_ : time_);
    const std::optional<double> time = words_.finite(timeWord, byFrame ? "the frame" : "the time");
    const std::optional<double> x = words_.finite(wordOf(x_), "x");
    const std::optional<double> y = words_.finite(wordOf(y_), "y");
    if (!time || !x || !y) {
      return false;
    }
    point.time = *time;
    point.position = Vec2(*x, *y);
    point.line = timeWord.line;
    point.column = timeWord.column;
    return true;
  }

  bool readMotion(TrackPoint& point) {
    std::optional<double> vx;
    std::optional<double> vy;
    bool good = readOptional(heading_, "the heading", point.heading);
    good = readOptional(omega_, "omega", point.angularSpeed) && good;
    good = readOptional(vx_, "vx", vx) && readOptional(vy_, "vy", vy) && good;
    if (vx && vy) {
      point.velocity = Vec2(*vx, *vy);
    }
    return good;
  }

  bool readBody(Track& body) {
    std::optional<double> group;
    std::optional<double> radius;
    bool good = readOptional(group_, "the group", group);
    good = readOptional(radius_, "the radius", radius) && good;
    if (radius && !(*radius > 0.0)) {
      words_.error(wordOf(radius_), "tracks.bad-radius");
      good = false;
    }
    body.radius = radius;
    body.group = group ? static_cast<int>(std::clamp(*group, -1.0, 1e9)) : body.group;
    return readKind(body.isRobot) && good;
  }

  bool readKind(bool& isRobot) {
    if (kind_ == kNone) {
      return true;
    }
    const std::string kind = base::lowered(wordOf(kind_).text);
    isRobot = kind == "robot";
    if (!isRobot && kind != "human" && kind != "person" && kind != "pedestrian") {
      words_.error(wordOf(kind_), "trace.bad-kind", {kind});
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
      tellNumbers(input_, all);
    }
    if (frame_ != kNone) {
      if (!(input_.options.framesPerSecond > 0.0)) {
        input_.problems.push_back(base::error("tracks.no-rate", {}, input_.path, 1, 1));
      }
      framesToSeconds(file, input_.options.framesPerSecond);
    }
    return file;
  }

  const ForeignInput& input_;
  WordReader words_;
  CsvReader reader_;
  CsvRow row_;
  std::vector<std::pair<std::string, Track>> tracks_;            // with what stands there as id
  std::map<std::pair<bool, std::string>, std::size_t> numbers_;  // in tracks_, by kind and id
  bool hasWords_ = false;                                        // among the ids
  std::size_t time_ = kNone, frame_ = kNone, id_ = kNone, x_ = kNone, y_ = kNone, vx_ = kNone,
              vy_ = kNone, heading_ = kNone, omega_ = kNone, group_ = kNone, radius_ = kNone,
              kind_ = kNone;
};

/// Columns may have any names: a table with ours is one for certain.
Claim claim(const FirstLook& look) {
  const auto holds = [&look](std::string_view name) {
    return std::any_of(look.row.begin(), look.row.end(),
                       [name](const Word& word) { return word.text == name; });
  };
  const bool isOurs = (holds("time") || holds("frame")) && holds("id") && holds("x") && holds("y");
  return isOurs ? Claim::ByContent : Claim::Fallback;
}

}  // namespace

void addCsv(TrackFormats& to) {
  to.add({"csv", 0, claim, [](const ForeignInput& input) { return CsvTracks(input).read(); }, true,
          true});
}

}  // namespace sim2d
