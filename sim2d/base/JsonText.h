#pragma once

#include <string>

namespace base {

/// JSON for a file or for people, two blanks deep; `indent` -1: on one line. Bytes that are no
/// UTF-8, as names of files may hold, become U+FFFD.
template <class Json>
std::string jsonText(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace base
