#include "app/bridge/dds/OwnAnswers.h"

namespace bridge {
namespace {

constexpr std::size_t kMostWaiting = 100;

}  // namespace

void OwnAnswers::recognizeBy(Recognize recognize) {
  const std::lock_guard<std::mutex> lock(mutex_);
  recognize_ = std::move(recognize);
}

std::optional<OwnAnswers::Answer> OwnAnswers::next() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty()) {
    return std::nullopt;
  }
  Answer answer = std::move(waiting_.front());
  waiting_.pop_front();
  return answer;
}

void OwnAnswers::on_data_available(efd::DataReader* reader) {
  Bytes bytes;
  efd::SampleInfo info;
  bool isAnyOurs = false;
  while (takeNext(*reader, bytes, info)) {
    isAnyOurs = keepIfOurs(bytes, info) || isAnyOurs;
  }
  if (isAnyOurs) {
    bell_.ring();
  }
}

bool OwnAnswers::keepIfOurs(Bytes& bytes, const efd::SampleInfo& info) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::optional<std::int64_t> number = recognize_ ? recognize_(bytes, info) : std::nullopt;
  if (!number) {
    return false;
  }
  if (waiting_.size() >= kMostWaiting) {
    waiting_.pop_front();
  }
  waiting_.emplace_back(*number, std::move(bytes));
  return true;
}

}  // namespace bridge
