#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

/// WebSocket frames (RFC 6455, sections 5 and 7) without I/O: bytes in, messages out. Not
/// thread-safe.
namespace live {

enum class Opcode : std::uint8_t { Continuation = 0, Text = 1, Binary = 2, Close = 8, Ping, Pong };

/// The reason why a connection is closed (RFC 6455, 7.4.1).
enum class CloseCode : std::uint16_t {
  Normal = 1000,
  GoingAway = 1001,
  ProtocolError = 1002,
  InvalidText = 1007,  // not UTF-8
  Policy = 1008,
  TooLarge = 1009,
  InternalError = 1011
};

constexpr std::size_t kLargestMessage = std::size_t{1} << 20U;  // [B], limit for client messages

/// The header of an unfragmented, unmasked server frame.
std::string frameHead(Opcode opcode, std::size_t payloadSize);
std::string wholeFrame(Opcode opcode, std::string_view payload);
std::string closeFrame(CloseCode code, std::string_view reason);

/// Whether the bytes are valid UTF-8: no overlong forms, surrogates or truncated characters.
bool isUtf8(std::string_view bytes);

/// A complete message of a client, with joined fragments. opcode is never Continuation.
struct WebSocketMessage {
  Opcode opcode = Opcode::Binary;
  std::string payload;
};

/// A protocol violation of a client. It ends the connection.
struct Violation {
  CloseCode code = CloseCode::ProtocolError;
  std::string_view reason;
};

/// Parses the bytes of one client, in pieces of any size. Holds at most the received part of one
/// message and of one control frame.
class FrameReader {
 public:
  explicit FrameReader(std::size_t largestMessage = kLargestMessage) : largest_(largestMessage) {}

  /// `take` receives each complete message. If it returns false, the remaining bytes are dropped.
  /// After a violation nothing is read.
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
  bool isStopped_ = false;
  std::array<std::uint8_t, 14> head_{};  // header of the current frame
  std::size_t headRead_ = 0;
  bool hasHead_ = false;
  unsigned opcode_ = 0;
  bool isLast_ = false;
  std::uint64_t length_ = 0, payloadRead_ = 0;
  std::array<std::uint8_t, 4> mask_{};
  std::optional<Opcode> messageOpcode_;  // type of an incomplete message
  std::string message_, control_;
};

}  // namespace live
