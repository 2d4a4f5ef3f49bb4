#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

#include "app/bridge/bag/Bag.h"
#include "app/bridge/bag/BagTrace.h"
#include "tests/fuzz/Require.h"

/// Any bytes as a recording of messages, an MCAP file or a database of rosbag2: opened, read and
/// made a record of a run without harm, twice with the same end.
namespace {

/// Of this process, overwritten by each input.
const std::string& fileOfInput() {
  static const std::string kFile =
      std::filesystem::temp_directory_path() / ("fuzz_bag_" + std::to_string(::getpid()));
  return kFile;
}

std::size_t messagesIn(bridge::Bag& bag) {
  std::size_t count = 0;
  const std::vector<bool> all(bag.channels().size(), true);
  bag.read(all, [&](std::size_t channel, std::int64_t /*time*/, std::string_view /*bytes*/) {
    require(channel < all.size(), "a message is of a channel");
    ++count;
  });
  return count;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string& path = fileOfInput();
  std::ofstream(path, std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const base::Result<std::unique_ptr<bridge::Bag>> bag = bridge::openBag(path);
  if (bag) {
    require(messagesIn(**bag) == messagesIn(**bag), "reading twice changes nothing");
  } else {
    require(base::hasErrors(bag.diagnostics()), "what is not read has an error");
  }
  const base::Result<sim2d::Trace> trace = bridge::readBagTrace(path, {}, {});
  require(trace || base::hasErrors(trace.diagnostics()), "what is no record has an error");
  std::filesystem::remove(path);
  return 0;
}
