#include "sim2d/base/Problems.h"

#include <algorithm>
#include <iterator>

namespace base {
namespace {

constexpr ProblemText kTexts[] = {
#include "sim2d/base/problems.inc"  // written by CMake from problems.txt
};

constexpr bool areSortedAndUnique() {
  for (std::size_t i = 1; i < std::size(kTexts); ++i) {
    if (!(kTexts[i - 1].id < kTexts[i].id)) {
      return false;
    }
  }
  return true;
}
static_assert(areSortedAndUnique(), "problems.txt must be sorted by id, without duplicates");

}  // namespace

const std::vector<ProblemText>& problemTexts() {
  static const std::vector<ProblemText> kAll(std::begin(kTexts), std::end(kTexts));
  return kAll;
}

const ProblemText* problemText(std::string_view id) {
  const auto* found =
      std::lower_bound(std::begin(kTexts), std::end(kTexts), id,
                       [](const ProblemText& each, std::string_view key) { return each.id < key; });
  return found == std::end(kTexts) || found->id != id ? nullptr : found;
}

Diagnostics withStrictSubstitutions(Diagnostics problems) {
  for (Diagnostic& each : problems) {
    const ProblemText* const text = problemText(each.code);
    const bool isWarning = each.severity == Severity::Warning;  // infos keep their severity
    each.severity =
        isWarning && text != nullptr && text->isSubstitution ? Severity::Error : each.severity;
  }
  return problems;
}

}  // namespace base
