#pragma once

#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// The catalogue of everything that can be wrong. Who finds a problem names it by its id
/// (base::error("scenario.goal-twice", {goal})); what is written here is what the user reads.
namespace base {

struct ProblemText {
  std::string_view id;    // "area.what"; other programs go by it, so it stays
  std::string_view text;  // one sentence with holes: {name}, {nearest} = " (did you mean '…'?)",
                          // {name?words, shown only with a value, that stands at %}
  /// Something of the input is replaced, left out, or takes a default instead of what is written:
  /// `--strict` makes the warning an error. In the catalogue: `kSubstitution` behind the text.
  bool isSubstitution = false;
};

const std::vector<ProblemText>& problemTexts();
const ProblemText* problemText(std::string_view id);  // nullptr = no such problem

/// The same problems; warnings whose text is marked as a substitution are errors.
Diagnostics withStrictSubstitutions(Diagnostics problems);

}  // namespace base
