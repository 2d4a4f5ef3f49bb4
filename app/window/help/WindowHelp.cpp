#include "app/window/help/WindowHelp.h"

#include "app/window/help/CommandPalette.h"
#include "app/window/help/ManualViewer.h"
#include "app/window/help/WhatsThis.h"
#include "editor/look/Form.h"

namespace app {

namespace {

QKeySequence keysOf(const QKeyEvent& event) {
  return QKeySequence(event.key() | static_cast<int>(event.modifiers() & ~Qt::KeypadModifier));
}

}  // namespace

WindowHelp::WindowHelp(QMainWindow& window, Workspace& workspace, const WindowActions& actions,
                       ManualFolders manual)
    : QObject(&window),
      window_(window),
      workspace_(workspace),
      actions_(actions),
      manual_(std::move(manual)) {
  connect(actions.manual, &QAction::triggered, this, &WindowHelp::showPageOfFocus);
  connect(actions.whatsThis, &QAction::triggered, this, [] { QWhatsThis::enterWhatsThisMode(); });
  connect(actions.palette, &QAction::triggered, this, [this] { palette().open(); });
  explainWindow(window, workspace);
  const auto showToolPage = [this] {
    for (const editor::ToolManager::Entry& tool : workspace_.tools().entries()) {
      if (tool.tool == workspace_.tools().current()) {
        workspace_.view().setProperty(editor::kManualPageProperty,
                                      manualPageOfTool(tool.info.icon));
      }
    }
  };
  connect(&workspace.tools(), &editor::ToolManager::currentChanged, this, showToolPage);
  showToolPage();
  connect(&workspace, &Workspace::themeChanged, this, [this] {
    if (viewer_ != nullptr) {
      viewer_->setTheme(workspace_.theme());
    }
    if (palette_ != nullptr) {
      palette_->setTheme(workspace_.theme());
    }
  });
  qApp->installEventFilter(this);
}

WindowHelp::~WindowHelp() {
  delete viewer_;
}

ManualViewer* WindowHelp::viewer() const {
  return viewer_;
}

CommandPalette& WindowHelp::palette() {
  if (palette_ == nullptr) {
    palette_ = new CommandPalette(*window_.menuBar(), workspace_.theme(), &window_);
  }
  return *palette_;
}

void WindowHelp::showPage(const QString& page) {
  const QString file = QDir(manual_.html).filePath(page + QStringLiteral(".html"));
  if (!manual_.html.isEmpty() && QFileInfo::exists(file) &&
      QDesktopServices::openUrl(QUrl::fromLocalFile(file))) {
    return;
  }
  QWidget* modal = QApplication::activeModalWidget();  // blocks all windows but its own
  if (viewer_ == nullptr || viewer_->parentWidget() != modal) {
    delete viewer_;
    viewer_ = new ManualViewer(manual_.markdown, workspace_.theme(), modal);
    viewer_->setAttribute(Qt::WA_QuitOnClose, false);
  }
  viewer_->showPage(page);
}

void WindowHelp::showPageOfFocus() {
  const QWidget* focus = QApplication::focusWidget();
  showPage(manualPageOf(focus == nullptr ? window_.focusWidget() : focus));
}

/// Dialogs block the commands of the window, so their keys are handled here.
bool WindowHelp::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  if (widget == nullptr) {
    return false;
  }
  if (event->type() == QEvent::KeyPress) {
    const bool isOther = widget->window() != &window_ && viewer_ != widget->window();
    const bool isHelp =
        isOther && actions_.manual->shortcuts().contains(keysOf(static_cast<QKeyEvent&>(*event)));
    if (isHelp) {
      event->accept();
      showPage(manualPageOf(widget));
    }
    return isHelp;
  }
  return explains(*widget, *event);
}

/// Explanations of widgets that have none of their own, with a link to the manual.
bool WindowHelp::explains(QWidget& widget, QEvent& event) {
  if (event.type() == QEvent::WhatsThisClicked) {
    const QString href = static_cast<QWhatsThisClickedEvent&>(event).href();
    const bool isManual = href.startsWith(QLatin1String(kManualScheme));
    if (isManual) {
      showPage(href.mid(static_cast<int>(qstrlen(kManualScheme))));
    }
    return isManual;
  }
  const bool isQuestion = event.type() == QEvent::QueryWhatsThis;
  if ((!isQuestion && event.type() != QEvent::WhatsThis) ||
      qobject_cast<QMenu*>(&widget) != nullptr) {
    return false;
  }
  const QString text = explanationOf(widget);
  if (text.isEmpty()) {
    return false;
  }
  event.accept();
  if (!isQuestion) {
    QWhatsThis::showText(static_cast<QHelpEvent&>(event).globalPos(),
                         withManualLink(text, manualPageOf(&widget)), &widget);
  }
  return true;
}

}  // namespace app
