#pragma once

#include <cstdint>
#include <string>

struct sqlite3;

/// Limits for reading databases of other programs.
namespace sim2d {

/// [B] of the file and of the journal beside it ("-wal"), which may hold most of it.
std::uint64_t databaseSize(const std::string& path);

/// Prepares a database for reading only tables: no views, which can be queries without an end, and
/// no functions of the schema with effects. Queries are interrupted when they take more steps, and
/// refused when a value is larger, than its size [B] justifies: a damaged file can refer to the
/// same page repeatedly. `budget` counts the steps of all queries and must outlive the connection.
void limitQueries(sqlite3* database, std::uint64_t size, std::int64_t& budget);

}  // namespace sim2d
