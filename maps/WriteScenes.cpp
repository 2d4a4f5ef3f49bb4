#include <cstdio>

#include "sim2d/world/realism/RealismTest.h"

/// Writes the scenes of the realism tests into the folder it is given. Part of the build.
int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: write_scenes FOLDER\n", stderr);
    return 64;
  }
  const base::Diagnostics problems = sim2d::writeScenes(words[1]);
  for (const base::Diagnostic& problem : problems) {
    std::fprintf(stderr, "%s\n", problem.text().c_str());
  }
  return base::hasErrors(problems) ? 1 : 0;
}
