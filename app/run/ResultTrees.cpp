#include "app/run/ResultStore.h"
#include "app/run/SqlStatement.h"

namespace app {

namespace {

/// Optional tables of the coverage of behaviour trees. Rows of runs that were removed are ignored.
const char* const kTreeTables =
    "CREATE TABLE IF NOT EXISTS tree_paths(id INTEGER PRIMARY KEY, paths TEXT NOT NULL UNIQUE);"
    "CREATE TABLE IF NOT EXISTS tree_results(run INTEGER NOT NULL, place INTEGER NOT NULL,"
    " owners TEXT NOT NULL, paths_id INTEGER NOT NULL, returned TEXT NOT NULL,"
    " PRIMARY KEY(run, place));";

}  // namespace

bool ResultStore::addTrees(const StoredRun& run) const {
  bool isStored = this->run(kTreeTables);
  const auto execute = [](const SqlStatement& statement) {
    return statement.prepared != nullptr && sqlite3_step(statement.prepared) == SQLITE_DONE;
  };
  for (std::size_t place = 0; isStored && place < run.row.trees.size(); ++place) {
    const TreeRow& tree = run.row.trees[place];
    isStored = execute(SqlStatement(database_, "INSERT OR IGNORE INTO tree_paths(paths) VALUES(?)",
                                    tree.paths)) &&
               execute(SqlStatement(database_,
                                    "INSERT OR REPLACE INTO tree_results SELECT ?,?,?,id,? FROM "
                                    "tree_paths WHERE paths=?",
                                    static_cast<long long>(run.run), static_cast<long long>(place),
                                    tree.owners, tree.returned, tree.paths));
  }
  return isStored;
}

/// The trees of a run.
std::vector<TreeRow> ResultStore::treesOf(std::size_t run) const {
  std::vector<TreeRow> trees;
  const SqlStatement statement(
      database_,
      "SELECT owners, paths, returned FROM tree_results JOIN tree_paths ON id=paths_id "
      "WHERE run=? ORDER BY place",
      static_cast<long long>(run));
  while (statement.step()) {
    trees.push_back({statement.text(0), statement.text(1), statement.text(2)});
  }
  return trees;
}

}  // namespace app
