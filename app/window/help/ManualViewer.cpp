#include "app/window/help/ManualViewer.h"

#include <algorithm>

#include "editor/look/DeferredActions.h"
#include "editor/look/Icons.h"
#include "editor/panels/RowDelegate.h"

namespace app {

using editor::Role;

namespace {

constexpr QSize kManualSize(960, 680);
constexpr int kManualSide = 240;
constexpr int kPageMargin = 24;

/// The name that a link uses for a heading: "Your own map" is "your-own-map".
QString slugOf(const QString& heading) {
  QString slug;
  for (const QChar letter : heading.toLower().trimmed()) {
    if (letter.isLetterOrNumber() || letter == QLatin1Char('_') || letter == QLatin1Char('-')) {
      slug += letter;
    } else if (letter.isSpace()) {
      slug += QLatin1Char('-');
    }
  }
  return slug;
}

/// A directive of MyST: ```{name} argument, options, body.
struct Directive {
  QString name, argument;
  QStringList body;
};

/// A link to a page with its title.
QString linkTo(const QString& page) {
  const auto& pages = manualPages();
  const auto found = std::find_if(pages.begin(), pages.end(), [&page](const ManualPage& each) {
    return page == QLatin1String(each.name);
  });
  const QString title =
      found == pages.end() ? page : QCoreApplication::translate("Manual", found->title);
  return QStringLiteral("[%1](%2.md)").arg(title, page);
}

/// The pages of a `toctree`, one per line after its options.
QString contentsOf(const QStringList& body) {
  QString list;
  for (const QString& line : body) {
    const QString page = line.trimmed();
    if (page.startsWith(QLatin1String(":caption:"))) {
      list += QStringLiteral("\n**%1**\n\n").arg(page.mid(9).trimmed());
    } else if (!page.isEmpty() && !page.startsWith(QLatin1Char(':'))) {
      list += QStringLiteral("- %1\n").arg(linkTo(page));
    }
  }
  return list;
}

QString includedFile(const QString& name, const QString& folder) {
  QFile file(QDir(folder).filePath(name));
  return file.open(QIODevice::ReadOnly)
             ? plainMarkdown(QString::fromUtf8(file.readAll()), folder)
             : QObject::tr("*This part is generated; it is in the HTML pages of the manual.*\n");
}

QString markdownOf(const Directive& directive, const QString& folder) {
  if (directive.name == QLatin1String("include")) {
    return includedFile(directive.argument, folder);
  }
  QStringList body;
  QString alt;
  for (const QString& line : directive.body) {
    const QString trimmed = line.trimmed();
    if (trimmed.startsWith(QLatin1String(":alt:"))) {
      alt = trimmed.mid(5).trimmed();
    } else if (!(body.isEmpty() && trimmed.startsWith(QLatin1Char(':')))) {
      body << line;
    }
  }
  const QString text = body.join(QLatin1Char('\n')).trimmed();
  if (directive.name == QLatin1String("figure") || directive.name == QLatin1String("image")) {
    return QStringLiteral("![%1](%2)\n\n%3\n").arg(alt, directive.argument, text);
  }
  if (directive.name == QLatin1String("toctree")) {
    return contentsOf(directive.body);
  }
  if (directive.name.startsWith(QLatin1String("code"))) {
    return QStringLiteral("```\n%1\n```\n").arg(text);
  }
  const QString title = editor::capitalized(directive.name);
  return QStringLiteral("> **%1.** %2\n")
      .arg(title, QString(text).replace(QLatin1Char('\n'), QLatin1String("\n> ")));
}

}  // namespace

QString plainMarkdown(const QString& myst, const QString& folder) {
  static const QRegularExpression kOpening(
      QStringLiteral("^(`{3,}|:{3,})\\{([\\w:-]+)\\}\\s*(.*)$"));
  static const QRegularExpression kLabel(QStringLiteral("^\\([\\w-]+\\)=$"));
  static const QRegularExpression kRole(
      QStringLiteral("\\{(?:ref|doc|term|numref)\\}`([^`<]*?)\\s*(?:<[^`]*>)?`"));
  QStringList lines;
  QString fence;  // of the open directive; empty: none
  Directive open;
  for (const QString& line : myst.split(QLatin1Char('\n'))) {
    if (!fence.isEmpty()) {
      if (line.trimmed() == fence) {
        lines << QString() << markdownOf(open, folder);
        fence.clear();
      } else {
        open.body << line;
      }
      continue;
    }
    const QRegularExpressionMatch opening = kOpening.match(line);
    if (opening.hasMatch()) {
      fence = opening.captured(1);
      open = {opening.captured(2), opening.captured(3).trimmed(), {}};
    } else if (!kLabel.match(line).hasMatch()) {
      lines << QString(line).replace(kRole, QStringLiteral("\\1"));
    }
  }
  QString text = lines.join(QLatin1Char('\n'));
  static const QRegularExpression kUntitled(QStringLiteral("\\[\\]\\(([\\w-]+)\\.md[^)]*\\)"));
  for (QRegularExpressionMatch link = kUntitled.match(text); link.hasMatch();
       link = kUntitled.match(text)) {
    text.replace(link.capturedStart(), link.capturedLength(), linkTo(link.captured(1)));
  }
  return text;
}

ManualViewer::ManualViewer(QString folder, const editor::Theme& theme, QWidget* parent)
    : QWidget(parent, Qt::Window),
      folder_(std::move(folder)),
      search_(new editor::SearchField(tr("Search the manual"), tr("Search the manual"), this)) {
  setWindowTitle(tr("HuNavSim Desktop manual"));
  setObjectName(QStringLiteral("manual"));
  resize(kManualSize);
  text_->setOpenLinks(false);
  text_->setFrameShape(QFrame::NoFrame);
  text_->setAccessibleName(tr("Page"));
  text_->setSearchPaths({folder_, QDir(folder_).filePath(QStringLiteral(".."))});
  text_->document()->setDocumentMargin(kPageMargin);
  back_ = editor::makeAction(tr("Back"), QKeySequence::Back, tr("Show the previous page"), this);
  forward_ = editor::makeAction(tr("Forward"), QKeySequence::Forward,
                                tr("Show the next page again"), this);
  addActions({back_, forward_});
  connect(back_, &QAction::triggered, this, [this] { step(-1); });
  connect(forward_, &QAction::triggered, this, [this] { step(1); });
  connect(text_, &QTextBrowser::anchorClicked, this, &ManualViewer::follow);
  auto* row = editor::configuredLayout(new QHBoxLayout(this), {0, 0, 0, 0}, 0, {makeSide()});
  row->addWidget(text_, 1);
  setTheme(theme);
}

QWidget* ManualViewer::makeSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kManualSide);
  auto* column = editor::configuredLayout(new QVBoxLayout(side), {8, 8, 8, 8}, 6);
  auto* buttons = editor::configuredLayout(new QHBoxLayout, {0, 0, 0, 0}, 4);
  for (QAction* action : {back_, forward_}) {
    auto* button = new QToolButton(side);
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  editor::styleList(*pages_, tr("Pages"));
  for (const ManualPage& page : manualPages()) {
    auto* entry = new QListWidgetItem(QCoreApplication::translate("Manual", page.title), pages_);
    entry->setData(Qt::UserRole, QString::fromLatin1(page.name));
  }
  nothing_ = new editor::NoMatchesPlaceholder(*search_, *pages_, side);
  column->addLayout(buttons);
  column->addWidget(search_);
  column->addWidget(pages_, 1);
  column->addWidget(nothing_, 1);
  connect(search_, &QLineEdit::textChanged, this, &ManualViewer::filter);
  const auto open = [this](const QListWidgetItem* entry) {
    if (entry != nullptr && entry->data(Qt::UserRole).toString() != page()) {
      showPage(entry->data(Qt::UserRole).toString());
    }
  };
  connect(pages_, &QListWidget::itemClicked, this, open);
  connect(pages_, &QListWidget::itemActivated, this, open);
  return side;
}

void ManualViewer::setTheme(const editor::Theme& theme) {
  search_->setTheme(theme);
  const auto icon = [&theme](int turns) {
    const QPixmap arrow =
        editor::tintedIcon(QStringLiteral("chevron-right"), theme.color(Role::Text)).pixmap(24, 24);
    return QIcon(arrow.transformed(QTransform().rotate(turns)));
  };
  back_->setIcon(icon(180));
  forward_->setIcon(icon(0));
  QPalette colors = text_->palette();
  colors.setColor(QPalette::Link, theme.color(Role::AccentText));
  text_->setPalette(colors);
  if (shown_ >= 0) {
    display();  // links take the new colour
  }
}

QString ManualViewer::textOf(const QString& page) const {
  QFile file(QDir(folder_).filePath(page + QStringLiteral(".md")));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

void ManualViewer::showPage(const QString& page, const QString& heading) {
  const QPair<QString, QString> wanted(page, heading);
  if (shown_ < 0 || history_.at(shown_) != wanted) {
    history_.erase(history_.begin() + shown_ + 1, history_.end());
    history_ << wanted;
    shown_ = static_cast<int>(history_.size()) - 1;
  }
  display();
  show();
  raise();
  activateWindow();
  text_->setFocus();
}

void ManualViewer::display() {
  const auto& [page, heading] = history_.at(shown_);
  const QString text = textOf(page);
  text_->document()->setMarkdown(
      text.isNull()
          ? tr("# Page not found\n\nThe manual has no file `%1.md` in `%2`. Reinstall the "
               "program, or read the manual on the project's page.")
                .arg(page, QDir::toNativeSeparators(folder_))
          : plainMarkdown(text, folder_));
  text_->document()->setDocumentMargin(kPageMargin);
  text_->moveCursor(QTextCursor::Start);
  for (int i = 0; i < pages_->count(); ++i) {
    if (pages_->item(i)->data(Qt::UserRole).toString() == page) {
      pages_->setCurrentRow(i);
    }
  }
  back_->setEnabled(shown_ > 0);
  forward_->setEnabled(shown_ + 1 < history_.size());
  scrollTo(heading);
}

void ManualViewer::scrollTo(const QString& heading) {
  if (heading.isEmpty()) {
    return;
  }
  for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() > 0 && slugOf(block.text()) == heading) {
      QTextCursor cursor(block);
      text_->setTextCursor(cursor);
      const QRectF place = text_->document()->documentLayout()->blockBoundingRect(block);
      text_->verticalScrollBar()->setValue(static_cast<int>(place.top()) - kPageMargin / 2);
    }
  }
}

/// Links to other pages stay here; all others open in the desktop's programs.
void ManualViewer::follow(const QUrl& link) {
  if (link.isRelative()) {
    const QString file = QFileInfo(link.path()).fileName();
    const bool isPage = file.isEmpty() || file.endsWith(QLatin1String(".md")) ||
                        file.endsWith(QLatin1String(".html"));
    if (isPage) {
      showPage(file.isEmpty() ? page() : QFileInfo(file).completeBaseName(), link.fragment());
      return;
    }
  }
  QDesktopServices::openUrl(
      link.isRelative() ? QUrl::fromLocalFile(QDir(folder_).filePath(link.path())) : link);
}

void ManualViewer::step(int by) {
  if (shown_ + by >= 0 && shown_ + by < history_.size()) {
    shown_ += by;
    display();
  }
}

/// Leaves the pages that contain the text, and marks its first place in the shown page.
void ManualViewer::filter(const QString& typed) {
  const QString wanted = typed.trimmed();
  bool isAny = false;
  for (int i = 0; i < pages_->count(); ++i) {
    QListWidgetItem& entry = *pages_->item(i);
    const bool isMatch =
        entry.text().contains(wanted, Qt::CaseInsensitive) ||
        textOf(entry.data(Qt::UserRole).toString()).contains(wanted, Qt::CaseInsensitive);
    entry.setHidden(!isMatch);
    isAny = isAny || isMatch;
  }
  nothing_->setMatchFound(isAny);
  text_->moveCursor(QTextCursor::Start);
  if (!wanted.isEmpty()) {
    text_->find(wanted);
  }
}

void ManualViewer::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
  } else if (event->matches(QKeySequence::Find)) {
    search_->setFocus();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace app
