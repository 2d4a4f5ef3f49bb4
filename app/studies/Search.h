#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/EliteArchive.h"
#include "app/studies/FailureKind.h"
#include "app/studies/FailureShrinking.h"
#include "app/studies/SearchCoverage.h"
#include "app/studies/SearchEmitters.h"
#include "app/studies/SearchSpace.h"

/// Search for the worst runs, for failures that differ in kind, and for runs that execute nodes of
/// behaviour trees that no other run has executed.
namespace app {

struct SearchPlan {
  std::string worst;       // key of a metric to make worse; empty: search for failures
  bool covers = false;     // instead of failures, nodes of behaviour trees that no run has executed
  std::size_t runs = 500;  // of the search, without shrinking
  /// The search ends when it has failures of so many kinds, unless it searches for the worst value.
  std::size_t failures = 1;
  std::size_t shrinkRuns = 400;  // limit per failure
  std::uint64_t seed = 1;        // of the search itself
  std::array<Descriptor, 2> descriptors = defaultDescriptors();
  ContactJudge countsAgainstRobot;  // empty: all contacts count

  /// The direction of the nearest person at the end in eight sectors, and the number of people near
  /// the robot.
  static std::array<Descriptor, 2> defaultDescriptors();
};

/// The worst that a metric can be is its largest (1) or smallest (-1) value; 0: the metric is
/// unknown or neither is better.
int worseDirection(const std::string& metric);

/// The metrics that the runs of a search compute, as comma-separated keys.
std::string searchedMetrics(const SearchPlan& plan);

/// One run of a search.
struct SearchedRun {
  Candidate candidate;
  bool wasSimulated = false;
  std::string reason, simulated;  // of its end; [s]
  double value = 0.0;             // of the metric; NaN: undefined
  double fitness = 0.0;           // see fitnessOf()
  std::array<double, 2> descriptors{};
  std::optional<FailureKind> kind;  // it is a failure
  std::size_t newNodes = 0;         // of behaviour trees, with SearchPlan::covers
  bool isUnavoidable = false;       // a contact that does not count; judged for new kinds only
};

/// A failure of a kind that no earlier run had.
struct FoundFailure {
  std::size_t run = 0;
  FailureKind kind;
  RunRequest request;
  ResultRow row;
};

struct SearchResult {
  std::vector<SearchedRun> runs;
  EliteArchive archive;
  SearchCoverage coverage;             // with SearchPlan::covers
  std::vector<FoundFailure> failures;  // in the order in which they were found
  std::optional<FoundFailure> worst;   // with SearchPlan::worst: the run with the worst value
  std::size_t notSimulated = 0;
  std::string firstProblem;  // why the first of them could not run

  /// With SearchPlan::covers: the runs that executed a node first; they form the archive.
  std::vector<std::size_t> coveringRuns() const;

  explicit SearchResult(const std::array<Descriptor, 2>& descriptors) : archive(descriptors) {}
};

/// How good a run is for the search. With a metric: its value in the worse direction. Otherwise a
/// failure has 1 + 1/(1 + t/30 s), more the earlier it ends at t, and another run the larger one of
/// 1/(1 + smallest gap to people [m]) and the share of time standing still. -infinity: not
/// simulated, or the metric is undefined.
double fitnessOf(const ResultRow& row, const SearchPlan& plan);

/// Searches. To cover trees, it rates all runs again after each batch, by the rarity of their nodes
/// (SearchCoverage), and ends when there is no missing node; the results of `run` must have trees.
/// Equal plans give equal results for any number of parallel processes. Errors: those of `run` and
/// of the judge.
base::Result<SearchResult> search(const SearchSpace& space, const SearchPlan& plan,
                                  const RunMany& run);

}  // namespace app
