#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "bt/robot/Nav2Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/params/ReferencedFiles.h"

namespace bt {
namespace {

using sim2d::nav2::BinaryFilterParameters;
using sim2d::nav2::CostmapPlugin;
using sim2d::nav2::FilterMask;
using sim2d::nav2::KeepoutFilterParameters;
using sim2d::nav2::KeyUsage;
using sim2d::nav2::SpeedFilterParameters;

/// File and interpretation of a filter's mask.
struct NamedMask {
  std::string file;          // empty: none
  bool isPublished = false;  // by a node; otherwise named in the filter's block
  FilterMask mask;
};
NamedMask maskOf(const CostmapPlugin& filter) {
  const auto* const keepout = std::get_if<KeepoutFilterParameters>(&filter.parameters);
  if (keepout != nullptr && keepout->enabled) {
    return {keepout->maskFile, keepout->isMaskPublished, {}};
  }
  if (const auto* const binary = std::get_if<BinaryFilterParameters>(&filter.parameters)) {
    FilterMask mask;
    mask.base = binary->maskBase;
    mask.multiplier = binary->maskMultiplier;
    return {binary->enabled ? binary->maskFile : std::string(), binary->isMaskPublished, mask};
  }
  const auto* const speed = std::get_if<SpeedFilterParameters>(&filter.parameters);
  if (speed == nullptr || !speed->enabled) {
    return {};
  }
  NamedMask named{speed->maskFile, speed->isMaskPublished, {}};
  named.mask.base = speed->maskBase;
  named.mask.multiplier = speed->maskMultiplier;
  named.mask.isPercentage = speed->maskIsPercentage;
  return named;
}

/// At the position of the map server's `yaml_filename`.
base::Diagnostic missingMask(const sim2d::nav2::Nav2Parameters& parameters,
                             const std::string& filter, const std::string& mask) {
  base::Diagnostic problem = base::warning("nav2.mask-not-found", {filter, mask}, parameters.file);
  for (const KeyUsage& key : parameters.notes.keys) {
    if (key.value == mask && base::endsWith(key.path, ".yaml_filename")) {
      problem.file = key.file;
      problem.line = key.line;
      problem.column = key.column;
    }
  }
  return problem;
}

}  // namespace

Nav2Masks loadNav2Masks(const sim2d::nav2::Nav2Parameters& parameters) {
  Nav2Masks masks;
  const auto load = [&](const std::vector<CostmapPlugin>& filters, sim2d::nav2::FilterMasks& to) {
    for (const CostmapPlugin& filter : filters) {
      NamedMask named = maskOf(filter);
      if (named.file.empty()) {
        continue;
      }
      const std::string folder = std::filesystem::path(parameters.file).parent_path().string();
      std::string file = sim2d::nav2::findReferencedFile(named.file, {folder}).file;
      if (file.empty() && named.isPublished) {  // a path on the robot's computer
        masks.problems.push_back(missingMask(parameters, filter.name, named.file));
        continue;
      }
      file = file.empty() ? (std::filesystem::path(folder) / named.file).string() : file;
      base::Result<sim2d::MapFile> map = sim2d::readMap(file, {});
      base::append(masks.problems, map.diagnostics());
      if (map) {
        named.mask.grid = std::move(map->grid);
        masks.files.insert(masks.files.end(), {file, map->imagePath});
        to[filter.name] = std::move(named.mask);
      }
    }
  };
  load(parameters.localCostmap.filters, masks.local);
  load(parameters.globalCostmap.filters, masks.global);
  return masks;
}

// Loads the graph of the route server.
namespace {

using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2

/// Checks that each operation of the graph names a plugin of class TriggerEvent.
void checkOperations(const Nav2Parameters& parameters, Nav2RouteGraph& to) {
  const auto check = [&](const std::vector<RouteOperation>& operations) {
    for (const RouteOperation& operation : operations) {
      const auto& loaded = parameters.route.operations;
      const bool isThere = std::any_of(loaded.begin(), loaded.end(), [&](const auto& each) {
        return each.first == operation.type &&
               std::holds_alternative<TriggerEventParameters>(each.second);
      });
      if (!isThere) {
        to.problems.push_back(base::warning("nav2.graph-operation", {operation.type}, to.file));
      }
    }
  };
  for (const RouteNode& node : to.graph.nodes) {
    check(node.operations);
  }
  for (const RouteEdge& edge : to.graph.edges) {
    check(edge.operations);
  }
}

}  // namespace

Nav2RouteGraph loadNav2RouteGraph(const Nav2Parameters& parameters) {
  Nav2RouteGraph result;
  const std::string& named = parameters.route.server.graphFilepath;
  if (named.empty()) {
    return result;
  }
  const ReferencedFile found =
      findReferencedFile(named, {std::filesystem::path(parameters.file).parent_path().string()});
  result.file = found.file;
  if (result.file.empty()) {
    result.problems.push_back(withFilePosition(
        parameters,
        base::withContext("route_server", referencedFileMissing("graph_filepath", named, found,
                                                                "an empty graph"))));
    return result;
  }
  const base::Result<std::string> text = base::readTextFile(result.file);
  base::append(result.problems, text.diagnostics());
  if (!text) {
    return result;
  }
  base::Result<RouteGraph> graph = readRouteGraph(*text, result.file);
  base::append(result.problems, graph.diagnostics());
  if (graph) {
    result.graph = *std::move(graph);
    checkOperations(parameters, result);
  }
  return result;
}

namespace {

using LatticeJson = nlohmann::json;
using sim2d::nav2::GlobalPlannerParameters;
using sim2d::nav2::Lattice;
using sim2d::nav2::LatticePrimitive;
using sim2d::nav2::SmacLatticeParameters;

constexpr std::size_t kMostPrimitives = 10000, kMostHeadings = 360;
constexpr double kFarthest = 1000.0;  // [m]

/// Reads the values of a lattice; any missing or out-of-range value makes it invalid.
class LatticeReader {
 public:
  explicit LatticeReader(const LatticeJson& root) : root_(root) {}

  std::optional<Lattice> read() {
    Lattice lattice;
    const LatticeJson meta = root_.value("lattice_metadata", LatticeJson::object());
    lattice.motionModel = textAt(meta, "motion_model");
    lattice.turningRadius = numberAt(meta, "turning_radius", 1e-3, kFarthest);
    const LatticeJson angles =
        meta.is_object() ? meta.value("heading_angles", LatticeJson()) : LatticeJson();
    for (const LatticeJson& angle : angles) {
      lattice.headings.push_back(base::wrapToPi(numberOf(angle, -10.0, 10.0)));
    }
    const bool isEven = lattice.headings.size() % 2 == 0;
    isGood_ =
        isGood_ && angles.is_array() && !angles.empty() && isEven && angles.size() <= kMostHeadings;
    if (!isGood_) {
      return std::nullopt;
    }
    lattice.primitives.resize(lattice.headings.size());
    const LatticeJson all = root_.value("primitives", LatticeJson::array());
    isGood_ = isGood_ && all.is_array() && !all.empty() && all.size() <= kMostPrimitives;
    for (const LatticeJson& each : all) {
      const LatticePrimitive primitive = primitiveOf(each, lattice.size());
      if (!isGood_) {
        return std::nullopt;
      }
      lattice.primitives[static_cast<std::size_t>(primitive.startHeading)].push_back(primitive);
    }
    return isGood_ ? std::optional(std::move(lattice)) : std::nullopt;
  }

 private:
  double numberOf(const LatticeJson& value, double low, double high) {
    const double number = value.is_number() ? value.get<double>() : high + 1.0;
    const bool isSound = number >= low && number <= high;
    isGood_ = isGood_ && isSound;
    return isSound ? number : low;
  }
  double numberAt(const LatticeJson& object, const char* key, double low, double high) {
    const bool isThere = object.is_object() && object.contains(key);
    isGood_ = isGood_ && isThere;
    return isThere ? numberOf(object.at(key), low, high) : low;
  }
  static std::string textAt(const LatticeJson& object, const char* key) {
    const bool isText = object.is_object() && object.contains(key) && object.at(key).is_string();
    return isText ? object.at(key).get<std::string>() : std::string();
  }

  LatticePrimitive primitiveOf(const LatticeJson& json, int headings) {
    LatticePrimitive primitive;
    primitive.startHeading =
        static_cast<int>(numberAt(json, "start_angle_index", 0.0, headings - 1.0));
    primitive.endHeading = static_cast<int>(numberAt(json, "end_angle_index", 0.0, headings - 1.0));
    primitive.length = numberAt(json, "trajectory_length", 0.0, kFarthest);
    primitive.arcLength = numberAt(json, "arc_length", 0.0, kFarthest);
    const bool knowsTurn =
        json.is_object() && json.contains("left_turn") && json.at("left_turn").is_boolean();
    primitive.isLeftTurn = !knowsTurn || json.at("left_turn").get<bool>();
    const LatticeJson poses =
        json.is_object() ? json.value("poses", LatticeJson::array()) : LatticeJson::array();
    for (const LatticeJson& pose : poses) {
      const bool isPose = pose.is_array() && pose.size() >= 3;
      isGood_ = isGood_ && isPose;
      if (isPose) {
        primitive.poses.push_back(
            {{numberOf(pose[0], -kFarthest, kFarthest), numberOf(pose[1], -kFarthest, kFarthest)},
             base::wrapToPi(numberOf(pose[2], -10.0, 10.0))});
      }
    }
    isGood_ = isGood_ && !primitive.poses.empty();
    return primitive;
  }

  const LatticeJson& root_;
  bool isGood_ = true;
};

/// Sets the problem's position to the line of the key.
base::Diagnostic placedProblem(const sim2d::nav2::Nav2Parameters& parameters,
                               const std::string& planner, base::Diagnostic problem) {
  problem.file = parameters.file;
  for (const char* const key : {".plugin", ".lattice_filepath"}) {
    for (const sim2d::nav2::KeyUsage& note : parameters.notes.keys) {
      if (note.path == "planner_server." + planner + key && note.line > 0) {
        problem.line = note.line;
        problem.column = note.column;
      }
    }
  }
  return problem;
}

/// Reads a file of nav2_smac_planner's generator. Error: values are missing or out of range.
base::Result<std::shared_ptr<const Lattice>> readLattice(const std::string& file) {
  const base::Result<std::string> text = base::readTextFile(file);
  if (!text) {
    return text.diagnostics();
  }
  const LatticeJson root = LatticeJson::parse(base::shallowJson(*text), nullptr, false);
  std::optional<Lattice> lattice =
      root.is_object() ? LatticeReader(root).read() : std::optional<Lattice>();
  if (!lattice) {
    return {base::error("nav2.bad-lattice", {}, file)};
  }
  lattice->file = file;
  return std::shared_ptr<const Lattice>(std::make_shared<Lattice>(*std::move(lattice)));
}

}  // namespace

Nav2Lattices loadNav2Lattices(sim2d::nav2::Nav2Parameters& parameters) {
  Nav2Lattices found;
  const std::string folder = std::filesystem::path(parameters.file).parent_path().string();
  for (auto& [name, planner] : parameters.planners) {
    auto* const lattice = std::get_if<SmacLatticeParameters>(&planner);
    if (lattice == nullptr) {
      continue;
    }
    const std::string file =
        sim2d::nav2::findReferencedFile(lattice->latticeFilepath, {folder}).file;
    if (file.empty()) {
      found.problems.push_back(placedProblem(
          parameters, name,
          base::warning("nav2.treated-as",
                        {"planner_server." + name, "nav2_smac_planner::SmacPlannerLattice",
                         "nav2_smac_planner::SmacPlannerHybrid",
                         "its file '" + lattice->latticeFilepath + "' was not found"})));
      planner = hybridFallback(*lattice, parameters.distro);
      continue;
    }
    const auto read = readLattice(file);
    base::append(found.problems, read.diagnostics());
    found.files.push_back(file);
    if (read) {
      lattice->lattice = *read;
    }
  }
  return found;
}

}  // namespace bt
