#pragma once

#include <string>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "sim2d/base/Files.h"
#include "sim2d/trace/Sqlite.h"

namespace bridge {

/// Writes a rosbag2 `.db3` file (schema 3: Humble and later): tables schema, metadata, topics and
/// messages, and `hunavsim_metadata` for other metadata. Writes to a temporary file, which finish()
/// moves to its final path. Not thread-safe.
class SqliteBagWriter final : public BagWriter {
 public:
  explicit SqliteBagWriter(const std::string& path);

  std::uint16_t addChannel(ChannelInfo channel) override;
  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override;
  void addMetadata(const std::string& name, const Entries& entries) override;
  bool hasFailed() const override { return !problems_.empty(); }
  base::Diagnostics finish() override;
  const Totals& totals() const override { return totals_; }

 private:
  void run(const char* sql);
  sim2d::SqliteStatement prepared(const char* sql);
  void check(int code, int wanted);
  void writeTopics();

  std::string path_;
  base::AtomicFileWriter file_;  // its temporary file is the database
  sim2d::SqliteConnection database_;
  sim2d::SqliteStatement insert_;  // inserts a message
  std::vector<ChannelInfo> channels_;
  Totals totals_;
  base::Diagnostics problems_;
};

}  // namespace bridge
