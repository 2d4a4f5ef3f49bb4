#include <algorithm>

#include "app/window/files/FileDialogs.h"
#include "editor/document/LineDiff.h"
#include "editor/look/Icons.h"

namespace app {

using editor::DiffLine;
using editor::Role;
using editor::TreeConflict;

namespace {

constexpr int kListWidth = 200;
constexpr int kQuestionWidth = 560;  // the question fits on one line
constexpr int kDiffHeight = 460;
constexpr int kTreeRow = 24;
constexpr int kContext = 3;  // unchanged lines shown around a change
constexpr int kSignWidth = 16;
constexpr int kPadding = 8;

bool isOnDisk(const TreeConflict& question) {
  return question.why == TreeConflict::Why::ChangedOnDisk;
}

}  // namespace

/// Shows the differences of two texts line by line; long unchanged parts are folded.
class DiffView : public QAbstractScrollArea {
  Q_DECLARE_TR_FUNCTIONS(app::DiffView)
 public:
  explicit DiffView(const editor::Theme& theme, QWidget* parent)
      : QAbstractScrollArea(parent), theme_(theme) {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setStyleHint(QFont::Monospace);
    fixed.setFixedPitch(true);
    fixed.setPointSizeF(theme.font().pointSizeF());
    setFont(fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Differences"));
    viewport()->setBackgroundRole(QPalette::Base);
  }

  void setTexts(const std::string& left, const std::string& right) {
    const std::vector<DiffLine> lines = editor::lineDiff(left, right);
    std::vector<bool> shown(lines.size(), false);
    removed_ = added_ = widest_ = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].kind == DiffLine::Kind::Same) {
        continue;
      }
      ++(lines[i].kind == DiffLine::Kind::Removed ? removed_ : added_);
      const std::size_t first = i > kContext ? i - kContext : 0;
      for (std::size_t k = first; k < std::min(lines.size(), i + kContext + 1); ++k) {
        shown[k] = true;
      }
    }
    rows_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (shown[i]) {
        rows_.push_back({lines[i], 0});
        const QString text = QString::fromStdString(lines[i].text);
        widest_ = std::max(widest_, fontMetrics().horizontalAdvance(text));
      } else if (!rows_.empty() && rows_.back().folded > 0) {
        ++rows_.back().folded;
      } else {
        rows_.push_back({{}, 1});
      }
    }
    updateBars();
    verticalScrollBar()->setValue(0);
    viewport()->update();
  }

  int removedCount() const { return removed_; }
  int addedCount() const { return added_; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(viewport());
    painter.fillRect(viewport()->rect(), theme_.color(Role::Field));
    int top = kPadding - verticalScrollBar()->value();
    for (const Row& row : rows_) {
      if (top + rowHeight() >= 0 && top <= viewport()->height()) {
        paintRow(painter, row, top);
      }
      top += rowHeight();
    }
  }

  void resizeEvent(QResizeEvent* event) override {
    QAbstractScrollArea::resizeEvent(event);
    updateBars();
  }

 private:
  struct Row {
    DiffLine line;
    int folded = 0;  // > 0: number of folded unchanged lines
  };

  int rowHeight() const { return fontMetrics().height() + 2; }
  int gutterWidth() const {
    return 2 * fontMetrics().horizontalAdvance(QStringLiteral("0000")) + 3 * kPadding;
  }

  void updateBars() {
    const int height = static_cast<int>(rows_.size()) * rowHeight() + 2 * kPadding;
    verticalScrollBar()->setRange(0, std::max(0, height - viewport()->height()));
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setSingleStep(rowHeight());
    const int width = gutterWidth() + kSignWidth + widest_ + 2 * kPadding;
    horizontalScrollBar()->setRange(0, std::max(0, width - viewport()->width()));
    horizontalScrollBar()->setPageStep(viewport()->width());
    horizontalScrollBar()->setSingleStep(20);
  }

  void paintRow(QPainter& painter, const Row& row, int top) const {
    const QRect whole(0, top, viewport()->width(), rowHeight());
    const int gutter = gutterWidth();
    const QColor pale = theme_.color(Role::TextSecondary);
    if (row.folded > 0) {
      painter.fillRect(whole, theme_.color(Role::RowHover));
      painter.setPen(pale);
      painter.drawText(whole.adjusted(gutter + kSignWidth, 0, 0, 0), Qt::AlignVCenter,
                       row.folded == 1 ? tr("1 equal line") : tr("%1 equal lines").arg(row.folded));
      return;
    }
    const bool isRemoved = row.line.kind == DiffLine::Kind::Removed;
    const bool isAdded = row.line.kind == DiffLine::Kind::Added;
    const Role mark = isRemoved ? Role::Error : Role::Ok;
    if (isRemoved || isAdded) {
      painter.fillRect(whole, theme_.color(mark, theme_.isDark() ? 0.22 : 0.13));
    }
    const auto number = [&](int value, int left) {
      if (value > 0) {
        painter.drawText(QRect(left, top, gutter / 2 - kPadding, rowHeight()),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(value));
      }
    };
    painter.setPen(theme_.color(Role::Text));
    painter.save();
    painter.setClipRect(QRect(gutter, top, whole.width() - gutter, rowHeight()));
    const int left = gutter - horizontalScrollBar()->value();
    if (isRemoved || isAdded) {
      painter.setPen(theme_.color(mark));
      painter.drawText(QRect(left, top, kSignWidth, rowHeight()), Qt::AlignVCenter,
                       isRemoved ? QStringLiteral("−") : QStringLiteral("+"));
      painter.setPen(theme_.color(Role::Text));
    }
    painter.drawText(left + kSignWidth, top + fontMetrics().ascent() + 1,
                     QString::fromStdString(row.line.text));
    painter.restore();
    painter.setPen(pale);
    number(row.line.left, 0);
    number(row.line.right, gutter / 2 - kPadding / 2);
  }

  const editor::Theme theme_;
  std::vector<Row> rows_;
  int removed_ = 0, added_ = 0, widest_ = 0;
};

TreeChoiceDialog::TreeChoiceDialog(std::vector<TreeConflict> questions, const editor::Theme& theme,
                                   QWidget* parent)
    : QDialog(parent),
      questions_(std::move(questions)),
      theme_(theme),
      differences_(
          editor::linkButton({}, {}, this, [this] { showDifferences(diff_->isHidden()); })),
      diff_(new DiffView(theme, this)) {
  setWindowTitle(tr("Custom trees"));
  build();
  for (int i = 0; i < static_cast<int>(questions_.size()); ++i) {
    list_->addItem(QString::fromStdString(questions_[static_cast<std::size_t>(i)].name));
    list_->item(i)->setSizeHint(QSize(0, kTreeRow));
    updateRow(i);
  }
  connect(list_, &QListWidget::currentRowChanged, this, &TreeChoiceDialog::showQuestion);
  connect(keep_, &QRadioButton::clicked, this, [this] { take(false); });
  connect(replace_, &QRadioButton::clicked, this, [this] { take(true); });
  connect(all_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) {
      take(replace_->isChecked());
    }
  });
  list_->setCurrentRow(0);
  showDifferences(false);
}

void TreeChoiceDialog::build() {
  QLabel* title = editor::headingLabel(tr("Saving would overwrite custom trees"),
                                       theme_.font(12.0, QFont::DemiBold), this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 8, {title});
  auto* columns = editor::configuredLayout(new QHBoxLayout, {}, 16, {list_});
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setIconSize(QSize(16, 16));
  list_->setVisible(questions_.size() > 1);
  auto* right = editor::configuredLayout(new QVBoxLayout, {}, 4, {why_});
  why_->setWordWrap(true);
  right->addSpacing(4);
  right->addWidget(keep_);
  right->addWidget(replace_);
  all_->setVisible(questions_.size() > 1);
  right->addWidget(all_);
  right->addSpacing(4);
  auto* heading = new QHBoxLayout;
  heading->addWidget(differences_);
  heading->addStretch(1);
  heading->addWidget(legend_);
  right->addLayout(heading);
  right->addWidget(diff_, 1);
  right->addStretch(0);
  columns->addLayout(right, 1);
  rows->addLayout(columns, 1);
  rows->addSpacing(4);
  addButtons(this, *rows, tr("&Save"));
}

void TreeChoiceDialog::showQuestion(int index) {
  const TreeConflict& question = questions_[static_cast<std::size_t>(index)];
  const QString name = QString::fromStdString(question.name).toHtmlEscaped();
  const QString file = QFileInfo(QString::fromStdString(question.path)).fileName();
  why_->setText(isOnDisk(question)
                    ? tr("<b>%1</b>: the file %2 was changed by another program.")
                          .arg(name, file.toHtmlEscaped())
                    : tr("<b>%1</b>: behaviour or goals changed after this custom tree was "
                         "written.")
                          .arg(name));
  keep_->setText(isOnDisk(question) ? tr("Keep the tree in the file") : tr("Keep the custom tree"));
  replace_->setText(isOnDisk(question) ? tr("Replace it with the tree in this window")
                                       : tr("Use the generated tree"));
  (replaced_.count(question.human) == 0 ? keep_ : replace_)->setChecked(true);
  diff_->setTexts(question.mine, question.replacement);
  legend_->setText(isOnDisk(question) ? tr("− in the file   + in this window")
                                      : tr("− custom   + generated"));
  showDifferences(!diff_->isHidden());
}

void TreeChoiceDialog::showDifferences(bool on) {
  diff_->setVisible(on);
  legend_->setVisible(on);
  differences_->setText(on ? tr("Hide differences")
                           : tr("Show differences (−%1 +%2 lines)")
                                 .arg(diff_->removedCount())
                                 .arg(diff_->addedCount()));
  const int least = questions_.size() > 1 ? kQuestionWidth + kListWidth : kQuestionWidth;
  const int tall = layout()->totalHeightForWidth(least);
  setMinimumSize(least, on ? std::max(kDiffHeight, tall) : tall);
  const QSize wanted = on ? QSize(std::max(width(), 860), std::max(height(), 600)) : minimumSize();
  const QRect before = geometry();
  resize(wanted.boundedTo(screen()->availableSize()));
  if (isVisible()) {
    moveOnScreen(before.center() - rect().center());
  }
}

/// Keeps the buttons on the screen when the dialog grows.
void TreeChoiceDialog::moveOnScreen(const QPoint& corner) {
  const QRect room = screen()->availableGeometry();
  move(std::clamp(corner.x(), room.left(), std::max(room.left(), room.right() - width())),
       std::clamp(corner.y(), room.top(), std::max(room.top(), room.bottom() - height())));
}

void TreeChoiceDialog::take(bool isReplaced) {
  for (int i = 0; i < static_cast<int>(questions_.size()); ++i) {
    if (all_->isChecked() || i == list_->currentRow()) {
      choose(i, isReplaced);
    }
  }
}

void TreeChoiceDialog::choose(int question, bool isReplaced) {
  const editor::EntityId human = questions_[static_cast<std::size_t>(question)].human;
  isReplaced ? (void)replaced_.insert(human) : (void)replaced_.erase(human);
  updateRow(question);
  if (question == list_->currentRow()) {
    (isReplaced ? replace_ : keep_)->setChecked(true);
  }
}

void TreeChoiceDialog::updateRow(int index) {
  const bool keeps = replaced_.count(questions_[static_cast<std::size_t>(index)].human) == 0;
  list_->item(index)->setIcon(
      editor::tintedIcon(keeps ? QStringLiteral("tree") : QStringLiteral("file-save"),
                         theme_.color(keeps ? Role::TextSecondary : Role::WarningMark)));
  list_->item(index)->setToolTip(keeps ? tr("kept") : tr("replaced"));
}

std::optional<editor::TreeReplacements> TreeChoiceDialog::ask(std::vector<TreeConflict> questions,
                                                              const editor::Theme& theme,
                                                              QWidget* parent) {
  if (questions.empty()) {
    return editor::TreeReplacements();
  }
  TreeChoiceDialog dialog(std::move(questions), theme, parent);
  return dialog.exec() == QDialog::Accepted ? std::make_optional(dialog.replaced()) : std::nullopt;
}

}  // namespace app
