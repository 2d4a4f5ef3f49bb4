#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QObject>

#include "editor/document/Entity.h"
#include "editor/document/LatestTask.h"
#include "sim2d/map/OccupancyGrid.h"

namespace editor {

/// One leg of a route, from a start or goal to the next goal.
struct RouteLeg {
  std::vector<Vec2> points;  // world, both ends included
  bool isReachable = true;   // false: the straight line is given
};
struct EntityRoute {
  std::vector<RouteLeg> legs;
  bool returns = false;  // the last leg leads back to the first goal
};
using Routes = std::map<EntityId, EntityRoute>;

/// The ways of all people and robots round walls, by the planner of the simulation. Planned beside
/// the GUI thread; `routesChanged` tells when newer ones are there.
class RouteModel : public QObject {
  Q_OBJECT
 public:
  explicit RouteModel(QObject* parent = nullptr);
  ~RouteModel() override;
  Q_DISABLE_COPY_MOVE(RouteModel)

  void update(const sim2d::Scenario& scenario, std::shared_ptr<const sim2d::OccupancyGrid> map);
  const EntityRoute* route(EntityId id) const;
  void finish() { task_.finish(); }  // waits for what was asked for

 Q_SIGNALS:
  void routesChanged();

 private:
  struct Planning;
  Routes routes_;
  std::shared_ptr<Planning> planning_;  // kept from one task to the next, used by one at a time
  LatestTask<Routes> task_;
};

}  // namespace editor
