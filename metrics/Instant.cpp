#include "metrics/Instant.h"

namespace metrics {

double TermMemory::of(Term term, const Sample& sample, const MetricParameters& parameters) {
  for (const auto& [known, value] : known_) {
    if (known == term) {
      return value;
    }
  }
  return known_.emplace_back(term, term(sample, parameters)).second;
}

double Instant::term(Term which) const {
  return memory != nullptr ? memory->of(which, now, parameters) : which(now, parameters);
}

}  // namespace metrics
