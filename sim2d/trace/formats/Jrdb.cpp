#include <limits>
#include <set>

#include <nlohmann/json.hpp>

#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/JsonInput.h"

/// JRDB labels_3d: people around a robot at the origin, 15 frames per second.
namespace sim2d {

namespace {

using Json = nlohmann::json;

constexpr double kRate = 15.0;

/// The number at the end of "pedestrian:12", or before the extension of "000012.pcd".
std::optional<long long> numberIn(const std::string& text) {
  const std::size_t end = text.find_last_of("0123456789");
  if (end == std::string::npos) {
    return std::nullopt;
  }
  const std::size_t before = text.find_last_not_of("0123456789", end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return base::parseInt(text.substr(begin, end - begin + 1));
}

class JrdbReader {
 public:
  explicit JrdbReader(const TrackInput& input) : input_(input) {}

  TrackFile read() {
    const std::optional<Json> parsed = parseJsonInput(input_);
    if (!parsed) {
      return {};
    }
    try {
      const Json& root = *parsed;
      std::multimap<long long, const Json*> frames;  // sorted numerically
      for (const auto& [name, boxes] : root.at("labels").items()) {
        if (const std::optional<long long> frame = numberIn(name)) {
          frames.emplace(*frame, &boxes);
        } else {
          wrong("no number in the frame '" + name + "'");
        }
      }
      for (const auto& [frame, boxes] : frames) {
        for (const Json& box : *boxes) {
          addBox(frame, box);
        }
      }
    } catch (const Json::exception& problem) {
      input_.error("tracks.bad-json", {base::jsonErrorMessage(problem.what())});
      return {};
    }
    reportSkipped();
    TrackFile file = tracks_.finish(input_.path, input_.rateOr(kRate));
    for (Track& track : file.tracks) {
      track.name = names_[track.id];  // contains the id
    }
    return file;
  }

 private:
  void wrong(const std::string& reason) { input_.error("tracks.bad-json", {reason}); }

  void reportSkipped() {
    if (!left_.empty()) {
      const std::vector<std::string> names(others_.begin(), others_.end());
      input_.warning("tracks.not-people", {left_.size(), base::join(names, ", ")});
    }
    input_.warning("tracks.around-robot");
  }

  void addBox(long long frame, const Json& label) {
    const std::string name = label.at("label_id").get<std::string>();
    if (!base::startsWith(name, "pedestrian")) {
      left_.insert(name);
      others_.insert(name.substr(0, name.find(':')));
      return;
    }
    const std::optional<long long> id = numberIn(name);
    if (!id || *id > std::numeric_limits<int>::max()) {
      wrong("no valid number in '" + name + "'");
      return;
    }
    const Json& box = label.at("box");
    const Vec2 place(box.at("cx").get<double>(), box.at("cy").get<double>());
    names_[static_cast<int>(*id)] = name;
    TrackPoint& point = tracks_.add(static_cast<int>(*id), frame, place, 0, 0);
    if (box.contains("rot_z")) {
      point.heading = box.at("rot_z").get<double>();
    }
  }

  const TrackInput& input_;
  FrameTracks tracks_;
  std::map<int, std::string> names_;     // by id
  std::set<std::string> left_, others_;  // ids of other objects, and their kinds
};

FormatMatch matchFormat(const FilePreview& preview) {
  const bool isBoxes = preview.mentions("\"labels\"") && preview.mentions("label_id");
  return isBoxes ? FormatMatch::ByContent : FormatMatch::None;
}

}  // namespace

void addJrdb(TrackFormats& to) {
  to.add(
      {"jrdb", 10, matchFormat, [](const TrackInput& input) { return JrdbReader(input).read(); }});
}

}  // namespace sim2d
