#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "metrics/Samples.h"
#include "sim2d/base/Files.h"

namespace metrics {

/// A temporary file for numbers, deleted with the store. Not synchronised.
class SeriesStorage {
 public:
  using Place = base::ScratchFile::Piece;
  /// Empty if the disk is full.
  std::optional<Place> put(const std::vector<double>& numbers);
  /// Returns false if the numbers cannot be read; hasFailed() is true from then on.
  bool get(const Place& place, double* numbers);
  bool hasFailed() const { return failed_; }

 private:
  base::ScratchFile file_;
  bool failed_ = false;
};

/// An append-only list of numbers that is read sequentially; most of it is stored on disk.
class StoredSeries {
 public:
  /// Without a store, or if the disk is full, the numbers stay in memory.
  void add(double number, SeriesStorage* store);
  std::size_t size() const { return stored_ + newest_.size(); }
  /// All numbers; NaN where reading fails.
  std::vector<double> all() const;

 private:
  friend class StoredSeriesReader;

  std::vector<double> newest_;
  std::vector<SeriesStorage::Place> blocks_;
  std::size_t stored_ = 0;  // in blocks
  SeriesStorage* store_ = nullptr;
};

/// Reads the numbers sequentially, one block at a time. The list must outlive the reader.
class StoredSeriesReader {
 public:
  explicit StoredSeriesReader(const StoredSeries& numbers) : numbers_(numbers) {}
  /// Call at most size() times.
  double next();

 private:
  const StoredSeries& numbers_;
  std::vector<double> block_;
  std::size_t nextBlock_ = 0, at_ = 0;
};

struct Instant;

/// A value computed from one instant; NaN: undefined.
using Term = double (*)(const Instant& at);

/// Caches the terms of one instant, which several metrics use.
class TermCache {
 public:
  void forget() { known_.clear(); }
  double of(Term term, const Instant& at) {
    for (const auto& [known, value] : known_) {
      if (known == term) {
        return value;
      }
    }
    return known_.emplace_back(term, term(at)).second;
  }

 private:
  std::vector<std::pair<Term, double>> known_;
};

/// The newest sample of a run and the context that metrics may use; at the end of a run it
/// represents the whole run. Holds references to data of its creator.
struct Instant {
  const RunContext& context;
  const MetricParameters& parameters;
  const Sample& now;                // with a robot, Pedestrian::pair is computed
  const Sample* before;             // null at the first sample
  const Sample* earlier;            // previous but one, null at the first two
  std::size_t index = 0;            // of now, from 0
  double begin = 0.0;               // time of the first sample [s]
  std::optional<double> arrival{};  // of the robot at its goals, if an event reports it by now [s]
  bool keepsSeries = true;          // one value per sample is requested
  SeriesStorage* store = nullptr;   // stores series on disk; null: in memory
  TermCache* memory = nullptr;      // null: terms are not cached

  std::size_t count() const { return index + 1; }                         // N so far
  double elapsed() const { return now.time - begin; }                     // T at the end [s]
  double step() const { return before ? now.time - before->time : 0.0; }  // since `before` [s]
  double term(Term which) const {
    return memory != nullptr ? memory->of(which, *this) : which(*this);
  }
  bool usesHunavProfile() const { return parameters.profile == Profile::Hunav2; }
};

/// One value per sample, stored if series are requested.
class SeriesColumn {
 public:
  void add(const Instant& at, double value) {
    if (at.keepsSeries) {
      values_.add(value, at.store);
    }
  }
  std::vector<double> values() const { return values_.all(); }

 private:
  StoredSeries values_;
};

/// A sum over the samples and its terms.
class SeriesSum {
 public:
  void add(const Instant& at, double term) {
    sum_ += term;
    terms_.add(at, term);
  }
  double sum() const { return sum_; }
  std::vector<double> terms() const { return terms_.values(); }

 private:
  double sum_ = 0.0;
  SeriesColumn terms_;
};

}  // namespace metrics
