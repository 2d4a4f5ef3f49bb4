#include "app/run/MetricsChoice.h"

#include <filesystem>

#include "sim2d/base/Text.h"

namespace app {

base::Diagnostics chooseMetrics(const MetricsWords& words, MetricsSetup& setup,
                                base::Diagnostics& wrongWords) {
  setup.parameters.profile = *metrics::profileOf(words.profile);
  if (words.metrics.empty()) {
    return {};
  }
  std::error_code ignored;
  const bool namesAFile = words.metrics.find_first_of("/.") != std::string::npos;
  if (namesAFile || std::filesystem::exists(words.metrics, ignored)) {
    const base::Result<metrics::MetricsFile> file = metrics::readMetricsFile(words.metrics);
    if (file) {
      setup.selection.keys = file->selection.keys;
      setup.selection.own = file->selection.own;
    }
    return file.diagnostics();
  }
  const base::Result<metrics::Selection> chosen =
      metrics::selectionOfKeys(base::split(words.metrics, ','));
  if (chosen) {
    setup.selection.keys = chosen->keys;
    setup.selection.own.clear();
  }
  base::append(wrongWords, chosen.diagnostics());
  return {};
}

}  // namespace app
