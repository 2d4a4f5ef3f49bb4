#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sqlite3.h>

#include "app/bridge/bag/Bag.h"
#include "sim2d/base/Files.h"
#include "sim2d/trace/Sqlite.h"

namespace bridge {
namespace {

/// The bytes of a column, valid until the next step.
std::string_view bytesOf(sqlite3_stmt* statement, int column) {
  const void* const bytes = sqlite3_column_blob(statement, column);
  const int size = sqlite3_column_bytes(statement, column);
  return bytes == nullptr
             ? std::string_view()
             : std::string_view(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

/// A rosbag2 `.db3` file: tables topics (id, name, type, serialization_format) and messages
/// (topic_id, timestamp, data).
class SqliteBagReader final : public Bag {
 public:
  SqliteBagReader(std::string path, sim2d::SqliteConnection connection)
      : path_(std::move(path)), connection_(std::move(connection)) {}

  base::Diagnostics readTopics() {
    sim2d::limitQueries(connection_.get(), sim2d::databaseSize(path_), budget_);
    const sim2d::SqliteStatement topics = sim2d::prepare(
        connection_.get(), "SELECT id, name, type, serialization_format FROM topics");
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

  /// hunavsim stores its metadata in an additional table, which rosbag2 ignores.
  std::string metadata(const std::string& name, const std::string& key) override {
    const sim2d::SqliteStatement entry = sim2d::prepare(
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
    const sim2d::SqliteStatement messages = sim2d::prepare(
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
  std::int64_t budget_ = 0;  // must outlive connection_
  sim2d::SqliteConnection connection_;
  std::vector<BagChannel> channels_;
  std::map<sqlite3_int64, std::size_t> places_;  // topic id -> index in channels_
};

}  // namespace

base::Result<std::unique_ptr<Bag>> openSqliteBag(const std::string& path) {
  sqlite3* raw = nullptr;
  const int code =
      sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_NOMUTEX, nullptr);
  sim2d::SqliteConnection connection(raw);
  if (code != SQLITE_OK) {
    return base::error("bag.bad-database", {sqlite3_errstr(code)}, path);
  }
  auto database = std::make_unique<SqliteBagReader>(path, std::move(connection));
  base::Diagnostics problems = database->readTopics();
  if (!problems.empty()) {
    return problems;
  }
  return std::unique_ptr<Bag>(std::move(database));
}

namespace {

constexpr const char* kTables =
    "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF;"
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL,"
    " metadata TEXT NOT NULL);"
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
    " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
    "CREATE TABLE hunavsim_metadata(name TEXT NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL);"
    "INSERT INTO schema VALUES(3, 'humble'); BEGIN";
void bindText(sqlite3_stmt* statement, int place, std::string_view text) {
  sqlite3_bind_text(statement, place, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

/// A double-quoted YAML string.
std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) {
    if (c == '\n') {
      all += "\\n";
      continue;
    }
    all += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return all + "\"";
}

std::string topicLines(const ChannelInfo& topic, std::uint64_t messages) {
  return R"(    - topic_metadata:
        name: )" +
         quoted(topic.topic) + R"(
        type: )" +
         quoted(topic.type) + R"(
        serialization_format: cdr
        offered_qos_profiles: )" +
         quoted(topic.qos) + R"(
      message_count: )" +
         std::to_string(messages) + "\n";
}

/// Writes a rosbag2 database (makeSqliteBagWriter).
class SqliteBagWriter final : public BagWriter {
 public:
  explicit SqliteBagWriter(const std::string& path) : path_(path), file_(path) {
    if (file_.hasFailed()) {
      problems_ = file_.complete();
      return;
    }
    sqlite3* raw = nullptr;
    // The file is locked already, and on some file systems a second lock would fail.
    const int code = sqlite3_open_v2(file_.temporaryPath().c_str(), &raw,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, "unix-none");
    database_.reset(raw);
    check(code, SQLITE_OK);
    run(kTables);
    insert_ = prepared("INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)");
  }

  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override {
    if (hasFailed()) {
      return;
    }
    sqlite3_bind_int(insert_.get(), 1, channel + 1);
    sqlite3_bind_int64(insert_.get(), 2, time);
    sqlite3_bind_blob64(insert_.get(), 3, message.data(), message.size(), SQLITE_STATIC);
    check(sqlite3_step(insert_.get()), SQLITE_DONE);
    sqlite3_reset(insert_.get());
    totals_.add(channel, time);
  }

  void addMetadata(const std::string& name, const Entries& entries) override {
    const sim2d::SqliteStatement insert =
        prepared("INSERT INTO hunavsim_metadata VALUES(?1, ?2, ?3)");
    for (const auto& [key, value] : entries) {
      if (!hasFailed()) {
        bindText(insert.get(), 1, name);
        bindText(insert.get(), 2, key);
        bindText(insert.get(), 3, value);
        check(sqlite3_step(insert.get()), SQLITE_DONE);
        sqlite3_reset(insert.get());
      }
    }
  }

  bool hasFailed() const override { return !problems_.empty(); }

  base::Diagnostics finish() override {
    writeTopics();
    run("CREATE INDEX timestamp_idx ON messages(timestamp ASC); COMMIT");
    insert_.reset();
    if (!hasFailed()) {
      check(sqlite3_close(database_.release()), SQLITE_OK);
    }
    if (!hasFailed()) {
      problems_ = file_.finish();
    }
    return problems_;
  }

 private:
  void check(int code, int wanted) {
    if (code != wanted && problems_.empty()) {
      problems_.push_back(base::error(
          "file.cannot-write",
          {database_ == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(database_.get())}, path_));
    }
  }

  void run(const char* sql) {
    if (!hasFailed()) {
      check(sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr), SQLITE_OK);
    }
  }

  sim2d::SqliteStatement prepared(const char* sql) {
    sqlite3_stmt* statement = nullptr;
    if (!hasFailed()) {
      check(sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr), SQLITE_OK);
    }
    return sim2d::SqliteStatement(statement);
  }

  /// Writes the topics with messages, and the bag metadata that rosbag2 reads.
  void writeTopics() {
    const sim2d::SqliteStatement insert =
        prepared("INSERT INTO topics VALUES(?1, ?2, ?3, 'cdr', ?4)");
    for (const auto& [channel, count] : totals_.perChannel) {
      const ChannelInfo& info = channels_[channel];
      if (!hasFailed()) {
        sqlite3_bind_int(insert.get(), 1, channel + 1);
        bindText(insert.get(), 2, info.topic);
        bindText(insert.get(), 3, info.type);
        bindText(insert.get(), 4, info.qos);
        check(sqlite3_step(insert.get()), SQLITE_DONE);
        sqlite3_reset(insert.get());
      }
    }
    const std::string metadata =
        rosbagMetadata(std::filesystem::path(path_).filename().string(), "sqlite3");
    const sim2d::SqliteStatement row = prepared("INSERT INTO metadata VALUES(1, 5, ?1)");
    if (!hasFailed()) {
      bindText(row.get(), 1, metadata);
      check(sqlite3_step(row.get()), SQLITE_DONE);
    }
  }

  std::string path_;
  base::AtomicFileWriter file_;  // its temporary file is the database
  sim2d::SqliteConnection database_;
  sim2d::SqliteStatement insert_;  // inserts a message
  base::Diagnostics problems_;
};

}  // namespace

std::unique_ptr<BagWriter> makeSqliteBagWriter(const std::string& path) {
  return std::make_unique<SqliteBagWriter>(path);
}

std::string BagWriter::rosbagMetadata(const std::string& file, const std::string& storage) const {
  const std::string begin = std::to_string(totals_.begin);
  const std::string length = std::to_string(totals_.end - totals_.begin);
  const std::string count = std::to_string(totals_.messages);
  std::string text = R"(rosbag2_bagfile_information:
  version: 5
  storage_identifier: )" +
                     storage + R"(
  duration:
    nanoseconds: )" + length +
                     R"(
  starting_time:
    nanoseconds_since_epoch: )" +
                     begin + R"(
  message_count: )" + count +
                     R"(
  topics_with_message_count:
)";
  for (const auto& [channel, messages] : totals_.perChannel) {
    text += topicLines(channels_[channel], messages);
  }
  return text + R"(  compression_format: ""
  compression_mode: ""
  relative_file_paths:
    - )" +
         quoted(file) + R"(
  files:
    - path: )" +
         quoted(file) + R"(
      starting_time:
        nanoseconds_since_epoch: )" +
         begin + R"(
      duration:
        nanoseconds: )" +
         length + R"(
      message_count: )" +
         count + "\n";
}

}  // namespace bridge
