#include "sim2d/trace/JsonInput.h"

#include <algorithm>
#include <string>

#include "sim2d/base/JsonText.h"

namespace sim2d {

std::optional<nlohmann::json> parseJsonInput(const ForeignInput& input) {
  try {
    return nlohmann::json::parse(input.text);
  } catch (const nlohmann::json::parse_error& problem) {
    const std::size_t at = std::min(problem.byte > 0 ? problem.byte - 1 : 0, input.text.size());
    const auto begin = input.text.begin();
    const auto place = begin + static_cast<std::ptrdiff_t>(at);
    const auto line = std::count(begin, place, '\n');
    const std::size_t lineEnd = at == 0 ? std::string::npos : input.text.rfind('\n', at - 1);
    const std::size_t column = lineEnd == std::string::npos ? at + 1 : at - lineEnd;
    input.problems.push_back(base::error("trace.not-json", {}, input.path,
                                         static_cast<int>(line) + 1, static_cast<int>(column)));
  } catch (const nlohmann::json::exception& problem) {  // a number out of range
    input.problems.push_back(
        base::error("tracks.bad-json", {base::jsonReason(problem.what())}, input.path));
  }
  return std::nullopt;
}

}  // namespace sim2d
