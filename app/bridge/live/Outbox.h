#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace live {

/// Bytes that many clients may wait for, held once.
using SharedBytes = std::shared_ptr<const std::string>;

constexpr std::size_t kMostWaiting = std::size_t{8} << 20U;    // [B] of messages for a slow client
constexpr std::size_t kMostAnswers = std::size_t{256} << 10U;  // [B] of all else that waits for it

/// What waits to be sent to one client, in order. Messages of which newer ones follow may be left
/// out, the oldest first; answers never are. Thread: one at a time.
class Outbox {
 public:
  enum class Kind { Answer, Message };

  explicit Outbox(std::size_t mostWaiting = kMostWaiting) : most_(mostWaiting) {}

  /// Answers alone do not push messages out: whoever has many of them waiting is not read from
  /// (`hasManyAnswers`).
  void add(std::string head, SharedBytes body = nullptr, Kind kind = Kind::Answer);
  /// An answer that is sent before all messages that have not begun.
  void addNext(std::string bytes);
  /// No message that has not begun is sent.
  void dropMessages();

  bool isEmpty() const { return pieces_.empty(); }
  bool hasManyAnswers() const { return answers_ > kMostAnswers; }
  std::size_t waiting() const { return messages_ + answers_; }  // [B]
  std::size_t leftOut() const { return leftOut_; }              // messages, since the beginning

  /// What comes next, in at most `count` parts.
  std::vector<std::string_view> next(std::size_t count) const;
  /// So many bytes of that are on their way.
  void sent(std::size_t bytes);

 private:
  struct Piece {
    std::string head;
    SharedBytes body;
    Kind kind;
    std::size_t size() const { return head.size() + (body ? body->size() : 0); }
    std::size_t cost() const { return size() + kEach; }
  };
  static constexpr std::size_t kEach = 128;  // [B] of memory beside the bytes
  using Place = std::deque<Piece>::iterator;
  Place firstWhole();
  Place leaveOut(const Place& piece);
  void keepWithin();
  std::size_t& sumOf(Kind kind) { return kind == Kind::Message ? messages_ : answers_; }

  std::size_t most_;
  std::deque<Piece> pieces_;
  std::size_t begun_ = 0;  // [B] of the first piece that are sent
  std::size_t messages_ = 0, answers_ = 0, leftOut_ = 0;
};

}  // namespace live
