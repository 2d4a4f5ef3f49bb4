#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/bridge/messages/CdrReader.h"
#include "app/bridge/messages/CdrWriter.h"
#include "sim2d/base/Result.h"

namespace bridge {

/// What rmw_cyclonedds puts in front of the fields of a request and of its response.
struct RequestId {
  std::uint64_t guid = 0;
  std::int64_t sequence = 0;

  template <class Self, class F>
  static void fields(Self& self, F&& field) {
    field("guid", self.guid);
    field("sequence", self.sequence);
  }
};

/// Whether bytes behind the last field are allowed; up to three of padding always are.
enum class Rest { Refused, Ignored };

/// The message as DDS, MCAP and the live view carry it, with the four bytes of encapsulation.
/// `expected`: bytes that it will have or so.
template <class M>
std::string encode(const M& message, std::size_t expected = 0) {
  std::string bytes;
  bytes.reserve(expected);
  CdrWriter(bytes).message(message);
  return bytes;
}

/// The same with the identity of the request in front, as rmw_cyclonedds has it.
template <class M>
std::string encode(const RequestId& id, const M& message) {
  std::string bytes;
  CdrWriter writer(bytes);
  writer.message(id);
  writer.message(message);
  return bytes;
}

/// The message in these bytes; an error when they are none of this type. Any bytes are safe.
template <class M>
base::Result<M> decode(std::string_view bytes, Rest rest = Rest::Refused) {
  M message;
  CdrReader reader(bytes);
  reader.message(message);
  if (rest == Rest::Refused) {
    reader.requireEnd();
  }
  if (reader.hasFailed()) {
    return reader.problem(M::kType);
  }
  return message;
}

template <class M>
struct Request {
  RequestId id;
  M message;
};

/// The same of bytes that begin with the identity of a request.
template <class M>
base::Result<Request<M>> decodeRequest(std::string_view bytes) {
  Request<M> request;
  CdrReader reader(bytes);
  reader.message(request.id);
  reader.message(request.message);
  reader.requireEnd();
  if (reader.hasFailed()) {
    return reader.problem(M::kType);
  }
  return request;
}

}  // namespace bridge
