#include "app/bridge/bag/BagTrace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "app/bridge/bag/BagBodies.h"
#include "app/bridge/bag/RunBagWriter.h"
#include "app/bridge/bag/ThirdPartyBag.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/TraceContents.h"

namespace bridge {
namespace {

const std::vector<sim2d::TraceGoal>* goalsOf(const sim2d::TraceHeader& header, int id) {
  for (const sim2d::TraceRobot& robot : header.robots) {
    if (robot.id == id) {
      return &robot.goals;
    }
  }
  const sim2d::TraceHuman* const human = header.human(id);
  return human != nullptr ? &human->goals : nullptr;
}

/// The id of the goal at this position; kNoGoal: none.
int goalAt(const sim2d::TraceHeader& header, int id, const std::optional<base::Vec2>& place) {
  const std::vector<sim2d::TraceGoal>* const goals = goalsOf(header, id);
  if (!place || goals == nullptr) {
    return sim2d::kNoGoal;
  }
  const auto found = std::find_if(goals->begin(), goals->end(), [&](const sim2d::TraceGoal& goal) {
    return (goal.position - *place).norm() < kSamePlace;
  });
  return found == goals->end() ? sim2d::kNoGoal : found->id;
}

/// Creates the trace of a hunavsim run: header and events from the metadata, bodies from the
/// messages.
class HunavsimTrace {
 public:
  HunavsimTrace(Bag& bag, const std::string& path) : bag_(bag), path_(path) {}

  base::Result<sim2d::Trace> make() {
    sim2d::TraceTexts texts{{path_ + " trajectory", {}},
                            {path_ + " events.csv", bag_.metadata(kRunMetadata, "events.csv")},
                            {path_ + " trace.json", bag_.metadata(kRunMetadata, "trace.json")}};
    const base::Result<sim2d::TraceHeader> header =
        sim2d::parseTraceJson(texts.header.content, texts.header.path);
    if (!header) {
      return header.diagnostics();
    }
    BagBodies bodies(bag_, hunavsimTopics(bag_.channels()), path_);
    base::Diagnostics problems = bodies.read();
    if (base::hasErrors(problems) || bodies.hasInvalidSamples()) {
      return problems;  // the run cannot be reconstructed
    }
    texts.trajectory.content = rowsOf(bodies, *header);
    base::Result<sim2d::Trace> trace = sim2d::parseTrace(texts);
    base::append(problems, trace.diagnostics());
    return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(problems))
                 : base::Result<sim2d::Trace>(std::move(problems));
  }

 private:
  using Frames = std::map<std::int64_t, sim2d::Frame>;  // by step

  static void add(const BagBody& body, const sim2d::TraceHeader& header, bool isRobot,
                  Frames& frames) {
    for (const BagSample& sample : body.samples) {
      const std::int64_t step =
          std::llround(static_cast<double>(sample.time) * kNanosecond / header.dt);
      sim2d::Frame& frame = frames[step];
      frame.step = step;
      frame.time = static_cast<double>(step) * header.dt;
      sim2d::BodyColumns& columns =
          isRobot ? frame.robots : static_cast<sim2d::BodyColumns&>(frame.humans);
      columns.add(body.id, sample.pose, sample.velocity.value_or(base::Vec2::Zero()),
                  sample.omega.value_or(0.0), goalAt(header, body.id, sample.goal));
      if (!isRobot) {
        frame.humans.group.push_back(sample.group);
        frame.humans.state.push_back(sample.state);
      }
    }
  }

  /// The rows of trajectory.csv, so that its reader validates them.
  static std::string rowsOf(const BagBodies& bodies, const sim2d::TraceHeader& header) {
    Frames frames;
    for (const auto& [id, body] : bodies.people()) {
      add(body, header, false, frames);
    }
    const std::map<int, BagBody>& robots = bodies.robots();
    for (auto robot = robots.rbegin(); robot != robots.rend(); ++robot) {  // ids -1, -2 …
      add(robot->second, header, true, frames);
    }
    std::string rows = sim2d::headerLine(sim2d::kTrajectoryColumns);
    for (const auto& [step, frame] : frames) {
      sim2d::appendTrajectoryRows(rows, frame);
    }
    return rows;
  }

  Bag& bag_;
  const std::string& path_;
};

/// Whether the bag is used unmodified: no options for topics, robots or time step.
bool isUnmodified(Bag& bag, const BagTopicOptions& use, const sim2d::TrackOptions& options) {
  const bool isChosen = !use.people.empty() || !use.robot.empty() || !use.map.empty() ||
                        options.robotId || !options.robotName.empty() || options.robotGoal ||
                        options.step > 0.0;
  return !isChosen && !bag.metadata(kRunMetadata, "trace.json").empty() &&
         hunavsimTopics(bag.channels()).people;
}

}  // namespace

base::Result<sim2d::Trace> readBagTrace(const std::string& path, const BagTopicOptions& use,
                                        const sim2d::TrackOptions& options,
                                        sim2d::RecordedPoints* points) {
  base::Result<std::unique_ptr<Bag>> bag = openBag(path);
  base::Diagnostics problems = bag.diagnostics();
  if (!bag) {
    return problems;
  }
  if (isUnmodified(**bag, use, options)) {
    base::Result<sim2d::Trace> own = HunavsimTrace(**bag, path).make();
    if (own) {
      base::append(problems, own.diagnostics());
      return {*std::move(own), std::move(problems)};
    }
    problems.push_back(
        base::warning("bag.not-as-written", {own.diagnostics().front().message}, path));
  }
  base::Result<sim2d::Trace> trace = readThirdPartyBag(**bag, path, use, options, points);
  base::append(problems, trace.diagnostics());
  return trace ? base::Result<sim2d::Trace>(*std::move(trace), std::move(problems))
               : base::Result<sim2d::Trace>(std::move(problems));
}

}  // namespace bridge
