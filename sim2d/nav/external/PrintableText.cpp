#include "sim2d/nav/external/PrintableText.h"

#include <algorithm>

namespace sim2d {
namespace {

bool isContinuationByte(char c) {  // UTF-8 continuation byte
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

}  // namespace

std::string printableText(std::string_view text, std::size_t most) {
  std::size_t size = std::min(text.size(), most);
  while (size > 0 && size < text.size() && isContinuationByte(text[size])) {
    --size;
  }
  std::string shown(text.substr(0, size));
  std::replace_if(
      shown.begin(), shown.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }, '?');
  return size < text.size() ? shown + "…" : shown;
}

}  // namespace sim2d
