#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

/// Owning handles of SQLite; reading of third-party databases.
namespace sim2d {

struct SqliteCloser {
  void operator()(sqlite3* database) const;
  void operator()(sqlite3_stmt* statement) const;
};
using SqliteConnection = std::unique_ptr<sqlite3, SqliteCloser>;
using SqliteStatement = std::unique_ptr<sqlite3_stmt, SqliteCloser>;

/// Null: an error of the database.
SqliteStatement prepare(sqlite3* database, const char* sql);

// Limits for reading third-party databases.

/// [B] of the file and its write-ahead log ("-wal"), which may contain most of the data.
std::uint64_t databaseSize(const std::string& path);

/// Restricts a database to reading tables: views, which can be endless queries, and schema
/// functions with side effects are disabled. Queries are interrupted after a number of steps, and
/// values are limited in size, in proportion to `size` [B]: a damaged file can refer to the same
/// page repeatedly. `budget` counts the steps of all queries and must outlive the connection.
void limitQueries(sqlite3* database, std::uint64_t size, std::int64_t& budget);

}  // namespace sim2d
