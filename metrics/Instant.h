#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "metrics/NumberStore.h"
#include "metrics/Samples.h"

namespace metrics {

struct Instant;

/// Of one instant alone; NaN = undefined there.
using Term = double (*)(const Instant& at);

/// The terms of one instant, each worked out once for all metrics that ask.
class TermMemory {
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

/// The newest sample of a run as metrics meet it, and what they may know of those before. At the
/// end of a run it stands for the whole of it. Refers to what its maker holds.
struct Instant {
  const RunContext& context;
  const MetricParameters& parameters;
  const Sample& now;                // with a robot, Person::pair is known
  const Sample* before;             // null at the first sample
  const Sample* earlier;            // the one before that, null at the first two
  std::size_t index = 0;            // of now, from 0
  double begin = 0.0;               // time of the first sample [s]
  std::optional<double> arrival{};  // of the robot at its goals, by an event up to here [s]
  bool keepsSeries = true;          // one value per sample is requested
  NumberStore* store = nullptr;     // takes series; null: they stay in memory
  TermMemory* memory = nullptr;     // null: terms are worked out again

  std::size_t count() const { return index + 1; }                         // N up to here
  double elapsed() const { return now.time - begin; }                     // T at the end [s]
  double step() const { return before ? now.time - before->time : 0.0; }  // since the last [s]
  double term(Term which) const {
    return memory != nullptr ? memory->of(which, *this) : which(*this);
  }
  bool isOriginal() const { return parameters.profile == Profile::Hunav2; }
};

/// One value per sample, kept where series are wanted.
class SeriesColumn {
 public:
  void add(const Instant& at, double value) {
    if (at.keepsSeries) {
      values_.add(value, at.store);
    }
  }
  std::vector<double> values() const { return values_.all(); }

 private:
  StoredNumbers values_;
};

/// A sum over the samples with its terms.
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
