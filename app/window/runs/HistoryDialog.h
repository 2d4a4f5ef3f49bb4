#pragma once

#include <cstddef>

#include <QtWidgets>

#include "app/window/files/FileDialogs.h"
#include "editor/look/Theme.h"
#include "editor/run/SimulationRunner.h"

namespace app {

/// RAM for the frames of a run [B]: the last chosen value, otherwise the default.
std::size_t historyMemory(const UserSettings& memory);

/// Settings for the memory of a run's history, with the usage of the displayed run.
class HistoryDialog : public QDialog {
  Q_OBJECT
 public:
  HistoryDialog(std::size_t memory, const editor::RecordingPtr& shown, const editor::Theme& theme,
                QWidget* parent = nullptr);
  std::size_t memory() const;  // [B]

 private:
  QSpinBox* megabytes_;
};

/// Shows the dialog. The value applies to runs started afterwards.
void showHistoryDialog(UserSettings& memory, editor::SimulationRunner& runner,
                       const editor::Theme& theme, QWidget* parent);

}  // namespace app
