#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"

namespace app {

/// "RUN@12.5": the folder of a run and a time in it.
struct RunMoment {
  std::string folder;
  double time = 0.0;  // [s]
};
std::optional<RunMoment> runMomentOf(const std::string& text);

/// From this step on a run continues with changed options: those of RunOption::AtBranch. Its seed
/// is that of all random numbers drawn from there on; people keep what was drawn for them at the
/// start. `moves` are inputs of the first step of the branch.
struct RunBranch {
  std::int64_t step = 0;  // of the last state in common
  RunSpec changes;
};

/// The branches up to a step.
std::vector<RunBranch> branchesUntil(std::vector<RunBranch> branches, std::int64_t step);

/// Errors of options that do not fit a run that continues another one (exit code 64).
base::Diagnostics checkBranchOptions(const RunSpec& spec);

/// The run with changed options. Invalid options are in `wrongOptions` of the result. Errors:
/// values that cannot change while a run continues.
base::Result<Bundle> continueWith(const Bundle& was, const RunSpec& changes);
/// With the changes of all branches in order. Errors: invalid options too.
base::Result<Bundle> continueWith(const Bundle& was, const std::vector<RunBranch>& branches);

/// The inputs that place people elsewhere. Errors, in the name of `file`: a text that describes no
/// move, an unknown name.
base::Result<sim2d::StepInputs> inputsOfMoves(const std::vector<std::string>& moves,
                                              const sim2d::TraceHeader& header,
                                              const std::string& file = {});

/// The changes as text: "robot1.planner = dwa, seed 7"; empty: none.
std::string changesText(const RunSpec& changes);

/// The world of a run with branches: it is stepped from its beginning and continues as the branches
/// specify, each from its step on. One thread.
class BranchedRun {
 public:
  /// `branches` by rising step.
  BranchedRun(Bundle bundle, const std::vector<RunBranch>& branches);

  /// Result of checking the last branch, with the world to run; without a world there are errors:
  /// those of the first branch that has any.
  Verdict& verdict() { return verdict_; }
  const Bundle& bundle() const { return bundle_; }              // of the last branch
  const sim2d::TraceHeader& header() const { return header_; }  // of the last branch
  std::uint64_t seed() const { return seed_; }                  // of the last branch
  /// To be called with each state before the next step, in rising order.
  void apply(const sim2d::Frame& frame, sim2d::World& world);

 private:
  struct Change {
    std::int64_t step = 0;
    std::unique_ptr<sim2d::World> next;
    std::uint64_t seed = 1;  // of random numbers from there on
  };
  bool checkLast();

  Bundle bundle_;
  Verdict verdict_;
  sim2d::TraceHeader header_;
  std::uint64_t seed_ = 1;
  std::vector<Change> changes_;  // by step
};

}  // namespace app
