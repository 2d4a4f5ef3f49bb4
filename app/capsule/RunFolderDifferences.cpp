#include <algorithm>
#include <filesystem>
#include <set>

#include "app/capsule/Rerun.h"
#include "app/capsule/TableDifferences.h"
#include "app/capsule/Unpacked.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

bool isOfMetrics(const std::string& name) {
  return base::startsWith(name, "metrics") || base::startsWith(name, "steps");
}

/// Tables and headers of a run, without files of other programs.
void addRunFileNames(const std::string& folder, bool withMetrics, std::set<std::string>& names) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool isTable = base::endsWith(name, ".csv") || base::endsWith(name, ".json");
    const bool isCompared = name != "counterfactual.csv" && name.front() != '.';
    if (entry.is_regular_file(ignored) && isTable && isCompared &&
        (withMetrics || !isOfMetrics(name))) {
      names.insert(name);
    }
  }
}

/// Without times of the clock, and without paths, which differ.
const std::vector<std::string>& comparedManifestKeys() {
  static const std::vector<std::string> kKeys = {"status",       "reason", "seed",
                                                 "dt",           "model",  "compat",
                                                 "record_every", "steps",  "simulated_seconds",
                                                 "humans",       "robots"};
  return kKeys;
}

}  // namespace

base::Diagnostics runFolderDifferences(const UnpackedCapsule& capsule, const std::string& place,
                                       const std::string& repeated, bool withMetrics) {
  const std::string stored = app::pathIn(capsule.root, place);
  std::set<std::string> names;
  addRunFileNames(stored, withMetrics, names);
  addRunFileNames(repeated, withMetrics, names);
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const std::string member = base::join({capsule.file, "/", place, name}, "");
    const base::Result<std::string> was =
        base::readTextFile(app::pathIn(stored, name), base::kMaxRecord);
    const base::Result<std::string> is =
        base::readTextFile(app::pathIn(repeated, name), base::kMaxRecord);
    if (!was || !is) {
      problems.push_back(base::error(was ? "capsule.not-written" : "capsule.missing", {}, member));
    } else if (name == app::Manifest::kName) {
      const std::string text = withRecordedPaths(*is, capsule.manifest, capsule.root);
      base::append(problems, jsonDifferences(*was, text, member, comparedManifestKeys()));
    } else if (base::endsWith(name, ".json")) {
      base::append(problems, jsonDifferences(*was, *is, member));
    } else {
      base::append(problems, firstCsvDifference(*was, *is, member));
    }
  }
  return problems;
}

}  // namespace capsule
