#include "app/cli/MapImages.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

#include <QtGlobal>

#include "editor/document/QtImageLoader.h"

namespace app {

namespace {

/// Redirects standard error to /dev/null (RAII).
class SilencedStderr {
 public:
  SilencedStderr() : kept_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) {
      std::fflush(stderr);
      ::dup2(nowhere, STDERR_FILENO);
    }
    if (nowhere >= 0) {
      ::close(nowhere);
    }
  }
  ~SilencedStderr() {
    if (kept_ >= 0) {
      std::fflush(stderr);
      ::dup2(kept_, STDERR_FILENO);
      ::close(kept_);
    }
  }
  Q_DISABLE_COPY_MOVE(SilencedStderr)

 private:
  int kept_;
};

}  // namespace

base::Result<sim2d::MapImage> loadMapImage(const std::string& path) {
  const SilencedStderr silent;
  return editor::loadMapImage(path);
}

}  // namespace app
