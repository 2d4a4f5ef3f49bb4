#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/VelocityRecording.h"

namespace sim2d {
namespace {

struct ReplayParameters {
  double robot = -1.0;
};

base::ParameterTable<ReplayParameters> replayTable() {
  base::ParameterTable<ReplayParameters> table;
  table.addCount(&ReplayParameters::robot, "robot", {-1e6, 1e6},
                 "Id of the robot whose velocities are read from a trajectory.csv.");
  return table;
}

std::vector<base::ParameterSpec> replaySpecs() {
  base::ParameterSpec file;
  file.key = "file";
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help =
      "CSV with time,linear,angular and optionally lateral, or the trajectory.csv of a run; "
      "relative to the scenario.";
  std::vector<base::ParameterSpec> specs{file};
  for (const base::ParameterSpec& spec : replayTable().specs()) {
    specs.push_back(spec);
  }
  return specs;
}

/// Drives recorded velocities without regard to obstacles.
class Replay : public Planner {
 public:
  explicit Replay(VelocityRecording record) : record_(std::move(record)) {}

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    return record_.at(observation.time);
  }
  bool needsGoal() const override { return false; }

 private:
  VelocityRecording record_;
};

base::Result<std::shared_ptr<Planner>> makeReplay(const PlannerSetup& setup) {
  ReplayParameters parameters;
  replayTable().set(parameters, setup.parameters);
  const std::string path = fileParameter(setup, "file");
  if (path.empty()) {
    return base::withContext("robot '" + setup.robot + "'", base::error("replay.no-file"));
  }
  base::Result<VelocityRecording> record = readVelocities(path, static_cast<int>(parameters.robot));
  if (!record) {
    return record.diagnostics();
  }
  return std::shared_ptr<Planner>(std::make_shared<Replay>(*std::move(record)));
}

}  // namespace

void addReplay(PlannerRegistry& to);
void addReplay(PlannerRegistry& to) {
  to.add("replay", replaySpecs(), makeReplay, "Replays recorded velocities and ignores obstacles.");
}

}  // namespace sim2d
