// New scenarios: on an open plane, in a room, on a map, on an image.
#include <QFileInfo>

#include "app/window/FileCommands.h"
#include "app/window/MapDialogs.h"
#include "editor/canvas/MapItem.h"
#include "editor/document/MapEdit.h"

namespace app {

bool FileCommands::openNewFromMap(const QString& mapYaml) {
  if (!tell(workspace_.document().newOnMap(mapYaml))) {
    return false;
  }
  Q_EMIT opened();
  return true;
}

void FileCommands::newRoom() {
  workspace_.document().clear();
  tell({});
  Q_EMIT opened();
}

void FileCommands::newOnMap(std::shared_ptr<const sim2d::OccupancyGrid> map) {
  workspace_.document().load(sim2d::Scenario());
  workspace_.document().setMap(std::move(map));
  tell({});
  Q_EMIT opened();
}

void FileCommands::askNewRoom() {
  RoomDialog dialog(workspace_.theme(), &window_);
  if (dialog.exec() != QDialog::Accepted || !mayLeave()) {
    return;
  }
  if (dialog.hasWalls()) {
    newOnMap(editor::emptyRoom(dialog.size().width(), dialog.size().height()));
  } else {
    newRoom();
  }
}

void FileCommands::askNewFromMap() {
  const QString path =
      dialogs_.openFile(tr("New scenario on a map"), folder(),
                        tr("Maps and images (*.yaml *.yml *.png *.pgm *.bmp *.jpg *.jpeg)"));
  if (path.isEmpty()) {
    return;
  }
  if (kindOf(path) == Kind::Image) {
    askMapOfImage(path);
  } else if (mayLeave()) {
    openNewFromMap(path);
  }
}

void FileCommands::askMapOfImage(const QString& path) {
  constexpr double kResolution = 0.05;
  const base::Result<std::shared_ptr<const sim2d::OccupancyGrid>> grid =
      editor::gridOfImage(path, kResolution);
  if (!tell(grid.diagnostics()) || !grid) {
    return;
  }
  QImage image(path);
  if (image.isNull()) {  // a format that only the map reader knows
    image = editor::mapImage(**grid, workspace_.theme());
  }
  ImageMapDialog dialog(*grid, image, workspace_.theme(), &window_);
  if (dialog.exec() == QDialog::Accepted && mayLeave()) {
    newOnMap(dialog.map());
  }
}

void FileCommands::askOtherMap() {
  const QString path =
      dialogs_.openFile(tr("Put a map under the scenario"), folder(), tr("Maps (*.yaml *.yml)"));
  if (!path.isEmpty()) {
    putOtherMap(path);
  }
}

/// One that cannot be read leaves everything as it is, a run too.
bool FileCommands::putOtherMap(const QString& path) {
  const bool isFine = tell(workspace_.document().openMap(path));
  if (isFine) {
    workspace_.runner().reset();
  }
  mapRefused_ = !isFine;
  return isFine;
}

}  // namespace app
