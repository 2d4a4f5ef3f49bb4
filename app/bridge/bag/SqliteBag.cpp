#include "app/bridge/bag/SqliteBag.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include <sqlite3.h>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagMetadata.h"
#include "sim2d/base/Files.h"
#include "sim2d/trace/Sqlite.h"

namespace bridge {
namespace {

sim2d::SqliteStatement prepared(sqlite3* database, const char* sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql, -1, &statement, nullptr);
  return sim2d::SqliteStatement(statement);
}

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

  /// hunavsim stores its metadata in an additional table, which rosbag2 ignores.
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
constexpr const char* kQosKey = "offered_qos_profiles";
constexpr std::size_t kPiece = std::size_t{1} << 20U;  // [B]

void bindText(sqlite3_stmt* statement, int place, std::string_view text) {
  sqlite3_bind_text(statement, place, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
}

std::string qosOf(const ChannelInfo& channel) {
  const auto found = std::find_if(channel.metadata.begin(), channel.metadata.end(),
                                  [](const auto& entry) { return entry.first == kQosKey; });
  return found == channel.metadata.end() ? std::string() : found->second;
}

}  // namespace

SqliteBagWriter::SqliteBagWriter(std::string path) : path_(std::move(path)) {
  if (createTemporaryFile()) {
    open();
  }
}

SqliteBagWriter::~SqliteBagWriter() {
  insert_.reset();
  database_.reset();
  if (!temporaryPath_.empty()) {
    ::unlink(temporaryPath_.c_str());
  }
}

/// Creates the temporary file in the folder of the final file, so that both are on the same disk.
bool SqliteBagWriter::createTemporaryFile() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  if (!folder.empty()) {
    std::filesystem::create_directories(folder, error);
  }
  std::string name = path_ + ".XXXXXX";
  const int descriptor = error ? -1 : ::mkstemp(name.data());
  if (descriptor < 0) {
    fail((error ? error : std::error_code(errno, std::generic_category())).message());
    return false;
  }
  ::close(descriptor);
  temporaryPath_ = std::move(name);
  return true;
}

void SqliteBagWriter::open() {
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(temporaryPath_.c_str(), &raw,
                                   SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(raw);
  check(code, SQLITE_OK);
  run(kTables);
  insert_ = prepared("INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)");
}

void SqliteBagWriter::fail(const std::string& reason) {
  if (problems_.empty()) {
    problems_.push_back(base::error("file.cannot-write", {reason}, path_));
  }
}

void SqliteBagWriter::check(int code, int wanted) {
  if (code != wanted) {
    fail(database_ == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(database_.get()));
  }
}

void SqliteBagWriter::run(const char* sql) {
  if (!hasFailed()) {
    check(sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr), SQLITE_OK);
  }
}

sim2d::SqliteStatement SqliteBagWriter::prepared(const char* sql) {
  sqlite3_stmt* statement = nullptr;
  if (!hasFailed()) {
    check(sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr), SQLITE_OK);
  }
  return sim2d::SqliteStatement(statement);
}

std::uint16_t SqliteBagWriter::addChannel(ChannelInfo channel) {
  channels_.push_back(std::move(channel));
  return static_cast<std::uint16_t>(channels_.size() - 1);
}

void SqliteBagWriter::write(std::uint16_t channel, std::int64_t time, std::string_view message) {
  if (hasFailed()) {
    return;
  }
  sqlite3_bind_int(insert_.get(), 1, channel + 1);
  sqlite3_bind_int64(insert_.get(), 2, time);
  sqlite3_bind_blob64(insert_.get(), 3, message.data(), message.size(), SQLITE_STATIC);
  check(sqlite3_step(insert_.get()), SQLITE_DONE);
  sqlite3_reset(insert_.get());
  totals_.begin = totals_.messages == 0 ? time : std::min(totals_.begin, time);
  totals_.end = totals_.messages == 0 ? time : std::max(totals_.end, time);
  ++totals_.messages;
  ++totals_.perChannel[channel];
}

void SqliteBagWriter::addMetadata(const std::string& name, const Entries& entries) {
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

/// Writes the topics with messages, and the bag metadata that rosbag2 reads.
void SqliteBagWriter::writeTopics() {
  const sim2d::SqliteStatement insert =
      prepared("INSERT INTO topics VALUES(?1, ?2, ?3, 'cdr', ?4)");
  std::vector<BagTopic> topics;
  for (const auto& [channel, count] : totals_.perChannel) {
    const ChannelInfo& info = channels_[channel];
    topics.push_back({info.topic, info.type, count, qosOf(info)});
    if (!hasFailed()) {
      sqlite3_bind_int(insert.get(), 1, channel + 1);
      bindText(insert.get(), 2, info.topic);
      bindText(insert.get(), 3, info.type);
      bindText(insert.get(), 4, topics.back().qos);
      check(sqlite3_step(insert.get()), SQLITE_DONE);
      sqlite3_reset(insert.get());
    }
  }
  const std::string metadata =
      bagMetadata(std::filesystem::path(path_).filename().string(), topics,
                  {totals_.begin, totals_.end, totals_.messages}, "sqlite3");
  const sim2d::SqliteStatement row = prepared("INSERT INTO metadata VALUES(1, 5, ?1)");
  if (!hasFailed()) {
    bindText(row.get(), 1, metadata);
    check(sqlite3_step(row.get()), SQLITE_DONE);
  }
}

void SqliteBagWriter::moveToFinalPath() {
  base::AtomicFileWriter file(path_);
  std::ifstream from(temporaryPath_, std::ios::binary);
  std::string piece(kPiece, '\0');
  while (from && !file.hasFailed()) {
    from.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    file.append(std::string_view(piece).substr(0, static_cast<std::size_t>(from.gcount())));
  }
  if (!from.eof()) {
    fail(std::error_code(errno, std::generic_category()).message());
    return;
  }
  base::append(problems_, file.finish());
}

base::Diagnostics SqliteBagWriter::finish() {
  writeTopics();
  run("CREATE INDEX timestamp_idx ON messages(timestamp ASC); COMMIT");
  insert_.reset();
  if (!hasFailed()) {
    check(sqlite3_close(database_.release()), SQLITE_OK);
  }
  if (!hasFailed()) {
    moveToFinalPath();
  }
  return problems_;
}

}  // namespace bridge
