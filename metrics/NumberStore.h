#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace metrics {

/// Numbers put aside on the disk, in a temporary file that is gone with the store. One thread at a
/// time.
class NumberStore {
 public:
  using Place = long;  // [B] in the file
  NumberStore();
  NumberStore(const NumberStore&) = delete;
  NumberStore& operator=(const NumberStore&) = delete;
  NumberStore(NumberStore&&) = delete;
  NumberStore& operator=(NumberStore&&) = delete;
  ~NumberStore() = default;

  /// None when the disk takes no more.
  std::optional<Place> put(const double* numbers, std::size_t count);
  /// False when they cannot be read back; hasFailed() from then on.
  bool get(Place place, double* numbers, std::size_t count);
  bool hasFailed() const { return failed_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // null: none could be made
  Place end_ = 0;
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
  struct Block {
    NumberStore::Place place = 0;
    std::size_t count = 0;
  };
  void putAside(NumberStore& store);

  std::vector<double> newest_;
  std::vector<Block> blocks_;
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
