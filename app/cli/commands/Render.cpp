#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/bridge/bag/RunBagWriter.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/PictureFiles.h"
#include "app/cli/RunExport.h"
#include "app/cli/RunPicture.h"
#include "app/report/PlayerPage.h"
#include "app/report/RunPictures.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OutputFolder.h"
#include "app/run/RecordedRun.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/trace/TrackImport.h"

namespace app {

namespace {

namespace fs = std::filesystem;

/// All overlays except those that a recording does not contain.
std::vector<std::string> recordedOverlayNames() {
  std::vector<std::string> names = figureOverlayNames();
  names.erase(std::remove(names.begin(), names.end(), "forces"), names.end());
  return names;
}

struct RenderOptions {
  std::string run;              // run folder
  std::string output;           // picture, film or page
  std::optional<double> at;     // [s]
  std::optional<double> width;  // [mm] of vector formats, otherwise [px]
  std::optional<double> fps;    // of a film, frames per second
  std::optional<double> speed;  // of a film, relative to real time
  std::vector<std::string> overlays;
  std::optional<double> timeMarks;  // [s] between two
  std::string strip;                // a number of instants, or their times
  std::string plot;                 // keys of metrics
  std::string theme;                // light or dark; empty: light
  bool force = false;               // overwrite files not created by hunavsim
};

enum class Kind { Picture, Vectors, Film, Page, Bag, Trajnet, Socnav3 };

/// The kinds of files, by extension.
const std::map<std::string, Kind>& kindsOfFiles() {
  static const std::map<std::string, Kind> kKinds = {
      {".png", Kind::Picture}, {".svg", Kind::Vectors},    {".pdf", Kind::Vectors},
      {".gif", Kind::Film},    {".mp4", Kind::Film},       {".webm", Kind::Film},
      {".webp", Kind::Film},   {".html", Kind::Page},      {".mcap", Kind::Bag},
      {".db3", Kind::Bag},     {".ndjson", Kind::Trajnet}, {".json", Kind::Socnav3}};
  return kKinds;
}

std::string endingOf(const RenderOptions& options) {
  return base::toLower(fs::path(options.output).extension().string());
}

/// Errors for options that do not apply to this file, and for non-finite numbers.
base::Diagnostics wrongOptions(const RenderOptions& options, Kind kind) {
  base::Diagnostics problems;
  const bool isPicture = kind == Kind::Picture || kind == Kind::Vectors;
  const auto checkApplies = [&](bool isGiven, bool isUseful, const char* option) {
    if (isGiven && !isUseful) {
      problems.push_back(base::error("option.not-of-this-file", {option}, options.output));
    }
  };
  checkApplies(options.at.has_value(), isPicture, "--at");
  const bool isDrawn = isPicture || kind == Kind::Film;
  checkApplies(options.width.has_value(), isDrawn, "--width");
  const bool isSampled = kind == Kind::Film || kind == Kind::Trajnet || kind == Kind::Socnav3;
  checkApplies(options.fps.has_value(), isSampled, "--fps");
  checkApplies(options.speed.has_value(), kind == Kind::Film, "--speed");
  const bool isPlot = !options.plot.empty();
  checkApplies(!options.overlays.empty(), isDrawn && !isPlot, "--overlay");
  checkApplies(options.timeMarks.has_value(), isDrawn && !isPlot, "--time-marks");
  checkApplies(!options.theme.empty(), isDrawn && !isPlot, "--theme");
  checkApplies(!options.strip.empty(), isPicture && !isPlot && !options.at, "--strip");
  checkApplies(isPlot, isPicture, "--plot");
  const auto checkFinite = [&](const std::optional<double>& number, const char* option) {
    if (number && !std::isfinite(*number)) {
      problems.push_back(base::error("option.not-positive", {option}));
    }
  };
  checkFinite(options.width, "--width");
  checkFinite(options.fps, "--fps");
  checkFinite(options.speed, "--speed");
  checkFinite(options.timeMarks, "--time-marks");
  if (options.at && !(*options.at >= 0.0 && std::isfinite(*options.at))) {
    problems.push_back(base::error("option.at"));
  }
  if (endingOf(options) == ".gif" && options.fps.value_or(0.0) > kMaxGifRate) {
    problems.push_back(base::error("option.gif-rate", {}, options.output));
  }
  return problems;
}

PictureLayout layoutOf(const RenderOptions& options, Kind kind) {
  PictureLayout layout;
  if (kind == Kind::Vectors) {
    layout.width = options.width.value_or(kVectorWidth) * kPixelsPerMm;
    layout.textAsOutlines = endingOf(options) == ".svg";
  } else if (kind == Kind::Film) {
    layout.width = options.width.value_or(kFilmWidth);
  } else if (options.width) {
    layout.width = *options.width;
  } else {
    layout.height = kPictureHeight;
  }
  for (const std::string& name : options.overlays) {
    const std::vector<std::string>& names = figureOverlayNames();
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    layout.options.overlays.insert(static_cast<FigureOverlay>(at));
  }
  layout.options.timeMarks = options.timeMarks.value_or(0.0);
  layout.options.isDark = options.theme == "dark";
  return layout;
}

/// "5": number of equidistant instants; "0,2.5,8": times [s].
std::vector<double> stripTimes(const std::string& words, const sim2d::Trace& trace) {
  constexpr int kMaxInstants = 24;
  std::vector<double> times;
  bool isFine = true;
  for (const std::string& word : base::split(words, ',')) {
    const std::optional<double> time = base::parseDouble(word);
    isFine = isFine && time && *time >= 0.0 && std::isfinite(*time);
    times.push_back(time.value_or(0.0));
  }
  const bool isCount = times.size() == 1;
  const bool isWhole = isCount && times.front() == std::floor(times.front());
  if (!isFine || times.size() > kMaxInstants ||
      (isCount && !(isWhole && times.front() >= 1.0 && times.front() <= kMaxInstants))) {
    requireFine({base::error("option.strip", {words})}, ExitWrongCommandLine);
  }
  return isCount ? equidistantTimes(trace, static_cast<int>(times.front())) : times;
}

/// The series of these metrics over the run, with the settings of its scenario.
std::vector<report::TimeCurve> plotCurves(const std::string& keys, const sim2d::Trace& trace) {
  MetricsSetup setup;
  base::Diagnostics wrong;
  base::Diagnostics problems = readMetricsSetup(trace.header, setup);
  MetricsOptions words;
  words.metrics = keys;
  base::append(problems, applyMetricsOptions(words, setup, wrong));
  requireFine(wrong, ExitWrongCommandLine);
  requireFine(problems);
  setup.selection.behaviors = false;
  const base::Result<metrics::Evaluation> evaluation =
      metrics::evaluate(trace, setup.selection, setup.parameters);
  requireFine(evaluation.diagnostics());
  std::vector<report::TimeCurve> curves;
  for (const metrics::MetricResult& result : evaluation->results) {
    if (!result.value.series) {
      problems.push_back(base::error("option.plot-series", {result.info.key}));
      continue;
    }
    // A count per sample, such as 0 or 1, does not have the unit of the metric.
    const bool isCount = result.value.series->kind == metrics::Kind::Count;
    curves.push_back({result.info.name, isCount ? "count per step" : result.info.unit,
                      evaluation->times, result.value.series->values});
  }
  requireFine(problems, ExitWrongCommandLine);
  return curves;
}

/// The file content of a figure of this size.
std::string fileOf(const RenderOptions& options, const sim2d::Trace& trace, const RunFigure& figure,
                   const Paint& paint) {
  return runFigureFile(figure, paint, endingOf(options), trace.header.scenario);
}

std::string bytesOf(const RenderOptions& options, const sim2d::Trace& trace,
                    const PictureLayout& layout) {
  if (!options.plot.empty()) {
    const std::string caption =
        trace.header.scenario + " · seed " + std::to_string(trace.header.seed);
    return figureFile(
        report::timePlot(plotCurves(options.plot, trace), layout.width, caption, options.at),
        endingOf(options));
  }
  if (!options.strip.empty()) {
    RunStrip strip(trace, layout, stripTimes(options.strip, trace));
    return fileOf(options, trace, strip, [&](QPainter& painter) { strip.paint(painter); });
  }
  RunPicture picture(trace, layout);
  return fileOf(options, trace, picture,
                [&](QPainter& painter) { picture.paint(painter, options.at); });
}

/// False: interrupted.
bool makeFilm(const RenderOptions& options, const sim2d::Trace& trace, RunPicture& picture,
              bool quiet) {
  catchInterrupts();
  FilmTiming timing;
  timing.framesPerSecond = options.fps.value_or(timing.framesPerSecond);
  timing.speed = options.speed.value_or(timing.speed);
  timing.from = trace.frames.empty() ? 0.0 : trace.frames.front().time;
  timing.to = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  Progress progress(quiet);
  const base::Result<bool> isComplete =
      writeFilm(options.output, picture, timing, [&progress](long long frame, long long count) {
        progress.show("frame " + std::to_string(frame) + " of " + std::to_string(count));
        return !wasInterrupted();
      });
  requireFine(isComplete.diagnostics());
  return *isComplete;
}

base::Diagnostics writeBag(const std::string& path, const std::string& run) {
  const base::Result<RecordedRun> recorded = readRecordedRun(run);
  if (!recorded) {
    return recorded.diagnostics();
  }
  const std::string file = (fs::path(run) / "scans.csv").string();
  std::error_code none;  // most runs have no recorded scans
  if (!fs::exists(file, none)) {
    return bridge::writeRunBag(path, *recorded->recording);
  }
  const base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  const auto scans = sim2d::parseScans(*text, file);
  return scans ? bridge::writeRunBag(path, *recorded->recording, *scans) : scans.diagnostics();
}

/// Writes the run in a third-party format.
void writeTracks(const RenderOptions& options, Kind kind, const sim2d::Trace& trace, bool quiet) {
  const double rate = options.fps.value_or(0.0);
  const base::Result<std::string> text =
      kind == Kind::Trajnet ? sim2d::trajnetText(trace, rate) : sim2d::socnav3Text(trace, rate);
  requireFine(text.diagnostics(), ExitBadInput,
              quiet ? base::Severity::Warning : base::Severity::Info);
  requireFine(writeFile(options.output, *text, options.force));
}

std::string pageOf(const sim2d::Trace& trace) {
  MetricsSetup setup;
  requireFine(readMetricsSetup(trace.header, setup));
  return report::playerPage(trace, metrics::robotContacts(trace, setup.selection, setup.parameters),
                            trace.header.scenario);
}

void drawRun(const RenderOptions& options, Kind kind, bool quiet) {
  if (kind == Kind::Bag) {
    requireFine(checkOverwrite(options.output, options.force));
    requireFine(writeBag(options.output, options.run));
    return;
  }
  const base::Result<sim2d::Trace> trace = readRun(options.run);
  requireFine(trace.diagnostics());
  if (kind == Kind::Trajnet || kind == Kind::Socnav3) {
    writeTracks(options, kind, *trace, quiet);
    return;
  }
  if (kind == Kind::Page) {
    requireFine(writeFile(options.output, pageOf(*trace), options.force));
    return;
  }
  const PictureLayout layout = layoutOf(options, kind);
  if (kind != Kind::Film) {
    requireFine(writeFile(options.output, bytesOf(options, *trace, layout), options.force));
    return;
  }
  requireFine(checkOverwrite(options.output, options.force));
  RunPicture picture(*trace, layout);
  if (!makeFilm(options, *trace, picture, quiet)) {
    requireFine({base::error("movie.interrupted", {}, options.output)}, ExitRunFailed);
  }
}

int renderCommand(const RenderOptions& options, const Invocation& given) {
  const auto found = kindsOfFiles().find(endingOf(options));
  if (found == kindsOfFiles().end()) {
    requireFine({base::error("option.picture-format", {endingOf(options)}, options.output)},
                ExitWrongCommandLine);
  }
  const Kind kind = found->second;
  requireFine(wrongOptions(options, kind), ExitWrongCommandLine);
  drawRun(options, kind, given.quiet);
  requireFine(recordOutputFile(options.output, "render"));
  if (given.json) {
    print(base::jsonText(nlohmann::ordered_json{{"written", {options.output}}}) + "\n");
  } else if (!given.quiet) {
    printLine(options.output);
  }
  return ExitFine;
}

Drawing drawingOf(const RenderOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addRender(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "render", "Render a recorded run as a picture, video, web page, bag or trajectory file",
      renderCommand, drawingOf);
  command.add_option("run", options.run, "Folder of the run")->required();
  command
      .add_option(
          "-o,--output", options.output,
          "Output file: picture (.png, .svg, .pdf), video (.gif; .mp4, .webm and .webp with "
          "ffmpeg), web page that plays the run (.html), bag for ROS 2 and Foxglove "
          "(.mcap, .db3), or trajectories for TrajNet++ (.ndjson) or SocNav3 (.json)")
      ->required();
  command.add_option("--at", options.at, "Render only up to this time [s]");
  command
      .add_option("--width", options.width,
                  "Width in mm for .svg and .pdf (default: 170; one column: 85), otherwise in "
                  "pixels")
      ->check(CLI::Range(50.0, 8000.0));
  command
      .add_option(
          "--overlay", options.overlays,
          "Overlays on the map, comma-separated: density, zones, gaussian, velocities, contacts "
          "(forces are not recorded; the window shows them during a run)")
      ->delimiter(',')
      ->check(oneOf(recordedOverlayNames()));
  command.add_option("--theme", options.theme, "Colours: light (default) or dark")
      ->check(oneOf({"light", "dark"}));
  command
      .add_option("--time-marks", options.timeMarks,
                  "Draw a dot on each trajectory at this interval [s]")
      ->check(CLI::Range(0.01, 1e6));
  command.add_option("--strip", options.strip,
                     "Draw several instants side by side: their number, or their comma-separated "
                     "times [s]");
  command.add_option("--plot", options.plot,
                     "Draw metrics over time instead of the map: comma-separated keys");
  addForce(command, options.force);
  command
      .add_option("--fps", options.fps,
                  "Frames per second of a video (default: 20); samples per second of .ndjson "
                  "(default: 2.5) and .json (default: all states)")
      ->check(CLI::Range(1.0, 60.0));
  command.add_option("--speed", options.speed, "Playback speed of a video (default: 1)")
      ->check(CLI::Range(0.05, 100.0));
  commands.addExamples(
      command,
      {{"hunavsim render out -o out.png", "Draw the trajectories of a run"},
       {"hunavsim render out -o strip.pdf --strip 4 --force",
        "Draw four instants side by side for a paper"},
       {"hunavsim render out -o out.mp4 --speed 2", "Make a video at twice the speed", "ffmpeg"}});
}

}  // namespace app
