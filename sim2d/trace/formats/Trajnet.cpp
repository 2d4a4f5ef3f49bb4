#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "sim2d/trace/TrackFormats.h"

/// TrajNet++: rows of numbers, or JSON lines with scenes and tracks.
namespace sim2d {

namespace {

using Json = nlohmann::json;

class TrajnetReader {
 public:
  explicit TrajnetReader(const TrackInput& input) : input_(input) {}

  TrackFile read() {
    std::size_t begin = 0;
    const WordReader words(input_.path, input_.problems);
    for (int line = 1; words.isUsable() && begin < input_.text.size(); ++line) {
      const std::size_t end = std::min(input_.text.find('\n', begin), input_.text.size());
      readLine(input_.text.substr(begin, end - begin), line);
      begin = end + 1;
    }
    const double rate = input_.options.framesPerSecond;
    TrackFile file = tracks_.finish(input_.path, rate);
    if (rate <= 0.0 && sceneRate_ > 0.0) {  // observations per second, not frames
      for (Track& track : file.tracks) {
        for (TrackPoint& point : track.points) {
          point.time *= 1.0 / (sceneRate_ * file.step);
        }
      }
      file.step = 1.0 / sceneRate_;
    }
    return file;
  }

 private:
  void error(int line, int column, const char* code) {
    input_.problems.push_back(base::error(code, {}, input_.path, line, column));
  }

  void readLine(const std::string& text, int line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) {
      return;
    }
    try {
      const Json json = Json::parse(text);
      if (json.is_object() && json.contains("track")) {
        readTrack(json["track"], line);
      } else if (json.is_object() && json.contains("scene")) {
        readScene(json["scene"], line);
      } else {
        error(line, 1, "tracks.no-scene");
      }
    } catch (const Json::parse_error& problem) {
      error(line, static_cast<int>(problem.byte), "trace.not-json");
    } catch (const Json::exception&) {
      error(line, 1, "tracks.out-of-range");
    }
  }

  void readScene(const Json& scene, int line) {
    if (!scene.is_object()) {
      error(line, 1, "tracks.bad-scene");
    } else if (scene.contains("fps")) {
      const double rate = scene["fps"].is_number() ? scene["fps"].get<double>() : 0.0;
      if (!(rate > 0.0) || !std::isfinite(rate)) {
        error(line, 1, "tracks.bad-rate");
      } else if (sceneRate_ > 0.0 && rate != sceneRate_) {
        error(line, 1, "tracks.rates-differ");
      }
      sceneRate_ = rate;
    }
  }

  void readTrack(const Json& track, int line) {
    const bool isWhole = track.is_object() && isInteger(track, "f") && isInteger(track, "p") &&
                         isNumber(track, "x") && isNumber(track, "y");
    if (!isWhole) {
      error(line, 1, "tracks.bad-track");
      return;
    }
    if (track.contains("prediction_number") && !track["prediction_number"].is_null()) {
      return;  // a predicted position
    }
    if (track["p"].get<long long>() < 0) {
      error(line, 1, "tracks.negative-id");
      return;
    }
    tracks_.add(track["p"].get<int>(), track["f"].get<long long>(),
                Vec2(track["x"].get<double>(), track["y"].get<double>()), line, 1);
  }

  static bool isInteger(const Json& object, const char* key) {
    constexpr double kLargest = 2e9;
    return object.contains(key) && object[key].is_number_integer() &&
           std::fabs(object[key].get<double>()) <= kLargest;
  }
  static bool isNumber(const Json& object, const char* key) {
    return object.contains(key) && object[key].is_number() &&
           std::isfinite(object[key].get<double>());
  }

  const TrackInput& input_;
  FrameTracks tracks_;
  double sceneRate_ = 0.0;
};

TrackFile readTrajnetRows(const TrackInput& input) {
  constexpr std::size_t kWidth = 4;
  const std::vector<std::size_t> order = numberedColumns(input, {"frame", "id", "x", "y"}, kWidth);
  FrameTracks tracks;
  forEachRow(input, kWidth, "frame id x y", [&](WordReader& words, const std::vector<Word>& row) {
    tracks.add(words, row[order[0]], row[order[1]], row[order[2]], row[order[3]]);
  });
  const double given = input.options.framesPerSecond;
  return tracks.finish(input.path, given > 0.0 ? given : statedRate(leadingComments(input.text)));
}

TrackFile readTrajnet(const TrackInput& input) {
  const std::size_t first = input.text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && input.text[first] == '{';
  if (isJson && !input.options.columns.empty()) {
    input.problems.push_back(
        base::error("tracks.fixed-columns", {"trajnet (JSON lines)"}, input.path));
    return {};
  }
  return isJson ? TrajnetReader(input).read() : readTrajnetRows(input);
}

FormatMatch matchFormat(const FilePreview& preview) {
  if (preview.endsWith(".ndjson")) {
    return FormatMatch::ByName;
  }
  const bool isJson = !preview.row.empty() && preview.row.front().text.front() == '{' &&
                      (preview.mentions("\"scene\"") || preview.mentions("\"track\""));
  return (isJson || (preview.isNumbers && preview.row.size() == 4)) && !preview.endsWith(".csv")
             ? FormatMatch::ByContent
             : FormatMatch::None;
}

}  // namespace

void addTrajnet(TrackFormats& to) {
  to.add({"trajnet", 3, matchFormat, readTrajnet, false, true});
}

}  // namespace sim2d
