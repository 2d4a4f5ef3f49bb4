#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>

#include "bt/tree/TreeXml.h"
#include "editor/document/BehaviorValues.h"
#include "editor/document/EditCommands.h"
#include "editor/document/TreeFiles.h"
#include "editor/look/FigurePainter.h"
#include "editor/panels/BehaviorPanel.h"
#include "sim2d/base/Text.h"

namespace editor {

base::Diagnostics BehaviorPanel::takeTreeFrom(const QString& path) {
  const base::Result<std::string> text = base::readTextFile(path.toStdString());
  if (!text) {
    return text.diagnostics();
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(*text, path.toStdString());
  if (file) {
    pushTreeText(document_, person_, *text, tr("Take the tree %1").arg(QFileInfo(path).fileName()));
  }
  return file.diagnostics();
}

base::Diagnostics BehaviorPanel::saveTreeTo(const QString& path) const {
  base::Diagnostics problems =
      base::writeFileAtomically(path.toStdString(), treeText(document_, person_));
  base::append(problems, writeIncludedTrees(QFileInfo(path).absolutePath().toStdString()));
  return problems;
}

void BehaviorPanel::askForTree() {
  const QString path = QFileDialog::getOpenFileName(window(), tr("Take a behaviour tree"),
                                                    QFileInfo(document_.path()).absolutePath(),
                                                    tr("Behaviour trees (*.xml);;All files (*)"));
  if (!path.isEmpty()) {
    Q_EMIT told(takeTreeFrom(path));
  }
}

void BehaviorPanel::askForFile() {
  const sim2d::Human* human = document_.human(person_);
  const QString name = QString::fromStdString(
      treeFileName(document_.scenario().yamlBaseName.value_or("scenario"), human->id));
  const QString path = QFileDialog::getSaveFileName(
      window(), tr("Save the behaviour tree"),
      QFileInfo(document_.path()).absoluteDir().filePath(name), tr("Behaviour trees (*.xml)"));
  if (!path.isEmpty()) {
    Q_EMIT told(saveTreeTo(path));
  }
}

void BehaviorPanel::takeTemplate(sim2d::BehaviorType type) {
  const QString text = tr("Take the tree of %1").arg(lookName(lookOf(type)));
  document_.undoStack().beginMacro(text);
  pushTreeText(document_, person_, std::nullopt, text);
  pushChange<sim2d::Human>(document_, person_, text, [this, type](sim2d::Human& human) {
    human.behavior.type = type;
    completeReaction(document_.scenario(), human);
  });
  document_.undoStack().endMacro();
}

void BehaviorPanel::offerTemplates() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const FigurePainter painter(theme_);
  for (int i = 1; i <= 6; ++i) {
    const auto type = static_cast<sim2d::BehaviorType>(i);
    QAction* action = menu->addAction(painter.markIcon(lookOf(type)), lookName(lookOf(type)));
    connect(action, &QAction::triggered, this, [this, type] { takeTemplate(type); });
  }
  menu->popup(template_->mapToGlobal(QPoint(0, template_->height())));
}

}  // namespace editor
