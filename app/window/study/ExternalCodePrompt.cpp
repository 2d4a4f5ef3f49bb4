#include "app/window/study/ExternalCodePrompt.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "app/run/ExperimentRunner.h"
#include "app/run/RunSpec.h"
#include "app/window/NoticeBar.h"
#include "app/window/study/StudyPanel.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

using editor::SimulationRunner;

namespace {

/// "python3 follow.py (robot1)", with special characters escaped. Nothing is cut, because that
/// could hide commands.
QString codeText(const std::vector<ExternalCode>& code) {
  QStringList all;
  for (const ExternalCode& each : code) {
    const std::string words = sim2d::printableText(each.words, each.words.size());
    all << QStringLiteral("%1 (%2)").arg(QString::fromStdString(words),
                                         QString::fromStdString(each.robot));
  }
  return all.join(QStringLiteral("; "));
}

void warn(NoticeBar& notices, const QString& id, const QString& file,
          const std::vector<ExternalCode>& code, const std::function<void()>& allow) {
  notices.warn(
      id,
      QObject::tr("%1 runs external code (%2) with your permissions.").arg(file, codeText(code)),
      {{QObject::tr("Allow for this file"), allow}, {QObject::tr("Do not run"), {}}});
}

}  // namespace

ExternalCodePrompt::ExternalCodePrompt(Workspace& workspace, NoticeBar& notices, QObject* parent)
    : QObject(parent), workspace_(workspace), notices_(notices) {
  connect(&workspace, &Workspace::codePermissionNeeded, this, &ExternalCodePrompt::showPrompt);
  connect(&workspace.document(), &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {
              notices_.drop(noticeId());  // another file was opened
            }
          });
}

void ExternalCodePrompt::showPrompt(bool paused) {
  const std::vector<ExternalCode> code = workspace_.unapprovedCode();
  const auto allow = [this, code, paused] {
    workspace_.allowCode(code);
    SimulationRunner& runner = workspace_.runner();
    paused ? runner.stepOnce() : runner.play();
  };
  warn(notices_, noticeId(), workspace_.document().displayName(), code, allow);
}

void ExternalCodePrompt::attachTo(StudyPanel& study, NoticeBar& notices) {
  connect(&study, &StudyPanel::codePermissionNeeded, &notices,
          [&study, &notices](const std::vector<ExternalCode>& code) {
            if (code.empty()) {
              notices.drop(studyNoticeId());
              return;
            }
            warn(notices, studyNoticeId(), QFileInfo(study.file()).fileName(), code,
                 [&study, code] { study.allowCode(code); });
          });
}

namespace {

bool holds(const std::vector<ExternalCode>& all, const ExternalCode& code) {
  return std::find(all.begin(), all.end(), code) != all.end();
}

}  // namespace

/// Errors in scenarios and values are reported when they are run.
std::vector<ExternalCode> externalCodeOfStudy(const Experiment& experiment) {
  std::vector<ExternalCode> all;
  const std::size_t runs = experiment.runCount() / experiment.scenarios.size();
  for (std::size_t k = 0; k < experiment.scenarios.size(); ++k) {
    sim2d::Scenario first = sim2d::readScenario(experiment.scenarioPaths[k]).scenario;
    applyOptions(first, experiment.specOf(k * runs), {});
    for (const ExternalCode& code : externalCodeOf(experiment, first)) {
      if (!holds(all, code)) {
        all.push_back(code);
      }
    }
  }
  return all;
}

bool StudyCodePermissions::allows(const std::vector<ExternalCode>& code) const {
  return std::all_of(code.begin(), code.end(),
                     [this](const ExternalCode& each) { return holds(allowed_, each); });
}

void StudyCodePermissions::allow(const std::vector<ExternalCode>& code) {
  allowed_.insert(allowed_.end(), code.begin(), code.end());
  if (const auto then = std::exchange(then_, {})) {
    then();
  }
}

void StudyCodePermissions::reset() {
  allowed_.clear();
  then_ = {};
}

}  // namespace app
