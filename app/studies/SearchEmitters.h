#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/studies/CmaEs.h"
#include "app/studies/EliteArchive.h"
#include "app/studies/SearchSpace.h"

namespace app {

/// What is known about a candidate after its run.
struct RatedCandidate {
  Candidate candidate;
  double fitness = 0.0;  // larger is better; -infinity: it could not run
};

/// Proposes the candidates of a search. Two emitters take turns within each batch, each with a
/// CMA-ES over the continuous values: one optimises the fitness with restarts (IPOP), the other one
/// searches for new and better cells of the archive and restarts from a random elite when a
/// generation has changed none (improvement emitter of CMA-ME; Fontaine et al. 2020,
/// arXiv:1912.02400). Their categories are those of the best candidate and of the elite; a share of
/// the candidates gets another option of one category. Without continuous values, candidates are
/// new combinations near elites or at random.
class SearchEmitters {
 public:
  /// The space must outlive this.
  SearchEmitters(const SearchSpace& space, std::uint64_t seed);

  /// Candidates spread over the whole space: a Sobol sequence with random categories.
  /// `isBalanced`: with equally frequent options of each category instead of random ones.
  std::vector<Candidate> first(std::size_t count, bool isBalanced = false);
  /// The next batch. `elites`: numbers of the runs in the archive; `rated`: all candidates so far,
  /// by number of their run.
  std::vector<Candidate> next(const std::vector<std::size_t>& elites,
                              const std::vector<RatedCandidate>& rated);
  /// The results of the batch of next(), in its order.
  void tell(const std::vector<double>& fitness,
            const std::vector<std::optional<EliteArchive::Change>>& changes);

 private:
  std::vector<Candidate> candidatesAt(const std::vector<Point>& points,
                                      const std::vector<std::size_t>& choices);
  std::vector<Candidate> combinations(const std::vector<std::size_t>& elites,
                                      const std::vector<RatedCandidate>& rated);
  std::optional<std::vector<std::size_t>> newCombination(const std::vector<std::size_t>& elites,
                                                         const std::vector<RatedCandidate>& rated);
  void restartImprovement(const Candidate& elite);

  const SearchSpace& space_;
  const std::uint64_t seed_;
  SearchRandom random_;
  std::unique_ptr<RestartedCmaEs> optimiser_;
  std::unique_ptr<CmaEs> improver_;
  std::vector<std::size_t> improverChoices_;
  int improverRestarts_ = 0;
  std::size_t optimiserCount_ = 0;               // candidates of the optimiser in the current batch
  std::set<std::vector<std::size_t>> proposed_;  // combinations, without continuous values
};

}  // namespace app
