#include "app/capsule/Texts.h"

#include "app/report/Methods.h"
#include "app/report/Page.h"
#include "app/report/PlayerPage.h"
#include "app/run/DataPaths.h"

namespace capsule {

namespace {

constexpr char kReadme[] =
    R"(This file is a capsule of HuNavSim Desktop: a study with everything that is needed to repeat it.

  hunavsim FILE.hnv            opens the study in the window
  hunavsim verify FILE.hnv     compares all checksums and repeats 5 % of the runs

It is a ZIP archive. Without the program:

  unzip FILE.hnv -d folder && cd folder && sha256sum -c SHA256SUMS

inputs/          scenarios, maps, trees and parameter files, as they lay relative to each other
inputs/shared/   those that are shipped with the program
study/           results: results.csv (one row per run), or the files of a single run
manifest.json    versions, inputs as recorded, SHA-256 of all files
methods.html     text for the methods section of a publication
references.bib   what to cite

The format is described in sim2d/scenario/FORMAT.md of the source code.
)";

/// The facts of a single run: there is nothing to compare.
std::string runMethods(const StudySource& source) {
  std::vector<report::Fact> facts = {
      {"Run created by", "hunavsim " + source.version + " " + source.commit}};
  for (const SourceInput& input : source.inputs) {
    report::addInputs({input.recorded}, facts);
  }
  const std::string body =
      report::element("h1", "", "A simulated run") + report::element("h2", "", "Methods") +
      report::paragraph(
          "The run was simulated with HuNavSim Desktop. All parameters, seeds and sampled values "
          "are listed in study/manifest.json; equal inputs, seed and program give equal files.") +
      report::provenanceMarkup(facts, {});
  return report::htmlPage("A simulated run", body, false);
}

}  // namespace

base::Result<std::vector<ArchiveMember>> textMembers(const StudySource& source) {
  std::string methods;
  if (source.isBatch) {
    report::StudyOptions options;
    options.folder = source.folder;
    const base::Result<report::Study> study = report::readStudy(options);
    if (!study) {
      return study.diagnostics();
    }
    methods = report::methodsPage(*study, {"hunavsim", "verify", "FILE.hnv", "--sample", "100%"});
  } else {
    methods = runMethods(source);
  }
  const std::string references =
      report::filled(report::kReferencesText, {{"version", app::programVersion()}});
  return std::vector<ArchiveMember>{{"README.txt", kReadme, {}, false},
                                    {"methods.html", methods, {}, false},
                                    {"references.bib", references, {}, false}};
}

}  // namespace capsule
