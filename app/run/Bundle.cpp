#include "app/run/Bundle.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/Nav2Robots.h"
#include "app/run/PlannerFiles.h"
#include "sim2d/base/Result.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

constexpr std::size_t kMaxKept = 4;

/// Returns the value for the key, created if missing, and makes it the most recently used one.
template <class Key, class Value, class Make>
std::shared_ptr<const Value> fetch(std::list<std::pair<Key, std::shared_ptr<const Value>>>& shelf,
                                   const Key& key, Make make) {
  const auto found = std::find_if(shelf.begin(), shelf.end(),
                                  [&key](const auto& each) { return each.first == key; });
  if (found != shelf.end()) {
    shelf.splice(shelf.begin(), shelf, found);
  } else {
    shelf.emplace_front(key, make());
    shelf.resize(std::min(shelf.size(), kMaxKept));
  }
  return shelf.front().second;
}

}  // namespace

std::shared_ptr<const sim2d::Surroundings> SurroundingsCache::of(
    const sim2d::Scenario& scenario, const std::shared_ptr<const sim2d::OccupancyGrid>& map,
    const base::StopFlagPtr& stop) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool isKnown = surroundings_ != nullptr && map_ == map && stop_ == stop &&
                       obstacles_ == scenario.obstacles && doors_ == scenario.doors;
  if (!isKnown) {
    surroundings_ =
        std::make_shared<const sim2d::Surroundings>(sim2d::makeSurroundings(scenario, *map, stop));
    stop_ = stop;
    map_ = map;
    obstacles_ = scenario.obstacles;
    doors_ = scenario.doors;
  }
  return surroundings_;
}

std::shared_ptr<const sim2d::ScenarioReading> FileCache::scenario(const std::string& path) {
  return fetch(scenarios_, path, [&path] {
    return std::make_shared<const sim2d::ScenarioReading>(sim2d::readScenario(path));
  });
}

void FileCache::setScenario(const std::string& path, sim2d::ScenarioReading reading) {
  scenarios_.remove_if([&path](const auto& each) { return each.first == path; });
  fetch(scenarios_, path,
        [&reading] { return std::make_shared<const sim2d::ScenarioReading>(std::move(reading)); });
}

std::shared_ptr<const CachedMap> FileCache::map(const std::string& path, const std::string& rule) {
  return fetch(maps_, std::pair(path, rule), [&] {
    auto known = std::make_shared<CachedMap>();
    if (path.empty()) {
      known->grid = std::make_shared<const sim2d::OccupancyGrid>();
      return known;
    }
    base::Result<sim2d::MapFile> file = readMapFile(path, rule, loader_);
    known->problems = file.diagnostics();
    if (file) {
      known->path = file->path;
      known->imagePath = file->imagePath;
      known->grid = std::make_shared<const sim2d::OccupancyGrid>(std::move(file->grid));
    }
    return known;
  });
}

base::Result<sim2d::MapFile> readMapFile(const std::string& path, const std::string& rule,
                                         const sim2d::ImageLoader& loader) {
  return sim2d::readMap(path, loader,
                        rule == "main" ? sim2d::MapRule::Main : sim2d::MapRule::Humble);
}

namespace {

struct DuplicateRule {
  std::string_view code, of;
};
constexpr DuplicateRule kDuplicateRules[] = {
    {"scenario.nobody-listed", "scenario.nobody"},
    {"tree.no-goal", "scenario.goal-undefined"},
    {"world.body-moved", "places.moved"},
    {"world.body-does-not-fit", "places.no-place"},
    {"world.goal-out-of-reach", "places.no-way"},
    {"world.point-out-of-reach", "places.no-way"},
    {"world.point-out-of-reach", "places.no-way-to-point"}};

}  // namespace

base::Diagnostics withoutDuplicates(const base::Diagnostics& some, const base::Diagnostics& all) {
  using Subject = std::tuple<base::EntityId, std::string_view, std::string>;  // entity, code, goal
  std::set<Subject> reported;
  for (const base::Diagnostic& issue : all) {
    for (const base::EntityId thing : {issue.entity, base::EntityId()}) {
      reported.insert({thing, issue.code, issue.value("goal")});
      reported.insert({thing, issue.code, std::string()});
    }
  }
  base::Diagnostics left;
  std::copy_if(some.begin(), some.end(), std::back_inserter(left), [&](const auto& issue) {
    return std::none_of(std::begin(kDuplicateRules), std::end(kDuplicateRules),
                        [&](const DuplicateRule& echo) {
                          return echo.code == issue.code &&
                                 reported.count({issue.entity, echo.of, issue.value("goal")}) > 0;
                        });
  });
  return left;
}

base::Diagnostics newDiagnostics(const base::Diagnostics& reported, const base::Diagnostics& more) {
  std::set<std::string> lines;
  for (const base::Diagnostic& problem : reported) {
    lines.insert(problem.text());
  }
  base::Diagnostics rest;
  std::copy_if(more.begin(), more.end(), std::back_inserter(rest),
               [&lines](const auto& problem) { return lines.count(problem.text()) == 0; });
  return rest;
}

namespace {

void readMapOf(Bundle& bundle, const sim2d::FileSearchPaths& places, FileCache& files) {
  const sim2d::Scenario& scenario = *bundle.scenario;
  const base::Result<std::string> path = sim2d::findMap(scenario, places);
  base::Diagnostics problems = path.diagnostics();
  sim2d::addMapLocation(problems, places.scenarioPath);
  base::append(bundle.remarks, problems);
  if (!path) {
    return;
  }
  const auto map = files.map(*path, scenario.desktop.mapRule.value_or("humble"));
  base::append(bundle.remarks, map->problems);
  bundle.map = map->grid;
  bundle.known = map->surroundings;
  bundle.routes = map->routes;
  bundle.mapPath = map->path;
  bundle.mapImagePath = map->imagePath;
}

/// Reports people without a tree file, whose trees are generated: information if `isUsual`, else a
/// warning, because scenarios of HuNavSim should have tree files.
void reportGeneratedTrees(Bundle& bundle, const std::vector<std::string>& names,
                          const sim2d::ScenarioReading& reading, bool isUsual) {
  if (names.empty()) {
    return;
  }
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> first = names;
  first.resize(std::min(kNamed, names.size()));
  const std::string more = names.size() > kNamed ? " …" : "";
  const char* const people = names.size() == 1 ? " person" : " people";
  bundle.remarks.push_back(base::problem(
      isUsual ? base::Severity::Info : base::Severity::Warning, "run.no-tree-files",
      {std::to_string(names.size()) + people, base::join(first, ", ") + more}, bundle.path));
  bundle.remarks.back().line = reading.agentsLine;
  bundle.remarks.back().column = reading.agentsColumn;
}

void findTrees(Bundle& bundle, const sim2d::FileSearchPaths& places,
               const sim2d::ScenarioReading& reading) {
  bool hasFiles = false;
  std::vector<std::string> generated;
  for (const sim2d::Human& human : bundle.scenario->humans) {
    if (!human.listed) {
      continue;
    }
    const std::string path = sim2d::findTree(*bundle.scenario, human, places);
    bundle.trees[human.name] = path;
    if (path.empty()) {
      generated.push_back(human.name);
    } else {
      hasFiles = true;
    }
  }
  std::error_code ignored;
  const std::string& folder = places.treesOption;
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) {
    reportGeneratedTrees(bundle, generated, reading,
                         reading.hasDesktopNode && !hasFiles && folder.empty());
  } else {
    bundle.remarks.push_back(base::error("option.no-trees-folder", {}, folder));
  }
}

std::shared_ptr<const sim2d::Surroundings> surroundingsOf(const Bundle& bundle) {
  // Positions are not checked against walls without the map, or if positions in the file were
  // invalid and have been replaced.
  return bundle.map && bundle.isWhole ? bundle.known->of(*bundle.scenario, bundle.map, bundle.stop)
                                      : std::make_shared<const sim2d::Surroundings>();
}

void checkMetrics(const Bundle& bundle, Verdict& verdict) {
  const base::Result<MetricsSetup> setup = metricsSetupOf(*bundle.scenario, bundle.path);
  base::append(verdict.problems, setup.diagnostics());
  if (setup) {
    verdict.scenarioMetrics = *setup;
    verdict.metrics = *setup;
    base::append(verdict.problems,
                 applyMetricsOptions(bundle.metrics, verdict.metrics, verdict.wrongOptions));
  }
}

/// Reports external code of robots unless it is allowed: an error with Refused, a warning with
/// Skipped.
void reportExternalCode(const Bundle& bundle, const std::vector<ExternalCode>& code,
                        Verdict& verdict) {
  const sim2d::ExternalCodePolicy use = bundle.settings.code;
  if (code.empty() || use == sim2d::ExternalCodePolicy::Allowed) {
    return;
  }
  base::Diagnostics told = externalCodeProblems(
      code,
      use == sim2d::ExternalCodePolicy::Refused ? base::Severity::Error : base::Severity::Warning,
      bundle.path);
  sim2d::addLocations(told, bundle.lines, bundle.path);
  base::append(verdict.problems, told);
}

/// `unread`: problems of files that could not be read.
void completeSetup(const Bundle& bundle, sim2d::WorldSetup& setup, base::Diagnostics& unread) {
  setup.scenario = withNav2GoalRadius(bundle.scenario, bundle.path, unread);
  setup.compatibility = bundle.settings.compatibility;
  setup.threads = bundle.settings.threads;
  setup.exact = bundle.settings.exact;
  setup.code = bundle.settings.code;
  setup.folder = plannerFolderOf(bundle.path);
  setup.stop = bundle.stopOfRun;
  setup.registries = sharedRegistries();
}

void checkWorld(const Bundle& bundle, bool isRunnable, sim2d::WorldSetup setup,
                base::Diagnostics unread, Verdict& verdict) {
  base::Result<std::unique_ptr<sim2d::World>> world = sim2d::World::create(std::move(setup));
  base::Diagnostics ofWorld = world.diagnostics();
  sim2d::addLocations(ofWorld, bundle.lines, bundle.path);
  bundle.stop->check();
  base::Diagnostics all = verdict.problems;
  base::append(all, ofWorld);
  base::append(world ? verdict.worldRemarks : verdict.problems, withoutDuplicates(ofWorld, all));
  if (world && isRunnable) {
    base::append(unread, unlistedNav2Trees(*bundle.scenario, bundle.path, bundle.inputs));
    if (base::hasErrors(unread)) {  // and could be read now
      base::append(verdict.problems, unread);
      return;
    }
    verdict.world = *std::move(world);
  }
}

}  // namespace

base::Diagnostics errorsOf(const base::Diagnostics& problems) {
  base::Diagnostics errors;
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(errors),
               [](const base::Diagnostic& said) { return said.severity == base::Severity::Error; });
  return errors;
}

void listInputs(Bundle& bundle) {
  const sim2d::Scenario& scenario = *bundle.scenario;
  std::vector<std::string>& inputs = bundle.inputs;
  inputs = {bundle.path};
  if (!bundle.mapPath.empty()) {
    inputs.insert(inputs.end(), {bundle.mapPath, bundle.mapImagePath});
  }
  sim2d::forEachListed(scenario.humans, [&](const sim2d::Human& human) {
    const auto tree = bundle.trees.find(human.name);
    if (tree != bundle.trees.end() && !tree->second.path.empty()) {
      inputs.push_back(tree->second.path);
    }
  });
  for (const auto& files :
       {nav2FilesOf(scenario, bundle.path), filesThatPlannersRead(scenario, bundle.path)}) {
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  if (const auto file = metricsFileOf(scenario, bundle.path)) {
    inputs.push_back(*file);
  }
}

Bundle readBundle(const RunSpec& spec, const RunSettings& settings,
                  const sim2d::ImageLoader& loader) {
  FileCache files(loader);
  return readBundle(spec, settings, files);
}

Bundle readBundle(const RunSpec& spec, const RunSettings& settings, FileCache& files) {
  Bundle bundle;
  bundle.path = spec.scenario;
  bundle.metrics = {spec.metrics, spec.metricsProfile};
  bundle.settings = settings;
  bundle.stop = files.stopFlag();
  bundle.knownTrees = files.trees();
  bundle.inputs.push_back(spec.scenario);
  const auto reading = files.scenario(spec.scenario);
  const std::optional<base::Diagnostic> unknown = unknownScenario(spec.scenario);
  bundle.remarks = unknown ? base::Diagnostics{*unknown} : reading->diagnostics;
  bundle.isWhole = reading->ok();
  bundle.comments = reading->commentCount;
  bundle.lines = reading->lines;
  auto scenario = std::make_shared<sim2d::Scenario>(reading->scenario);
  if (bundle.isWhole) {
    bundle.wrongOptions = applyOptions(*scenario, spec, settings.compatibility);
    if (!spec.set.empty()) {
      base::append(bundle.wrongOptions, wrongNav2Values(*scenario, spec.scenario));
    }
  }
  bundle.scenario = std::move(scenario);
  if (bundle.hasScenario() && !base::hasErrors(bundle.wrongOptions)) {
    const sim2d::FileSearchPaths places{spec.scenario, spec.map, spec.trees, shippedMapsFolder()};
    readMapOf(bundle, places, files);
    findTrees(bundle, places, *reading);
    listInputs(bundle);
  }
  return bundle;
}

namespace {

/// A copy with the bodies that robots take from their Nav2 files; none: no robot does.
std::optional<Bundle> withBodies(const Bundle& bundle, base::Diagnostics& problems) {
  if (!bundle.hasScenario()) {
    return std::nullopt;
  }
  base::Diagnostics found;
  auto scenario = withNav2Bodies(bundle.scenario, bundle.path, found);
  sim2d::addLocations(found, bundle.lines, bundle.path);
  base::append(problems, found);
  if (scenario == bundle.scenario) {
    return std::nullopt;
  }
  std::optional<Bundle> shaped = bundle;
  shaped->scenario = std::move(scenario);
  return shaped;
}

/// The verdict with `--strict`: substitutions are errors.
Verdict strict(Verdict verdict) {
  verdict.problems = base::withStrictSubstitutions(std::move(verdict.problems));
  verdict.worldRemarks = base::withStrictSubstitutions(std::move(verdict.worldRemarks));
  if (base::hasErrors(verdict.worldRemarks)) {
    base::append(verdict.problems, std::exchange(verdict.worldRemarks, {}));
  }
  if (!verdict.ok()) {
    verdict.world.reset();
    verdict.setup.reset();
  }
  return verdict;
}

Verdict checkBundle(const Bundle& given, CheckDepth depth) {
  Verdict verdict;
  verdict.problems = given.remarks;
  const std::optional<Bundle> shaped = withBodies(given, verdict.problems);
  const Bundle& bundle = shaped ? *shaped : given;
  verdict.wrongOptions = bundle.wrongOptions;
  if (!bundle.hasScenario() || base::hasErrors(bundle.wrongOptions)) {
    return verdict;
  }
  sim2d::WorldSetup setup;
  setup.surroundings = surroundingsOf(bundle);
  bundle.stopOfRun->check();
  base::Diagnostics meaning = sim2d::checkScenario(
      *bundle.scenario, *setup.surroundings, bundle.path, sim2d::knownNames(builtinRegistries()));
  bundle.stop->check();  // otherwise unfinished searches would be reported as unreachable places
  sim2d::addLocations(meaning, bundle.lines, bundle.path);
  base::append(verdict.problems, meaning);
  setup.behavior = bt::makeTreeBehavior(*bundle.scenario, bundle.trees, verdict.problems,
                                        bundle.settings.compatibility, bundle.knownTrees);
  checkMetrics(bundle, verdict);
  const std::vector<ExternalCode> code = externalCodeOf(*bundle.scenario);
  reportExternalCode(bundle, code, verdict);
  verdict.problems = withoutDuplicates(verdict.problems, verdict.problems);
  if (depth == CheckDepth::Meaning || !verdict.ok()) {
    return verdict;
  }
  bundle.stopOfRun->check();
  base::Diagnostics unread;
  completeSetup(bundle, setup, unread);
  if (depth == CheckDepth::Setup) {
    base::append(verdict.problems, unread);
    verdict.setup = std::move(setup);
    return verdict;
  }
  const bool isRunnable =
      code.empty() || bundle.settings.code == sim2d::ExternalCodePolicy::Allowed;
  checkWorld(bundle, isRunnable, std::move(setup), std::move(unread), verdict);
  return verdict;
}

}  // namespace

Verdict check(const Bundle& bundle, CheckDepth depth) {
  Verdict verdict = checkBundle(bundle, depth);
  return bundle.settings.strict ? strict(std::move(verdict)) : std::move(verdict);
}

}  // namespace app
