#include "bt/robot/Nav2Files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "bt/robot/FirstPlugins.h"
#include "bt/robot/RobotNodes.h"
#include "bt/tree/TreeUse.h"
#include "bt/tree/TreeXml.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/ReferencedFiles.h"

namespace bt {
namespace {

namespace fs = std::filesystem;
using sim2d::nav2::Distro;
using sim2d::nav2::Nav2Parameters;

bool isFile(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

std::string inFolder(const std::string& file, const std::string& folder) {
  return (fs::path(folder) / file).lexically_normal().string();
}

std::string known(const std::string& folder, const std::string& extension) {
  std::set<std::string> names;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none)) {
    if (entry.path().extension() == extension) {
      names.insert(entry.path().stem().string());
    }
  }
  return base::join({names.begin(), names.end()}, ", ");
}

/// Warns about ports that the node does not have in the distribution; Nav2 then rejects the tree.
void checkPorts(const NodeSpec& node, const std::string& file, Distro distro, NavigatorTree& to) {
  const unsigned ofNode = distrosOfNode(node.id);
  for (const Attribute& port : node.ports) {
    const unsigned distros = distrosOfPort(node.id, port.name);
    if (sim2d::nav2::includesDistro(ofNode, distro) &&
        !sim2d::nav2::includesDistro(distros, distro)) {
      to.problems.push_back(base::warning("nav2.port-of-others",
                                          {port.name, node.id, sim2d::nav2::distroTitles(distros),
                                           sim2d::nav2::distroTitle(distro)},
                                          file, node.line));
    }
  }
}

/// Collects the tree that a node requests; a name in a blackboard entry is unknown at load time.
void collectSubTree(const NodeSpec& node, NavigatorTree& to) {
  const bool isToPose = node.id == "NavigateToPose";
  if (!isToPose && node.id != "NavigateThroughPoses") {
    return;
  }
  const std::string* const port = findAttribute(node.ports, "behavior_tree");
  const std::string name = port != nullptr ? *port : std::string();
  if (name.find('{') == std::string::npos) {
    (isToPose ? to.toPose : to.throughPoses).insert(name);
  }
}

/// Warns about nodes and ports that the distribution does not have.
void checkNodes(const NodeSpec& node, const std::string& file, Distro distro, NavigatorTree& to) {
  const unsigned distros = distrosOfNode(node.id);
  to.isThroughPoses = to.isThroughPoses || node.id == "ComputePathThroughPoses";
  if (!sim2d::nav2::includesDistro(distros, distro)) {
    to.problems.push_back(base::warning(
        "nav2.node-of-others",
        {node.id, sim2d::nav2::distroTitles(distros), sim2d::nav2::distroTitle(distro)}, file,
        node.line));
  }
  to.usesRouteServer =
      to.usesRouteServer || node.id == "ComputeRoute" || node.id == "ComputeAndTrackRoute";
  checkPorts(node, file, distro, to);
  collectSubTree(node, to);
  for (const NodeSpec& child : node.children) {
    checkNodes(child, file, distro, to);
  }
}

/// The shipped parameter file of robots that name none.
constexpr const char* kDefaultParams = "generic";

/// Resolves a parameter file: a path relative to `folder`, otherwise the name of a shipped file
/// ("turtlebot3"). Empty: not found.
std::string paramsFile(const std::string& named, const std::string& folder,
                       const Nav2Folders& shipped) {
  const std::string name = named.empty() ? kDefaultParams : named;
  std::string beside = inFolder(name, folder);
  if (!named.empty() && isFile(beside)) {
    return beside;
  }
  const fs::path own = fs::path(shipped.params) / (name + ".yaml");
  return isFile(own) ? own.string() : std::string();
}

base::Diagnostic missingParamsFile(const std::string& named, const std::string& folder,
                                   const Nav2Folders& shipped) {
  const std::string name = named.empty() ? kDefaultParams : named;
  return base::error("nav2.no-file", {name, known(shipped.params, ".yaml")},
                     inFolder(name, folder));
}

/// Finds a shipped tree by name; empty: not found.
std::string shippedTree(const std::string& name, Distro distro, const Nav2Folders& shipped) {
  fs::path file = fs::path(name).filename();
  file = file.extension() == ".xml" ? file : fs::path(file.string() + ".xml");
  const std::string own = sim2d::nav2::distroName(distro);
  const bool isOld = distro < Distro::Lyrical;  // Kilted uses the trees of Jazzy
  for (const std::string& branch : {own, std::string(isOld ? "jazzy" : "main"), std::string("main"),
                                    std::string("jazzy"), std::string("humble")}) {
    const fs::path found = fs::path(shipped.trees) / branch / file;
    if (isFile(found)) {
      return found.string();
    }
  }
  return {};
}

/// The same for a tree named by the user. A missing path is searched by its file name among the
/// shipped trees, those of the same distribution first.
std::string treeFileOf(const std::string& named, const std::string& folder, Distro distro,
                       const Nav2Folders& shipped) {
  const std::string name = named.empty() ? kDefaultNav2Tree : named;
  std::string beside = inFolder(name, folder);
  return !named.empty() && isFile(beside) ? beside : shippedTree(name, distro, shipped);
}

}  // namespace

std::string nav2TreeOfParameter(const Nav2Parameters& parameters, const TreeParameter& parameter,
                                const std::string& folder, const Nav2Folders& shipped,
                                base::Diagnostics& problems) {
  if (parameter.value.empty()) {
    return shippedTree(parameter.usual, parameters.distro, shipped);
  }
  const std::string key = "bt_navigator." + parameter.name;
  std::vector<std::string> folders = sim2d::nav2::parameterFolders(parameters, key);
  folders.push_back(folder);
  const sim2d::nav2::ReferencedFile found =
      sim2d::nav2::findReferencedFile(parameter.value, folders);
  if (!found.file.empty()) {
    return found.file;
  }
  const std::string path = sim2d::nav2::pathWithoutSubstitution(parameter.value);
  std::string own = path.empty() ? path : shippedTree(path, parameters.distro, shipped);
  if (own.empty()) {
    own = shippedTree(parameter.usual, parameters.distro, shipped);
    const base::Diagnostic missing =
        sim2d::nav2::referencedFileMissing(parameter.name, parameter.value, found, "Nav2's tree");
    problems.push_back(withFilePosition(parameters, base::withContext("bt_navigator", missing)));
  }
  return own;
}

bool isNav2sOwnTree(const std::string& file, const Nav2Folders& shipped) {
  return !shipped.trees.empty() && base::startsWith(file, shipped.trees);
}

NavigatorTree loadNavigatorTree(const std::string& file, const Nav2Parameters& parameters) {
  NavigatorTree tree;
  const base::Result<TreeFile> read = readTree(file);
  if (!read) {
    tree.problems = read.diagnostics();
    return tree;
  }
  if (const auto problem = wrongTreeUse(*read, TreeUse::Navigator)) {
    tree.problems = {*problem};
    return tree;
  }
  const base::Result<TreeTable> table =
      prependDiagnostics(read.diagnostics(), resolveIncludes(*read));
  for (const base::Diagnostic& problem : table.diagnostics()) {
    const bool isUsual = problem.code == "tree.no-format" || problem.code == "tree.converted";
    if (!isUsual) {  // Humble's trees have format 3
      tree.problems.push_back(problem);
    }
  }
  if (!table) {
    return tree;
  }
  CompileOptions options;
  options.mainTree = table->mainTree;
  options.hostEntries = {{parameters.btNavigator.goalBlackboardId, PortType::Any},
                         {parameters.btNavigator.goalsBlackboardId, PortType::Any},
                         {"number_recoveries", PortType::Int},
                         {parameters.btNavigator.waypointStatusesBlackboardId, PortType::Any}};
  auto program = compile(*table, robotNodes(), options);
  base::append(tree.problems, program.diagnostics());
  for (const auto& [id, entry] : table->entries) {
    checkNodes(entry.tree.root, entry.file, parameters.distro, tree);
  }
  tree.program = program ? *program : nullptr;
  return tree;
}

namespace {

/// Loads the tree for several goals.
void loadThroughPosesTree(const std::string& folder, const Nav2Folders& shipped,
                          Nav2Loaded& loaded) {
  const std::string& named = loaded.parameters.btNavigator.defaultNavThroughPosesBtXml;
  loaded.throughPosesFile = nav2TreeOfParameter(
      loaded.parameters, {"default_nav_through_poses_bt_xml", named, kDefaultThroughPosesTree},
      folder, shipped, loaded.problems);
  if (loaded.throughPosesFile.empty()) {  // goals are then visited one by one
    return;
  }
  loaded.through = loadNavigatorTree(loaded.throughPosesFile, loaded.parameters);
  if (!named.empty()) {  // shipped trees are valid
    base::append(loaded.problems, loaded.through.problems);
  }
}

/// Loads a tree requested by a node. Null, with a problem: missing or invalid. Warnings about
/// shipped trees are suppressed.
std::shared_ptr<const Program> loadSubTree(const std::string& named, const std::string& folder,
                                           const Nav2Folders& shipped, Nav2Loaded& loaded) {
  const std::string file = treeFileOf(named, folder, loaded.parameters.distro, shipped);
  if (file.empty()) {
    loaded.problems.push_back(
        base::error("nav2.no-file", {named, known(shipped.trees, ".xml")}, named));
    return nullptr;
  }
  NavigatorTree tree = loadNavigatorTree(file, loaded.parameters);
  base::append(loaded.problems, tree.problems);
  loaded.subTreeFiles.push_back(file);
  return tree.program;
}

void loadSubTrees(const NavigatorTree& tree, const std::string& folder, const Nav2Folders& shipped,
                  Nav2Loaded& loaded) {
  const sim2d::nav2::BtNavigatorParameters& own = loaded.parameters.btNavigator;
  const std::string toPose =
      own.defaultNavToPoseBtXml.empty() ? kDefaultNav2Tree : own.defaultNavToPoseBtXml;
  const std::string through = own.defaultNavThroughPosesBtXml.empty()
                                  ? kDefaultThroughPosesTree
                                  : own.defaultNavThroughPosesBtXml;
  for (const auto& [wanted, fallback] :
       {std::pair(&tree.toPose, &toPose), std::pair(&tree.throughPoses, &through)}) {
    for (const std::string& name : *wanted) {
      auto program = loadSubTree(name.empty() ? *fallback : name, folder, shipped, loaded);
      if (!name.empty()) {
        loaded.subTrees.byName[name] = std::move(program);
      } else {
        (wanted == &tree.toPose ? loaded.subTrees.toPose : loaded.subTrees.throughPoses) =
            std::move(program);
      }
    }
  }
}

}  // namespace

Nav2Loaded loadNav2Parameters(const sim2d::Nav2Config& choice, const std::string& folder,
                              const std::string& robot, const Nav2Folders& shipped) {
  Nav2Loaded loaded;
  const Nav2ParamFiles files(choice.params, folder, shipped);
  loaded.paramsFiles = files.paths();
  loaded.overrides = files.overrides();
  loaded.problems = files.problems();
  if (base::hasErrors(loaded.problems)) {
    return loaded;
  }
  sim2d::nav2::Nav2ReadResult reading =
      files.read(choice.values, {choice.distro, robot}, loaded.invalidValues);
  for (base::Diagnostic& problem : reading.problems) {
    if (problem.code == "nav2.partial-file") {  // no further file completes this one
      problem = base::error("nav2.no-controller", {reading.parameters.nodeNames}, problem.file,
                            problem.line);
    }
  }
  base::append(loaded.problems, reading.problems);
  loaded.parameters = std::move(reading.parameters);
  loaded.masks = loadNav2Masks(loaded.parameters);
  base::append(loaded.problems, loaded.masks.problems);
  loaded.graph = loadNav2RouteGraph(loaded.parameters);
  base::append(loaded.problems, loaded.graph.problems);
  const base::Result<NavigatorTopics> topics = NavigatorTopics::read(choice.topics);
  base::append(loaded.problems, topics.diagnostics());
  loaded.topics = topics ? *topics : NavigatorTopics();
  if (const std::string& docks = loaded.parameters.dockingServer.dockDatabase; isFile(docks)) {
    loaded.masks.files.push_back(docks);  // a further input of the run
  }
  Nav2Lattices lattices = loadNav2Lattices(loaded.parameters);
  base::append(loaded.problems, lattices.problems);
  loaded.lattices = std::move(lattices.files);
  return loaded;
}

Nav2Loaded loadNav2(const sim2d::Nav2Config& choice, const std::string& folder,
                    const std::string& robot, const Nav2Folders& shipped) {
  Nav2Loaded loaded = loadNav2Parameters(choice, folder, robot, shipped);
  if (loaded.parameters.file.empty()) {  // it could not be read
    return loaded;
  }
  if (choice.tree.empty()) {
    const TreeParameter parameter{"default_nav_to_pose_bt_xml",
                                  loaded.parameters.btNavigator.defaultNavToPoseBtXml,
                                  kDefaultNav2Tree};
    loaded.treeFile =
        nav2TreeOfParameter(loaded.parameters, parameter, folder, shipped, loaded.problems);
  } else {
    loaded.treeFile = treeFileOf(choice.tree, folder, loaded.parameters.distro, shipped);
  }
  if (loaded.treeFile.empty()) {
    const std::string named = choice.tree.empty() ? kDefaultNav2Tree : choice.tree;
    loaded.problems.push_back(
        base::error("nav2.no-file", {named, known(shipped.trees, ".xml")}, named));
    return loaded;
  }
  if (choice.tree.empty() && isNav2sOwnTree(loaded.treeFile, shipped)) {
    loaded.parameters.usesFirstPlugins = true;
    base::append(loaded.problems, firstPluginWarnings(loaded.parameters));
  }
  NavigatorTree tree = loadNavigatorTree(loaded.treeFile, loaded.parameters);
  base::append(loaded.problems, tree.problems);
  loadSubTrees(tree, folder, shipped, loaded);
  if (tree.usesRouteServer && loaded.graph.graph.isEmpty() && loaded.graph.problems.empty()) {
    loaded.problems.push_back(base::warning("nav2.routes-without-graph", {}, loaded.treeFile));
  }
  loaded.program = std::move(tree.program);
  loaded.isThroughPoses = tree.isThroughPoses;
  if (choice.tree.empty()) {
    loadThroughPosesTree(folder, shipped, loaded);
  }
  return loaded;
}

namespace {

using sim2d::nav2::Nav2ReadOptions;
using sim2d::nav2::Nav2ReadResult;
using sim2d::nav2::ParameterFile;

/// A plugin class that is set outside the files changes which keys are read.
bool isPlugin(const std::string& path) {
  return path.find("plugin") != std::string::npos;
}

}  // namespace

Nav2ParamFiles::Nav2ParamFiles(const std::vector<std::string>& entries, const std::string& folder,
                               const Nav2Folders& shipped) {
  const bool hasFile = std::any_of(entries.begin(), entries.end(), [](const std::string& entry) {
    return !sim2d::nav2::parameterOverride(entry);
  });
  if (!hasFile) {
    addFile({}, folder, shipped);
  }
  for (const std::string& entry : entries) {
    if (auto single = sim2d::nav2::parameterOverride(entry)) {
      entries_.push_back({std::nullopt, *std::move(single)});
      overrides_.push_back(entry);
    } else {
      addFile(entry, folder, shipped);
    }
  }
}

void Nav2ParamFiles::addFile(const std::string& named, const std::string& folder,
                             const Nav2Folders& shipped) {
  const std::string path = paramsFile(named, folder, shipped);
  if (path.empty()) {
    problems_.push_back(missingParamsFile(named, folder, shipped));
    return;
  }
  paths_.push_back(path);
  base::Result<ParameterFile> file = ParameterFile::read(path);
  base::append(problems_, file.diagnostics());
  if (file) {
    entries_.push_back({*std::move(file)});
  }
}

ParameterFile Nav2ParamFiles::merged() const {
  ParameterFile all;
  for (const Entry& entry : entries_) {
    if (entry.file) {
      all.append(*entry.file);
    }
  }
  return all;
}

ParameterFile Nav2ParamFiles::overridden(Nav2ReadResult reading, const Nav2ReadOptions& options,
                                         base::Diagnostics& wrong) const {
  ParameterFile all;
  for (const Entry& entry : entries_) {
    if (entry.file) {
      all.append(*entry.file);
      continue;
    }
    base::append(wrong, overrideNav2Value(all, reading, entry.single));
    if (isPlugin(entry.single.name)) {
      ParameterFile so = merged();
      so.append(all);
      reading = readNav2Parameters(so, options);
    }
  }
  return all;
}

Nav2ReadResult Nav2ParamFiles::read(const std::vector<std::pair<std::string, std::string>>& values,
                                    Nav2ReadOptions options, base::Diagnostics& wrong) const {
  ParameterFile file = merged();
  Nav2ReadResult reading = readNav2Parameters(file, options);
  if (values.empty() && overrides_.empty()) {
    return reading;
  }
  const bool isGuessed = reading.parameters.isGuessed;
  std::vector<std::string> reasons = std::move(reading.parameters.distroReasons);
  options.distro = reading.parameters.distro;  // from the unmodified files
  if (!overrides_.empty()) {
    file = overridden(std::move(reading), options, wrong);
    reading = readNav2Parameters(file, options);
  }
  for (const auto& [path, yaml] : values) {
    base::append(wrong, setNav2Value(file, reading, path, yaml));
    if (isPlugin(path)) {
      reading = readNav2Parameters(file, options);
    }
  }
  reading = readNav2Parameters(file, options);
  reading.parameters.isGuessed = isGuessed;
  reading.parameters.distroReasons = std::move(reasons);
  return reading;
}

}  // namespace bt
