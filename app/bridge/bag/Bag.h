#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace bridge {

/// A topic of a recording.
struct BagChannel {
  std::string topic, type;  // "/odom", "nav_msgs/msg/Odometry"
  std::string encoding = "cdr";
};

/// The index of the channel with the same topic and type, which is added if there is none: channels
/// of one topic, written by several publishers, are merged.
std::size_t indexOfChannel(const BagChannel& channel, std::vector<BagChannel>& channels);

/// A recording: an MCAP file, a rosbag2 database or a rosbag2 folder. Files are untrusted: lengths
/// are checked against the file size before memory is allocated. Not thread-safe.
class Bag {
 public:
  /// `time`: recording time [ns]. `bytes` is valid during the call.
  using Visit = std::function<void(std::size_t channel, std::int64_t time, std::string_view bytes)>;

  virtual ~Bag() = default;
  virtual const std::vector<BagChannel>& channels() const = 0;
  /// Calls `visit` for the messages of the channels that are true, in file order. Returns warnings
  /// about damaged parts that were skipped, or errors.
  virtual base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) = 0;
  /// A value of a metadata record; empty: none.
  virtual std::string metadata(const std::string& /*name*/, const std::string& /*key*/) {
    return {};
  }
};

/// Detects bags by content, independent of the file name.
bool isBag(const std::string& path);
/// Errors: not a bag, or an unsupported kind. Warnings: the file is truncated.
base::Result<std::unique_ptr<Bag>> openBag(const std::string& path);

/// The files of a bag for a manifest, including those named in its metadata.
std::vector<std::string> filesOfBag(const std::string& path);

// Readers for the kinds of bags.
base::Result<std::unique_ptr<Bag>> openMcap(const std::string& path);
base::Result<std::unique_ptr<Bag>> openSqliteBag(const std::string& path);
base::Result<std::unique_ptr<Bag>> openBagFolder(const std::string& folder);

/// A topic of a bag that is being written.
struct ChannelInfo {
  std::string topic, type;
  std::string definition;  // in ros2msg format
  std::string qos;         // offered QoS profile as YAML; may be empty
};

/// Writes messages to a temporary file and moves it to its final path in finish(). Not thread-safe.
class BagWriter {
 public:
  using Entries = std::vector<std::pair<std::string, std::string>>;

  BagWriter() = default;
  virtual ~BagWriter() = default;
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;
  BagWriter(BagWriter&&) = delete;
  BagWriter& operator=(BagWriter&&) = delete;

  virtual std::uint16_t addChannel(ChannelInfo channel) {
    channels_.push_back(std::move(channel));
    return static_cast<std::uint16_t>(channels_.size() - 1);
  }
  /// `time` [ns] need not be increasing.
  virtual void write(std::uint16_t channel, std::int64_t time, std::string_view message) = 0;
  /// Adds a metadata record.
  virtual void addMetadata(const std::string& name, const Entries& entries) = 0;
  /// Whether a write failed; finish() returns the reason.
  virtual bool hasFailed() const = 0;
  /// Closes the file. Empty on success: the file is complete and at its final path.
  virtual base::Diagnostics finish() = 0;
  /// The contents of metadata.yaml (version 5: Humble and later) for a folder that contains the
  /// file under the name `file`. `storage`: "mcap" or "sqlite3". Topics without messages are
  /// omitted.
  std::string rosbagMetadata(const std::string& file, const std::string& storage) const;

 protected:
  struct Totals {
    std::uint64_t messages = 0;
    std::int64_t begin = 0, end = 0;  // [ns], first and last message
    std::map<std::uint16_t, std::uint64_t> perChannel;

    void add(std::uint16_t channel, std::int64_t time) {
      begin = messages == 0 ? time : std::min(begin, time);
      end = messages == 0 ? time : std::max(end, time);
      ++messages;
      ++perChannel[channel];
    }
  };

  std::vector<ChannelInfo> channels_;
  Totals totals_;  // of the messages written
};

/// Writes an MCAP file of profile ros2: CDR messages in zstd-compressed chunks of about 1 MiB, with
/// checksums, indexes and a summary. Memory: one chunk, and 100 bytes per earlier chunk. Channels
/// of one type share a schema.
std::unique_ptr<BagWriter> makeMcapWriter(const std::string& path);
/// Writes a rosbag2 `.db3` file (schema 3: Humble and later): tables schema, metadata, topics and
/// messages, and `hunavsim_metadata` for other metadata.
std::unique_ptr<BagWriter> makeSqliteBagWriter(const std::string& path);

}  // namespace bridge
