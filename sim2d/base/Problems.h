#pragma once

#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// The catalogue of diagnostics, compiled in from problems.txt. Code names a problem by its id
/// (base::error("scenario.goal-twice", {goal})); the text there is shown to the user.
namespace base {

struct ProblemText {
  std::string_view id;    // "area.what"; programs depend on it, so it does not change
  std::string_view text;  // one sentence with placeholders: {name}, {nearest} = " (did you mean
                          // '…'?)", {name?text, shown only with a value, which replaces %}
  /// The input is replaced, left out, or replaced by a default: `--strict` makes this warning an
  /// error. In the catalogue: `(substitution)` after the id.
  bool isSubstitution = false;
};

const std::vector<ProblemText>& problemTexts();
const ProblemText* problemText(std::string_view id);  // nullptr: unknown id

/// The problems, with warnings marked as substitutions turned into errors.
Diagnostics withStrictSubstitutions(Diagnostics problems);

}  // namespace base
