#include "app/run/BundleReader.h"

#include <utility>

#include "app/run/ExperimentRunner.h"
#include "app/run/MetricsSetup.h"
#include "app/run/PlannerFiles.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "app/run/TreeCoverage.h"

namespace app {

/// Cached files may be outdated: if a file was modified since it was hashed, everything is read
/// again.
Bundle BundleReader::read(const RunSpec& spec, const RunSettings& settings, FileIndices& used) {
  constexpr int kMaxReads = 5;
  for (int reads = 1;; ++reads) {
    const InputFingerprints::Time before = InputFingerprints::now();
    Bundle bundle = readBundle(spec, settings, *files_);
    used = filesOf(bundle);
    if (reads == kMaxReads || !fingerprints_.anyModifiedSince(used, before)) {
      return bundle;
    }
    files_ = std::make_unique<FileCache>(loader_);
  }
}

const BundleReader::FileIndices& BundleReader::filesOf(const Bundle& bundle) {
  constexpr std::size_t kMaxKnownBundles = 10000;
  std::vector<std::string> names = bundle.inputs;  // includes trees, but not their includes
  for (const ExternalCode& code : externalCodeOf(*bundle.scenario)) {
    names.push_back(code.words);
  }
  const auto found = inputsByBundle_.find(names);
  if (found != inputsByBundle_.end()) {
    return found->second;
  }
  if (inputsByBundle_.size() >= kMaxKnownBundles) {
    inputsByBundle_.clear();
  }
  FileIndices& used = inputsByBundle_[names];
  for (const std::string& path : inputFilesOf(bundle)) {
    used.push_back(fingerprints_.add(path));
  }
  return used;
}

ResultRow measureRun(const Bundle& bundle, bool keepsTrees) {
  Verdict verdict = check(bundle);
  if (!verdict.ok()) {
    base::Diagnostics all = verdict.wrongOptions;
    base::append(all, verdict.problems);
    return rowOf(all);
  }
  sim2d::World& world = *verdict.world;
  skipUnwrittenMetrics(false, false, verdict.metrics.selection);
  RunWriter writer({}, world, world.header(), verdict.metrics.selection, verdict.metrics.parameters,
                   bundle.routes);
  Session session(sim2d::stopRuleOf(*bundle.scenario));
  ResultRow row = rowOf(simulate(
      session, world, verdict.scenarioMetrics, writer, [](const sim2d::Frame&) { return false; },
      PlanningClock::Off));
  if (keepsTrees) {
    row.trees = treeRowsOf(world.treeResults());
  }
  return row;
}

}  // namespace app
