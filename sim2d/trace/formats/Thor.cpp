#include <algorithm>
#include <map>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"
#include "sim2d/trace/TrackFormats.h"

/// THÖR-MAGNI recordings: header lines, then a table with the columns Frame, Time and, per body,
/// "Helmet_1 Centroid_X" … in millimetres; empty if a body is not visible. Helmets are people; of
/// other bodies only robots are read.
namespace sim2d {

namespace {

constexpr double kMillimetre = 1e-3;  // [m]
constexpr long long kLargestId = 2000000000;
constexpr int kNoId = -1, kFirstOwnId = 1000;
constexpr std::string_view kEnd = " Centroid_X";

struct BodyPlace {
  std::string name;
  std::size_t x = 0, y = 0;
};

/// "Helmet_10": 10.
std::optional<int> numberOf(const std::string& name) {
  const std::size_t line = name.rfind('_');
  const std::optional<long long> number =
      line == std::string::npos ? std::nullopt : base::parseInt(name.substr(line + 1));
  return number && *number >= 0 && *number <= kLargestId ? std::optional(static_cast<int>(*number))
                                                         : std::nullopt;
}

bool isRobotName(const std::string& name) {
  return base::startsWith(name, "DARKO") || name.find("obot") != std::string::npos;
}

class ThorReader {
 public:
  explicit ThorReader(const TrackInput& input)
      : input_(input), words_(input.path, input.problems), rows_(input.text) {}

  TrackFile read() {
    if (!findTable()) {
      input_.error("tracks.no-table", {"Frame, Time, NAME Centroid_X, NAME Centroid_Y …"});
      return {};
    }
    while (words_.isUsable() && rows_.next(row_)) {
      const bool isEmpty = row_.size() == 1 && base::trimmed(row_.front().text).empty();
      if (!isEmpty && row_.size() != width_) {
        words_.error(wordOf(row_.size() - 1), "trace.field-count", {row_.size(), width_});
      } else if (!isEmpty) {
        readRow();
      }
    }
    if (!others_.empty()) {
      input_.warning("tracks.not-people", {others_.size(), base::join(others_, ", ")});
    }
    assignMissingIds();
    TrackFile file;
    file.lengthUnit = kMillimetre;
    for (Track& track : tracks_) {
      if (!track.points.empty()) {
        file.tracks.push_back(std::move(track));
      }
    }
    if (!hasTimes_) {
      framesToSeconds(file, rateOf(input_, rate_));
    }
    return file;
  }

 private:
  /// Header lines may state the frame rate, which is used if the table has no times.
  bool findTable() {
    while (rows_.next(row_)) {
      std::vector<std::string> names;
      for (const CsvField& field : row_) {
        names.push_back(base::trimmed(field.text));
      }
      if (names.front() != "Frame") {
        noteRate(names);
        continue;
      }
      const auto time = std::find(names.begin(), names.end(), "Time");
      hasTimes_ = time != names.end();
      time_ = hasTimes_ ? static_cast<std::size_t>(time - names.begin()) : 0;
      width_ = names.size();
      std::map<std::string, std::size_t> columns;
      for (std::size_t k = 0; k < names.size(); ++k) {
        columns.emplace(names[k], k);
      }
      for (std::size_t k = 0; k < names.size(); ++k) {
        addBody(names[k], k, columns);
      }
      return !bodies_.empty() || !others_.empty();
    }
    return false;
  }

  void noteRate(const std::vector<std::string>& fields) {
    const std::string name = base::toLower(fields.front());
    const bool isRate = name == "frequency" || name == "frame_rate" || name == "framerate" ||
                        name == "camera_frequency" || name == "fps";
    if (isRate && fields.size() > 1) {
      rate_ = base::parseDouble(fields[1]).value_or(0.0);
    }
  }

  void addBody(const std::string& name, std::size_t x,
               const std::map<std::string, std::size_t>& columns) {
    if (name.size() <= kEnd.size() || !base::endsWith(name, kEnd)) {
      return;
    }
    const std::string body = name.substr(0, name.size() - kEnd.size());
    const auto y = columns.find(body + " Centroid_Y");
    if (y == columns.end()) {
      return;
    }
    if (!base::startsWith(body, "Helmet_") && !isRobotName(body)) {
      others_.push_back(body);
      return;
    }
    bodies_.push_back({body, x, y->second});
    Track track;
    track.name = body;
    track.isRobot = isRobotName(body);
    track.id = track.isRobot ? kNoId : numberOf(body).value_or(kNoId);
    tracks_.push_back(std::move(track));
  }

  /// Assigns unused numbers to robots and to helmets without one, and reports them.
  void assignMissingIds() {
    std::set<int> taken;
    for (const Track& track : tracks_) {
      taken.insert(track.id);
    }
    int next = kFirstOwnId;
    std::vector<const Track*> numbered;
    for (Track& track : tracks_) {
      while (track.id == kNoId && taken.count(next) > 0) {
        ++next;
      }
      if (track.id == kNoId) {
        track.id = next++;
        numbered.push_back(&track);
      }
    }
    reportAssignedIds(input_, numbered);
  }
  Word wordOf(std::size_t column) const {
    const CsvField& field = row_[column];
    return {field.text, field.line, field.column};
  }

  void readRow() {
    const std::optional<double> time =
        words_.finite(wordOf(time_), hasTimes_ ? "the time" : "the frame");
    for (std::size_t k = 0; time && k < bodies_.size(); ++k) {
      if (base::trimmed(row_[bodies_[k].x].text).empty()) {
        continue;  // not visible
      }
      const std::optional<double> x = words_.finite(wordOf(bodies_[k].x), "x");
      const std::optional<double> y = words_.finite(wordOf(bodies_[k].y), "y");
      if (x && y) {
        tracks_[k].points.push_back(
            pointAt(wordOf(bodies_[k].x), *time, kMillimetre * Vec2(*x, *y)));
      }
    }
  }

  const TrackInput& input_;
  WordReader words_;
  CsvReader rows_;
  CsvRow row_;
  std::size_t time_ = 0, width_ = 0;  // column of times or frames; number of columns
  bool hasTimes_ = true;
  double rate_ = 0.0;  // frame rate stated in the file [1/s]
  std::vector<BodyPlace> bodies_;
  std::vector<Track> tracks_;        // parallel to bodies_
  std::vector<std::string> others_;  // ignored bodies
};

FormatMatch matchFormat(const FilePreview& preview) {
  return preview.mentions(kEnd) ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addThor(TrackFormats& to) {
  to.add(
      {"thor", 9, matchFormat, [](const TrackInput& input) { return ThorReader(input).read(); }});
}

}  // namespace sim2d
