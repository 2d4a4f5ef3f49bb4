#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

namespace bridge {

/// A topic of a recording.
struct BagChannel {
  std::string topic, type;  // "/odom", "nav_msgs/msg/Odometry"
  std::string encoding = "cdr";
};

/// Messages that were recorded: an MCAP file, a database of rosbag2, a folder of rosbag2. Files may
/// hold anything: lengths are held against the file before memory is taken. One thread at a time.
class Bag {
 public:
  /// `time` [ns] at which it was recorded; the bytes are valid during the call.
  using Visit = std::function<void(std::size_t channel, std::int64_t time, std::string_view bytes)>;

  virtual ~Bag() = default;
  virtual const std::vector<BagChannel>& channels() const = 0;
  /// Calls `visit` for the messages of the channels with true, in the order of the file. What comes
  /// back are warnings of what is damaged and left out, or errors.
  virtual base::Diagnostics read(const std::vector<bool>& channels, const Visit& visit) = 0;
  /// A value of a metadata record; empty: there is none.
  virtual std::string metadata(const std::string& /*name*/, const std::string& /*key*/) {
    return {};
  }
};

/// By its content, whatever it is called.
bool isBag(const std::string& path);
/// Errors: no bag, or of a kind that cannot be read. Warnings: it is cut off.
base::Result<std::unique_ptr<Bag>> openBag(const std::string& path);

/// The files of a bag, for a manifest; those that its metadata names.
std::vector<std::string> filesOfBag(const std::string& path);

// the kinds
base::Result<std::unique_ptr<Bag>> openMcap(const std::string& path);
base::Result<std::unique_ptr<Bag>> openDatabase(const std::string& path);
base::Result<std::unique_ptr<Bag>> openBagFolder(const std::string& folder);

}  // namespace bridge
