#include "app/cli/MapImages.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

#include "editor/document/QtImageLoader.h"

namespace app {

namespace {

/// What libraries write to the standard error is lost as long as it lives.
class SilentError {
 public:
  SilentError() : kept_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) {
      std::fflush(stderr);
      ::dup2(nowhere, STDERR_FILENO);
    }
    if (nowhere >= 0) {
      ::close(nowhere);
    }
  }
  ~SilentError() {
    if (kept_ >= 0) {
      std::fflush(stderr);
      ::dup2(kept_, STDERR_FILENO);
      ::close(kept_);
    }
  }
  SilentError(const SilentError&) = delete;
  SilentError& operator=(const SilentError&) = delete;
  SilentError(SilentError&&) = delete;
  SilentError& operator=(SilentError&&) = delete;

 private:
  int kept_;
};

}  // namespace

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  const SilentError silent;
  return editor::loadMapImage(path);
}

}  // namespace app
