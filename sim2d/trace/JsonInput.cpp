#include "sim2d/trace/JsonInput.h"

#include <algorithm>

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
    input.problems.push_back(base::error("tracks.bad-json", {jsonReason(problem)}, input.path));
  }
  return std::nullopt;
}

std::string jsonReason(const nlohmann::json::exception& problem) {
  const std::string text = problem.what();  // "[json.exception.type_error.302] type must be …"
  const std::size_t end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace sim2d
