#include "app/window/runs/HistoryDialog.h"

#include <algorithm>

#include "editor/look/Form.h"
#include "editor/panels/runs/Playback.h"

namespace app {

namespace {

constexpr const char* kMemoryKey = "run/history-megabytes";
constexpr std::size_t kMega = std::size_t{1} << 20;
constexpr int kLeast = 16, kMost = 65536, kStep = 64;  // [MB]
constexpr int kTextWidth = 380;                        // [px]

QString megabytesText(std::size_t bytes) {
  return QObject::tr("%1 MB").arg(double(bytes) / double(kMega), 0, 'f', 1);
}

/// The usage of the displayed run: "12.0 MB in memory, 3.1 MB on the disk".
QString useText(const sim2d::Recording& run) {
  const sim2d::FrameHistory& history = run.history();
  QString text = QObject::tr("The displayed run uses %1 of memory and %2 of disk space.")
                     .arg(megabytesText(history.memory()), megabytesText(history.disk()));
  if (run.first() > 0) {
    text += QObject::tr(" The disk is full: the timeline starts at %1.")
                .arg(editor::clockText(run.timeOf(run.first())));
  }
  return text;
}

}  // namespace

std::size_t historyMemory(const UserSettings& memory) {
  const int chosen = memory.value(kMemoryKey).toInt();  // 0: never chosen
  return chosen == 0 ? sim2d::Recording::kDefaultMemory
                     : static_cast<std::size_t>(std::clamp(chosen, kLeast, kMost)) * kMega;
}

HistoryDialog::HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown,
                             const editor::Theme& theme, QWidget* parent)
    : QDialog(parent), megabytes_(new QSpinBox(this)) {
  setWindowTitle(tr("Run history"));
  megabytes_->setRange(kLeast, kMost);
  megabytes_->setSingleStep(kStep);
  megabytes_->setSuffix(tr(" MB"));
  megabytes_->setAlignment(Qt::AlignRight);
  megabytes_->setValue(static_cast<int>(memory / kMega));
  megabytes_->setAccessibleName(tr("Memory per run"));
  megabytes_->setToolTip(
      tr("Memory per run\nMemory for the steps of a run that the timeline can show. 200 people "
         "need about 12 MB per minute."));
  QLabel* title = editor::headingLabel(tr("Run history"), theme.font(12.0, QFont::DemiBold), this);
  QLabel* explanation = editor::secondaryLabel(
      tr("Older steps are stored in a temporary file until the run is closed. When the disk is "
         "full, the oldest are deleted and the timeline starts later."),
      this);
  auto* rows = editor::configuredLayout(new QVBoxLayout(this), {16, 16, 16, 12}, 8, {title});
  QFormLayout* form = formRows();
  form->addRow(tr("Memory per run"), megabytes_);
  rows->addLayout(form);
  rows->addWidget(explanation);
  if (shown != nullptr && shown->size() > 0) {
    explanation->setText(explanation->text() + QStringLiteral("\n\n") + useText(*shown));
  }
  QLabel* when = editor::secondaryLabel(tr("Applies to runs started from now on."), this);
  for (QLabel* label : {explanation, when}) {
    label->setWordWrap(true);
    label->setMinimumWidth(kTextWidth);
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

void showHistoryDialog(UserSettings& memory, editor::SimulationRunner& runner,
                       const editor::Theme& theme, QWidget* parent) {
  HistoryDialog dialog(runner.historyMemory(), runner.recording(), theme, parent);
  if (dialog.exec() == QDialog::Accepted) {
    memory.setValue(kMemoryKey, static_cast<int>(dialog.memory() / kMega));
    runner.setHistory(dialog.memory());
  }
}

}  // namespace app
