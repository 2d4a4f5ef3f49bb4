#pragma once

#include <string>

#include "bt/tree/TreeXml.h"
#include "tests/bt/TreeProbe.h"

/// Tree files as texts.
namespace probe {

/// Nothing, with a warning, when the text is refused.
inline bt::TreeFile parsed(const std::string& xml) {
  const base::Result<bt::TreeFile> file = bt::readTreeText(xml, "t.xml");
  if (!file) {
    qWarning("%s", textOf(file.diagnostics()).c_str());
    return {};
  }
  return *file;
}

inline std::string tree(const char* id, const char* body) {
  return std::string("<BehaviorTree ID=\"") + id + "\">" + body + "</BehaviorTree>";
}

inline std::string root(const std::string& body, const char* attributes = "BTCPP_format=\"4\"") {
  return std::string("<root ") + attributes + ">" + body + "</root>";
}

}  // namespace probe
