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
  const base::Result<std::unique_ptr<BatchFolder>> folder = mergeShards(
      options.output, options.shards, options.force ? Earlier::Replace : Earlier::Refuse);
  requireFine(folder.diagnostics());
  return reportBatch(**folder, {}, given);
}

}  // namespace

void addMerge(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("merge", "Join the results of all shards of a batch", mergeCommand);
  command.add_option("shard", options.shards, "Folders that batch --shard K/N has written")
      ->required();
  addOutputFolder(command, options.output, "Folder for the results").required();
  command.add_flag("--force", options.force,
                   "Begin anew where a batch was interrupted; replace files of others");
}

}  // namespace app
