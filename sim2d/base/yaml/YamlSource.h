#pragma once

#include <string>
#include <string_view>

#include "sim2d/base/Result.h"

/// What is wrong with a text before a YAML parser sees it. Private to this folder.
namespace base {

/// Line of the first byte that is not text in UTF-8; 0 = all is.
int lineOfBinary(std::string_view text);
/// An error for each line that begins with a tab.
void findTabs(std::string_view text, const std::string& file, Diagnostics& diagnostics);
/// Without byte order mark and carriage returns, so that columns are those of an editor.
std::string normalised(std::string_view text);

}  // namespace base
