#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
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
  void readLine(const std::string& text, int line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) {
      return;
    }
    try {
      const Json json = Json::parse(base::shallowJson(text));
      if (json.is_object() && json.contains("track")) {
        readTrack(json["track"], line);
      } else if (json.is_object() && json.contains("scene")) {
        readScene(json["scene"], line);
      } else {
        input_.error("tracks.no-scene", {}, line, 1);
      }
    } catch (const Json::parse_error& problem) {
      input_.error("trace.not-json", {}, line, static_cast<int>(problem.byte));
    } catch (const Json::exception&) {
      input_.error("tracks.out-of-range", {}, line, 1);
    }
  }

  void readScene(const Json& scene, int line) {
    if (!scene.is_object()) {
      input_.error("tracks.bad-scene", {}, line, 1);
    } else if (scene.contains("fps")) {
      const double rate = scene["fps"].is_number() ? scene["fps"].get<double>() : 0.0;
      if (!(rate > 0.0) || !std::isfinite(rate)) {
        input_.error("tracks.bad-rate", {}, line, 1);
      } else if (sceneRate_ > 0.0 && rate != sceneRate_) {
        input_.error("tracks.rates-differ", {}, line, 1);
      }
      sceneRate_ = rate;
    }
  }

  void readTrack(const Json& track, int line) {
    const bool isWhole = track.is_object() && isInteger(track, "f") && isInteger(track, "p") &&
                         isNumber(track, "x") && isNumber(track, "y");
    if (!isWhole) {
      input_.error("tracks.bad-track", {}, line, 1);
      return;
    }
    if (track.contains("prediction_number") && !track["prediction_number"].is_null()) {
      return;  // a predicted position
    }
    if (track["p"].get<long long>() < 0) {
      input_.error("tracks.negative-id", {}, line, 1);
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
  return tracks.finish(input.path, input.rateOr(statedRate(leadingComments(input.text))));
}

TrackFile readTrajnet(const TrackInput& input) {
  const std::size_t first = input.text.find_first_not_of(" \t\r\n");
  const bool isJson = first != std::string::npos && input.text[first] == '{';
  if (isJson && !input.options.columns.empty()) {
    input.error("tracks.fixed-columns", {"trajnet (JSON lines)"});
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
