#include "sim2d/base/JsonText.h"

#include <cstddef>

namespace base {

std::string_view shallowJson(std::string_view json, int depth) {
  int level = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (isInString) {
      i += c == '\\' ? 1 : 0;
      isInString = c != '"';
    } else if (c == '"') {
      isInString = true;
    } else if (c == '[' || c == '{') {
      if (++level > depth) {
        return json.substr(0, i);
      }
    } else if (c == ']' || c == '}') {
      --level;
    }
  }
  return json;
}

}  // namespace base
