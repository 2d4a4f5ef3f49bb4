#pragma once

#include <memory>

struct sqlite3;
struct sqlite3_stmt;

/// Owning handles of SQLite.
namespace sim2d {

struct SqliteCloser {
  void operator()(sqlite3* database) const;
  void operator()(sqlite3_stmt* statement) const;
};
using SqliteConnection = std::unique_ptr<sqlite3, SqliteCloser>;
using SqliteStatement = std::unique_ptr<sqlite3_stmt, SqliteCloser>;

}  // namespace sim2d
