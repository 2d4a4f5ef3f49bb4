#include "app/window/help/WhatsThis.h"

namespace app {

namespace {

struct Explanation {
  const char* key;
  const char* text;
};

/// By the name of the tool's icon.
constexpr Explanation kToolTexts[] = {
    {"tool-select",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Selects items on the map. Click an item, or drag over empty space to "
                       "select several. Drag the selection to move it, its handles to resize or "
                       "rotate it. Shift adds to the selection, Alt suspends snapping.")},
    {"tool-person",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Places a person. Click the position, or press and drag to set the "
                       "heading. A person walks when it has goals: place them with the goal tool "
                       "and assign them with the route tool.")},
    {"tool-brush",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Places people along a line. Drag a line; spacing, width and the mix of "
                       "behaviours are set in the bar at the top left of the map.")},
    {"tool-fill",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Fills an area with people. Drag a rectangle or click the corners of an "
                       "area; the number of people and their goals are set in the bar at the top "
                       "left of the map.")},
    {"tool-goal",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Places goals. Click free space to add a goal; drag a goal to move it. "
                       "Several people can share a goal.")},
    {"tool-route",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Assigns goals to a person or robot. Click the person, then its goals in "
                       "visiting order, then press Enter.")},
    {"tool-wall",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Draws a wall as a line of segments. Click each corner; Enter or a double "
                       "click ends the wall. People and robots cannot cross it.")},
    {"tool-box",
     QT_TRANSLATE_NOOP(
         "WhatsThis", "Draws a rectangular obstacle from corner to corner. Shift makes a square.")},
    {"tool-polygon",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Draws an obstacle with any number of corners. Click each corner; Enter or "
                       "a click on the first corner closes it.")},
    {"tool-circle",
     QT_TRANSLATE_NOOP("WhatsThis", "Draws a round obstacle. Drag from its centre to its edge.")},
    {"tool-door",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Draws a door. Drag from the hinge to the other jamb. The properties set "
                       "when it opens and closes.")},
    {"tool-area",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Draws an area, for example a source or sink of people, or a zone with a "
                       "speed limit. Choose the kind in the bar at the top left of the map.")},
    {"tool-robot",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Places the robot and its goal. Click the position (drag to set the "
                       "heading), then click the goal. Shift adds another robot.")},
    {"tool-dock",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Places a charging dock for robots with Nav2. Click the position of the "
                       "docked robot and drag to set its heading.")},
    {"tool-map",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Paints walls, free or unknown space into the cells of the map. Keys 1, 2 "
                       "and 3 choose the kind, [ and ] the width.")},
    {"tool-measure",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Measures a distance and an angle. Drag from one point to another; the "
                       "result is shown in the status bar.")},
    {"tool-eraser",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Removes items. Click them or drag over them. Routes of people are "
                       "updated. Undo restores everything.")},
    {"tool-pan",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Moves the map. With any other tool, drag with the middle button, or hold "
                       "Space and drag.")}};

/// By the name of the panel.
constexpr Explanation kPanelTexts[] = {
    {"scenario",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Everything in the scenario as a list: people, goals, robots, obstacles "
                       "and areas. Select entries here or on the map. Double-click a name or "
                       "press F2 to change it.")},
    {"properties",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "The properties of the selected items. A value in the secondary colour is "
                       "the default; right-click a field to restore it. With nothing selected, "
                       "the settings of the scenario are shown.")},
    {"behaviour",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "The behaviour tree of the selected person as an outline. During a run it "
                       "shows which nodes are active. Click beside a node to set a breakpoint.")},
    {"issues",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Errors and warnings of the scenario, checked while you edit. Double-click "
                       "an entry to go to its place; many entries offer a fix.")},
    {"metrics",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "The metrics of the displayed run, updated while it runs. Select a metric "
                       "to plot it over time; hover over it to read its definition.")},
    {"events",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "What happened in the run: contacts, arrivals, reactions. Click an entry "
                       "to show that moment.")},
    {"runs",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Branches of the run and recorded runs. Check several to compare their "
                       "metrics and paths.")},
    {"futures",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Repeats the rest of the run many times from the displayed moment and "
                       "shows how often a contact occurs.")},
    {"study",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "Runs scenarios with several planners and seeds and compares them with "
                       "confidence intervals in a report. It also shows the results of tune, "
                       "gate, sensitivity and search.")},
    {"layers", QT_TRANSLATE_NOOP(
                   "WhatsThis",
                   "What the map shows: people, routes, sensor data, costmaps and other layers, "
                   "each with its opacity.")},
    {"nav2",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "The Nav2 parameters of the selected robot with defaults and explanations. "
                       "Search by name, or show only what was changed.")},
    {"tree",
     QT_TRANSLATE_NOOP("WhatsThis",
                       "The behaviour tree of the selected person as a graph. Drag nodes from the "
                       "palette, press F8 to use the whole window.")}};

template <std::size_t N>
QString textIn(const Explanation (&table)[N], const QString& key) {
  for (const Explanation& row : table) {
    if (key == QLatin1String(row.key)) {
      return QCoreApplication::translate("WhatsThis", row.text);
    }
  }
  return {};
}

/// A heading in bold, the key, and a paragraph.
QString richText(const QString& title, const QString& keys, const QString& text) {
  const QString key =
      keys.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(keys.toHtmlEscaped());
  return QStringLiteral("<p><b>%1</b>%2</p><p>%3</p>")
      .arg(title.toHtmlEscaped(), key, text.toHtmlEscaped());
}

/// A tooltip whose first line is its title.
QString richTooltip(const QString& tip) {
  if (Qt::mightBeRichText(tip) || !tip.contains(QLatin1Char('\n'))) {
    return tip;
  }
  return richText(tip.section(QLatin1Char('\n'), 0, 0), {},
                  tip.section(QLatin1Char('\n'), 1).replace(QLatin1Char('\n'), QLatin1Char(' ')));
}

}  // namespace

QString explanationOf(const QWidget& widget) {
  const QWidget* each = &widget;
  if (const auto* label = qobject_cast<const QLabel*>(each);
      label != nullptr && label->buddy() != nullptr) {
    each = label->buddy();
  }
  for (; each != nullptr; each = each->parentWidget()) {
    if (!each->whatsThis().isEmpty()) {
      return each->whatsThis();
    }
    if (!each->toolTip().isEmpty()) {
      const QString name = each->accessibleName();
      return name.isEmpty() || each->toolTip().contains(QLatin1Char('\n'))
                 ? richTooltip(each->toolTip())
                 : richText(name, {}, each->toolTip());
    }
  }
  return {};
}

QString withManualLink(const QString& explanation, const QString& page) {
  return QStringLiteral("%1<p><a href=\"%2%3\">%4</a></p>")
      .arg(explanation, QLatin1String(kManualScheme), page,
           QCoreApplication::translate("WhatsThis", "Open the manual (F1)"));
}

void explainWindow(QMainWindow& window, Workspace& workspace) {
  QHash<QString, QString> panels;  // by title, as in the menu that shows and hides them
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    const QString text = textIn(kPanelTexts, dock->objectName());
    panels.insert(dock->windowTitle(), text);
    dock->setWhatsThis(text.isEmpty() ? QString() : richText(dock->windowTitle(), {}, text));
  }
  for (const Command& command : commandsOf(*window.menuBar())) {
    const QString text = panels.value(command.name);
    command.action->setWhatsThis(richText(command.name, commandKeys(*command.action),
                                          text.isEmpty() ? command.action->statusTip() : text));
  }
  for (const editor::ToolManager::Entry& tool : workspace.tools().entries()) {
    const QString text = textIn(kToolTexts, tool.info.icon);
    tool.action->setWhatsThis(richText(tool.info.name,
                                       tool.info.shortcut.toString(QKeySequence::NativeText),
                                       text.isEmpty() ? tool.action->statusTip() : text));
  }
  workspace.view().setWhatsThis(richText(
      QCoreApplication::translate("WhatsThis", "Map"), {},
      QCoreApplication::translate(
          "WhatsThis",
          "The scenario. The wheel zooms, the middle button or Space and drag move the map. The "
          "status bar shows what the mouse does with the active tool. During a run, click a person "
          "for details; right-click to push, stop or add people.")));
}

}  // namespace app
