#pragma once

#include <string>

#include "app/run/ResultStore.h"

namespace app {

/// results.csv of what is in the store: a row per run, by number. Columns beside those of every
/// batch: the metrics in their order, then others as they first appear. Nothing of it depends on
/// the number of processes, their order, interruptions, shards, or the clock.
base::Diagnostics writeResults(const ResultStore& store, const std::string& path);

/// A row as one line of JSON, without its end: {"run", "scenario", "seed", "values": {path: text},
/// "status", "reason", "metrics": {column: number, true, false, text or null}}.
std::string rowJson(const Study& study, const StoredRun& run);

/// What is said before the rows: {"runs", "finished"}, of the shard.
std::string beginJson(const ResultStore& store);

/// manifest.json of a batch: the program, files that were read, how many runs there are, and what
/// was drawn for each scenario and seed.
base::Result<std::string> batchManifest(const ResultStore& store, const std::string& resultsHash);
/// The same of one in which nothing has run, and that lists no files. `former`: how many runs the
/// batch in this folder had that it takes the place of.
std::string emptyManifest(const Study& study, std::size_t former);

}  // namespace app
