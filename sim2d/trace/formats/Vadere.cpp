#include <algorithm>
#include <cmath>

#include "sim2d/trace/ForeignReaders.h"

/// Output of Vadere: positions by time step ("timeStep pedestrianId x y"), or footsteps
/// ("pedestrianId simTime endTime startX startY endX endY"). Names may end with "-PID1".
namespace sim2d {

namespace {

constexpr double kUsualStep = 0.4;  // [s] of a time step of Vadere
constexpr double kSameTime = 1e-6;  // [s] a footstep begins when the one before ends
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

class VadereReader {
 public:
  explicit VadereReader(const ForeignInput& input)
      : input_(input), words_(input.path, input.problems), rows_(input.text) {}

  TrackFile read() {
    if (!rows_.next(header_)) {
      input_.problems.push_back(base::error("tracks.file-empty", {}, input_.path));
      return {};
    }
    const std::size_t id = column("pedestrianId");
    const bool isStepwise = column("timeStep") != kNone;
    std::vector<std::size_t> wanted;
    for (const char* name : isStepwise ? kStepwise : kFootsteps) {
      wanted.push_back(column(name));
    }
    if (id == kNone || std::count(wanted.begin(), wanted.end(), kNone) > 0) {
      words_.error(header_.front(), "tracks.no-table",
                   {"pedestrianId timeStep x y, or pedestrianId simTime endTime startX …"});
      return {};
    }
    std::vector<Word> row;
    while (rows_.next(row)) {
      if (row.size() != header_.size()) {
        words_.error(row.back(), "trace.field-count", {row.size(), header_.size()});
        continue;
      }
      readRow(row, id, wanted, isStepwise);
    }
    return finish(isStepwise);
  }

 private:
  static constexpr std::initializer_list<const char*> kStepwise = {"timeStep", "x", "y"};
  static constexpr std::initializer_list<const char*> kFootsteps = {"simTime", "startX", "startY",
                                                                    "endTime", "endX",   "endY"};

  std::size_t column(std::string_view name) const {
    for (std::size_t k = 0; k < header_.size(); ++k) {
      if (header_[k].text.substr(0, header_[k].text.find("-PID")) == name) {
        return k;
      }
    }
    return kNone;
  }

  void readRow(const std::vector<Word>& row, std::size_t id, const std::vector<std::size_t>& wanted,
               bool isStepwise) {
    const std::optional<int> number = idOf(words_, row[id]);
    std::vector<double> values;
    for (const std::size_t at : wanted) {
      if (const std::optional<double> value = words_.finite(row[at], "a number")) {
        values.push_back(*value);
      }
    }
    if (!number || values.size() != wanted.size()) {
      return;
    }
    Track& track = tracks_[*number];
    track.id = *number;
    for (std::size_t k = 0; k + 2 < values.size(); k += 3) {
      TrackPoint point;
      point.time = values[k] * (isStepwise ? step() : 1.0);
      point.position = Vec2(values[k + 1], values[k + 2]);
      point.line = row.front().line;
      point.column = row.front().column;
      const bool isSame = !isStepwise && !track.points.empty() &&
                          std::fabs(point.time - track.points.back().time) < kSameTime;
      if (!isSame) {
        track.points.push_back(point);
      }
    }
  }

  double step() const {
    const double rate = input_.options.framesPerSecond;
    return rate > 0.0 ? 1.0 / rate : kUsualStep;
  }

  TrackFile finish(bool isStepwise) {
    TrackFile file;
    file.step = isStepwise ? step() : kUsualStep;
    file.isByFrames = isStepwise;
    file.isSparse = !isStepwise;
    for (auto& [id, track] : tracks_) {
      file.tracks.push_back(std::move(track));
    }
    return file;
  }

  const ForeignInput& input_;
  WordReader words_;
  TextRows rows_;
  std::vector<Word> header_;
  std::map<int, Track> tracks_;
};

Claim claim(const FirstLook& look) {
  const bool isNamed = std::any_of(look.row.begin(), look.row.end(), [](const Word& word) {
    return word.text.substr(0, 12) == "pedestrianId";
  });
  return isNamed ? Claim::ByContent : Claim::None;
}

}  // namespace

void addVadere(TrackFormats& to) {
  to.add(
      {"vadere", 6, claim, [](const ForeignInput& input) { return VadereReader(input).read(); }});
}

}  // namespace sim2d
