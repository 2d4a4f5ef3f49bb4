#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "bt/human/Templates.h"
#include "sim2d/base/Files.h"
#include "sim2d/scenario/Export.h"

namespace app {

struct ExportRequest {
  std::string target = "native";
  std::optional<sim2d::Dialect> dialect;
  bt::TreeStyle style = bt::TreeStyle::Corrected;  // of trees that are generated
  std::string folder;
};

/// What an export would write; nothing is written yet.
struct ExportPlan {
  enum class State { New, Replaced, Unchanged };
  struct File {
    std::string name;  // in the folder of the request
    base::FileContent content;
    State state = State::New;
  };
  std::vector<File> files;
  base::Diagnostics report;  // errors: it cannot be done
  std::string startCommand;
};

/// What becomes of the file at `path` when it gets this content.
ExportPlan::State stateOf(const std::string& path, const std::string& content);
const char* stateName(ExportPlan::State state);  // "written", "replaced", "unchanged"

/// The scenario of a bundle for another simulator, with its map and trees, whose texts it has.
ExportPlan planExport(const Bundle& source, const ExportRequest& request);
/// Where BehaviorTree.CPP 4.10 treats the trees in files of a bundle differently.
base::Diagnostics notesOnTrees(const Bundle& source);
/// All files or none.
base::Diagnostics writeExport(const ExportPlan& plan);

/// The scenario of `options` with what belongs to it. What a check refuses is not handed on, but
/// for a map that is lost.
base::Result<Bundle> readExportSource(const RunOptions& options, const sim2d::ImageLoader& loader);

/// The report as a person reads it: what is said of several people in the same words is one line,
/// "7 people: start_time is not known there".
struct ReportLine {
  base::Diagnostic said;
  std::vector<std::string> people;  // whom it is about, when they are several
};
std::vector<ReportLine> groupedByPeople(const base::Diagnostics& report);

}  // namespace app
