#include "sim2d/base/yaml/YamlSource.h"

namespace base {
namespace {

std::size_t sequenceLength(unsigned char lead) {
  if (lead < 0x80) {
    return 1;
  }
  if (lead >= 0xC2 && lead < 0xE0) {
    return 2;
  }
  if (lead >= 0xE0 && lead < 0xF0) {
    return 3;
  }
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

}  // namespace

int lineOfBinary(std::string_view text) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = sequenceLength(lead);
    bool good = length > 0 && i + length <= text.size();
    good = good && (lead >= 0x20 || lead == '\n' || lead == '\r' || lead == '\t');
    for (std::size_t k = 1; good && k < length; ++k) {
      good = (static_cast<unsigned char>(text[i + k]) & 0xC0) == 0x80;
    }
    if (!good) {
      return line;
    }
    line += lead == '\n' ? 1 : 0;
    i += length;
  }
  return 0;
}

void findTabs(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
  int line = 1;
  for (std::size_t start = 0; start < text.size(); ++line) {
    std::size_t end = text.find('\n', start);
    end = end == std::string_view::npos ? text.size() : end;
    const std::string_view content = text.substr(start, end - start);
    const std::size_t word = content.find_first_not_of(" \t\r");
    const std::size_t tab = content.find('\t');
    if (word != std::string_view::npos && content[word] != '#' && tab < word) {
      diagnostics.push_back(error("yaml.tab", {}, file, line, static_cast<int>(tab) + 1));
    }
    start = end + 1;
  }
}

std::string normalised(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") {
    text.remove_prefix(3);
  }
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      result.push_back(text[i]);
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      result.push_back('\n');
    }
  }
  return result;
}

}  // namespace base
