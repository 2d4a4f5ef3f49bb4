#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QWidget>
#include <QtWidgets>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/DeferredActions.h"
#include "editor/look/Form.h"
#include "editor/look/Theme.h"
#include "sim2d/scenario/ResolvedValues.h"

namespace editor {

/// The goals of a person or robot as chips in visiting order. The menu of a chip selects its goal,
/// moves it or removes it, as Delete does; "+ Add" offers all goals.
class RouteEditor : public QWidget {
  Q_OBJECT
 public:
  explicit RouteEditor(ScenarioDocument& document, QWidget* parent = nullptr);

  void show(const std::vector<int>& goals);
  const std::vector<int>& goals() const { return goals_; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;

 Q_SIGNALS:
  void edited(const std::vector<int>& goals);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Chip;
  void rebuild();
  int place(int width, bool apply) const;
  void offerGoals(QWidget* button);
  void offerMoves(QWidget* chip, int index);
  bool has(int index) const { return index >= 0 && index < static_cast<int>(goals_.size()); }
  void removeGoal(int index);
  void moveGoal(int from, int to);

  ScenarioDocument& document_;
  std::vector<int> goals_;
  std::vector<QWidget*> parts_;
  PanelMenu menu_;  // Menu of a chip or the button.
};

/// The body of a robot from above, front to the right: footprint to scale, wheels, length and width
/// [m]; beside it the limits of its drive.
class RobotPicture : public QWidget {
  Q_OBJECT
 public:
  explicit RobotPicture(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  /// None: several robots with different bodies.
  void show(const std::optional<sim2d::ResolvedRobot>& robot);
  QSize sizeHint() const override { return {200, 128}; }

  /// Size of the footprint's bounding box: along and across the robot [m].
  static QSizeF sizeOf(const sim2d::ResolvedRobot& robot);
  /// The labels and values beside the body.
  static QList<std::pair<QString, QString>> specificationsOf(const sim2d::ResolvedRobot& robot);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBody(QPainter& painter, const QRectF& room) const;
  void paintSpecifications(QPainter& painter, const QRectF& room) const;

  Theme theme_;
  std::optional<sim2d::ResolvedRobot> robot_;
};

/// The skin of a person in a HuNavSim simulator, by number. The pictures are schematic: hair,
/// clothes and headwear, not the actual model.
struct Skin {
  enum class Head { Hair, LongHair, Helmet, Cap, Dice };
  int number = 0;
  const char* name = "";  // As in the simulator's editor or asset.
  QColor clothes, hair;
  Head head = Head::Hair;
};

/// For "Gazebo Classic", "Gazebo Fortress", "Isaac Sim" or "Webots"; Gazebo if none is named.
const std::vector<Skin>& skinsOf(const std::string& simulator);
/// For users: "Blue jeans", or the name of a model.
QString skinName(const Skin& skin);
/// The skin used for a number: outside of the range Webots uses the first, the others the last.
const Skin& skinFor(const std::string& simulator, int number);

QIcon skinIcon(const Skin& skin, const Theme& theme);  // 24 px

}  // namespace editor
