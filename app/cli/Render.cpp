#include <filesystem>

#include <QImage>
#include <QImageWriter>
#include <QSaveFile>

#include "app/cli/CommandLine.h"
#include "app/cli/Commands.h"
#include "app/cli/Console.h"
#include "app/cli/RunPicture.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

base::Diagnostics saveImage(const QImage& image, const std::string& path) {
  std::error_code ignored;  // an impossible folder shows when the file is opened
  fs::create_directories(fs::path(path).parent_path(), ignored);
  QSaveFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::WriteOnly)) {
    return {base::makeError("cannot write: " + file.errorString().toStdString(), path)};
  }
  QImageWriter writer(&file, "png");
  if (!writer.write(image) || !file.commit()) {
    return {base::makeError("cannot write: " + writer.errorString().toStdString(), path)};
  }
  return {};
}

}  // namespace

int renderCommand(const RenderOptions& options, const OutputOptions& output) {
  const std::string ending = base::lowered(fs::path(options.output).extension().string());
  if (ending != ".png") {
    printError(base::makeError("cannot draw '" + ending + "' files (use a name that ends in .png)",
                               options.output)
                   .text());
    return kWrongCommandLine;
  }
  const base::Result<sim2d::Trace> trace = sim2d::readTrace(options.run);
  printDiagnostics(trace.diagnostics());
  if (!trace) {
    return kBadInput;
  }
  const base::Diagnostics problems = saveImage(drawRun(*trace), options.output);
  printDiagnostics(problems);
  if (base::hasErrors(problems)) {
    return kBadInput;
  }
  if (!output.quiet) {
    printLine(options.output);
  }
  return kFine;
}

}  // namespace app
