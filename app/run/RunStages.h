#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/RunOptions.h"
#include "sim2d/base/Types.h"

namespace app {

/// "RUN@12.5": the folder of a run and a time in it.
struct RunMoment {
  std::string folder;
  double time = 0.0;  // [s]
};
std::optional<RunMoment> runMomentOf(const std::string& word);

/// "anna 2.5 1 0": somebody is put somewhere else.
struct PersonMove {
  std::string name;
  base::Pose2 pose;
};
std::optional<PersonMove> personMoveOf(const std::string& word);

/// What is wrong with the words of options that go on from a run (exit code 64).
base::Diagnostics checkFromWords(const RunOptions& options);

/// Reads the words of a command line behind the program's name, as the command `run` does.
using RunWordsReader = std::function<base::Result<RunOptions>(const std::vector<std::string>&)>;

/// A part of a run between two changes on the way.
struct RunStage {
  RunOptions options;                 // all that counts in it; the seed is that of the people
  std::string folder;                 // of the run that was made so; empty: not made yet
  std::optional<RunMoment> moment;    // where it begins; none: with the run
  std::optional<long long> drawSeed;  // of what is drawn from there on, where it is another
  std::vector<std::string> inputs;    // SHA-256 of the files it was made of; empty: not made yet
  std::string version;                // of the program that made it
};

/// The stages of the run that `options.from` names, and the one that goes on from there. Errors: a
/// folder that does not tell how it was made.
base::Result<std::vector<RunStage>> stagesOf(const RunOptions& options,
                                             const RunWordsReader& readWords);

/// Whether the scenarios differ only in what can change while a run goes on.
bool canGoOnAs(const sim2d::Scenario& was, const sim2d::Scenario& is);

}  // namespace app
