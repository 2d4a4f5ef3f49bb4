#pragma once

#include <string>
#include <string_view>

namespace base {

/// JSON for a file or for people, two blanks deep; `indent` -1: on one line. Bytes that are no
/// UTF-8, as names of files may hold, become U+FFFD.
template <class Json>
std::string jsonText(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

/// What the JSON library says in an exception, without its own number in front: "key 'labels' not
/// found" of "[json.exception.out_of_range.403] key 'labels' not found". Other texts stay.
inline std::string jsonReason(std::string_view what) {
  constexpr std::string_view kBegin = "[json.exception.", kEnd = "] ";
  const std::size_t end = what.rfind(kBegin, 0) == 0 ? what.find(kEnd) : std::string_view::npos;
  return std::string(end == std::string_view::npos ? what : what.substr(end + kEnd.size()));
}

}  // namespace base
