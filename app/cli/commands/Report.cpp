#include <filesystem>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <QPainter>
#include <QSvgRenderer>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/PictureFiles.h"
#include "app/report/Page.h"
#include "app/run/BatchFolder.h"
#include "app/run/ListedFiles.h"
#include "app/run/OutputFolder.h"
#include "sim2d/base/Files.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  report::Wishes wishes;
  std::string metrics, pareto, weights;  // words with commas
  bool noPdf = false;
  bool force = false;
};

/// A batch that has not written its table yet: it runs, or it was killed. Nothing: there is a
/// table, or no batch.
base::Diagnostics batchWithoutEnd(const std::string& folder) {
  std::error_code ignored;
  const fs::path place(folder);
  if (fs::exists(fs::symlink_status(place / "results.csv", ignored)) ||
      !ResultStore::isStore((place / "results.sqlite").string())) {
    return {};
  }
  const base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
  if (!lock) {
    const bool isRunning = lock.diagnostics().front().code == "batch.locked";
    return isRunning ? base::Diagnostics{base::error("report.batch-runs", {}, folder)}
                     : lock.diagnostics();
  }
  const base::Result<std::unique_ptr<ResultStore>> store = readResults(folder);
  if (!store) {
    return store.diagnostics();
  }
  const Study& study = (*store)->study();
  std::vector<std::string> words = {"hunavsim", "batch", study.experimentPath,
                                    "-o",       folder,  "--resume"};
  if (study.shard.count > 1) {
    words.insert(words.end(), {"--shard", study.shard.text()});
  }
  if (study.allowsCode) {
    words.emplace_back("--allow-code");
  }
  if (study.timeLimit > 0.0) {
    words.insert(words.end(), {"--time-limit", base::formatDouble(study.timeLimit)});
  }
  return {base::error(
      "report.batch-cut",
      {(*store)->finished(), study.shard.runsOf(study.runs), report::shellText(words)}, folder)};
}

/// "path_length=2,success=1". What is no number above 0 is told.
base::Diagnostics readWeights(const std::string& words,
                              std::vector<std::pair<std::string, double>>& weights) {
  base::Diagnostics problems;
  for (const std::string& word : base::split(words, ',')) {
    const std::size_t equals = word.find('=');
    const std::string number = equals == std::string::npos ? "" : word.substr(equals + 1);
    const std::optional<double> weight = base::parseDouble(base::trimmed(number));
    if (!weight || !(*weight >= 0.0) || *weight > 1e6) {
      problems.push_back(base::error("report.weights", {word}));
      continue;
    }
    weights.emplace_back(base::trimmed(word.substr(0, equals)), *weight);
  }
  return problems;
}

base::Diagnostics readWords(const ReportOptions& options, report::Wishes& wishes) {
  base::Diagnostics problems;
  if (!options.metrics.empty()) {
    for (const std::string& key : base::split(options.metrics, ',')) {
      wishes.metrics.push_back(base::trimmed(key));
    }
  }
  if (!options.pareto.empty()) {
    const std::vector<std::string> keys = base::split(options.pareto, ',');
    if (keys.size() != 2) {
      problems.push_back(base::error("report.pareto", {options.pareto}));
    } else {
      wishes.paretoX = base::trimmed(keys[0]);
      wishes.paretoY = base::trimmed(keys[1]);
    }
  }
  if (!options.weights.empty()) {
    base::append(problems, readWeights(options.weights, wishes.weights));
  }
  return problems;
}

/// A figure on a page of its size.
std::string pdfOfFigure(const std::string& svg) {
  QSvgRenderer renderer(QByteArray::fromStdString(svg));
  const QSizeF size = renderer.defaultSize();
  return pdfOf(size, [&](QPainter& painter) { renderer.render(&painter, {QPointF(), size}); });
}

/// All files of a report, named in its folder.
std::vector<base::FileContent> filesOf(const report::Report& report, bool withPdf) {
  std::vector<base::FileContent> files = {{"report.html", report.html}};
  for (const report::Figure& figure : report.figures) {
    const std::string svg = figure.standalone();
    files.push_back({"figures/" + figure.name() + ".svg", svg});
    if (withPdf) {
      files.push_back({"figures/" + figure.name() + ".pdf", pdfOfFigure(svg)});
    }
  }
  for (const report::Table& table : report.tables) {
    files.push_back({"tables/" + table.name + ".csv", report::tableCsv(table)});
    files.push_back({"tables/" + table.name + ".tex", report::tableLatex(table)});
  }
  for (const auto& [name, text] : report.moreTables) {
    files.push_back({"tables/" + name + ".csv", text});
  }
  return files;
}

/// Figures and tables of an earlier report, which may hold other metrics.
base::Result<std::vector<std::string>> earlierFiles(const std::string& folder) {
  const base::Result<FileHashes> listed = listedFiles(folder, OutputFolder::kHiddenManifest);
  if (!listed) {
    return listed.diagnostics();
  }
  std::vector<std::string> names;
  for (const auto& [name, hash] : *listed) {
    if (name.rfind("figures/", 0) == 0 || name.rfind("tables/", 0) == 0) {
      names.push_back(name);
    }
  }
  return names;
}

int reportCommand(const ReportOptions& options, const Invocation& given) {
  report::Wishes wishes = options.wishes;
  requireFine(readWords(options, wishes), ExitWrongCommandLine);
  requireFine(batchWithoutEnd(wishes.folder));
  Progress progress(given.quiet || given.json);
  progress.show("reading the results");
  const base::Result<report::Study> study = report::readStudy(wishes);
  requireFine(study.diagnostics());
  std::vector<std::string> words = given.words();
  words.front() = "hunavsim";
  const report::Report report = report::makeReport(
      *study, wishes.weights, words, [&progress](const std::string& what) { progress.show(what); });
  requireFine(report.problems);
  const std::vector<base::FileContent> files = filesOf(report, !options.noPdf);
  const base::Result<std::vector<std::string>> earlier = earlierFiles(options.wishes.folder);
  requireFine(earlier.diagnostics());
  requireFine(writeIntoOthers(options.wishes.folder, files, "report", options.force, *earlier));
  if (given.json) {
    nlohmann::ordered_json written = nlohmann::ordered_json::array();
    for (const base::FileContent& file : files) {
      written.push_back((fs::path(options.wishes.folder) / file.path).string());
    }
    print(base::jsonText(nlohmann::ordered_json{{"written", written}}) + "\n");
  } else if (!given.quiet) {
    printLine((fs::path(options.wishes.folder) / "report.html").string());
  }
  // else it lacks what is there
  return report.problems.empty() && !study->lacksFile ? ExitFine : ExitRunFailed;
}

Drawing drawingOfReport(const ReportOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addReport(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("report", "Tables, statistics and pictures of a batch as one page",
                   reportCommand, drawingOfReport);
  command.add_option("folder", options.wishes.folder, "Folder of a batch")->required();
  command.add_option("--metrics", options.metrics,
                     "Keys to show, with commas (a choice; all are in tables/all_metrics.csv)");
  command.add_option("--compare", options.wishes.compare,
                     "Value path to compare, or \"scenario\" (the planner, else the first varied)");
  command.add_option("--pareto", options.pareto,
                     "Two keys to weigh against each other "
                     "(time_to_reach_goal,minimum_distance_to_people)");
  command.add_option("--weights", options.weights, "KEY=WEIGHT,… of a composite (none)");
  command.add_option("--level", options.wishes.level, "Of intervals (0.95)")
      ->check(CLI::Range(0.5, 0.999));
  command.add_option("--resamples", options.wishes.resamples, "Of the bootstrap (2000)")
      ->check(CLI::Range(100, 100000));
  command.add_flag("--no-pdf", options.noPdf, "Figures as SVG alone");
  addForce(command, options.force);
}

}  // namespace app
