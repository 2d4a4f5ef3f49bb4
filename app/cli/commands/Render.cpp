#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include <QImage>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/Movie.h"
#include "app/cli/PictureFiles.h"
#include "app/cli/RunPicture.h"
#include "app/report/Page.h"
#include "app/run/RunFolder.h"
#include "editor/look/Images.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Trace.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  std::string run;              // folder of a run
  std::string output;           // picture, film or page
  std::optional<double> at;     // [s]
  std::optional<double> width;  // [mm] of vectors, else [px]
  std::optional<double> fps;    // of a film, frames per second
  std::optional<double> speed;  // of a film, in real time
};

enum class Kind { Picture, Vectors, Film, Page };

constexpr double kPixelsPerMm = 96.0 / 25.4;
constexpr double kVectorWidth = 170.0;     // [mm] of two columns
constexpr double kPictureHeight = 1000.0;  // [px] of the usual picture
constexpr double kFilmWidth = 1280.0;      // [px]
constexpr double kMostGifRate = 50.0;      // frames per second that viewers show
constexpr double kFilmRate = 20.0;         // frames per second

std::optional<Kind> kindOf(const std::string& ending) {
  if (ending == ".png") {
    return Kind::Picture;
  }
  if (ending == ".svg" || ending == ".pdf") {
    return Kind::Vectors;
  }
  if (ending == ".html") {
    return Kind::Page;
  }
  return Movie::isName(ending) ? std::optional(Kind::Film) : std::nullopt;
}

std::string endingOf(const RenderOptions& options) {
  return base::lowered(fs::path(options.output).extension().string());
}

/// Options that do nothing for such a file, and numbers that are none.
base::Diagnostics wrongOptions(const RenderOptions& options, Kind kind) {
  base::Diagnostics problems;
  const bool isPicture = kind == Kind::Picture || kind == Kind::Vectors;
  const auto tell = [&](bool isGiven, bool isUseful, const char* option) {
    if (isGiven && !isUseful) {
      problems.push_back(base::error("option.not-of-this-file", {option}, options.output));
    }
  };
  tell(options.at.has_value(), isPicture, "--at");
  tell(options.width.has_value(), kind != Kind::Page, "--width");
  tell(options.fps.has_value(), kind == Kind::Film, "--fps");
  tell(options.speed.has_value(), kind == Kind::Film, "--speed");
  const auto tellNumber = [&](const std::optional<double>& number, const char* option) {
    if (number && !std::isfinite(*number)) {
      problems.push_back(base::error("option.not-positive", {option}));
    }
  };
  tellNumber(options.width, "--width");
  tellNumber(options.fps, "--fps");
  tellNumber(options.speed, "--speed");
  if (options.at && !(*options.at >= 0.0 && std::isfinite(*options.at))) {
    problems.push_back(base::error("option.at"));
  }
  if (endingOf(options) == ".gif" && options.fps.value_or(kFilmRate) > kMostGifRate) {
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
  return layout;
}

std::string bytesOf(const RenderOptions& options, const sim2d::Trace& trace, RunPicture& picture) {
  const Paint paint = [&](QPainter& painter) { picture.paint(painter, options.at); };
  const std::string ending = endingOf(options);
  if (ending == ".svg") {
    return svgOf(picture.size(), QString::fromStdString(trace.header.scenario), paint);
  }
  return ending == ".pdf" ? pdfOf(picture.size(), paint) : pngOf(picture.size(), paint);
}

/// Of even sides, as encoders want them.
QImage frameAt(double time, RunPicture& picture) {
  const auto even = [](double side) { return 2 * static_cast<int>(std::ceil(0.5 * side)); };
  QImage image = editor::blankImage({even(picture.size().width()), even(picture.size().height())},
                                    QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  picture.paint(painter, time);
  painter.end();
  return image;
}

/// False: it was interrupted.
bool makeFilm(const RenderOptions& options, const sim2d::Trace& trace, RunPicture& picture,
              bool quiet) {
  catchInterrupts();
  const double rate = options.fps.value_or(kFilmRate);
  const double step = options.speed.value_or(1.0) / rate;
  const double first = trace.frames.empty() ? 0.0 : trace.frames.front().time;
  const double last = trace.frames.empty() ? 0.0 : trace.frames.back().time;
  const auto count = static_cast<long long>(std::ceil((last - first) / step - 1e-9)) + 1;
  base::Result<std::unique_ptr<Movie>> film = Movie::begin(options.output, rate);
  requireFine(film.diagnostics());
  Progress progress(quiet);
  for (long long k = 0; k < count; ++k) {
    if (wasInterrupted()) {
      return false;
    }
    progress.show("frame " + std::to_string(k + 1) + " of " + std::to_string(count));
    requireFine(
        (*film)->add(frameAt(std::min(last, first + static_cast<double>(k) * step), picture)));
  }
  requireFine((*film)->finish());
  return true;
}

int renderCommand(const RenderOptions& options, const Invocation& given) {
  const std::optional<Kind> kind = kindOf(endingOf(options));
  if (!kind) {
    printError(base::error("option.picture-format", {endingOf(options)}, options.output).text());
    return ExitWrongCommandLine;
  }
  requireFine(wrongOptions(options, *kind), ExitWrongCommandLine);
  const base::Result<sim2d::Trace> trace = readRun(options.run);
  requireFine(trace.diagnostics());
  if (*kind == Kind::Page) {
    const std::string page = report::playerPage(*trace, trace->header.scenario);
    requireFine(base::writeFileAtomically(options.output, page));
  } else {
    RunPicture picture(*trace, layoutOf(options, *kind));
    if (*kind != Kind::Film) {
      requireFine(base::writeFileAtomically(options.output, bytesOf(options, *trace, picture)));
    } else if (!makeFilm(options, *trace, picture, given.quiet)) {
      printError("interrupted: no film was written");
      return ExitRunFailed;
    }
  }
  if (!given.quiet) {
    printLine(options.output);
  }
  return ExitFine;
}

Drawing drawingOf(const RenderOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addRender(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("render", "Draw a recorded run", renderCommand, drawingOf);
  command.add_option("run", options.run, "Folder of the run")->required();
  command
      .add_option("-o,--output", options.output,
                  "Picture (.png, .svg, .pdf), film (.gif; .mp4 and .webm with ffmpeg), or a page "
                  "that plays the run (.html)")
      ->required();
  command.add_option("--at", options.at, "The run up to this time alone [s]");
  command
      .add_option("--width", options.width,
                  "Of .svg and .pdf in mm (170; a column has 85), else in pixels")
      ->check(CLI::Range(50.0, 8000.0));
  command.add_option("--fps", options.fps, "Frames per second of a film (20)")
      ->check(CLI::Range(1.0, 60.0));
  command.add_option("--speed", options.speed, "Of a film, times as fast as the run was (1)")
      ->check(CLI::Range(0.05, 100.0));
}

}  // namespace app
