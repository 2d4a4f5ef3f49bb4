#include "app/bridge/messages/CdrWriter.h"

#include <algorithm>

namespace bridge {

namespace {

constexpr std::size_t kLeastGrowth = 256, kMostGrowth = 4096;  // [bytes]; fits into the cache

}  // namespace

CdrWriter::CdrWriter(std::string& to) : to_(to) {
  to_.append("\0\1\0\0", 4);  // plain CDR, little endian; no options
  begin_ = at_ = room_ = to_.size();
  data_ = to_.data();
}

void CdrWriter::text(std::string_view text) {
  scalar(static_cast<std::uint32_t>(text.size() + 1));
  makeRoom(text.size() + 1);
  std::copy(text.begin(), text.end(), data_ + at_);
  at_ += text.size() + 1;
}

void CdrWriter::grow(std::size_t more) {
  const std::size_t least = at_ + more;
  const std::size_t wanted = least + std::clamp(at_, kLeastGrowth, kMostGrowth);
  to_.resize(to_.capacity() >= least ? std::min(to_.capacity(), wanted) : wanted);
  data_ = to_.data();
  room_ = to_.size();
}

void CdrWriter::flush() {
  to_.resize(at_);
  room_ = at_;
}

}  // namespace bridge
