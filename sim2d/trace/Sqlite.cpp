#include "sim2d/trace/Sqlite.h"

#include <algorithm>
#include <filesystem>

#include <sqlite3.h>

#include "sim2d/trace/TrackImport.h"

namespace sim2d {

void SqliteCloser::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

void SqliteCloser::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SqliteStatement prepare(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
  return SqliteStatement(statement);
}

namespace {

constexpr int kStepsPerCall = 10000;

/// Progress handler of SQLite. A nonzero result interrupts the query.
int takeFromBudget(void* budget) {
  auto& left = *static_cast<std::int64_t*>(budget);
  left -= kStepsPerCall;
  return left < 0 ? 1 : 0;
}

}  // namespace

std::uint64_t databaseSize(const std::string& path) {
  std::uint64_t size = 0;
  for (const char* ending : {"", "-wal"}) {
    std::error_code none;
    const std::uintmax_t bytes = std::filesystem::file_size(path + ending, none);
    size += none ? 0 : bytes;
  }
  return size;
}

void limitQueries(sqlite3* database, std::uint64_t size, std::int64_t& budget) {
  constexpr std::int64_t kStepsOfAny = 10000000;
  constexpr std::int64_t kStepsPerByte = 20;  // a row takes 10 to 30 steps and at least 5 bytes
  constexpr std::uint64_t kLargestValue = std::uint64_t{1} << 30U;  // [B]
  constexpr std::uint64_t kValueOfAny = 1000000;                    // [B]
  constexpr int kLongestPattern = 100;
  budget = kStepsOfAny + kStepsPerByte * static_cast<std::int64_t>(size);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH,
                static_cast<int>(std::clamp(size, kValueOfAny, kLargestValue)));
  sqlite3_limit(database, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, kLongestPattern);
  sqlite3_progress_handler(database, kStepsPerCall, takeFromBudget, &budget);
}

bool isTrajectoryDatabase(const std::string& path) {
  sqlite3* database = nullptr;
  const int code =
      sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
  const bool isOne =
      code == SQLITE_OK &&
      sqlite3_table_column_metadata(database, nullptr, "trajectory_data", "frame", nullptr, nullptr,
                                    nullptr, nullptr, nullptr) == SQLITE_OK;
  sqlite3_close(database);
  return isOne;
}

}  // namespace sim2d
