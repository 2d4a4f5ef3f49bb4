#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/TrackFormats.h"

/// Vadere output: positions per time step ("timeStep pedestrianId x y") or footsteps ("pedestrianId
/// simTime endTime startX startY endX endY"). Column names may end with "-PID1". The length of a
/// time step is in the scenario file next to the output.
namespace sim2d {

namespace {

constexpr double kDefaultStep = 0.4;  // [s], default length of a time step
constexpr double kSameTime = 1e-6;    // [s]; a footstep begins at the end of the previous one
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// [s], "simTimeStepLength" of the only *.scenario file in the folder; 0: none.
double scenarioTimeStep(const std::string& path) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(path).parent_path();
  std::error_code error;
  std::vector<std::string> scenarios;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    if (entry->path().extension() == ".scenario") {
      scenarios.push_back(entry->path().string());
    }
  }
  if (path == "-" || scenarios.size() != 1) {
    return 0.0;
  }
  const base::Result<std::string> text = base::readTextFile(scenarios.front());
  const nlohmann::json root =
      nlohmann::json::parse(base::shallowJson(text ? *text : ""), nullptr, false);
  for (const char* name : {"scenario", "vadere"}) {
    const auto place = nlohmann::json::json_pointer("/" + std::string(name) +
                                                    "/attributesSimulation/simTimeStepLength");
    if (root.is_object() && root.contains(place) && root[place].is_number()) {
      const double step = root[place].get<double>();
      return step > 0.0 && std::isfinite(step) ? step : 0.0;
    }
  }
  return 0.0;
}

class VadereReader {
 public:
  explicit VadereReader(const TrackInput& input)
      : input_(input), words_(input.path, input.problems), rows_(input.text) {
    const double rate = input.options.framesPerSecond;
    const double stated = rate > 0.0 ? 0.0 : scenarioTimeStep(input.path);
    step_ = rate > 0.0 ? 1.0 / rate : stated > 0.0 ? stated : kDefaultStep;
  }

  TrackFile read() {
    if (!rows_.next(header_)) {
      input_.error("tracks.file-empty");
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
    while (words_.isUsable() && rows_.next(row)) {
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
      const TrackPoint point = pointAt(row.front(), values[k] * (isStepwise ? step_ : 1.0),
                                       Vec2(values[k + 1], values[k + 2]));
      const bool isSame = !isStepwise && !track.points.empty() &&
                          std::fabs(point.time - track.points.back().time) < kSameTime;
      if (!isSame) {
        track.points.push_back(point);
      }
    }
  }

  TrackFile finish(bool isStepwise) {
    TrackFile file;
    file.step = isStepwise ? step_ : kDefaultStep;
    file.hasFrameTimes = isStepwise;
    file.isSparse = !isStepwise;
    file.tracks = tracksOf(std::move(tracks_));
    return file;
  }

  const TrackInput& input_;
  WordReader words_;
  TextRows rows_;
  std::vector<Word> header_;
  std::map<int, Track> tracks_;
  double step_ = kDefaultStep;  // [s] per time step
};

FormatMatch matchFormat(const FilePreview& preview) {
  const bool isNamed = std::any_of(preview.row.begin(), preview.row.end(), [](const Word& word) {
    return word.text.substr(0, 12) == "pedestrianId";
  });
  return isNamed ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addVadere(TrackFormats& to) {
  to.add({"vadere", 6, matchFormat,
          [](const TrackInput& input) { return VadereReader(input).read(); }});
}

}  // namespace sim2d
