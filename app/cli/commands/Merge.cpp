#include "app/run/Merge.h"

#include <CLI/CLI.hpp>

#include "app/cli/BatchReport.h"
#include "app/cli/CommandRegistry.h"

namespace app {

namespace {

struct MergeOptions {
  std::string output;
  std::vector<std::string> shards;
  bool force = false;
};

int mergeCommand(const MergeOptions& options, const Invocation& given) {
  const base::Result<std::unique_ptr<BatchFolder>> folder =
      mergeShards(options.output, options.shards,
                  options.force ? ExistingBatch::Replace : ExistingBatch::Refuse);
  requireFine(folder.diagnostics());
  return reportBatch(**folder, {}, given);
}

}  // namespace

void addMerge(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("merge", "Merge the results of all shards of a batch", mergeCommand);
  command.add_option("shard", options.shards, "Folders written by batch --shard K/N")->required();
  addOutputFolder(command, options.output, "Output folder").required();
  command.add_flag("--force", options.force,
                   "Restart an interrupted merge from the beginning; overwrite files that hunavsim "
                   "did not create");
}

}  // namespace app
