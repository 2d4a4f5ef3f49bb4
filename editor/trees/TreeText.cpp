#include "editor/trees/TreeText.h"

#include <algorithm>

#include "bt/tree/TreeXml.h"
#include "editor/look/Form.h"
#include "editor/panels/TextViewer.h"

namespace editor {

namespace {

constexpr int kTypingPauseMs = 500;

}  // namespace

TreeText::TreeText(const Theme& theme)
    : theme_(theme), text_(new QPlainTextEdit(this)), problem_(new QLabel(this)) {
  QFont fixed(QStringLiteral("monospace"));
  fixed.setStyleHint(QFont::TypeWriter);
  fixed.setPointSizeF(theme.font().pointSizeF());
  text_->setFont(fixed);
  text_->setFrameShape(QFrame::NoFrame);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  text_->setUndoRedoEnabled(false);  // Undo is provided by the commands of the document.
  text_->setAccessibleName(tr("XML of the tree"));
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  back_ = linkButton(tr("Discard"),
                     tr("Discard the edit and show the current "
                        "tree"),
                     this, [this] {
                       const std::string counts = taken_;
                       taken_.clear();
                       showText(counts);
                     });
  auto* below = new QWidget(this);
  configuredLayout(new QHBoxLayout(below), {12, 2, 12, 2}, 8, {problem_, back_})
      ->setStretchFactor(problem_, 1);
  auto* layout = configuredLayout(new QVBoxLayout(this), {}, 0, {text_, below});
  layout->setStretchFactor(text_, 1);
  back_->hide();
  pause_.setSingleShot(true);
  pause_.setInterval(kTypingPauseMs);
  connect(&pause_, &QTimer::timeout, this, &TreeText::take);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    if (!showing_) {
      pause_.start();
    }
  });
  connect(text_, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    if (!showing_ && !pause_.isActive()) {
      Q_EMIT lineChosen(text_->textCursor().blockNumber() + 1);
    }
  });
  text_->installEventFilter(this);
  setTheme(theme);
}

void TreeText::setTheme(const Theme& theme) {
  theme_ = theme;
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, theme.color(Role::Error));
  problem_->setPalette(colors);
  markLine();
}

void TreeText::showText(const std::string& text) {
  if (text == taken_) {
    return;
  }
  taken_ = text;
  pause_.stop();
  problem_->clear();
  back_->hide();
  const QString now = QString::fromStdString(text);
  if (now == text_->toPlainText()) {
    return;  // The text was typed here: the cursor stays.
  }
  showing_ = true;
  const int line = text_->textCursor().blockNumber();
  text_->setPlainText(now);
  const QTextBlock block = text_->document()->findBlockByNumber(line);
  text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
  showing_ = false;
}

void TreeText::commitPendingEdit() {
  if (pause_.isActive()) {
    pause_.stop();
    take();
  }
}

bool TreeText::eventFilter(QObject* watched, QEvent* event) {
  if (watched == text_ && event->type() == QEvent::FocusOut) {
    commitPendingEdit();
  }
  return QWidget::eventFilter(watched, event);
}

void TreeText::take() {
  const std::string typed = text_->toPlainText().toStdString();
  if (typed == taken_) {
    problem_->clear();
    back_->hide();
    return;
  }
  const base::Result<bt::TreeFile> file = bt::readTreeText(typed);
  if (!file) {
    const base::Diagnostic& first = file.diagnostics().front();
    problem_->setText(
        first.line > 0
            ? tr("Line %1: %2").arg(first.line).arg(QString::fromStdString(first.message))
            : QString::fromStdString(first.message));
    back_->show();
    return;
  }
  Q_EMIT edited(typed);
}

void TreeText::showLine(int line) {
  line_ = line;
  markLine();
  if (line > 0 && !text_->hasFocus()) {
    showing_ = true;
    const QTextBlock block = text_->document()->findBlockByNumber(line - 1);
    text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
    text_->centerCursor();
    showing_ = false;
  }
}

void TreeText::markLine() {
  editor::markLine(*text_, line_, theme_);
}

}  // namespace editor
