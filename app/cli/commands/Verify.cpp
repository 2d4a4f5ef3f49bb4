#include "app/capsule/Verify.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <random>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/Batch.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

using VerifyJson = nlohmann::ordered_json;

struct VerifyCommandOptions {
  std::string file;
  std::string sample = "5%";
  std::optional<std::size_t> runs;
  std::optional<std::uint64_t> seed;
  int jobs = processorCount();
  bool allowCode = false;
};

/// "5%": the share 0.05; nullopt: invalid text.
std::optional<double> shareOf(const std::string& text) {
  const bool hasUnit = base::endsWith(text, "%");
  const std::optional<double> percent =
      base::parseDouble(base::trimmed(hasUnit ? text.substr(0, text.size() - 1) : text));
  return hasUnit && percent && *percent > 0.0 && *percent <= 100.0 ? std::optional(*percent / 100.0)
                                                                   : std::nullopt;
}

std::string sampleProblem(const std::string& text) {
  return shareOf(text) ? std::string() : "expected a share such as 5%, not '" + text + "'";
}

std::string runsText(const std::vector<std::size_t>& runs) {
  constexpr std::size_t kMaxShown = 20;
  std::vector<std::string> words;
  for (const std::size_t run : runs) {
    if (words.size() == kMaxShown) {
      words.emplace_back("…");
      break;
    }
    words.push_back(std::to_string(run));
  }
  return base::join(words, ", ");
}

VerifyJson differencesJson(const base::Diagnostics& differences) {
  VerifyJson all = VerifyJson::array();
  for (const base::Diagnostic& each : differences) {
    VerifyJson json = {{"file", each.file},
                       {"line", each.line > 0 ? VerifyJson(each.line) : VerifyJson()},
                       {"code", each.code},
                       {"message", each.message}};
    for (const auto& [name, value] : each.values) {
      json["values"][std::string(name)] = value;
    }
    all.push_back(json);
  }
  return all;
}

void printVerification(const capsule::Verification& found, const VerifyCommandOptions& options,
                       std::uint64_t seed, const Invocation& given) {
  if (given.json) {
    const VerifyJson json = {{"capsule", options.file},
                             {"identity", found.identity},
                             {"study", found.isBatch ? "batch" : "run"},
                             {"version", found.version},
                             {"commit", found.commit},
                             {"files", found.members},
                             {"runs", found.runs},
                             {"seed", seed},
                             {"sample", found.sample},
                             {"repeated", found.repeated},
                             {"equal", found.isEqual()},
                             {"differences", differencesJson(found.differences)}};
    print(base::jsonText(json) + "\n");
    return;
  }
  printDiagnostics(found.differences);
  if (given.quiet) {
    return;
  }
  printLine(
      std::string(found.isBatch ? "batch of " + std::to_string(found.runs) + " runs" : "run") +
      " by hunavsim " + found.version + " " + found.commit + ", " + std::to_string(found.members) +
      " files");
  printLine("identity " + found.identity);
  if (found.isBatch && !found.sample.empty()) {
    printLine("repeated " + std::to_string(found.repeated.size()) + " of " +
              std::to_string(found.runs) + " runs (--seed " + std::to_string(seed) +
              "): " + runsText(found.repeated));
  }
  const std::size_t count = found.differences.size();
  printLine(found.isEqual() ? "equal"
            : count == 1    ? "1 difference"
            : count > 1     ? std::to_string(count) + " differences"
                            : "interrupted: no difference so far");
}

int verifyCommand(const VerifyCommandOptions& options, const Invocation& given) {
  capsule::VerifyOptions verify;
  verify.file = options.file;
  verify.share = *shareOf(options.sample);
  verify.runs = options.runs;
  verify.seed = options.seed ? *options.seed : std::random_device()();
  verify.jobs = options.jobs;
  verify.allowCode = options.allowCode;
  verify.loader = loadMapImage;
  verify.stop = interruptStop();
  catchInterrupts();
  Progress progress(given.quiet || given.json);
  progress.show("reading " + options.file);
  const auto start = std::chrono::steady_clock::now();
  verify.showProgress = [&](std::size_t finished, std::size_t total) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const double left =
        elapsed.count() / static_cast<double>(finished) * static_cast<double>(total - finished);
    progress.show(std::to_string(finished) + " / " + std::to_string(total) + " runs repeated, " +
                  durationText(left) + " left");
  };
  const base::Result<capsule::Verification> found = capsule::verify(verify);
  requireFine(found.diagnostics());
  if (!given.json) {
    printDiagnostics(found->warnings);
  }
  printVerification(*found, options, verify.seed, given);
  return found->isEqual() ? ExitFine : ExitRunFailed;
}

}  // namespace

void addVerify(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "verify", "Check a packed study: compare checksums and repeat a sample of its runs",
      verifyCommand);
  command.add_option("capsule", options.file, "File written by pack")->required();
  CLI::Option* const sample =
      command
          .add_option("--sample", options.sample,
                      "Share of the runs to repeat, at least one (default: 5%)")
          ->check(sampleProblem);
  command
      .add_option("--runs", options.runs, "Number of runs to repeat; 0 = compare checksums only")
      ->check(CLI::NonNegativeNumber)
      ->excludes(sample);
  command.add_option("--seed", options.seed,
                     "Seed for the selection of runs (default: a random seed, which is printed)");
  addJobs(command, options.jobs);
  addAllowCode(command, options.allowCode);
  commands.addExamples(
      command,
      {{"hunavsim verify run.hnv", "Compare a packed run with its repetition"},
       {"hunavsim verify study.hnv --sample 5%", "Audit a packed study", "a capsule"},
       {"hunavsim verify study.hnv --runs 0", "Compare checksums and tables only", "a capsule"}});
}

}  // namespace app
