#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"

namespace bridge {

/// The topic or channel under which messages are written.
struct WrittenChannel {
  std::string topic, type;
  std::string definition;                                     // form `ros2msg`
  std::vector<std::pair<std::string, std::string>> metadata;  // of the channel
};

/// Writes messages to a temporary file, which is moved to its final path when it is finished.
class BagWriter {
 public:
  struct Totals {
    std::uint64_t messages = 0;
    std::int64_t begin = 0, end = 0;  // [ns] of the messages
    std::map<std::uint16_t, std::uint64_t> perChannel;
  };
  using Entries = std::vector<std::pair<std::string, std::string>>;

  BagWriter() = default;
  virtual ~BagWriter() = default;
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;
  BagWriter(BagWriter&&) = delete;
  BagWriter& operator=(BagWriter&&) = delete;

  virtual std::uint16_t addChannel(WrittenChannel channel) = 0;
  /// `time` [ns] need not be increasing.
  virtual void write(std::uint16_t channel, std::int64_t time, std::string_view message) = 0;
  /// Adds metadata that has no place in messages, under a name.
  virtual void addMetadata(const std::string& name, const Entries& entries) = 0;
  /// Something could not be written; finish() returns the reason.
  virtual bool hasFailed() const = 0;
  /// Empty = the file is complete and at its final path.
  virtual base::Diagnostics finish() = 0;
  /// So far.
  virtual const Totals& totals() const = 0;
};

}  // namespace bridge
