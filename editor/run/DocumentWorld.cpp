#include "editor/run/DocumentWorld.h"

#include <filesystem>
#include <map>
#include <set>

#include <QTemporaryDir>

#include "bt/human/TreeBehavior.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

namespace {

namespace fs = std::filesystem;

/// Trees that are not saved lie in a folder of their own while the run lasts, beside copies of what
/// they may include.
struct TreeFolder {
  QTemporaryDir folder;
  std::map<std::string, std::string> files;  // of people, by name
  base::Diagnostics problems;
};

/// Where trees of the document lie, and with them what they include.
std::set<fs::path> treeFolders(const ScenarioDocument& document) {
  std::set<fs::path> folders;
  if (!document.path().isEmpty()) {
    folders.insert(treeFolderOf(document.path().toStdString()));
  }
  for (const QString& file : document.files()) {
    if (file.endsWith(QLatin1String(".xml"))) {
      folders.insert(fs::path(file.toStdString()).parent_path());
    }
  }
  return folders;
}

std::shared_ptr<TreeFolder> treesOf(const ScenarioDocument& document) {
  auto trees = std::make_shared<TreeFolder>();
  const sim2d::Scenario& scenario = document.scenario();
  const fs::path folder = trees->folder.path().toStdString();
  for (const sim2d::Human& human : scenario.humans) {
    const std::optional<std::string> xml = document.treeToRun(human.key);
    if (!xml) {
      continue;
    }
    const std::string file = (folder / treeFileName("own", human.id)).string();
    base::append(trees->problems, base::writeFileAtomically(file, *xml));
    trees->files[human.name] = file;
  }
  if (trees->files.empty()) {
    return trees;
  }
  for (const fs::path& source : treeFolders(document)) {
    std::error_code none;  // no such folder: nothing to copy
    for (const fs::directory_entry& entry : fs::directory_iterator(source, none)) {
      if (entry.path().extension() == ".xml" && !fs::exists(folder / entry.path().filename())) {
        fs::copy_file(entry.path(), folder / entry.path().filename(), none);
      }
    }
  }
  base::append(trees->problems, writeIncludedTrees(folder.string()));
  return trees;
}

}  // namespace

RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings) {
  auto scenario = std::make_shared<const sim2d::Scenario>(document.scenario());
  const std::shared_ptr<const sim2d::OccupancyGrid> map = document.map();
  const std::shared_ptr<TreeFolder> trees = treesOf(document);
  if (document.isReadOnly()) {
    trees->problems.push_back(base::makeError(
        "the file could only be read in part: save it under another name to run what is there",
        document.path().toStdString()));
  }
  RunRequest request;
  request.rule = sim2d::stopRuleOf(*scenario);
  request.recordEvery = scenario->desktop.recordEvery.value_or(1);
  request.makeWorld = [scenario, map, trees,
                       settings]() -> base::Result<std::unique_ptr<sim2d::World>> {
    base::Diagnostics problems = trees->problems;
    sim2d::WorldSetup setup;
    setup.scenario = scenario;
    setup.map = *map;
    setup.compatibility = settings.compatibility;
    setup.threads = settings.threads;
    setup.exact = settings.exact;
    if (!base::hasErrors(problems)) {
      setup.behavior =
          bt::makeTreeBehavior(*scenario, trees->files, problems, settings.compatibility);
    }
    if (base::hasErrors(problems)) {
      return problems;
    }
    base::Result<std::unique_ptr<sim2d::World>> world = sim2d::World::create(std::move(setup));
    base::append(problems, world.diagnostics());
    if (!world) {
      return problems;
    }
    return {std::move(*world), std::move(problems)};
  };
  return request;
}

}  // namespace editor
