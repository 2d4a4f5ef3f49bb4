#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sqlite3.h>

#include "app/bridge/bag/Bag.h"
#include "sim2d/trace/SqliteHandles.h"
#include "sim2d/trace/SqliteLimits.h"

namespace bridge {
namespace {

sim2d::SqliteStatement prepared(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
  return sim2d::SqliteStatement(statement);
}

/// Bytes of a column; valid until the next step.
std::string_view bytesOf(sqlite3_stmt* statement, int column) {
  const void* const bytes = sqlite3_column_blob(statement, column);
  const int size = sqlite3_column_bytes(statement, column);
  return bytes == nullptr
             ? std::string_view()
             : std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

/// A `.db3` of rosbag2: tables topics (id, name, type, serialization_format) and messages
/// (topic_id, timestamp, data).
class Database final : public Bag {
 public:
  Database(std::string path, sim2d::SqliteConnection connection)
      : path_(std::move(path)), connection_(std::move(connection)) {}

  base::Diagnostics readTopics() {
    sim2d::limitQueries(connection_.get(), sim2d::databaseSize(path_), budget_);
    const sim2d::SqliteStatement topics =
        prepared(connection_.get(), "SELECT id, name, type, serialization_format FROM topics");
    if (!topics) {
      return problem();
    }
    int code = sqlite3_step(topics.get());
    for (; code == SQLITE_ROW; code = sqlite3_step(topics.get())) {
      places_[sqlite3_column_int64(topics.get(), 0)] = channels_.size();
      channels_.push_back({std::string(bytesOf(topics.get(), 1)),
                           std::string(bytesOf(topics.get(), 2)),
                           std::string(bytesOf(topics.get(), 3))});
    }
    return code == SQLITE_DONE ? base::Diagnostics() : problem();
  }

  const std::vector<BagChannel>& channels() const override { return channels_; }

  /// The metadata of hunavsim is in a table of its own, which rosbag2 ignores.
  std::string metadata(const std::string& name, const std::string& key) override {
    const sim2d::SqliteStatement entry = prepared(
        connection_.get(), "SELECT value FROM hunavsim_metadata WHERE name = ?1 AND key = ?2");
    if (!entry) {
      return {};
    }
    sqlite3_bind_text(entry.get(), 1, name.c_str(), -1, SQLITE_TRANSIENT);
    sqlite3_bind_text(entry.get(), 2, key.c_str(), -1, SQLITE_TRANSIENT);
    return sqlite3_step(entry.get()) == SQLITE_ROW ? std::string(bytesOf(entry.get(), 0))
                                                   : std::string();
  }

  base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) override {
    const sim2d::SqliteStatement messages = prepared(
        connection_.get(), "SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
    if (!messages) {
      return problem();
    }
    int code = sqlite3_step(messages.get());
    for (; code == SQLITE_ROW; code = sqlite3_step(messages.get())) {
      const auto place = places_.find(sqlite3_column_int64(messages.get(), 0));
      if (place != places_.end() && channels[place->second]) {
        visit(place->second, sqlite3_column_int64(messages.get(), 1), bytesOf(messages.get(), 2));
      }
    }
    return code == SQLITE_DONE ? base::Diagnostics() : problem();
  }

 private:
  base::Diagnostics problem() const {
    return {base::error("bag.bad-database", {sqlite3_errmsg(connection_.get())}, path_)};
  }

  std::string path_;
  std::int64_t budget_ = 0;  // outlives the connection
  sim2d::SqliteConnection connection_;
  std::vector<BagChannel> channels_;
  std::map<sqlite3_int64, std::size_t> places_;  // of topic ids in channels_
};

}  // namespace

base::Result<std::unique_ptr<Bag>> openDatabase(const std::string& path) {
  sqlite3* raw = nullptr;
  const int code =
      sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
  sim2d::SqliteConnection connection(raw);
  if (code != SQLITE_OK) {
    return base::error("bag.bad-database", {sqlite3_errstr(code)}, path);
  }
  auto database = std::make_unique<Database>(path, std::move(connection));
  base::Diagnostics problems = database->readTopics();
  if (!problems.empty()) {
    return problems;
  }
  return std::unique_ptr<Bag>(std::move(database));
}

}  // namespace bridge
