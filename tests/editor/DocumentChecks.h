#pragma once

#include <QtTest>

#include "sim2d/base/Result.h"

/// For tests of documents and their files.
namespace small {

/// A tree that somebody wrote.
constexpr const char* kOwnTree =
    "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
    "    <AlwaysSuccess/>\n  </BehaviorTree>\n</root>\n";

/// No errors; the first fails the test.
inline void check(const base::Diagnostics& found) {
  for (const base::Diagnostic& diagnostic : found) {
    QVERIFY2(diagnostic.severity != base::Severity::Error, diagnostic.text().c_str());
  }
}

}  // namespace small
