#include "app/studies/DeltaDebugging.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

namespace app {

namespace {

/// The elements in `parts` chunks whose sizes differ by one at most.
std::vector<ElementSet> chunksOf(const ElementSet& elements, std::size_t parts) {
  std::vector<ElementSet> chunks;
  for (std::size_t k = 0; k < parts; ++k) {
    const auto from = static_cast<std::ptrdiff_t>(elements.size() * k / parts);
    const auto to = static_cast<std::ptrdiff_t>(elements.size() * (k + 1) / parts);
    chunks.emplace_back(elements.begin() + from, elements.begin() + to);
  }
  return chunks;
}

std::vector<ElementSet> complementsOf(const ElementSet& elements,
                                      const std::vector<ElementSet>& chunks) {
  std::vector<ElementSet> complements;
  for (const ElementSet& chunk : chunks) {
    ElementSet rest;
    std::set_difference(elements.begin(), elements.end(), chunk.begin(), chunk.end(),
                        std::back_inserter(rest));
    complements.push_back(std::move(rest));
  }
  return complements;
}

/// The first subset that fails.
base::Result<std::optional<ElementSet>> firstFailure(const std::vector<ElementSet>& subsets,
                                                     const SubsetTest& fails) {
  const base::Result<std::vector<bool>> results = fails(subsets);
  if (!results) {
    return results.diagnostics();
  }
  const auto found = std::find(results->begin(), results->end(), true);
  return found == results->end() ? std::optional<ElementSet>()
                                 : subsets[static_cast<std::size_t>(found - results->begin())];
}

}  // namespace

base::Result<ElementSet> minimalFailure(std::size_t count, const SubsetTest& fails) {
  ElementSet elements(count);
  std::iota(elements.begin(), elements.end(), 0);
  const auto nothing = firstFailure({ElementSet()}, fails);
  if (!nothing) {
    return nothing.diagnostics();
  }
  if (nothing->has_value()) {
    return ElementSet();
  }
  std::size_t parts = 2;
  while (elements.size() > 1) {
    const std::vector<ElementSet> chunks = chunksOf(elements, parts);
    auto found = firstFailure(chunks, fails);
    const bool isChunk = found && found->has_value();
    if (found && !isChunk && parts > 2) {  // with two parts the complements are the chunks
      found = firstFailure(complementsOf(elements, chunks), fails);
    }
    if (!found) {
      return found.diagnostics();
    }
    if (found->has_value()) {
      elements = **found;
      parts = isChunk ? 2 : std::max<std::size_t>(parts - 1, 2);
    } else if (parts < elements.size()) {
      parts = std::min(2 * parts, elements.size());
    } else {
      break;
    }
  }
  return elements;
}

}  // namespace app
