#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/bridge/messages/AllMessages.h"
#include "app/bridge/messages/Codec.h"
#include "tests/fuzz/Require.h"

/// Any bytes as every message: read without harm, and what is read can be written and read again.
namespace {

template <class M>
void readAs(std::string_view bytes) {
  const base::Result<M> read = bridge::decode<M>(bytes);
  if (!read) {
    require(base::hasErrors(read.diagnostics()), "what is not read has an error");
    return;
  }
  const std::string written = bridge::encode(*read);
  const base::Result<M> again = bridge::decode<M>(written);
  require(static_cast<bool>(again), "what is written can be read");
  require(bridge::encode(*again) == written, "reading and writing change nothing");
}

template <class... M>
void readAsAll(std::string_view bytes, bridge::TypeList<M...> /*list*/) {
  (readAs<M>(bytes), ...);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  readAsAll(bytes, bridge::AllMessages{});
  return 0;
}
