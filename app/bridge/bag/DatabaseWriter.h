#pragma once

#include <string>
#include <vector>

#include "app/bridge/bag/BagWriter.h"
#include "sim2d/trace/SqliteHandles.h"

namespace bridge {

/// A `.db3` of rosbag2 (schema 3: Humble, later ones read it): tables schema, metadata, topics and
/// messages, and `hunavsim_metadata` for metadata that has no place in messages. It is written to a
/// temporary file, which finish() moves to its final path. One thread at a time.
class DatabaseWriter final : public BagWriter {
 public:
  explicit DatabaseWriter(std::string path);
  ~DatabaseWriter() override;
  DatabaseWriter(const DatabaseWriter&) = delete;
  DatabaseWriter& operator=(const DatabaseWriter&) = delete;
  DatabaseWriter(DatabaseWriter&&) = delete;
  DatabaseWriter& operator=(DatabaseWriter&&) = delete;

  std::uint16_t addChannel(WrittenChannel channel) override;
  void write(std::uint16_t channel, std::int64_t time, std::string_view message) override;
  void addMetadata(const std::string& name, const Entries& entries) override;
  bool hasFailed() const override { return !problems_.empty(); }
  base::Diagnostics finish() override;
  const Totals& totals() const override { return totals_; }

 private:
  bool makeFile();
  void open();
  void run(const char* sql);
  sim2d::SqliteStatement prepared(const char* sql);
  void check(int code, int wanted);
  void fail(const std::string& reason);
  void writeTopics();
  void copyInPlace();

  std::string path_, made_;  // the final path, and the temporary one
  sim2d::SqliteConnection database_;
  sim2d::SqliteStatement insert_;  // of a message
  std::vector<WrittenChannel> channels_;
  Totals totals_;
  base::Diagnostics problems_;
};

}  // namespace bridge
