#pragma once

#include <cstdio>
#include <cstdlib>

/// A property that must hold for every input; a fuzzer stops where it does not.
inline void require(bool holds, const char* property) {
  if (!holds) {
    std::fprintf(stderr, "property broken: %s\n", property);
    std::abort();
  }
}
