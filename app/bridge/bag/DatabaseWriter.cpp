#include "app/bridge/bag/DatabaseWriter.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <sqlite3.h>

#include "app/bridge/bag/BagTopics.h"
#include "sim2d/base/Files.h"

namespace bridge {
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

std::string qosOf(const WrittenChannel& channel) {
  const auto found = std::find_if(channel.metadata.begin(), channel.metadata.end(),
                                  [](const auto& entry) { return entry.first == kQosKey; });
  return found == channel.metadata.end() ? std::string() : found->second;
}

}  // namespace

DatabaseWriter::DatabaseWriter(std::string path) : path_(std::move(path)) {
  if (makeFile()) {
    open();
  }
}

DatabaseWriter::~DatabaseWriter() {
  insert_.reset();
  database_.reset();
  if (!made_.empty()) {
    ::unlink(made_.c_str());
  }
}

/// In the folder of the final file, so that both are on the same disk.
bool DatabaseWriter::makeFile() {
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
  made_ = std::move(name);
  return true;
}

void DatabaseWriter::open() {
  sqlite3* raw = nullptr;
  const int code =
      sqlite3_open_v2(made_.c_str(), &raw, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(raw);
  check(code, SQLITE_OK);
  run(kTables);
  insert_ = prepared("INSERT INTO messages(topic_id, timestamp, data) VALUES(?1, ?2, ?3)");
}

void DatabaseWriter::fail(const std::string& reason) {
  if (problems_.empty()) {
    problems_.push_back(base::error("file.cannot-write", {reason}, path_));
  }
}

void DatabaseWriter::check(int code, int wanted) {
  if (code != wanted) {
    fail(database_ == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(database_.get()));
  }
}

void DatabaseWriter::run(const char* sql) {
  if (!hasFailed()) {
    check(sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr), SQLITE_OK);
  }
}

sim2d::SqliteStatement DatabaseWriter::prepared(const char* sql) {
  sqlite3_stmt* statement = nullptr;
  if (!hasFailed()) {
    check(sqlite3_prepare_v2(database_.get(), sql, -1, &statement, nullptr), SQLITE_OK);
  }
  return sim2d::SqliteStatement(statement);
}

std::uint16_t DatabaseWriter::addChannel(WrittenChannel channel) {
  channels_.push_back(std::move(channel));
  return static_cast<std::uint16_t>(channels_.size() - 1);
}

void DatabaseWriter::write(std::uint16_t channel, std::int64_t time, std::string_view message) {
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

void DatabaseWriter::addMetadata(const std::string& name, const Entries& entries) {
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

/// The topics with messages, and the description of the file that rosbag2 reads.
void DatabaseWriter::writeTopics() {
  const sim2d::SqliteStatement insert =
      prepared("INSERT INTO topics VALUES(?1, ?2, ?3, 'cdr', ?4)");
  std::vector<BagTopic> topics;
  for (const auto& [channel, count] : totals_.perChannel) {
    const WrittenChannel& told = channels_[channel];
    topics.push_back({told.topic, told.type, count, qosOf(told)});
    if (!hasFailed()) {
      sqlite3_bind_int(insert.get(), 1, channel + 1);
      bindText(insert.get(), 2, told.topic);
      bindText(insert.get(), 3, told.type);
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

void DatabaseWriter::copyInPlace() {
  base::GrowingFile file(path_);
  std::ifstream from(made_, std::ios::binary);
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

base::Diagnostics DatabaseWriter::finish() {
  writeTopics();
  run("CREATE INDEX timestamp_idx ON messages(timestamp ASC); COMMIT");
  insert_.reset();
  if (!hasFailed()) {
    check(sqlite3_close(database_.release()), SQLITE_OK);
  }
  if (!hasFailed()) {
    copyInPlace();
  }
  return problems_;
}

}  // namespace bridge
