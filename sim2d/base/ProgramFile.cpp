#include "sim2d/base/ProgramFile.h"

#include <dlfcn.h>
#include <filesystem>
#include <system_error>

namespace base {

namespace fs = std::filesystem;

std::string programFile() {
  std::error_code error;
  const fs::path path = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string() : path.string();
}

std::string codeFile() {
  Dl_info info = {};
  const bool isKnown =
      dladdr(reinterpret_cast<const void*>(&programFile), &info) != 0 && info.dli_fname != nullptr;
  const fs::path file = isKnown ? fs::path(info.dli_fname) : fs::path();
  // The name of an executable may be relative to a folder that is no longer the current one.
  return file.extension() == ".so" ? file.string() : programFile();
}

}  // namespace base
