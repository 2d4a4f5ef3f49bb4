#include "app/cli/CertifyCommand.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/Console.h"
#include "app/run/Certificate.h"
#include "app/run/DataPaths.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

constexpr int kMostSeeds = 1000;
constexpr int kLargestSeed = 1'000'000'000;

const std::vector<std::string>& usualPlanners() {
  static const std::vector<std::string> kPlanners = {"pursuit", "orca", "social_force"};
  return kPlanners;
}

/// Paths of the scenarios: those given, or all shipped ones that have a card with metrics, except
/// failures.
std::vector<std::string> scenarioPaths(const std::vector<std::string>& files, bool all) {
  const base::Result<std::vector<std::string>> given = scenarioFiles(files);
  requireFine(given.diagnostics());
  std::vector<std::string> paths = *given;
  if (all) {
    for (const ShippedScenario& shipped : shippedScenarios()) {
      const base::Result<std::string> text = base::readTextFile(shipped.path);
      const sim2d::ScenarioCard card = text ? sim2d::cardOf(*text) : sim2d::ScenarioCard();
      if (!card.metrics.empty() && card.family != kFailureFamily) {
        paths.push_back(shipped.path);
      }
    }
  }
  return paths;
}

CertificationPlan planOf(const CertifyOptions& options) {
  CertificationPlan plan;
  for (int k = 0; k < options.seeds; ++k) {
    plan.seeds.push_back(options.firstSeed + k);
  }
  plan.planners = options.planners.empty() ? usualPlanners() : options.planners;
  return plan;
}

void complete(CertificationPlan& plan, const CertifyOptions& options, Progress& progress) {
  plan.jobs = options.jobs;
  plan.loader = loadMapImage;
  plan.wantsStop = wasInterrupted;
  plan.showProgress = [&progress](std::size_t finished, std::size_t total) {
    progress.show(std::to_string(finished) + " / " + std::to_string(total) + " runs");
  };
}

std::string separationText(const Certificate& certificate) {
  if (!certificate.separates()) {
    return "separates no planners";
  }
  const CertifiedMetric& metric = certificate.metrics.front();
  return "separates " + metric.separated->first + " and " + metric.separated->second + " by " +
         metric.key;
}

void show(const Certificate& certificate) {
  printLine(certificate.scenario + ": " +
            (certificate.isCertified() ? "certified, " : "not certified, ") +
            separationText(certificate));
  for (const std::string& problem : certificate.problems) {
    printLine("  " + problem);
  }
}

std::string summary(const std::vector<Certificate>& certificates, std::size_t runs) {
  const auto certified = std::count_if(certificates.begin(), certificates.end(),
                                       [](const auto& each) { return each.isCertified(); });
  const auto separating = std::count_if(certificates.begin(), certificates.end(),
                                        [](const auto& each) { return each.separates(); });
  return std::to_string(certified) + " of " + std::to_string(certificates.size()) +
         " scenarios certified, " + std::to_string(separating) + " separate planners (" +
         std::to_string(runs) + " runs with robots)";
}

int certifyAll(const std::vector<std::string>& paths, const CertifyOptions& options,
               const Invocation& given) {
  Progress progress(given.quiet);
  CertificationPlan plan = planOf(options);
  complete(plan, options, progress);
  const base::Result<std::vector<Certificate>> certificates = certify(paths, plan);
  requireFine(certificates.diagnostics());
  bool areAllFine = true;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const Certificate& certificate = (*certificates)[k];
    requireFine(base::writeFileAtomically(certificatePath(paths[k]), certificateText(certificate)));
    areAllFine = areAllFine && certificate.isCertified();
    if (!given.quiet) {
      show(certificate);
    }
  }
  const std::size_t runs = paths.size() * plan.seeds.size() * (plan.planners.size() + 1);
  printLine(summary(*certificates, runs));
  return areAllFine ? ExitFine : ExitRunFailed;
}

/// Whether a repetition gives the stored certificate.
bool verifyOne(const std::string& path, const CertifyOptions& options, const Invocation& given) {
  const std::string file = certificatePath(path);
  const base::Result<std::string> text = base::readTextFile(file);
  requireFine(text.diagnostics());
  base::Result<CertificationPlan> plan = planOfCertificate(*text, file);
  requireFine(plan.diagnostics());
  Progress progress(given.quiet);
  complete(*plan, options, progress);
  const base::Result<std::vector<Certificate>> repeated = certify({path}, *plan);
  requireFine(repeated.diagnostics());
  const base::Result<std::vector<std::string>> differences =
      certificateDifferences(*text, repeated->front(), file);
  requireFine(differences.diagnostics());
  if (!differences->empty()) {
    printDiagnostics({base::error("certificate.differs", {base::join(*differences, ", ")}, file)});
  }
  return differences->empty();
}

}  // namespace

void addCertifyOptions(CLI::App& command, CertifyOptions& options) {
  CLI::Option* const certify = command.add_flag(
      "--certify", options.certify,
      "Test by simulation that scenarios are solvable, not trivial and match their cards; write "
      "<scenario>.certificate.json");
  CLI::Option* const verify =
      command.add_flag("--verify", options.verify,
                       "Repeat the runs of existing certificates and compare the results");
  verify->excludes(certify);
  command.add_flag(
      "--all", options.all,
      "With --certify or --verify: all shipped scenarios with a card, except failures");
  command
      .add_option("--jobs", options.jobs,
                  "With --certify or --verify: number of parallel processes (default: number "
                  "of cores)")
      ->check(CLI::Range(1, 1024));
  command.add_option("--seeds", options.seeds, "With --certify: number of seeds (default: 10)")
      ->check(CLI::Range(2, kMostSeeds));
  command
      .add_option("--first-seed", options.firstSeed, "With --certify: first seed (default: 1001)")
      ->check(CLI::Range(0, kLargestSeed));
  command
      .add_option("--planners", options.planners,
                  "With --certify: planners to compare (default: " +
                      base::join(usualPlanners(), ", ") + ")")
      ->delimiter(',')
      ->check(oneOf(knownPlanners()));
}

int certifyCommand(const std::vector<std::string>& files, const CertifyOptions& options,
                   const Invocation& given) {
  const std::vector<std::string> paths = scenarioPaths(files, options.all);
  catchInterrupts();
  if (options.certify) {
    return certifyAll(paths, options, given);
  }
  std::size_t same = 0;
  for (const std::string& path : paths) {
    same += verifyOne(path, options, given) ? 1 : 0;
  }
  printLine(std::to_string(same) + " of " + std::to_string(paths.size()) +
            " certificates confirmed");
  return same == paths.size() ? ExitFine : ExitRunFailed;
}

}  // namespace app
