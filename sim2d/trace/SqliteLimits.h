#pragma once

#include <cstdint>

struct sqlite3;

/// Databases that come from elsewhere.
namespace sim2d {

/// Prepares a database for reading tables alone: no views, which can be queries without an end, and
/// no functions of the schema with effects. Queries are interrupted when they take more steps, and
/// refused when a value is larger, than the size of the file [B] justifies: a damaged file can show
/// the same page again and again. `budget` counts the steps of all queries and must outlive the
/// connection.
void limitQueries(sqlite3* database, std::uint64_t fileSize, std::int64_t& budget);

}  // namespace sim2d
