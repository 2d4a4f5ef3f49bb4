#include "app/bridge/live/WebSocketFrames.h"

#include <algorithm>
#include <utility>

namespace live {

namespace {

constexpr unsigned kFinal = 0x80, kReserved = 0x70, kOpcodeBits = 0x0F;  // first byte of a frame
constexpr unsigned kMasked = 0x80, kLengthBits = 0x7F;                   // second byte
constexpr unsigned kLength16 = 126, kLength64 = 127;                     // a longer length follows
constexpr std::size_t kLongestControl = 125;                             // [B]

bool isKnown(unsigned opcode) {
  return opcode <= 2 || (opcode >= 8 && opcode <= 10);
}

/// Codes that may be sent in a close frame (RFC 6455, 7.4).
bool isCloseCode(unsigned code) {
  const bool isStandard =
      code >= 1000 && code <= 1014 && code != 1004 && code != 1005 && code != 1006;
  return isStandard || (code >= 3000 && code <= 4999);
}

std::optional<Violation> checkClose(std::string_view payload) {
  if (payload.empty()) {
    return std::nullopt;
  }
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned>(static_cast<std::uint8_t>(payload[i]));
  };
  if (payload.size() == 1 || !isCloseCode(byte(0) << 8U | byte(1))) {
    return Violation{CloseCode::ProtocolError, "wrong close code"};
  }
  if (!isUtf8(payload.substr(2))) {
    return Violation{CloseCode::InvalidText, "the reason is not UTF-8"};
  }
  return std::nullopt;
}

/// The length of the character that starts with `first`; 0: invalid first byte.
std::size_t utf8Length(std::uint8_t first) {
  if (first < 0x80) {
    return 1;
  }
  if (first >= 0xC2 && first <= 0xDF) {
    return 2;
  }
  if (first >= 0xE0 && first <= 0xEF) {
    return 3;
  }
  return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/// Checks the second byte, which excludes overlong forms, surrogates and values above U+10FFFF (RFC
/// 3629, 4).
bool isSecond(std::uint8_t first, std::uint8_t second) {
  const std::uint8_t low = first == 0xE0 ? 0xA0 : (first == 0xF0 ? 0x90 : 0x80);
  const std::uint8_t high = first == 0xED ? 0x9F : (first == 0xF4 ? 0x8F : 0xBF);
  return second >= low && second <= high;
}

}  // namespace

bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto first = static_cast<std::uint8_t>(bytes[i]);
    const std::size_t length = utf8Length(first);
    if (length == 0 || bytes.size() - i < length) {
      return false;
    }
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<std::uint8_t>(bytes[i + k]);
      if (k == 1 ? !isSecond(first, next) : (next & 0xC0U) != 0x80U) {
        return false;
      }
    }
    i += length;
  }
  return true;
}

std::string frameHead(Opcode opcode, std::size_t payloadSize) {
  std::string head(1, static_cast<char>(kFinal | static_cast<unsigned>(opcode)));
  const auto appendBytes = [&](int count) {  // in network byte order
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
      head += static_cast<char>(static_cast<std::uint64_t>(payloadSize) >> shift & 0xFFU);
    }
  };
  if (payloadSize < kLength16) {
    appendBytes(1);
  } else if (payloadSize <= 0xFFFF) {
    head += static_cast<char>(kLength16);
    appendBytes(2);
  } else {
    head += static_cast<char>(kLength64);
    appendBytes(8);
  }
  return head;
}

std::string wholeFrame(Opcode opcode, std::string_view payload) {
  return frameHead(opcode, payload.size()).append(payload);
}

std::string closeFrame(CloseCode code, std::string_view reason) {
  const auto number = static_cast<unsigned>(code);
  std::string payload{static_cast<char>(number >> 8U), static_cast<char>(number & 0xFFU)};
  reason = reason.substr(0, kLongestControl - payload.size());
  while (!isUtf8(reason)) {  // a truncated character
    reason.remove_suffix(1);
  }
  return wholeFrame(Opcode::Close, payload.append(reason));
}

/// The size of the header, as far as known.
std::size_t FrameReader::headSize() const {
  if (headRead_ < 2) {
    return 2;
  }
  const unsigned length = head_[1] & kLengthBits;
  return 2 + (length == kLength16 ? 2U : (length == kLength64 ? 8U : 0U)) + mask_.size();
}

std::optional<Violation> FrameReader::read(std::string_view bytes, const Take& take) {
  while (!isStopped_) {
    if (!hasHead_) {
      while (!bytes.empty() && headRead_ < headSize()) {
        head_.at(headRead_++) = static_cast<std::uint8_t>(bytes.front());
        bytes.remove_prefix(1);
      }
      if (headRead_ < headSize()) {
        return std::nullopt;
      }
      if (std::optional<Violation> wrong = beginFrame()) {
        isStopped_ = true;
        return wrong;
      }
    }
    bytes.remove_prefix(takePayload(bytes));
    if (payloadRead_ < length_) {
      return std::nullopt;
    }
    hasHead_ = false;
    headRead_ = 0;
    if (std::optional<Violation> wrong = endFrame(take)) {
      isStopped_ = true;
      return wrong;
    }
  }
  return std::nullopt;
}

std::optional<Violation> FrameReader::beginFrame() {
  opcode_ = head_[0] & kOpcodeBits;
  isLast_ = (head_[0] & kFinal) != 0;
  if ((head_[0] & kReserved) != 0) {
    return Violation{CloseCode::ProtocolError, "no extension was negotiated"};
  }
  if ((head_[1] & kMasked) == 0) {
    return Violation{CloseCode::ProtocolError, "frames of a client must be masked"};
  }
  length_ = 0;
  const std::size_t maskAt = headSize() - mask_.size();
  for (std::size_t i = 2; i < maskAt; ++i) {
    length_ = length_ << 8U | head_.at(i);
  }
  if (maskAt == 2) {
    length_ = head_[1] & kLengthBits;
  }
  for (std::size_t i = 0; i < mask_.size(); ++i) {
    mask_.at(i) = head_.at(maskAt + i);
  }
  payloadRead_ = 0;
  hasHead_ = true;
  if (std::optional<Violation> wrong = checkOrder(isLast_)) {
    return wrong;
  }
  return checkLength();
}

std::optional<Violation> FrameReader::checkOrder(bool isLast) const {
  if (!isKnown(opcode_)) {
    return Violation{CloseCode::ProtocolError, "unknown opcode"};
  }
  if (isControl()) {
    return isLast
               ? std::nullopt
               : std::optional(Violation{CloseCode::ProtocolError, "a fragmented control frame"});
  }
  if ((opcode_ == static_cast<unsigned>(Opcode::Continuation)) != messageOpcode_.has_value()) {
    return Violation{CloseCode::ProtocolError, "fragments of two messages are mixed"};
  }
  return std::nullopt;
}

std::optional<Violation> FrameReader::checkLength() const {
  const unsigned encoded = head_[1] & kLengthBits;
  const bool isShortest = (encoded != kLength16 || length_ >= kLength16) &&
                          (encoded != kLength64 || (length_ > 0xFFFF && length_ >> 63U == 0));
  if (!isShortest) {
    return Violation{CloseCode::ProtocolError, "wrong length of a frame"};
  }
  if (isControl()) {
    return length_ <= kLongestControl
               ? std::nullopt
               : std::optional(Violation{CloseCode::ProtocolError, "a control frame is too long"});
  }
  if (length_ > largest_ || message_.size() > largest_ - length_) {
    return Violation{CloseCode::TooLarge, "the message is too large"};
  }
  return std::nullopt;
}

/// Returns the number of bytes that belong to the frame.
std::size_t FrameReader::takePayload(std::string_view bytes) {
  const std::size_t count =
      std::min(bytes.size(), static_cast<std::size_t>(length_ - payloadRead_));
  std::string& to = isControl() ? control_ : message_;
  for (std::size_t i = 0; i < count; ++i, ++payloadRead_) {
    const auto byte = static_cast<std::uint8_t>(bytes[i]);
    to += static_cast<char>(byte ^ mask_.at(payloadRead_ % mask_.size()));
  }
  return count;
}

std::optional<Violation> FrameReader::endFrame(const Take& take) {
  if (isControl()) {
    return hand(static_cast<Opcode>(opcode_), control_, take);
  }
  if (opcode_ != static_cast<unsigned>(Opcode::Continuation)) {
    messageOpcode_ = static_cast<Opcode>(opcode_);
  }
  if (!isLast_) {
    return std::nullopt;
  }
  const Opcode opcode = *messageOpcode_;
  messageOpcode_.reset();
  if (opcode == Opcode::Text && !isUtf8(message_)) {
    return Violation{CloseCode::InvalidText, "the text is not UTF-8"};
  }
  return hand(opcode, message_, take);
}

std::optional<Violation> FrameReader::hand(Opcode opcode, std::string& payload, const Take& take) {
  WebSocketMessage message{opcode, std::exchange(payload, std::string())};
  if (opcode == Opcode::Close) {
    if (std::optional<Violation> wrong = checkClose(message.payload)) {
      return wrong;
    }
  }
  isStopped_ = !take(std::move(message));
  return std::nullopt;
}

}  // namespace live
