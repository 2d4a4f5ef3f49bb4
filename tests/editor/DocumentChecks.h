#pragma once

#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/ScenarioDocument.h"

/// For tests of documents and their files.
namespace small {

/// A tree that somebody wrote.
constexpr const char* kOwnTree =
    "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
    "    <AlwaysSuccess/>\n  </BehaviorTree>\n</root>\n";

/// The small scenario, in its room unless on the open plane.
struct Document : editor::ScenarioDocument {
  explicit Document(bool hasRoom = true) {
    load(small::scenario());
    if (hasRoom) {
      setMap(small::room());
    }
  }
};

/// No errors; the first fails the test.
inline void check(const base::Diagnostics& found) {
  for (const base::Diagnostic& diagnostic : found) {
    QVERIFY2(diagnostic.severity != base::Severity::Error, diagnostic.text().c_str());
  }
}

}  // namespace small
