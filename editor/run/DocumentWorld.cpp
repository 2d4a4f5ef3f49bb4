#include "editor/run/DocumentWorld.h"

#include "app/run/Bundle.h"

namespace editor {

RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings) {
  app::Bundle bundle = document.bundle();
  bundle.settings = settings;
  RunRequest request;
  request.rule = sim2d::stopRuleOf(*bundle.scenario);
  request.recordEvery = bundle.scenario->desktop.recordEvery.value_or(1);
  request.makeWorld = [bundle =
                           std::move(bundle)]() -> base::Result<std::unique_ptr<sim2d::World>> {
    app::Verdict verdict = app::check(bundle);
    if (!verdict.world) {
      return std::move(verdict.problems);
    }
    return {std::move(verdict.world), std::move(verdict.worldRemarks)};
  };
  return request;
}

}  // namespace editor
