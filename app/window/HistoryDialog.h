#pragma once

#include <cstddef>

#include <QDialog>
#include <QSpinBox>

#include "app/window/FileDialogs.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace app {

/// Memory for the states of a run [B]: what was chosen last, in any window; else the usual amount.
std::size_t historyMemory(const Memory& memory);

/// How much memory a run may take, so that all of it can be looked back at; what the run that is
/// shown takes now.
class HistoryDialog : public QDialog {
  Q_OBJECT
 public:
  HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown, const editor::Theme& theme,
                QWidget* parent = nullptr);
  std::size_t memory() const;  // [B]

 private:
  QSpinBox* megabytes_;
};

/// Asks; what is chosen counts for the runs that begin from now on.
void askHistory(Memory& memory, editor::SimulationRunner& runner, const editor::Theme& theme,
                QWidget* parent);

}  // namespace app
