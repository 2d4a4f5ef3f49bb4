#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <malloc.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include "app/cli/BenchScene.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/PictureFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/Lidar.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/crowd/CrowdForces.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

struct BenchOptions {
  bool quick = false;  // small crowds, short
  int threads = 1;
  std::string format = "text";  // text, csv
  std::string picture;          // picture file, or empty
};

constexpr int kBeams = 360;
constexpr int kRounds = 5;
constexpr int kMaxPlainPeople = 10000;  // people; beyond it the plain sum is scaled with N²

/// The value of the first line "<key> : <value>" in a /proc file; empty if missing.
std::string procFileValue(const char* file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && base::trimmed(line.substr(0, colon)) == key) {
      return base::trimmed(line.substr(colon + 1));
    }
  }
  return {};
}

/// A memory size of this process, "VmRSS" or "VmHWM" [kB]; 0 if unavailable.
double memoryOf(const char* key) {
  const std::string text = procFileValue("/proc/self/status", key);
  return base::parseDouble(text.substr(0, text.find(' '))).value_or(0.0);
}

/// Resets "VmHWM", the peak of resident memory.
void resetPeakMemory() {
  malloc_trim(0);  // otherwise memory freed by smaller scenes would be reused without being counted
  std::ofstream("/proc/self/clear_refs") << "5";
}

struct BenchRow {
  BenchScene scene;
  sim2d::StepTimes times;
  double sensing = 0.0;    // a scan of the robot [s]
  double recording = 0.0;  // per step [s]
  double plain = 0.0;      // a step of the plain forces [s]; 0: not measured
  bool isScaled = false;   // `plain` is extrapolated
  double perPerson = 0.0;  // peak memory per person [kB]
  double peak = 0.0;       // of the process during this scene [MB]

  double perStep(double seconds) const { return seconds / static_cast<double>(times.steps); }
  /// Step, scan and recording [s].
  double whole() const { return perStep(times.sum()) + sensing + recording; }
  double realTimeFactor() const { return 0.05 / whole(); }
  double forces() const {
    return perStep(times.seconds[static_cast<std::size_t>(sim2d::StepPhase::Forces)]);
  }
};

double scanSeconds(const sim2d::World& world, const sim2d::Surroundings& surroundings,
                   sim2d::StepClock clock) {
  const sim2d::Frame& frame = world.frame();
  std::vector<sim2d::SensedBody> bodies;
  bodies.reserve(frame.humans.size());
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    bodies.push_back({frame.humans.id[i],
                      sim2d::BodyKind::Person,
                      {frame.humans.x[i], frame.humans.y[i]},
                      frame.humans.heading[i],
                      {frame.humans.vx[i], frame.humans.vy[i]},
                      0.25});
  }
  sim2d::LidarParameters parameters;
  parameters.beams = kBeams;
  parameters.legs = false;
  sim2d::Lidar lidar(parameters, 1, -1);
  const base::Pose2 pose = world.view().robotPose(0);
  lidar.update({pose, pose, surroundings.obstacles, bodies, 0.0});  // caches the walls
  const double begin = sim2d::clockSeconds(clock);
  lidar.update({pose, pose, surroundings.obstacles, bodies, 1.0 / parameters.rate});
  return sim2d::clockSeconds(clock) - begin;
}

/// Creates a world and steps it until people have reached their speed.
base::Result<std::unique_ptr<sim2d::World>> makeWarmWorld(const BenchScene& scene) {
  constexpr int kWarmUp = 10;
  base::Result<std::unique_ptr<sim2d::World>> made = makeBenchWorld(scene);
  for (int i = 0; made && i < kWarmUp; ++i) {
    (*made)->step();
  }
  return made;
}

/// Peak memory of a scene with one person [kB].
double peakMemoryOfOnePerson(BenchScene scene) {
  scene.singlePerson = true;
  resetPeakMemory();
  const double before = memoryOf("VmRSS");
  const base::Result<std::unique_ptr<sim2d::World>> made = makeWarmWorld(scene);
  return memoryOf("VmHWM") - before;
}

/// Measures some steps; false if the run failed.
bool measureRound(sim2d::World& world, const sim2d::Surroundings& surroundings,
                  double atLeastSeconds, BenchRow& row) {
  constexpr int kMinSteps = 2;
  const int lastStep = crossingSteps(row.scene);
  const sim2d::StepClock clock = row.times.clock;
  world.measure(&row.times);
  sim2d::Recording recorded;
  double recording = 0.0;
  const double end = sim2d::clockSeconds(clock) + atLeastSeconds;
  while (row.times.steps < kMinSteps ||
         (world.stepIndex() < lastStep && sim2d::clockSeconds(clock) < end)) {
    if (!world.step()) {
      return false;
    }
    row.sensing += scanSeconds(world, surroundings, clock);
    const double record = sim2d::clockSeconds(clock);
    recorded.append(world.frame());
    recording += sim2d::clockSeconds(clock) - record;
  }
  world.measure(nullptr);
  row.sensing = row.perStep(row.sensing);
  row.recording = row.perStep(recording);
  return true;
}

/// The fastest of several rounds, because other processes only slow a round down.
base::Result<BenchRow> measure(const BenchScene& scene, double atLeastSeconds) {
  BenchRow row;
  row.scene = scene;
  row.times.clock = scene.threads == 1 ? sim2d::StepClock::Thread : sim2d::StepClock::Wall;
  const double ofOne = peakMemoryOfOnePerson(scene);
  resetPeakMemory();
  const double before = memoryOf("VmRSS");
  base::Result<std::unique_ptr<sim2d::World>> made = makeWarmWorld(scene);
  if (!made) {
    return made.diagnostics();
  }
  row.perPerson = (memoryOf("VmHWM") - before - ofOne) / (scene.people - 1);
  const sim2d::Surroundings surroundings =
      sim2d::makeSurroundings(makeBenchScenario(scene), sim2d::OccupancyGrid{});
  BenchRow best = row;
  for (int round = 0; round < kRounds; ++round) {
    if ((*made)->stepIndex() > crossingSteps(scene) / 2) {
      made->reset();  // two worlds at a time would increase the peak memory
      made = makeWarmWorld(scene);
    }
    if (!made) {
      return made.diagnostics();
    }
    BenchRow now = row;
    if (!measureRound(**made, surroundings, atLeastSeconds / kRounds, now)) {
      return base::error("run.failed", {(*made)->failure()});
    }
    best = round == 0 || now.whole() < best.whole() ? now : best;
  }
  best.peak = memoryOf("VmHWM") / 1024.0;
  return best;
}

/// With three significant digits.
std::string threeDigits(double value) {
  if (value == 0.0) {
    return "0";
  }
  const int digits = 2 - static_cast<int>(std::floor(std::log10(std::fabs(value))));
  const double factor = std::pow(10.0, std::max(0, digits));
  return base::formatDouble(std::round(value * factor) / factor);
}

std::vector<std::string> headline() {
  std::vector<std::string> names = {"people", "scene", "x real time", "ns/person"};
  for (std::size_t i = 0; i < sim2d::kStepPhaseCount; ++i) {
    names.emplace_back(sim2d::stepPhaseName(static_cast<sim2d::StepPhase>(i)));
  }
  names.insert(names.end(), {"sensing", "recording", "plain", "plain/forces", "plain/step",
                             "kB/person", "peak MB"});
  return names;
}

/// Times of phases in ms per step.
std::vector<std::string> cellsOf(const BenchRow& row) {
  std::vector<std::string> cells = {
      std::to_string(row.scene.people), row.scene.walls ? "200 walls" : "open",
      threeDigits(row.realTimeFactor()), threeDigits(row.whole() / row.scene.people * 1e9)};
  for (const double seconds : row.times.seconds) {
    cells.push_back(threeDigits(row.perStep(seconds) * 1e3));
  }
  cells.insert(cells.end(),
               {threeDigits(row.sensing * 1e3), threeDigits(row.recording * 1e3),
                threeDigits(row.plain * 1e3) + (row.isScaled ? "*" : ""),
                threeDigits(row.plain / row.forces()), threeDigits(row.plain / row.whole()),
                threeDigits(row.perPerson), threeDigits(row.peak)});
  return cells;
}

std::string textLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t width = i == 2 || i > 12 ? 13 : 10;
    line += std::string(cells[i].size() < width ? width - cells[i].size() : 1, ' ') + cells[i];
  }
  return line;
}

std::string csvLine(const std::vector<std::string>& cells, const std::string& machine) {
  return "\"" + machine + "\"," + base::join(cells, ",");
}

std::string machineName() {
  const std::string processor = procFileValue("/proc/cpuinfo", "model name");
  return (processor.empty() ? std::string("unknown processor") : processor) + ", " +
         sim2d::simdLevelName(sim2d::fastestSimdLevel());
}

/// A row as JSON; numeric cells are numbers.
Json jsonOf(const std::vector<std::string>& cells) {
  const std::vector<std::string> keys = headline();
  Json row;
  for (std::size_t k = 0; k < cells.size() && k < keys.size(); ++k) {
    const std::optional<double> number = base::parseDouble(cells[k]);
    row[keys[k]] = number ? Json(*number) : Json(cells[k]);
  }
  return row;
}

using ShowCells = std::function<void(const std::vector<std::string>&)>;

/// Measures all sizes, without and with walls; nullopt if a run failed.
std::optional<std::vector<BenchPoint>> measureSizes(const BenchOptions& options,
                                                    const std::string& tree,
                                                    const ShowCells& show) {
  const std::vector<int> sizes = options.quick ? std::vector<int>{10, 100, 1000}
                                               : std::vector<int>{10, 100, 1000, 10000, 100000};
  const double atLeast = options.quick ? 0.3 : 2.0;
  double plain = 0.0;
  peakMemoryOfOnePerson(
      {sizes.front(), true, tree, options.threads});  // loads program code into memory first
  std::vector<BenchPoint> points;
  for (const int people : sizes) {
    BenchScene scene{people, false, tree, options.threads};
    const bool isScaled = people > kMaxPlainPeople;
    plain = isScaled ? plain * std::pow(static_cast<double>(people) / kMaxPlainPeople, 2.0)
                     : plainStepSeconds(makeBenchScenario(scene), atLeast / 4.0);
    for (const bool walls : {false, true}) {
      scene.walls = walls;
      base::Result<BenchRow> row = measure(scene, atLeast);
      if (!row) {
        printDiagnostics(row.diagnostics());
        return std::nullopt;
      }
      row->plain = plain;
      row->isScaled = isScaled;
      show(cellsOf(*row));
      if (!walls) {
        points.push_back({people, row->whole() * 1e3, row->forces() * 1e3, plain * 1e3, isScaled});
      }
    }
  }
  return points;
}

int benchCommand(const BenchOptions& options, const Invocation& given) {
  // Returns freed memory to the system, so that earlier scenes leave no reusable memory.
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  QTemporaryDir folder;
  const std::string tree = folder.filePath(QStringLiteral("walker.xml")).toStdString();
  if (!(std::ofstream(tree) << benchTreeText()).flush()) {
    printError("cannot write " + tree);
    return ExitRunFailed;
  }
  const bool isCsv = options.format == "csv" && !given.json;
  if (isCsv) {
    printLine(csvLine(headline(), "machine"));
  } else if (!given.json) {
    printLine(machineName() + ", threads: " + std::to_string(options.threads));
    printLine(textLine(headline()));
  }
  Json rows = Json::array();
  const std::optional<std::vector<BenchPoint>> points =
      measureSizes(options, tree, [&](const std::vector<std::string>& cells) {
        if (given.json) {
          rows.push_back(jsonOf(cells));
        } else {
          printLine(isCsv ? csvLine(cells, machineName()) : textLine(cells));
        }
      });
  if (!points) {
    return ExitRunFailed;
  }
  if (given.json) {
    print(base::jsonText(
              Json{{"machine", machineName()}, {"threads", options.threads}, {"rows", rows}}) +
          "\n");
  } else if (!isCsv && !given.quiet) {
    printLine(
        "Phases: ms per step of 0.05 s, fastest of 5 rounds; with one thread, CPU time. sensing: a "
        "scan of 360 beams. plain: the same forces as a naive sum over all pairs in double "
        "precision, one thread; * extrapolated quadratically. Measured while the streams cross, "
        "after people have walked at most a seventh of the square. kB/person: increase of peak "
        "memory per person, from the creation of the scenario to the tenth step.");
  }
  if (!options.picture.empty()) {
    constexpr double kSharp = 2.0;  // image pixels per pixel
    const std::string ending = std::filesystem::path(options.picture).extension().string();
    if (!base::writeFileAtomically(options.picture,
                                   figureFile(benchFigure(*points, machineName()), ending, kSharp))
             .empty()) {
      printError("cannot write " + options.picture);
      return ExitRunFailed;
    }
  }
  return ExitFine;
}

Drawing drawingOf(const BenchOptions& options) {
  return options.picture.empty() ? Drawing::None : Drawing::Pictures;
}

/// Returns an error text, empty if the file name is valid.
std::string pictureFileError(const std::string& path) {
  const QFileInfo file(QString::fromStdString(path));
  const QStringList endings = {QStringLiteral("png"), QStringLiteral("svg"), QStringLiteral("pdf")};
  if (!endings.contains(file.suffix())) {
    return "'" + path + "' does not end in .png, .svg or .pdf";
  }
  return file.absoluteDir().exists() ? std::string() : "the folder does not exist: '" + path + "'";
}

}  // namespace

void addBench(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "bench", "Measure the simulation speed of this machine", benchCommand, drawingOf);
  command.add_flag("--quick", options.quick,
                   "Measure only up to 1000 people, within a few seconds");
  command.add_option("--threads", options.threads, "Number of threads")->check(CLI::Range(1, 256));
  command.add_option("--format", options.format, "Output format: text or csv")
      ->check(oneOf({"text", "csv"}));
  command.add_option("--picture", options.picture, "Draw the results to FILE.png, .svg or .pdf")
      ->check(pictureFileError);
  commands.addExamples(command, {{"hunavsim bench --quick", "Measure the speed of this machine",
                                  "an idle machine"}});
}

}  // namespace app
