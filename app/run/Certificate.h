#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/ExpectationMonitor.h"
#include "app/run/ManifestFiles.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/MapReader.h"

namespace app {

/// The runs that certify scenarios.
struct CertificationPlan {
  std::vector<long long> seeds;       // of the runs with planners
  std::vector<std::string> planners;  // compared with each other
  int jobs = 1;                       // number of parallel processes
  sim2d::ImageLoader loader;          // for map images other than PGM
  std::function<bool()> wantsStop;
  std::function<void(std::size_t finished, std::size_t total)> showProgress;
};

/// The planner that avoids nothing. It must fail in one of the seeds of a scenario, or be worse
/// than one of the planners in a metric of the card.
constexpr char kBaselinePlanner[] = "straight";

/// Family of scenarios in which a planner fails (`search`). They need not be solvable by others, so
/// they are not certified together with the shipped ones.
constexpr char kFailureFamily[] = "Failures";

/// What one planner achieves in one metric.
struct CertifiedArm {
  std::string planner;
  int runs = 0;  // with a defined value
  double mean = statistics::kUndefined;
  statistics::Interval interval;  // 95 %: Student's, for rates Wilson's
};

/// A metric of the card, and the two planners with the widest gap between disjoint intervals.
struct CertifiedMetric {
  std::string key;
  std::vector<CertifiedArm> arms;
  CertifiedArm baseline;
  std::optional<std::pair<std::string, std::string>> separated;  // lower mean first
};

/// What runs prove about a scenario; stored beside it as `<name>.certificate.json`.
struct Certificate {
  std::string scenario;           // name
  std::vector<InputHash> inputs;  // file names without folders, checksums
  std::vector<long long> seeds;
  std::vector<std::string> problems;                   // reasons why it is not certified
  std::vector<ExpectationOutcome> expectations;        // held in all seeds that were tried
  std::vector<std::pair<std::string, int>> successes;  // per planner, the baseline last
  std::vector<CertifiedMetric> metrics;                // in the order of the card
  bool isCertified() const { return problems.empty(); }
  /// Whether the first metric of the card separates two planners.
  bool separates() const { return !metrics.empty() && metrics.front().separated.has_value(); }
};

/// Path of the certificate of a scenario file.
std::string certificatePath(const std::string& scenarioPath);

/// Certifies scenario files by runs. Error: a stop was requested, or processes cannot be started.
base::Result<std::vector<Certificate>> certify(const std::vector<std::string>& scenarioPaths,
                                               const CertificationPlan& plan);

/// The file content, with the version of this program.
std::string certificateText(const Certificate& certificate);

/// Differences between a stored certificate and a repeated one; empty: none. The version of the
/// program does not count.
base::Result<std::vector<std::string>> certificateDifferences(const std::string& storedText,
                                                              const Certificate& repeated,
                                                              const std::string& path);

/// Seeds and planners of a stored certificate, to repeat it.
base::Result<CertificationPlan> planOfCertificate(const std::string& text, const std::string& path);

}  // namespace app
