#include "editor/panels/TextViewer.h"

#include <algorithm>

#include "editor/look/Form.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

constexpr int kLongest = 4 * 1024 * 1024;  // [bytes]

/// A text widget with line numbers in a margin at the left.
class NumberedText : public QPlainTextEdit {
 public:
  explicit NumberedText(QWidget* parent) : QPlainTextEdit(parent), margin_(new Margin(*this)) {
    connect(this, &QPlainTextEdit::updateRequest, margin_, qOverload<>(&QWidget::update));
    connect(this, &QPlainTextEdit::blockCountChanged, this, [this] { makeRoom(); });
    makeRoom();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QPlainTextEdit::resizeEvent(event);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), room(), inside.height());
  }

 private:
  class Margin : public QWidget {
   public:
    explicit Margin(NumberedText& text) : QWidget(&text), text_(text) {}

   protected:
    void paintEvent(QPaintEvent*) override {
      QPainter painter(this);
      painter.setPen(palette().color(QPalette::PlaceholderText));
      painter.setFont(text_.font());
      QTextBlock block = text_.firstVisibleBlock();
      qreal top = text_.blockBoundingGeometry(block).translated(text_.contentOffset()).top();
      while (block.isValid() && top <= rect().bottom()) {
        const qreal height = text_.blockBoundingRect(block).height();
        painter.drawText(QRectF(0, top, width() - 8, height), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
        block = block.next();
        top += height;
      }
    }

   private:
    NumberedText& text_;
  };

  int room() const {
    const int digits = std::max(3, static_cast<int>(QString::number(blockCount()).size()));
    return digits * fontMetrics().horizontalAdvance(QLatin1Char('9')) + 20;
  }
  void makeRoom() { setViewportMargins(room(), 0, 0, 0); }
  Margin* margin_;
};

}  // namespace

TextViewer::TextViewer(const Theme& theme, QWidget* parent)
    : QDialog(parent), theme_(theme), place_(new QLabel(this)), text_(new NumberedText(this)) {
  resize(720, limitedToScreen(*this, 520));
  text_->setReadOnly(true);
  text_->setLineWrapMode(QPlainTextEdit::NoWrap);
  QFont fixed(QStringLiteral("monospace"));
  fixed.setStyleHint(QFont::TypeWriter);
  fixed.setPointSizeF(theme.font().pointSizeF());
  text_->setFont(fixed);
  text_->setAccessibleName(tr("Text of the file"));
  place_->setTextFormat(Qt::PlainText);
  place_->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  QPushButton* outside = buttons->addButton(tr("Open with…"), QDialogButtonBox::ActionRole);
  outside->setAutoDefault(false);
  buttons->button(QDialogButtonBox::Close)->setDefault(true);
  outside->setToolTip(tr("Open the file with the default application"));
  connect(outside, &QPushButton::clicked, this, &TextViewer::openOutside);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout =
      configuredLayout(new QVBoxLayout(this), {16, 16, 16, 16}, 8, {place_, text_, buttons});
  layout->setStretchFactor(text_, 1);
}

void TextViewer::setTheme(const Theme& theme) {
  theme_ = theme;
  markLine();
}

QString TextViewer::showFile(const QString& path, int line) {
  const base::Result<std::string> read = base::readTextFile(path.toStdString());
  if (!read) {
    return QString::fromStdString(read.diagnostics().front().text());
  }
  if (read->size() > static_cast<std::size_t>(kLongest)) {
    return tr("%1 is too long to display").arg(path);
  }
  path_ = path;
  line_ = line;
  text_->setPlainText(QString::fromStdString(*read));
  setWindowTitle(QFileInfo(path).fileName());
  place_->setText(line > 0 ? tr("%1, line %2").arg(path).arg(line) : path);
  show();
  raise();
  markLine();
  return {};
}

void TextViewer::openOutside() {
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(path_))) {
    place_->setText(tr("No application is available to open %1").arg(path_));
  }
}

void markLine(QPlainTextEdit& text, int line, const Theme& theme) {
  const QTextBlock block = text.document()->findBlockByNumber(std::max(line - 1, 0));
  QList<QTextEdit::ExtraSelection> marks;
  if (line > 0 && block.isValid()) {
    QTextEdit::ExtraSelection mark;
    mark.format.setBackground(theme.color(Role::RowSelected));
    mark.format.setProperty(QTextFormat::FullWidthSelection, true);
    mark.cursor = QTextCursor(block);
    marks.push_back(mark);
  }
  text.setExtraSelections(marks);
}

void TextViewer::markLine() {
  editor::markLine(*text_, line_, theme_);
  const QTextBlock block = text_->document()->findBlockByNumber(std::max(line_ - 1, 0));
  text_->setTextCursor(QTextCursor(block.isValid() ? block : text_->document()->firstBlock()));
  text_->centerCursor();
}

}  // namespace editor
