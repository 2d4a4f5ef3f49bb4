#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "bt/human/TreeGenerator.h"
#include "sim2d/base/Files.h"
#include "sim2d/scenario/Export.h"

namespace app {

struct ExportRequest {
  std::string target = "native";
  std::optional<sim2d::Dialect> dialect;
  bt::TreeStyle style = bt::TreeStyle::Corrected;  // of generated trees
  std::string folder;
};

/// The files of an export before they are written.
struct ExportPlan {
  enum class State { New, Replaced, Unchanged };
  struct File {
    std::string name;  // relative to the folder of the request
    base::FileContent content;
    State state = State::New;
  };
  std::vector<File> files;
  base::Diagnostics report;  // with errors, the export is impossible
  std::string startCommand;
};

/// The effect of writing this content to `path`.
ExportPlan::State fileStateOf(const std::string& path, const std::string& content);
const char* fileStateName(ExportPlan::State state);  // "written", "replaced", "unchanged"

/// Exports the scenario of a bundle to another simulator, with its map and trees, whose text the
/// bundle contains.
ExportPlan planExport(const Bundle& source, const ExportRequest& request);
/// Where BehaviorTree.CPP 4.10 executes the bundle's tree files differently.
base::Diagnostics treeCompatibilityNotes(const Bundle& source);
/// Writes all files or none.
base::Diagnostics writeExport(const ExportPlan& plan);

/// The scenario of `spec` with its map and trees. Errors of the check make the export fail, except
/// a missing map.
base::Result<Bundle> readExportSource(const RunSpec& spec, const sim2d::ImageLoader& loader);

/// The report as users read it: equal messages about several agents are one line, "7 people:
/// start_time is not known there".
struct GroupedDiagnostic {
  base::Diagnostic diagnostic;
  std::vector<std::string> people;  // names of the agents; empty for one agent
};
std::vector<GroupedDiagnostic> groupedByAgents(const base::Diagnostics& report);

}  // namespace app
