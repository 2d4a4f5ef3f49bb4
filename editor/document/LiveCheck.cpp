#include "editor/document/LiveCheck.h"

namespace editor {

namespace {

constexpr std::int64_t kMostCells = 4'000'000;  // of larger maps the world is made by a run alone

}  // namespace

void LiveCheck::start(app::Bundle bundle) {
  task_.start([bundle = std::move(bundle)] {
    const bool isLarge =
        bundle.map && std::int64_t{bundle.map->width()} * bundle.map->height() > kMostCells;
    base::Diagnostics found =
        app::check(bundle, isLarge ? app::CheckDepth::Meaning : app::CheckDepth::World).problems;
    found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(bundle.remarks.size()));
    return found;
  });
}

}  // namespace editor
