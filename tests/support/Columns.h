#pragma once

#include <cstddef>

#include <QtTest>

/// Adds the columns of a table of test data: their types and names.
template <class... Types>
void addColumns(const char* const (&names)[sizeof...(Types)]) {
  std::size_t next = 0;
  (QTest::addColumn<Types>(names[next++]), ...);
}
