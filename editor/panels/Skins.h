#pragma once

#include <string>
#include <vector>

#include <QIcon>

#include "editor/look/Theme.h"

namespace editor {

/// How a simulator of HuNavSim dresses a person with a number. The pictures are ours: they show
/// hair, clothes and what the person wears on the head, not the model itself.
struct Skin {
  enum class Head { Hair, LongHair, Helmet, Cap, Dice };
  int number = 0;
  const char* name = "";  // as the simulator's editor or asset says
  QColor clothes, hair;
  Head head = Head::Hair;
};

/// Of "Gazebo Classic", "Gazebo Fortress", "Isaac Sim" or "Webots"; of Gazebo when none is named.
const std::vector<Skin>& skinsOf(const std::string& simulator);
/// What counts for a number: outside of the range Webots takes the first, the others the last.
const Skin& skinFor(const std::string& simulator, int number);

QIcon skinIcon(const Skin& skin, const Theme& theme);  // 24 px

}  // namespace editor
