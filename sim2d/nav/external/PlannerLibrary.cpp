#include "sim2d/nav/external/PlannerLibrary.h"

#include <dlfcn.h>
#include <utility>

namespace sim2d {
namespace {

template <class Function>
void findSymbol(void* handle, const char* name, Function& to) {
  to = reinterpret_cast<Function>(::dlsym(handle, name));
}

}  // namespace

PlannerLibrary::PlannerLibrary(std::string file, void* handle)
    : file_(std::move(file)), handle_(handle) {}

PlannerLibrary::~PlannerLibrary() {
  ::dlclose(handle_);
}

base::Result<std::shared_ptr<const PlannerLibrary>> PlannerLibrary::load(const std::string& file) {
  void* const handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    const char* why = ::dlerror();  // of this thread
    return base::error("library.not-loaded", {why == nullptr ? file : std::string(why)});
  }
  const std::shared_ptr<PlannerLibrary> library(new PlannerLibrary(file, handle));
  const base::Diagnostics problems = library->check();
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<const PlannerLibrary>(library);
}

base::Diagnostics PlannerLibrary::check() {
  base::Diagnostics problems;
  const auto need = [this, &problems](const char* name, auto& to) {
    findSymbol(handle_, name, to);
    if (to == nullptr) {
      problems.push_back(base::error("library.no-symbol", {file_, name}));
    }
  };
  decltype(&hunavsim_planner_abi) abi = nullptr;
  need("hunavsim_planner_abi", abi);
  need("hunavsim_planner_create", create);
  need("hunavsim_planner_command", command);
  need("hunavsim_planner_error", error);
  need("hunavsim_planner_destroy", destroy);
  findSymbol(handle_, "hunavsim_planner_path", path);
  if (abi != nullptr && abi() != HUNAVSIM_PLANNER_ABI) {
    problems = {base::error("library.other-version", {file_, abi(), HUNAVSIM_PLANNER_ABI})};
  }
  return problems;
}

}  // namespace sim2d
