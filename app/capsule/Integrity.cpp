#include "app/capsule/Integrity.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/capsule/Unpacked.h"
#include "app/run/BatchFolder.h"
#include "app/run/Experiment.h"
#include "app/run/OutputFolder.h"
#include "app/run/ResultStore.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;

std::string placeOf(const std::string& file, const std::string& member) {
  return file + "/" + member;
}

/// Files in a folder of the unpacked study that do not match its manifest. `below`: "study/".
base::Diagnostics listedDifferences(const std::string& root, const std::string& below,
                                    const char* manifestName, const std::string& file) {
  const std::string folder = app::pathIn(root, below);
  const base::Result<app::Manifest> manifest = app::readManifest(folder, manifestName);
  if (!manifest) {
    return manifest.diagnostics();
  }
  base::Diagnostics problems;
  for (const auto& [name, hash] : manifest->outputs) {
    if (!manifest->matches(folder, name)) {
      problems.push_back(
          base::error("capsule.checksum", {below + manifestName}, placeOf(file, below + name)));
    }
  }
  return problems;
}

/// Inputs that the results name, and those that the capsule names.
base::Diagnostics inputListDifferences(const CapsuleManifest& manifest, const app::Study& study,
                                       const std::string& file) {
  base::Diagnostics problems;
  const std::string place = placeOf(file, kManifestMember);
  for (const app::InputHash& input : study.inputs) {
    const bool isListed = std::any_of(
        manifest.inputs.begin(), manifest.inputs.end(), [&input](const CapsuleInput& each) {
          return each.path == input.path && each.sha256 == input.sha256;
        });
    if (!isListed) {
      problems.push_back(base::error("capsule.input-not-listed", {input.path}, place));
    }
  }
  return problems;
}

/// What the experiment says of a run, by column.
ResultTable::Row plannedRow(const app::Experiment& experiment, std::size_t index) {
  const app::Experiment::Run run = experiment.run(index);
  ResultTable::Row row;
  row.fields = {{"run", std::to_string(index)},
                {"scenario", experiment.scenarios[run.scenario]},
                {"seed", std::to_string(run.seed)}};
  for (std::size_t k = 0; k < run.values.size(); ++k) {
    row.fields[experiment.values[k].path] = run.values[k];
  }
  return row;
}

/// Differences in the part of results.csv that the experiment determines.
base::Diagnostics planDifferences(const app::Experiment& experiment, const app::Shard& shard,
                                  const ResultTable& table, const std::string& place) {
  base::Diagnostics problems;
  ResultTable plan;
  for (const auto& [run, row] : table.rows) {
    const bool isPlanned = run >= 0 && static_cast<std::size_t>(run) < experiment.runCount() &&
                           shard.contains(static_cast<std::size_t>(run));
    if (!isPlanned) {
      problems.push_back(base::error("capsule.row-not-planned", {run}, place, row.line));
      continue;
    }
    ResultTable::Row expected = plannedRow(experiment, static_cast<std::size_t>(run));
    for (const auto& [column, field] : row.fields) {
      expected.fields.emplace(column, field);  // what the plan leaves open
    }
    plan.rows.emplace(run, std::move(expected));
  }
  for (const app::ExperimentValue& value : experiment.values) {
    plan.columns.push_back(value.path);
  }
  base::append(problems, rowDifferences(table, plan, "capsule.plan-differs", place));
  return problems;
}

/// The table that results.sqlite contains; errors that make it unreadable.
base::Result<ResultTable> tableOfStore(const app::ResultStore& store, const std::string& place) {
  const base::Result<TemporaryFolder> folder = TemporaryFolder::create();
  if (!folder) {
    return folder.diagnostics();
  }
  const std::string path = app::pathIn(folder->path(), "results.csv");
  const base::Diagnostics unwritten = app::writeResults(store, path);
  const base::Result<std::string> text = base::readTextFile(path);
  if (!unwritten.empty() || !text) {
    return unwritten.empty() ? text.diagnostics() : unwritten;
  }
  return readResultTable(*text, place);
}

/// The manifest of the batch, against what its results give.
base::Diagnostics batchManifestDifferences(const app::ResultStore& store, const std::string& root,
                                           const std::string& file) {
  const std::string member = std::string(kStudyFolder) + app::Manifest::kName;
  const base::Result<std::string> expected = app::batchManifest(store);
  const base::Result<std::string> stored = base::readTextFile(app::pathIn(root, member));
  if (!expected || !stored) {
    return {base::error("capsule.missing", {}, placeOf(file, member))};
  }
  const std::vector<std::string> keys = {"program",  "inputs", "code",       "status", "runs",
                                         "finished", "failed", "time_limit", "shard",  "drawn"};
  base::Diagnostics problems = jsonDifferences(*stored, *expected, placeOf(file, member), keys);
  for (base::Diagnostic& problem : problems) {
    if (problem.code == "capsule.field-differs") {
      problem = base::error("capsule.manifest-differs",
                            {problem.value("key"), problem.value("stored"), problem.value("found")},
                            problem.file);
    }
  }
  return problems;
}

}  // namespace

base::Diagnostics memberDifferences(const CapsuleManifest& manifest, const std::string& sums,
                                    const app::FileHashes& members, const std::string& file) {
  const app::FileHashes listed = parseSums(sums);
  std::set<std::string> names;
  for (const app::FileHashes* const list : {&manifest.members, &listed, &members}) {
    for (const auto& [name, hash] : *list) {
      names.insert(name);
    }
  }
  names.erase(kSumsMember);
  const auto hashIn = [](const app::FileHashes& list, const std::string& name) {
    const auto found = list.find(name);
    return found == list.end() ? std::string() : found->second;
  };
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const std::string place = placeOf(file, name);
    const std::string actual = hashIn(members, name);
    const bool isManifest = name == kManifestMember;
    const std::string ofManifest = isManifest ? actual : hashIn(manifest.members, name);
    const std::string ofSums = hashIn(listed, name);
    if (actual.empty()) {
      problems.push_back(base::error("capsule.missing", {}, place));
    } else if (ofManifest.empty()) {
      problems.push_back(base::error("capsule.extra", {}, place));
    } else if (ofManifest != actual) {
      problems.push_back(base::error("capsule.checksum", {kManifestMember}, place));
    } else if (ofSums != actual) {
      problems.push_back(base::error("capsule.checksum", {kSumsMember}, place));
    }
  }
  return problems;
}

base::Diagnostics recordDifferences(const CapsuleManifest& manifest, const std::string& root,
                                    const std::string& file) {
  base::Diagnostics problems;
  for (const CapsuleInput& input : manifest.inputs) {
    if (!input.member.empty() &&
        app::sha256OfFile(pathOfInput(input, root)).value_or("") != input.sha256) {
      problems.push_back(
          base::error("capsule.other-input", {input.path}, placeOf(file, input.member)));
    }
  }
  for (const char* name : {app::Manifest::kName, app::Manifest::kHiddenName}) {
    base::append(problems, listedDifferences(root, kStudyFolder, name, file));
  }
  const std::string runs = app::pathIn(root, std::string(kStudyFolder) + "runs");
  std::error_code ignored;
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(runs, ignored)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) {
    base::append(problems, listedDifferences(root, std::string(kStudyFolder) + "runs/" + name + "/",
                                             app::Manifest::kName, file));
  }
  return problems;
}

base::Diagnostics resultDifferences(const CapsuleManifest& manifest, const ResultTable& table,
                                    const std::string& root, const std::string& file) {
  const std::string place = placeOf(file, std::string(kStudyFolder) + "results.csv");
  const base::Result<std::unique_ptr<app::ResultStore>> store =
      app::ResultStore::open(app::pathIn(root, std::string(kStudyFolder) + "results.sqlite"));
  if (!store) {
    return atMembers(store.diagnostics(), root, file);
  }
  base::Diagnostics problems = inputListDifferences(manifest, (*store)->study(), file);
  base::append(problems, batchManifestDifferences(**store, root, file));
  const base::Result<ResultTable> copy = tableOfStore(**store, place);
  if (copy) {
    base::append(problems, rowDifferences(table, *copy, "capsule.copies-differ", place));
  } else {
    base::append(problems, copy.diagnostics());
  }
  for (const auto& [run, row] : table.rows) {
    if (copy && copy->rows.count(run) == 0) {
      problems.push_back(base::error("capsule.row-not-planned", {run}, place, row.line));
    }
  }
  const base::Result<app::Experiment> experiment =
      app::readExperiment(pathOfInput(manifest.inputs.front(), root));
  if (experiment) {
    base::append(problems, planDifferences(*experiment, (*store)->study().shard, table, place));
  } else {
    base::append(problems, atMembers(experiment.diagnostics(), root, file));
  }
  return problems;
}

}  // namespace capsule
