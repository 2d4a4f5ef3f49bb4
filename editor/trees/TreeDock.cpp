#include "editor/trees/TreeStudio.h"

namespace editor {

/// Below the canvas, so that map and tree are seen together; closed until it is asked for.
void addTreeDock(PanelRegistry& to) {
  PanelInfo info = closedBelow(90, QObject::tr("Tree"));
  info.room = 400;
  to.add(info, [](PanelContext& context) {
    auto* studio = new TreeStudio(context);
    QObject::connect(&context, &PanelContext::themeChanged, studio, &TreeStudio::setTheme);
    QObject::connect(studio, &TreeStudio::nodeChosen, &context,
                     [&context, studio](int node) { Q_EMIT context.nodeChosen(node, studio); });
    QObject::connect(&context, &PanelContext::nodeChosen, studio,
                     [studio](int node, const QObject* by) {
                       if (by != studio) {
                         studio->choose(node);
                       }
                     });
    return studio;
  });
}

}  // namespace editor
