#pragma once

#include <string>
#include <vector>

#include "sim2d/scenario/Fields.h"

/// The keys of a scenario file as people read about them: `list keys` and FORMAT.md.
namespace sim2d {

struct KeyRow {
  std::string key;
  std::string values;    // "> 0", "planned, direct", "text" …
  std::string unit;      // may be empty
  std::string fallback;  // what counts when it is absent; "required"; empty = nothing does
  std::string help;
};
struct KeyTable {
  std::string title;  // "A robot"
  std::string path;   // before the key in `--set`: "ROBOT."
  std::vector<KeyRow> rows;
};

std::vector<KeyTable> keyTables(const FieldTables& tables = fieldTables());
std::string keysMarkdown(const FieldTables& tables = fieldTables());

}  // namespace sim2d
