#pragma once

#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "sim2d/base/Text.h"

namespace base {

/// JSON text, indented by two spaces; `indent` -1: on one line. Bytes that are not UTF-8 (as in
/// file names) become U+FFFD.
template <class Json>
std::string jsonText(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

constexpr int kMaxJsonDepth = 200;  // no file of this program nests deeper

/// The text up to the first bracket that nests deeper than `depth`; the whole text if there is
/// none. JSON from files and connections is parsed through it, and is not valid if it was cut: the
/// functions of the library that copy, compare or write values are recursive.
std::string_view shallowJson(std::string_view json, int depth = kMaxJsonDepth);

/// A number; null if it is NaN or infinite, which JSON does not have.
template <class Json>
Json jsonNumber(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// The text of a JSON exception without its id: "[json.exception.out_of_range.403] key 'labels' not
/// found" gives "key 'labels' not found". Other texts are returned unchanged.
inline std::string jsonErrorMessage(std::string_view what) {
  constexpr std::string_view kBegin = "[json.exception.", kEnd = "] ";
  const std::size_t end = startsWith(what, kBegin) ? what.find(kEnd) : std::string_view::npos;
  return std::string(end == std::string_view::npos ? what : what.substr(end + kEnd.size()));
}

/// The message of an unexpected exception.
inline std::string exceptionMessage(const std::exception& problem) {
  return dynamic_cast<const std::bad_alloc*>(&problem) != nullptr
             ? "not enough memory"
             : jsonErrorMessage(problem.what());
}

}  // namespace base
