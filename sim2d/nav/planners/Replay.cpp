#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/CommandFile.h"
#include "sim2d/nav/Planner.h"

namespace sim2d {
namespace {

struct ReplayParameters {
  double robot = -1.0;
};

base::ParameterTable<ReplayParameters> replayTable() {
  base::ParameterTable<ReplayParameters> table;
  table.addCount(&ReplayParameters::robot, "robot", {-1e6, 1e6},
                 "Whose velocities are taken from a trajectory.csv: its id.");
  return table;
}

std::vector<base::ParameterSpec> replaySpecs() {
  base::ParameterSpec file;
  file.key = "file";
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help =
      "CSV with time,linear,angular and perhaps lateral, or the trajectory.csv of a run; relative "
      "to "
      "the scenario.";
  std::vector<base::ParameterSpec> specs{file};
  for (const base::ParameterSpec& spec : replayTable().specs()) {
    specs.push_back(spec);
  }
  return specs;
}

/// Drives recorded velocities again, whatever is in the way.
class Replay : public Planner {
 public:
  explicit Replay(CommandRecord record) : record_(std::move(record)) {}

  bool readsScan() const override { return false; }
  base::Result<BodyTwist> command(const Observation& observation) override {
    return record_.at(observation.time);
  }
  bool needsGoal() const override { return false; }

 private:
  CommandRecord record_;
};

base::Result<std::shared_ptr<Planner>> makeReplay(const PlannerSetup& setup) {
  ReplayParameters parameters;
  replayTable().set(parameters, setup.parameters);
  const std::string path = fileOf(setup, "file");
  if (path.empty()) {
    return base::within("robot '" + setup.robot + "'", base::error("replay.no-file"));
  }
  base::Result<CommandRecord> record = readCommands(path, static_cast<int>(parameters.robot));
  if (!record) {
    return record.diagnostics();
  }
  return std::shared_ptr<Planner>(std::make_shared<Replay>(*std::move(record)));
}

}  // namespace

void addReplay(PlannerRegistry& to);
void addReplay(PlannerRegistry& to) {
  to.add("replay", replaySpecs(), makeReplay,
         "Drives recorded velocities again, whatever is in the way.");
}

}  // namespace sim2d
