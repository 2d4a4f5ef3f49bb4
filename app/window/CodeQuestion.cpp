#include "app/window/CodeQuestion.h"

#include <QFileInfo>

#include "app/window/NoticeBar.h"
#include "app/window/StudyPanel.h"
#include "sim2d/nav/external/ShownText.h"

namespace app {

using editor::SimulationRunner;

namespace {

/// "python3 follow.py (robot1)", whatever stands in it; nothing is cut, for that could hide things.
QString wordsOf(const std::vector<ForeignCode>& code) {
  QStringList all;
  for (const ForeignCode& each : code) {
    const std::string words = sim2d::shownText(each.words, each.words.size());
    all << QStringLiteral("%1 (%2)").arg(QString::fromStdString(words),
                                         QString::fromStdString(each.robot));
  }
  return all.join(QStringLiteral("; "));
}

void warn(NoticeBar& notices, const QString& id, const QString& file,
          const std::vector<ForeignCode>& code, const std::function<void()>& allow) {
  notices.warn(
      id,
      QObject::tr("%1 wants to start: %2. It can do all that you may do.").arg(file, wordsOf(code)),
      {{QObject::tr("Allow for this file"), allow}, {QObject::tr("Do not run"), {}}});
}

}  // namespace

CodeQuestion::CodeQuestion(Workspace& workspace, NoticeBar& notices, QObject* parent)
    : QObject(parent), workspace_(workspace), notices_(notices) {
  connect(&workspace, &Workspace::codeWanted, this, &CodeQuestion::ask);
  connect(&workspace.document(), &editor::ScenarioDocument::changed, this,
          [this](const editor::Change& change) {
            if (change.what == editor::Change::What::Everything) {
              notices_.drop(noticeId());  // of another file
            }
          });
}

void CodeQuestion::ask(bool paused) {
  const std::vector<ForeignCode> code = workspace_.codeToAllow();
  const auto allow = [this, code, paused] {
    workspace_.allowCode(code);
    SimulationRunner& runner = workspace_.runner();
    paused ? runner.stepOnce() : runner.play();
  };
  warn(notices_, noticeId(), workspace_.document().displayName(), code, allow);
}

void CodeQuestion::askFor(StudyPanel& study, NoticeBar& notices) {
  connect(&study, &StudyPanel::codeWanted, &notices,
          [&study, &notices](const std::vector<ForeignCode>& code) {
            if (code.empty()) {
              notices.drop(studyNoticeId());
              return;
            }
            warn(notices, studyNoticeId(), QFileInfo(study.file()).fileName(), code,
                 [&study, code] { study.allowCode(code); });
          });
}

}  // namespace app
