#pragma once

#include <string>

#include "app/run/ResultStore.h"

namespace app {

/// Writes results.csv from the store, one row per run by index. Columns after the common ones:
/// metrics in registry order, then others by first occurrence. The bytes do not depend on the
/// number of processes, their order, interruptions, shards or the clock.
base::Diagnostics writeResults(const ResultStore& store, const std::string& path);

/// A row as one line of JSON without line end: {"run", "scenario", "seed", "values": {path: text},
/// "status", "reason", "metrics": {column: number, true, false, text or null}}.
std::string rowJson(const Study& study, const StoredRun& run);

/// The message before the rows: {"runs", "finished"} of the shard.
std::string headerJson(const ResultStore& store);

/// manifest.json of a batch, without its output files: the program, input files, run counts, and
/// drawn values per scenario and seed.
base::Result<std::string> batchManifest(const ResultStore& store);
/// The manifest before any run. `former`: number of runs of the batch that is replaced in this
/// folder.
std::string emptyManifest(const Study& study, std::size_t former);

}  // namespace app
