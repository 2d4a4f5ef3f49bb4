#include "app/window/NoticeBar.h"

#include "app/window/Workspace.h"
#include "app/window/study/StudyPanel.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/look/Icons.h"
#include "sim2d/nav/external/CommandLine.h"

namespace app {

using editor::Role;

namespace {

constexpr int kLeastHeight = 40;
constexpr int kIcon = 18;
constexpr int kWords = 320;  // [px], min. text width beside the buttons

/// Icon, text, buttons and a close button in one row; in narrow windows the buttons are below the
/// text.
class NoticeRow : public QWidget {
 public:
  NoticeRow(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)), choices_(this) {
    setMinimumHeight(kLeastHeight);
    setAutoFillBackground(true);
    grid_->setContentsMargins(12, 4, 8, 4);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(4);
    grid_->setColumnStretch(WordsColumn, 1);
    buttons_ = editor::configuredLayout(new QHBoxLayout(&choices_), {}, 8);
    grid_->addWidget(&choices_, 0, ChoicesColumn);
  }

  enum Column { IconColumn, WordsColumn, ChoicesColumn, CrossColumn };
  void add(QWidget* part, Column column) { grid_->addWidget(part, 0, column); }
  void addChoice(QWidget* button) { buttons_->addWidget(button); }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    const bool isNarrow = width() < kWords + choices_.sizeHint().width();
    if (isNarrow == isNarrow_) {
      return;
    }
    isNarrow_ = isNarrow;
    grid_->removeWidget(&choices_);
    isNarrow ? grid_->addWidget(&choices_, 1, WordsColumn, Qt::AlignLeft)
             : grid_->addWidget(&choices_, 0, ChoicesColumn);
  }

 private:
  QGridLayout* grid_;
  QHBoxLayout* buttons_ = nullptr;
  QWidget choices_;
  bool isNarrow_ = false;
};

}  // namespace

NoticeBar::NoticeBar(const editor::Theme& theme, QWidget* parent)
    : QWidget(parent),
      theme_(theme),
      rows_(editor::configuredLayout(new QVBoxLayout(this), {}, 0)) {
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  hide();
}

void NoticeBar::coverTop(QWidget& widget) {
  if (auto* row = parentWidget() == nullptr ? nullptr
                                            : qobject_cast<QBoxLayout*>(parentWidget()->layout())) {
    row->removeWidget(this);
  }
  covered_ = &widget;
  setParent(&widget);
  widget.installEventFilter(this);
  setVisible(!notices_.empty());
  place();
}

void NoticeBar::insertInto(QBoxLayout& layout) {
  if (covered_ != nullptr) {
    covered_->removeEventFilter(this);
    covered_ = nullptr;
  }
  setCover(0);
  layout.insertWidget(0, this);
  setVisible(!notices_.empty());
}

bool NoticeBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == covered_ && event->type() == QEvent::Resize) {
    place();
  }
  return QWidget::eventFilter(watched, event);
}

/// In a narrow window the buttons of a row move below its text, which needs more height.
bool NoticeBar::event(QEvent* event) {
  const bool isUsed = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest) {
    place();
  }
  return isUsed;
}

/// In the covered widget: as wide as it, and as high as the notices are.
void NoticeBar::place() {
  if (covered_ == nullptr || notices_.empty()) {
    setCover(0);
    return;
  }
  rows_->activate();
  const int width = covered_->width();
  int height = 0;
  for (int k = 0; k < rows_->count(); ++k) {
    height += std::max(kLeastHeight, rows_->itemAt(k)->widget()->heightForWidth(width));
  }
  setGeometry(0, 0, width, height);
  raise();
  setCover(height);
}

void NoticeBar::setCover(int height) {
  if (std::exchange(cover_, height) != height) {
    Q_EMIT coverChanged(height);
  }
}

std::vector<Notice>::iterator NoticeBar::find(const QString& id) {
  return std::find_if(notices_.begin(), notices_.end(),
                      [&](const Notice& notice) { return notice.id == id; });
}

void NoticeBar::post(Notice notice) {
  if (const auto same = find(notice.id); same != notices_.end()) {
    *same = std::move(notice);
  } else {
    notices_.push_back(std::move(notice));
  }
  rebuild();
}

void NoticeBar::drop(const QString& id) {
  if (const auto gone = find(id); gone != notices_.end()) {
    notices_.erase(gone);
    rebuild();
  }
}

void NoticeBar::choose(const QString& id, int choice) {
  if (const auto found = find(id); found != notices_.end()) {
    const std::function<void()> action = found->choices.at(static_cast<std::size_t>(choice)).action;
    drop(id);
    if (action) {
      action();
    }
  }
}

void NoticeBar::setTheme(const editor::Theme& theme) {
  theme_ = theme;
  rebuild();
}

void NoticeBar::rebuild() {
  if (QWidget* focus = window()->focusWidget(); focus != nullptr && isAncestorOf(focus)) {
    Q_EMIT focusReleased();  // before Qt moves the focus
  }
  editor::clearLater(*rows_);
  for (const Notice& notice : notices_) {
    rows_->addWidget(rowOf(notice));
  }
  setVisible(!notices_.empty());
  place();
}

QWidget* NoticeBar::rowOf(const Notice& notice) {
  const Role mark = notice.isWarning ? Role::WarningMark : Role::Accent;
  auto* row = new NoticeRow(this);
  QPalette palette = row->palette();
  const QColor panel = theme_.color(Role::Panel);
  const QColor tint = theme_.color(mark);
  const double share = theme_.isDark() ? 0.18 : 0.10;
  const auto mixed = [&](int a, int b) { return static_cast<int>(a + share * (b - a)); };
  palette.setColor(QPalette::Window,
                   QColor(mixed(panel.red(), tint.red()), mixed(panel.green(), tint.green()),
                          mixed(panel.blue(), tint.blue())));
  row->setPalette(palette);
  auto* icon = new QLabel(row);
  icon->setPixmap(editor::tintedIcon(
                      notice.isWarning ? QStringLiteral("warning") : QStringLiteral("info"), tint)
                      .pixmap(kIcon, kIcon));
  row->add(icon, NoticeRow::IconColumn);
  auto* text = new QLabel(notice.text, row);
  text->setTextFormat(Qt::PlainText);  // may contain file and program names
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  text->setWordWrap(true);
  row->add(text, NoticeRow::WordsColumn);
  for (std::size_t i = 0; i < notice.choices.size(); ++i) {
    auto* button = new QPushButton(notice.choices[i].text, row);
    connect(button, &QPushButton::clicked, this,
            [this, id = notice.id, i] { choose(id, static_cast<int>(i)); });
    row->addChoice(button);
  }
  auto* close = new QToolButton(row);
  close->setIcon(editor::themedIcon(QStringLiteral("close"), theme_));
  close->setAutoRaise(true);
  close->setToolTip(tr("Dismiss"));
  close->setAccessibleName(tr("Dismiss"));
  connect(close, &QToolButton::clicked, this, [this, id = notice.id] { drop(id); });
  row->add(close, NoticeRow::CrossColumn);
  return row;
}

namespace {

/// "python3 follow.py (robot1)", with special characters escaped. Nothing is cut, because that
/// could hide commands.
QString codeText(const std::vector<ExternalCode>& code) {
  QStringList all;
  for (const ExternalCode& each : code) {
    const std::string words = sim2d::printableText(each.words, each.words.size());
    all << QStringLiteral("%1 (%2)").arg(QString::fromStdString(words),
                                         QString::fromStdString(each.robot));
  }
  return all.join(QStringLiteral("; "));
}

void warnOfCode(NoticeBar& notices, const QString& id, const QString& file,
                const std::vector<ExternalCode>& code, const std::function<void()>& allow) {
  notices.warn(
      id,
      QObject::tr("%1 runs external code (%2) with your permissions.").arg(file, codeText(code)),
      {{QObject::tr("Allow for this file"), allow}, {QObject::tr("Do not run"), {}}});
}

}  // namespace

void askBeforeExternalCode(Workspace& workspace, NoticeBar& notices) {
  QObject::connect(
      &workspace, &Workspace::codePermissionNeeded, &notices, [&workspace, &notices](bool paused) {
        const std::vector<ExternalCode> code = workspace.unapprovedCode();
        const auto allow = [&workspace, code, paused] {
          workspace.allowCode(code);
          paused ? workspace.runner().stepOnce() : workspace.runner().play();
        };
        warnOfCode(notices, codeNoticeId(), workspace.document().displayName(), code, allow);
      });
  QObject::connect(&workspace.document(), &editor::ScenarioDocument::changed, &notices,
                   [&notices](const editor::Change& change) {
                     if (change.what == editor::Change::What::Everything) {
                       notices.drop(codeNoticeId());  // another file was opened
                     }
                   });
}

void askBeforeExternalCode(StudyPanel& study, NoticeBar& notices) {
  QObject::connect(&study, &StudyPanel::codePermissionNeeded, &notices,
                   [&study, &notices](const std::vector<ExternalCode>& code) {
                     if (code.empty()) {
                       notices.drop(studyCodeNoticeId());
                       return;
                     }
                     warnOfCode(notices, studyCodeNoticeId(), study.shownName(), code,
                                [&study, code] { study.allowCode(code); });
                   });
}

}  // namespace app
