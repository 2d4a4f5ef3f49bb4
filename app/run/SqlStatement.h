#pragma once

#include <string>

#include <sqlite3.h>

namespace app {

/// A prepared SQL statement (RAII).
struct SqlStatement {
  /// `values`: of the placeholders.
  template <class... Values>
  SqlStatement(sqlite3* database, const char* sql, const Values&... values) {
    sqlite3_prepare_v2(database, sql, -1, &prepared, nullptr);
    bindAll(values...);
  }
  ~SqlStatement() { sqlite3_finalize(prepared); }
  SqlStatement(const SqlStatement&) = delete;
  SqlStatement& operator=(const SqlStatement&) = delete;
  SqlStatement(SqlStatement&&) = delete;
  SqlStatement& operator=(SqlStatement&&) = delete;

  bool step() const { return sqlite3_step(prepared) == SQLITE_ROW; }
  template <class... Values>
  void bindAll(const Values&... values) const {
    [[maybe_unused]] int place = 0;
    (bind(++place, values), ...);
  }
  void bind(int place, const std::string& text) const {
    sqlite3_bind_text(prepared, place, text.data(), static_cast<int>(text.size()),
                      SQLITE_TRANSIENT);  // NOLINT: a macro of the library
  }
  void bind(int place, long long number) const { sqlite3_bind_int64(prepared, place, number); }
  std::string text(int column) const {
    const auto* const bytes =
        static_cast<const char*>(static_cast<const void*>(sqlite3_column_text(prepared, column)));
    const int size = sqlite3_column_bytes(prepared, column);
    return bytes != nullptr ? std::string(bytes, static_cast<std::size_t>(size)) : std::string();
  }
  long long number(int column) const { return sqlite3_column_int64(prepared, column); }

  sqlite3_stmt* prepared = nullptr;
};

}  // namespace app
