#include "app/window/StudyWords.h"

#include <QObject>

#include "editor/look/Form.h"

namespace app {

QString studyTimeText(double seconds) {
  const auto minutes = static_cast<long long>(seconds / 60.0);
  return seconds < 100.0 ? QObject::tr("%1 s").arg(qRound(seconds))
         : minutes < 100 ? QObject::tr("%1 min").arg(minutes)
                         : QObject::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString sizeText(const Experiment& experiment) {
  QStringList parts = {editor::counted(experiment.scenarios.size(), QObject::tr("scenario"),
                                       QObject::tr("scenarios"))};
  for (const ExperimentValue& value : experiment.values) {
    if (!value.isDrawn() && value.texts.size() > 1) {
      const QString path = QString::fromStdString(value.path);
      parts.append(path.endsWith(QLatin1String(".planner"))
                       ? QObject::tr("%1 planners").arg(value.texts.size())
                       : QStringLiteral("%1 %2").arg(value.texts.size()).arg(path));
    }
  }
  parts.append(editor::counted(experiment.seeds.size(), QObject::tr("seed"), QObject::tr("seeds")));
  return parts.join(QStringLiteral(" × ")) + QStringLiteral(" = ") +
         editor::counted(experiment.runCount(), QObject::tr("run"), QObject::tr("runs"));
}

QString withoutSeverity(const QString& line) {
  const QString head = QStringLiteral("error: ");
  return editor::capitalized(line.startsWith(head) ? line.mid(head.size()) : line);
}

}  // namespace app
