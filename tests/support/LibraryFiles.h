#pragma once

#include <cstdlib>
#include <filesystem>

/// Whether a test that takes seconds per shipped file takes this one: those of the scenario
/// library, of which there are many, with HUNAV_ALL_TESTS alone.
inline bool isTakenByLongTests(const std::filesystem::path& file) {
  return file.string().find("/maps/library/") == std::string::npos ||
         std::getenv("HUNAV_ALL_TESTS") != nullptr;  // NOLINT(concurrency-mt-unsafe)
}
