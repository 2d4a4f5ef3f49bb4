#pragma once

#include <string>
#include <vector>

#include "app/run/Fork.h"
#include "app/run/RunStages.h"

namespace app {

/// What a recorded run was made of, so that it can be made again.
struct RunMaking {
  Bundle bundle;  // from its beginning
  std::vector<ForkStage> stages;
};

/// Of the folder of a run. Errors: it does not tell; files that it was made of are others by now.
base::Result<RunMaking> makingOf(const std::string& folder, const RunWordsReader& readWords,
                                 const sim2d::ImageLoader& loader);

/// Warns when the program that wrote the folder is another one than this.
base::Diagnostics otherProgram(const std::string& folder);

}  // namespace app
