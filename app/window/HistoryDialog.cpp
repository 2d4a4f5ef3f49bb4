#include "app/window/HistoryDialog.h"

#include <algorithm>

#include <QLabel>

#include "editor/look/Form.h"
#include "editor/panels/Playback.h"

namespace app {

namespace {

constexpr const char* kMemoryKey = "run/history-megabytes";
constexpr std::size_t kMega = std::size_t{1} << 20;
constexpr int kLeast = 16, kMost = 65536, kStep = 64;  // [MB]
constexpr int kWidth = 380;                            // [px]

QString megabytesText(std::size_t bytes) {
  return QObject::tr("%1 MB").arg(double(bytes) / double(kMega), 0, 'f', 1);
}

/// "12.0 MB in memory, 3.1 MB on the disk" of the run that is shown.
QString useText(const sim2d::Recording& run) {
  const sim2d::FrameHistory& history = run.history();
  QString text = QObject::tr("The run that is shown takes %1 of memory and %2 of the disk.")
                     .arg(megabytesText(history.memory()), megabytesText(history.disk()));
  if (run.first() > 0) {
    text += QObject::tr(" The disk takes no more: it can be looked back at from %1 on.")
                .arg(editor::clockText(run.timeOf(run.first())));
  }
  return text;
}

}  // namespace

std::size_t historyMemory(const Memory& memory) {
  const int chosen = memory.value(kMemoryKey).toInt();  // 0: nothing was
  return chosen == 0 ? sim2d::Recording::kUsualMemory
                     : static_cast<std::size_t>(std::clamp(chosen, kLeast, kMost)) * kMega;
}

HistoryDialog::HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown,
                             const editor::Theme& theme, QWidget* parent)
    : QDialog(parent), megabytes_(new QSpinBox(this)) {
  setWindowTitle(tr("Looking back"));
  megabytes_->setRange(kLeast, kMost);
  megabytes_->setSingleStep(kStep);
  megabytes_->setSuffix(tr(" MB"));
  megabytes_->setAlignment(Qt::AlignRight);
  megabytes_->setValue(static_cast<int>(memory / kMega));
  megabytes_->setAccessibleName(tr("Memory for a run"));
  megabytes_->setToolTip(
      tr("Memory for a run\nMegabytes for the moments of a run that the timeline goes back to. "
         "200 people take about 12 MB a minute."));
  QLabel* title =
      editor::headingLabel(tr("Looking back at a run"), theme.font(12.0, QFont::DemiBold), this);
  QLabel* says = editor::secondaryLabel(
      tr("Older moments wait in a temporary file until the run is left. When the disk is full, the "
         "oldest are dropped and the timeline begins later."),
      this);
  auto* rows = editor::arranged(new QVBoxLayout(this), {16, 16, 16, 12}, 8, {title});
  QFormLayout* form = formRows();
  form->addRow(tr("Memory for a run"), megabytes_);
  rows->addLayout(form);
  rows->addWidget(says);
  if (shown != nullptr && shown->size() > 0) {
    says->setText(says->text() + QStringLiteral("\n\n") + useText(*shown));
  }
  QLabel* when = editor::secondaryLabel(tr("Counts for the runs that begin from now on."), this);
  for (QLabel* label : {says, when}) {
    label->setWordWrap(true);
    label->setMinimumWidth(kWidth);
  }
  rows->addWidget(when);
  rows->addSpacing(8);
  addButtons(this, *rows, tr("Set"));
  megabytes_->setFocus();
  megabytes_->selectAll();
}

std::size_t HistoryDialog::memory() const {
  return static_cast<std::size_t>(megabytes_->value()) * kMega;
}

void askHistory(Memory& memory, editor::SimulationRunner& runner, const editor::Theme& theme,
                QWidget* parent) {
  HistoryDialog dialog(runner.historyMemory(), runner.recording(), theme, parent);
  if (dialog.exec() == QDialog::Accepted) {
    memory.setValue(kMemoryKey, static_cast<int>(dialog.memory() / kMega));
    runner.setHistory(dialog.memory());
  }
}

}  // namespace app
