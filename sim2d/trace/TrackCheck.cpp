#include "sim2d/trace/TrackCheck.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr double kFarthest = 1e9;  // [m] from the origin; map coordinates are below 1e7

class TrackChecker {
 public:
  TrackChecker(const TrackFile& file, const TrackOptions& options, base::Diagnostics& problems)
      : file_(file), options_(options), problems_(problems) {}

  const Track* check() {
    checkTimes();
    checkPlaces();
    chooseRobot();
    checkIds();
    return robot_;
  }

 private:
  void error(const TrackPoint& point, std::string_view code, base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_.file, point.line, point.column));
  }

  void checkTimes() {
    bool isEmpty = true;
    for (const Track& track : file_.tracks) {
      isEmpty = isEmpty && track.points.empty();
      for (std::size_t k = 1; k < track.points.size(); ++k) {
        if (track.points[k].time <= track.points[k - 1].time) {
          error(track.points[k], "tracks.backwards", {track.id});
        }
      }
    }
    if (isEmpty) {
      problems_.push_back(base::error("tracks.empty", {}, file_.file));
    }
  }

  /// Reports the first out-of-range position of each body.
  void checkPlaces() {
    for (const Track& track : file_.tracks) {
      const auto far = std::find_if(
          track.points.begin(), track.points.end(),
          [](const TrackPoint& point) { return !(point.position.norm() <= kFarthest); });
      if (far != track.points.end()) {
        error(*far, "tracks.too-far", {static_cast<int>(kFarthest / 1000.0)});
      }
    }
  }

  static std::string nameOf(const Track& track) {
    return track.name.empty() ? std::to_string(track.id) : track.name;
  }

  bool isRobotRequested() const { return options_.robotId || !options_.robotName.empty(); }

  /// Matches by name if any track has it, else by id; without a request, tracks marked as robots.
  bool matchesRequest(const Track& track, bool byName) const {
    if (track.points.empty()) {
      return false;
    }
    if (byName) {
      return track.name == options_.robotName;
    }
    return isRobotRequested() ? options_.robotId && track.id == *options_.robotId : track.isRobot;
  }

  /// If a person and a robot match, only the robot is kept.
  std::vector<const Track*> findCandidates() const {
    const bool byName = !options_.robotName.empty() &&
                        std::any_of(file_.tracks.begin(), file_.tracks.end(),
                                    [&](const Track& t) { return t.name == options_.robotName; });
    std::vector<const Track*> candidates;
    for (const Track& track : file_.tracks) {
      if (matchesRequest(track, byName)) {
        candidates.push_back(&track);
      }
    }
    const auto isRobot = [](const Track* track) { return track->isRobot; };
    if (std::any_of(candidates.begin(), candidates.end(), isRobot)) {
      candidates.erase(std::remove_if(candidates.begin(), candidates.end(), std::not_fn(isRobot)),
                       candidates.end());
    }
    return candidates;
  }

  void chooseRobot() {
    const std::vector<const Track*> candidates = findCandidates();
    if (!candidates.empty()) {
      robot_ = candidates.front();
      for (std::size_t k = 1; k < candidates.size(); ++k) {
        error(candidates[k]->points.front(), "tracks.second-robot",
              {nameOf(*robot_), nameOf(*candidates[k])});
      }
      reportOtherRobots(candidates.size());
    } else if (isRobotRequested()) {
      reportUnknownRobot();
    } else if (options_.robotGoal) {
      problems_.push_back(base::error("tracks.goal-without-robot", {}, file_.file));
    }
  }

  void reportUnknownRobot() {
    std::vector<std::string> names;
    for (const Track& track : file_.tracks) {
      if (!track.name.empty()) {
        names.push_back(track.name);
      }
    }
    const std::string who =
        options_.robotName.empty() ? std::to_string(*options_.robotId) : options_.robotName;
    problems_.push_back(
        base::error("tracks.nobody", {who, base::nearestName(who, names)}, file_.file));
  }

  /// Other robots are treated as people.
  void reportOtherRobots(std::size_t chosen) {
    for (const Track& track : file_.tracks) {
      if (chosen == 1 && track.isRobot && &track != robot_ && !track.points.empty()) {
        problems_.push_back(
            base::warning("tracks.robot-among-people", {nameOf(track)}, file_.file));
      }
    }
  }

  /// Ids of people must be unique in a recording.
  void checkIds() {
    std::set<int> ids;
    for (const Track& track : file_.tracks) {
      if (&track != robot_ && !track.points.empty() && !ids.insert(track.id).second) {
        error(track.points.front(), "tracks.same-id", {track.id});
      }
    }
  }

  const TrackFile& file_;
  const TrackOptions& options_;
  base::Diagnostics& problems_;
  const Track* robot_ = nullptr;
};

}  // namespace

const Track* checkTracks(const TrackFile& file, const TrackOptions& options,
                         base::Diagnostics& problems) {
  return TrackChecker(file, options, problems).check();
}

base::Diagnostics limitedPerKind(const base::Diagnostics& problems) {
  constexpr std::size_t kMost = 10;
  std::map<std::string_view, std::size_t> counts;
  base::Diagnostics few;
  for (const base::Diagnostic& problem : problems) {
    if (++counts[problem.code] <= kMost) {
      few.push_back(problem);
    }
  }
  for (const auto& [code, count] : counts) {
    if (count > kMost) {
      const auto first = std::find_if(
          few.begin(), few.end(), [code = code](const auto& each) { return each.code == code; });
      few.push_back(base::problem(first->severity, "tracks.more-of-a-kind",
                                  {count - kMost, first->message}, first->file));
    }
  }
  return few;
}

}  // namespace sim2d
