#pragma once

#include <optional>
#include <vector>

#include "sim2d/base/Files.h"

namespace metrics {

/// A temporary file for numbers that is gone with the store. One thread at a time.
class NumberStore {
 public:
  using Place = base::ScratchFile::Piece;
  /// None when the disk takes no more.
  std::optional<Place> put(const std::vector<double>& numbers);
  /// False when they cannot be read back; hasFailed() from then on.
  bool get(const Place& place, double* numbers);
  bool hasFailed() const { return failed_; }

 private:
  base::ScratchFile file_;
  bool failed_ = false;
};

/// A list of numbers that only grows and is read from the front; most of it is on the disk.
class StoredNumbers {
 public:
  /// Without store all stay in memory, and while the disk takes no more.
  void add(double number, NumberStore* store);
  std::size_t size() const { return stored_ + newest_.size(); }
  /// All; NaN where the store failed.
  std::vector<double> all() const;

 private:
  friend class StoredNumbersReader;

  std::vector<double> newest_;
  std::vector<NumberStore::Place> blocks_;
  std::size_t stored_ = 0;  // in blocks
  NumberStore* store_ = nullptr;
};

/// Reads them one after the other, a block at a time. They must outlive the reader.
class StoredNumbersReader {
 public:
  explicit StoredNumbersReader(const StoredNumbers& numbers) : numbers_(numbers) {}
  /// As often as there are numbers.
  double next();

 private:
  const StoredNumbers& numbers_;
  std::vector<double> block_;
  std::size_t nextBlock_ = 0, at_ = 0;
};

}  // namespace metrics
