#include "sim2d/trace/TrackCheck.h"

#include <algorithm>
#include <set>

namespace sim2d {
namespace {

class TrackChecker {
 public:
  TrackChecker(const TrackFile& file, const TrackOptions& options, base::Diagnostics& problems)
      : file_(file), options_(options), problems_(problems) {}

  const Track* check() {
    checkTimes();
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

  /// By its name where somebody has it, else by its id, else whom the file calls a robot.
  bool isChosen(const Track& track, bool byName) const {
    if (byName) {
      return track.name == options_.robotName;
    }
    return options_.robotId ? track.id == *options_.robotId
                            : options_.robotName.empty() && track.isRobot;
  }

  void chooseRobot() {
    const bool isAsked = options_.robotId || !options_.robotName.empty();
    const bool byName = !options_.robotName.empty() &&
                        std::any_of(file_.tracks.begin(), file_.tracks.end(),
                                    [&](const Track& t) { return t.name == options_.robotName; });
    for (const Track& track : file_.tracks) {
      const bool chosen = isChosen(track, byName) && !track.points.empty();
      if (chosen && robot_ == nullptr) {
        robot_ = &track;
      } else if (chosen) {
        error(track.points.front(), "tracks.second-robot");
      }
    }
    if (isAsked && robot_ == nullptr) {
      const std::string who =
          options_.robotName.empty() ? std::to_string(*options_.robotId) : options_.robotName;
      problems_.push_back(base::error("tracks.nobody", {who}, file_.file));
    }
    if (options_.robotGoal && robot_ == nullptr && !isAsked) {
      problems_.push_back(base::error("tracks.goal-without-robot", {}, file_.file));
    }
  }

  /// A record has one person of an id: the second would be lost.
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

}  // namespace sim2d
