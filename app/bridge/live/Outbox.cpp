#include "app/bridge/live/Outbox.h"

#include <algorithm>
#include <iterator>

namespace live {

void Outbox::add(std::string head, SharedBytes body, Kind kind) {
  pieces_.push_back({std::move(head), std::move(body), kind});
  sumOf(kind) += pieces_.back().cost();
  keepWithin();
}

void Outbox::addNext(std::string bytes) {
  const auto at = std::find_if(firstWhole(), pieces_.end(),
                               [](const Piece& piece) { return piece.kind == Kind::Message; });
  answers_ += pieces_.insert(at, {std::move(bytes), nullptr, Kind::Answer})->cost();
}

void Outbox::dropMessages() {
  for (auto piece = firstWhole(); piece != pieces_.end();) {
    piece = piece->kind == Kind::Message ? leaveOut(piece) : std::next(piece);
  }
}

/// The first piece of which nothing is sent yet.
Outbox::Place Outbox::firstWhole() {
  return pieces_.begin() + (begun_ > 0 ? 1 : 0);
}

Outbox::Place Outbox::leaveOut(const Place& piece) {
  messages_ -= piece->cost();
  ++leftOut_;
  return pieces_.erase(piece);
}

/// The newest stays, however large it is; so does one that is half sent.
void Outbox::keepWithin() {
  for (auto piece = firstWhole();
       messages_ > most_ && piece != pieces_.end() && std::next(piece) != pieces_.end();) {
    piece = piece->kind == Kind::Message ? leaveOut(piece) : std::next(piece);
  }
}

std::vector<std::string_view> Outbox::next(std::size_t count) const {
  std::vector<std::string_view> parts;
  std::size_t skip = begun_;
  for (const Piece& piece : pieces_) {
    for (const std::string* bytes : {&piece.head, piece.body.get()}) {
      if (bytes == nullptr) {
        continue;
      }
      const std::size_t here = std::min(skip, bytes->size());
      skip -= here;
      if (here < bytes->size()) {
        if (parts.size() == count) {
          return parts;
        }
        parts.emplace_back(std::string_view(*bytes).substr(here));
      }
    }
  }
  return parts;
}

void Outbox::sent(std::size_t bytes) {
  begun_ += bytes;
  while (!pieces_.empty() && begun_ >= pieces_.front().size()) {
    begun_ -= pieces_.front().size();
    sumOf(pieces_.front().kind) -= pieces_.front().cost();
    pieces_.pop_front();
  }
}

}  // namespace live
