#include "sim2d/base/GrowingFile.h"

#include <system_error>
#include <utility>

#include "sim2d/base/NewFile.h"

namespace base {

namespace {

constexpr std::size_t kPiece = 1U << 16U;  // [bytes] written at once

}  // namespace

GrowingFile::GrowingFile(std::string path)
    : path_(std::move(path)), part_(NewFile::open(path_, problems_)) {}

GrowingFile::~GrowingFile() = default;

void GrowingFile::note(const std::error_code& error) {
  if (error && problems_.empty()) {
    problems_.push_back(fileError("file.cannot-write", path_, error));
  }
}

void GrowingFile::flush() {
  if (problems_.empty() && part_) {
    note(part_->write(waiting_));
  }
  waiting_.clear();
}

void GrowingFile::append(std::string_view content) {
  waiting_ += content;
  if (waiting_.size() >= kPiece) {
    flush();
  }
}

const Diagnostics& GrowingFile::complete() {
  flush();
  if (problems_.empty() && part_) {
    note(part_->toDisk());
  }
  return problems_;
}

Diagnostics GrowingFile::finish() {
  complete();
  if (problems_.empty() && part_) {
    note(part_->putInPlace());
  }
  part_.reset();
  return problems_;
}

}  // namespace base
