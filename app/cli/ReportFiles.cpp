#include "app/cli/ReportFiles.h"

#include "app/cli/PictureFiles.h"
#include "app/report/SensitivityPage.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"

namespace app {

namespace {

/// Figures and tables of an earlier report, which may contain other metrics.
base::Result<std::vector<std::string>> earlierFiles(const std::string& folder) {
  const base::Result<Manifest> manifest = readManifest(folder, Manifest::kHiddenName);
  if (!manifest) {
    return manifest.diagnostics();
  }
  std::vector<std::string> names;
  for (const auto& [name, hash] : manifest->outputs) {
    if (name.rfind("figures/", 0) == 0 || name.rfind("tables/", 0) == 0) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace

std::vector<base::FileContent> filesOf(const report::Report& report, bool withPdf) {
  std::vector<base::FileContent> files = {{"report.html", report.html}};
  for (const report::Figure& figure : report.figures) {
    files.push_back({"figures/" + figure.name() + ".svg", figure.standalone()});
    if (withPdf) {
      files.push_back({"figures/" + figure.name() + ".pdf", figureFile(figure, ".pdf")});
    }
  }
  for (const report::Table& table : report.tables) {
    files.push_back({"tables/" + table.name + ".csv", report::tableCsv(table)});
    files.push_back({"tables/" + table.name + ".tex", report::tableLatex(table)});
  }
  for (const auto& [name, text] : report.moreTables) {
    files.push_back({"tables/" + name + ".csv", text});
  }
  for (const auto& [name, text] : report.moreFiles) {
    files.push_back({name, text});
  }
  return files;
}

base::Result<report::Report> sensitivityReport(const report::Study& study,
                                               const std::vector<std::string>& command) {
  const base::Result<report::SensitivityAnalysis> analysis = report::analyseSensitivity(study);
  return analysis ? report::makeSensitivityReport(study, *analysis, command)
                  : base::Result<report::Report>(analysis.diagnostics());
}

base::Diagnostics writeReport(const std::string& folder,
                              const std::vector<base::FileContent>& files, bool force) {
  const base::Result<std::vector<std::string>> earlier = earlierFiles(folder);
  return earlier ? writeIntoForeignFolder(folder, files, "report", force, *earlier)
                 : earlier.diagnostics();
}

}  // namespace app
