#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

/// The frames of WebSocket (RFC 6455, sections 5 and 7), without input and output: bytes in,
/// messages out. Thread: one at a time.
namespace live {

enum class Opcode : std::uint8_t { Continuation = 0, Text = 1, Binary = 2, Close = 8, Ping, Pong };

/// Why a connection is closed (RFC 6455, 7.4.1).
enum class CloseCode : std::uint16_t {
  Normal = 1000,
  GoingAway = 1001,
  ProtocolError = 1002,
  WrongText = 1007,  // no UTF-8
  Policy = 1008,
  TooLarge = 1009,
  InternalError = 1011
};

constexpr std::size_t kLargestMessage = std::size_t{1} << 20U;  // [B] that a client may send

/// What stands before the payload of a frame of the server, which is whole and not masked.
std::string frameHead(Opcode opcode, std::size_t payloadSize);
std::string wholeFrame(Opcode opcode, std::string_view payload);
std::string closeFrame(CloseCode code, std::string_view reason);

/// Whether the bytes are UTF-8: no overlong forms, no surrogates, nothing cut off.
bool isUtf8(std::string_view bytes);

/// A message of a client, its fragments joined; Opcode is never Continuation.
struct WebSocketMessage {
  Opcode opcode = Opcode::Binary;
  std::string payload;
};

/// What a client did against the rules: the connection ends with it.
struct Violation {
  CloseCode code = CloseCode::ProtocolError;
  std::string_view reason;
};

/// Takes the bytes of one client, in pieces of any size. It holds at most one message and one
/// control frame, and of those only what has come.
class FrameReader {
 public:
  explicit FrameReader(std::size_t largestMessage = kLargestMessage) : largest_(largestMessage) {}

  /// `take` gets each message when it is whole and says whether more is wanted; what stands behind
  /// it is dropped otherwise. After a violation nothing is read any more.
  using Take = std::function<bool(WebSocketMessage&& message)>;
  std::optional<Violation> read(std::string_view bytes, const Take& take);

 private:
  bool isControl() const { return (opcode_ & 8U) != 0; }
  std::size_t headSize() const;
  std::optional<Violation> beginFrame();
  std::optional<Violation> checkOrder(bool isLast) const;
  std::optional<Violation> checkLength() const;
  std::size_t takePayload(std::string_view bytes);
  std::optional<Violation> endFrame(const Take& take);
  std::optional<Violation> hand(Opcode opcode, std::string& payload, const Take& take);

  std::size_t largest_;
  bool isOver_ = false;
  std::array<std::uint8_t, 14> head_{};  // of the frame that is read
  std::size_t headRead_ = 0;
  bool hasHead_ = false;
  unsigned opcode_ = 0;
  bool isLast_ = false;
  std::uint64_t length_ = 0, payloadRead_ = 0;
  std::array<std::uint8_t, 4> mask_{};
  std::optional<Opcode> begun_;  // of a message whose last fragment has not come
  std::string message_, control_;
};

}  // namespace live
