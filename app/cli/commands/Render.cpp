#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include <QImage>
#include <QImageWriter>
#include <QSaveFile>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/RunPicture.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct RenderOptions {
  std::string run;     // folder of a run
  std::string output;  // picture
};

namespace fs = std::filesystem;

base::Diagnostics saveImage(const QImage& image, const std::string& path) {
  std::error_code ignored;  // an impossible folder shows when the file is opened
  fs::create_directories(fs::path(path).parent_path(), ignored);
  QSaveFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::WriteOnly)) {
    return {base::error("file.cannot-write-picture", {file.errorString().toStdString()}, path)};
  }
  QImageWriter writer(&file, "png");
  if (!writer.write(image) || !file.commit()) {
    return {base::error("file.cannot-write-picture", {writer.errorString().toStdString()}, path)};
  }
  return {};
}

int renderCommand(const RenderOptions& options, const OutputOptions& output) {
  const std::string ending = base::lowered(fs::path(options.output).extension().string());
  if (ending != ".png") {
    printError(base::error("option.picture-format", {ending}, options.output).text());
    return kWrongCommandLine;
  }
  const base::Result<sim2d::Trace> trace = sim2d::readTrace(options.run);
  if (!printDiagnostics(trace.diagnostics())) {
    return kBadInput;
  }
  const base::Diagnostics problems = saveImage(drawRun(*trace), options.output);
  if (!printDiagnostics(problems)) {
    return kBadInput;
  }
  if (!output.quiet) {
    printLine(options.output);
  }
  return kFine;
}

}  // namespace

void addRender(CommandRegistry& commands) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App& command = commands.add(
      "render", "Draw a recorded run",
      [options](const Invocation& given) { return renderCommand(*options, given.output); },
      [] { return Drawing::Pictures; });
  command.add_option("run", options->run, "Folder of the run")->required();
  command.add_option("-o,--output", options->output, "Picture (.png)")->required();
}

}  // namespace app
