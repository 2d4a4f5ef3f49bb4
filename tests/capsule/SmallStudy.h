#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "app/capsule/Archive.h"
#include "app/capsule/CapsuleManifest.h"
#include "app/capsule/Pack.h"
#include "app/capsule/Verify.h"
#include "app/run/Batch.h"
#include "app/run/BatchFolder.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "sim2d/base/Text.h"
#include "tests/app/StudyFiles.h"

/// A small study with a map, a tree and kept run folders, packed; and its altered copies.
namespace small {

inline QString textOf(const std::string& text) {
  return QString::fromStdString(text);
}

/// Executes an experiment into a folder, in this process and its workers.
inline base::Diagnostics runStudy(const QString& file, const QString& folder) {
  const base::Result<app::Experiment> experiment = app::readExperiment(file.toStdString());
  if (!experiment) {
    return experiment.diagnostics();
  }
  app::ExperimentRunner runner(*experiment, folder.toStdString() + "/runs", {});
  base::Diagnostics problems = runner.check();
  const base::Result<app::Study> study = app::studyOf(*experiment, runner.inputs(), {});
  if (!problems.empty() || !study) {
    return problems;
  }
  auto batch = app::BatchFolder::open(folder.toStdString(), *study, app::ExistingBatch::Refuse);
  if (!batch) {
    return batch.diagnostics();
  }
  app::BatchJob job;
  job.runs = (*batch)->missing();
  job.execute = [&](std::size_t run, const app::BatchJob::ReportInputs& report) {
    return runner.run(run, report);
  };
  job.storeRow = [&](std::size_t run, const app::ResultRow& row) {
    const app::Experiment::Run of = experiment->run(run);
    return (*batch)->add({run, experiment->scenarios[of.scenario], of.seed, of.values, row});
  };
  job.wantsStop = [] { return false; };
  problems = app::runBatch(job);
  base::append(problems, (*batch)->finish());
  return problems;
}

/// The study in a folder of its own: 4 runs of two workers among walls (trees, map) and of the
/// yard.
class PackedSmallStudy {
 public:
  QString path(const char* name) const { return folder_.filePath(outside::text(name)); }
  std::string file() const { return path("study.hnv").toStdString(); }

  /// Empty: it is packed.
  base::Diagnostics make() {
    for (const char* name :
         {"two_workers_agents.yaml", "two_workers.yaml", "two_workers.pgm",
          "two_workers_agents__agent_1_bt.xml", "two_workers_agents__agent_2_bt.xml"}) {
      outside::writeText(
          path(name),
          outside::bytesOf(outside::text(SOURCE_DIR "/maps/two_workers/") + outside::text(name)));
    }
    outside::writeText(path("yard.yaml"), outside::kYardText);
    outside::writeText(path("study.yaml"),
                       "hunavsim_experiment: 1\nscenarios: [yard.yaml, two_workers_agents.yaml]\n"
                       "seeds: [3, 7]\nduration: 1.5\nrecord: all\n"
                       "values:\n  \"*.max_vel\": {normal: [1.2, 0.2, 0.6, 1.8]}\n");
    base::Diagnostics problems = runStudy(path("study.yaml"), path("results"));
    if (problems.empty()) {
      capsule::PackOptions pack;
      pack.study = path("results").toStdString();
      pack.output = file();
      problems = capsule::packStudy(pack).diagnostics();
    }
    return problems;
  }

 private:
  QTemporaryDir folder_;
};

/// A capsule that was unpacked to be altered.
class AlteredCapsule {
 public:
  explicit AlteredCapsule(const std::string& file) {
    const auto archive = capsule::ArchiveReader::open(file);
    problems_ = archive ? (*archive)->extract(root().toStdString()) : archive.diagnostics();
  }
  const base::Diagnostics& problems() const { return problems_; }
  QString root() const { return folder_.filePath(outside::text("content")); }
  QString path(const char* member) const {
    return root() + QLatin1Char('/') + outside::text(member);
  }

  /// Replaces the first occurrence of a text in a member. False: it does not occur.
  bool replace(const char* member, const QByteArray& was, const QByteArray& by) const {
    QByteArray bytes = outside::bytesOf(path(member));
    const int at = bytes.indexOf(was);
    if (at >= 0) {
      outside::writeText(path(member), bytes.replace(at, was.size(), by));
    }
    return at >= 0;
  }

  /// Writes the present hashes to manifest.json and SHA256SUMS, which hides the change. `inner`:
  /// also to the manifests of the study and the list of inputs.
  void rehash(bool inner) const {
    if (inner) {
      rehashFolder(root() + QLatin1String("/study"));
      for (const QString& run : QDir(root() + QLatin1String("/study/runs"))
                                    .entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        rehashFolder(root() + QLatin1String("/study/runs/") + run);
      }
    }
    nlohmann::ordered_json manifest = readJson("manifest.json");
    app::FileHashes sums;
    nlohmann::ordered_json outputs = nlohmann::ordered_json::array();
    for (const std::string& name : members()) {
      const std::string hash = *app::sha256OfFile(path(name.c_str()).toStdString());
      if (name != capsule::kManifestMember && name != capsule::kSumsMember) {
        outputs.push_back({{"path", name}, {"sha256", hash}});
        sums[name] = hash;
      }
    }
    manifest["outputs"] = outputs;
    for (nlohmann::ordered_json& input : manifest["inputs"]) {
      const std::string member = input["member"].get<std::string>();
      if (inner && sums.count(member) != 0) {
        input["sha256"] = sums[member];
      }
    }
    const std::string text = manifest.dump(2) + "\n";
    outside::writeText(path(capsule::kManifestMember), QByteArray::fromStdString(text));
    sums[capsule::kManifestMember] = app::sha256Of(text);
    outside::writeText(path(capsule::kSumsMember),
                       QByteArray::fromStdString(capsule::sumsText(sums)));
  }

  std::string pack() const {
    std::string file = folder_.filePath(outside::text("altered.hnv")).toStdString();
    std::vector<capsule::ArchiveMember> all;
    for (const std::string& name : members()) {
      all.push_back({name, {}, path(name.c_str()).toStdString(), false});
    }
    return capsule::writeArchive(file, all).empty() ? file : std::string();
  }

  nlohmann::ordered_json readJson(const char* member) const {
    return nlohmann::ordered_json::parse(outside::bytesOf(path(member)).toStdString());
  }
  std::vector<std::string> members() const { return *app::filesBelow(root().toStdString()); }

 private:
  static void rehashFolder(const QString& folder) {
    const QString file = folder + QLatin1String("/manifest.json");
    nlohmann::ordered_json manifest =
        nlohmann::ordered_json::parse(outside::bytesOf(file).toStdString());
    for (nlohmann::ordered_json& output : manifest["outputs"]) {
      const std::string path = folder.toStdString() + "/" + output["path"].get<std::string>();
      output["sha256"] = app::sha256OfFile(path).value_or(output["sha256"].get<std::string>());
    }
    outside::writeText(file, QByteArray::fromStdString(manifest.dump(2) + "\n"));
  }

  QTemporaryDir folder_;
  base::Diagnostics problems_;
};

}  // namespace small
