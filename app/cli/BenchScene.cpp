#include "app/cli/BenchScene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <QFileInfo>
#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_renderer.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include "bt/human/TreeBehavior.h"
#include "editor/look/Theme.h"
#include "sim2d/world/World.h"

namespace app {
namespace {

using sim2d::Scenario;
using sim2d::Vec2;

constexpr double kDensity = 0.5;         // [1/m²]
constexpr double kSpeed = 1.3;           // [m/s]
constexpr double kStep = 0.05;           // [s]
constexpr double kGoalDistance = 100.0;  // [m]; goals are outside the square and never reached
constexpr double kRobotClearance = 1.2;  // [m]
constexpr int kSegmentsPerWall = 100;

/// Pseudo-random numbers (linear congruential), the same in every run.
class Jitter {
 public:
  double next() {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8U) / 16777216.0;
  }

 private:
  std::uint32_t state_ = 7;
};

void addGoal(Scenario& scenario, int id, const Vec2& position) {
  sim2d::GlobalGoal goal;
  goal.id = id;
  goal.position = position;
  scenario.goals.push_back(goal);
}

/// To the right for odd goals, to the left for even ones, at the agent's own y.
void addPerson(Scenario& scenario, int index, const Vec2& start, int goal) {
  sim2d::Human human;
  human.id = index + 1;
  human.name = "person" + std::to_string(human.id);
  human.initPose = {start, goal % 2 == 1 ? 0.0 : base::kPi};
  human.goals = {goal};
  human.radius = 0.25;
  human.maxVel = kSpeed;
  human.goalRadius = 0.3;
  human.cyclicGoals = false;
  scenario.humans.push_back(human);
}

/// Goals are ten metres apart in y.
int goalAt(double height, bool isRight) {
  const int row = static_cast<int>(height / 10.0);
  return 2 * row + (isRight ? 1 : 2);
}

void addWall(Scenario& scenario, double size, double height, double zigzag) {
  sim2d::Obstacle wall;
  wall.name = "wall" + std::to_string(scenario.obstacles.size() + 1);
  wall.kind = sim2d::ObstacleKind::Wall;
  wall.thickness = 0.1;
  for (int i = 0; i <= kSegmentsPerWall; ++i) {
    wall.points.emplace_back(size * i / kSegmentsPerWall, height + (i % 2 == 0 ? 0.0 : zigzag));
  }
  scenario.obstacles.push_back(wall);
}

void addRobot(Scenario& scenario, const Vec2& place) {
  sim2d::Robot robot;
  robot.name = "robot";
  robot.start = {place, 0.0};
  robot.radius = 0.35;
  scenario.robots.push_back(robot);
}

/// The force of the model, written for readability instead of speed.
Vec2 plainForce(const Vec2& apart, const Vec2& relative) {
  const double distance = std::sqrt(apart.squaredNorm());
  const Vec2 e = apart / distance;
  const Vec2 interaction = 2.0 * relative + e;
  const double length = std::sqrt(interaction.squaredNorm());
  if (length < 1e-6) {
    return Vec2::Zero();
  }
  const Vec2 t = interaction / length;
  const double reach = 0.35 * length;
  const double theta =
      std::atan2(t.x() * e.y() - t.y() * e.x(), t.x() * e.x() + t.y() * e.y()) + 0.005 * reach;
  const double forSpeed = 3.0 * reach * theta;
  const double forTurn = 2.0 * reach * theta;
  const double slowing = -std::exp(-distance / reach - forSpeed * forSpeed);
  const double turning = std::copysign(std::exp(-distance / reach - forTurn * forTurn), -theta);
  return 5.0 * (slowing * t + turning * Vec2(-t.y(), t.x()));
}

}  // namespace

Scenario makeBenchScenario(const BenchScene& scene) {
  Scenario scenario;
  scenario.desktop.dt = kStep;
  scenario.desktop.seed = 1;
  const double size = std::sqrt(scene.people / kDensity);
  for (int row = 0; 10.0 * row <= size; ++row) {
    const double height = 10.0 * row + 5.0;
    addGoal(scenario, 2 * row + 1, Vec2(size + kGoalDistance, height));
    addGoal(scenario, 2 * row + 2, Vec2(-kGoalDistance, height));
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(scene.people)));
  const double gap = size / side;
  const Vec2 middle(size / 2.0, size / 2.0);
  Jitter jitter;
  const int people = scene.singlePerson ? 1 : scene.people;
  scenario.humans.reserve(static_cast<std::size_t>(people));
  for (int i = 0; i < people; ++i) {
    const double x = (i % side + 0.25 + 0.5 * jitter.next()) * gap;
    const int row = i / side;
    const double y = (row + 0.25 + 0.5 * jitter.next()) * gap;
    const bool isRight = jitter.next() < 0.5;
    if ((Vec2(x, y) - middle).norm() > kRobotClearance) {
      addPerson(scenario, i, Vec2(x, y), goalAt(y, isRight));
    }
  }
  addRobot(scenario, middle);
  if (scene.walls) {
    addWall(scenario, size, -0.7, -0.3);
    addWall(scenario, size, size + 0.7, 0.3);
  }
  return scenario;
}

base::Result<std::unique_ptr<sim2d::World>> makeBenchWorld(const BenchScene& scene) {
  Scenario scenario = makeBenchScenario(scene);
  // Route search is unnecessary: the streams are straight.
  scenario.desktop.route = sim2d::Route::Direct;
  bt::TreeFiles trees;
  for (const sim2d::Human& human : scenario.humans) {
    trees[human.name] = scene.tree;
  }
  base::Diagnostics diagnostics;
  sim2d::WorldSetup setup;
  setup.behavior = bt::makeTreeBehavior(scenario, trees, diagnostics);
  if (!setup.behavior) {
    return diagnostics;
  }
  setup.scenario = std::make_shared<const Scenario>(std::move(scenario));
  setup.threads = scene.threads;
  return sim2d::World::create(std::move(setup));
}

int crossingSteps(const BenchScene& scene) {
  constexpr int kMinSteps = 30;
  const double size = std::sqrt(scene.people / kDensity);
  return std::max(kMinSteps, static_cast<int>(size / 7.0 / (kSpeed * kStep)));
}

std::string benchTreeText() {
  return R"(<?xml version="1.0" encoding="UTF-8"?>
<root main_tree_to_execute="Walker" BTCPP_format="4">
  <BehaviorTree ID="Walker">
    <ReactiveFallback>
      <ReactiveSequence>
        <IsRobotVisible agent_id="{id}" distance="0.1"/>
        <Inverter><IsGoalReached agent_id="{id}"/></Inverter>
        <LookAtRobot agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <IsGoalReached agent_id="{id}"/>
        <UpdateGoal agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <IsRobotVisible agent_id="{id}" distance="0.2"/>
        <ForceSuccess><AlwaysSuccess/></ForceSuccess>
        <LookAtRobot agent_id="{id}"/>
      </ReactiveSequence>
      <ReactiveSequence>
        <Inverter><IsGoalReached agent_id="{id}"/></Inverter>
        <AlwaysSuccess/>
        <RegularNav agent_id="{id}" time_step="{dt}"/>
      </ReactiveSequence>
    </ReactiveFallback>
  </BehaviorTree>
</root>
)";
}

double plainStepSeconds(const Scenario& scenario, double atLeastSeconds) {
  std::vector<Vec2> positions;
  std::vector<Vec2> velocities;
  for (const sim2d::Human& human : scenario.humans) {
    positions.push_back(human.initPose.position);
    velocities.push_back(kSpeed * base::directionOf(human.initPose.heading));
  }
  std::vector<Vec2> forces(positions.size(), Vec2::Zero());
  double fastest = 1e300;
  double before = sim2d::clockSeconds(sim2d::StepClock::Thread);
  const double end = before + atLeastSeconds;
  while (fastest == 1e300 || before < end) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      forces[i] = Vec2::Zero();
      for (std::size_t k = 0; k < positions.size(); ++k) {
        if (k != i) {
          forces[i] += plainForce(positions[k] - positions[i], velocities[i] - velocities[k]);
        }
      }
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
      velocities[i] += kStep * forces[i];
      velocities[i] *= std::min(1.0, kSpeed / std::max(velocities[i].norm(), 1e-9));
      positions[i] += kStep * velocities[i];
    }
    const double now = sim2d::clockSeconds(sim2d::StepClock::Thread);
    fastest = std::min(fastest, now - before);
    before = now;
  }
  return fastest;
}

namespace {

using editor::Role;

constexpr double kTickMs = 50.0;               // [ms] of simulated time
constexpr int kDotsPerInch = 144;              // twice the text size of a screen
const QSizeF kMillimetres = {254.0, 142.875};  // 1440 x 810 dots

/// Labels 10, 100, 1 000 … with thin spaces.
class PowerOfTenLabels : public QwtScaleDraw {
 public:
  QwtText label(double value) const override {
    const QLocale plain = QLocale::c();
    QString text = plain.toString(value, 'g', 12);
    for (int at = text.size() - 3; at > 0 && value >= 1000.0; at -= 3) {
      text.insert(at, QChar(0x202f));
    }
    return text;
  }
};

QwtText titled(const QString& text, const QFont& font, const QColor& color) {
  QwtText title(text);
  title.setFont(font);
  title.setColor(color);
  return title;
}

void setAxes(QwtPlot& plot, const editor::Theme& theme) {
  const QColor words = theme.color(Role::TextSecondary);
  plot.setAxisTitle(QwtPlot::xBottom, titled(QStringLiteral("people"), theme.font(9.0), words));
  plot.setAxisTitle(QwtPlot::yLeft,
                    titled(QStringLiteral("time per 50 ms step [ms]"), theme.font(9.0), words));
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    plot.setAxisScaleEngine(axis, new QwtLogScaleEngine);
    plot.setAxisScaleDraw(axis, new PowerOfTenLabels);
    plot.setAxisMaxMinor(axis, 0);
    plot.setAxisFont(axis, theme.font(8.5));
    plot.axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  }
}

void addCurve(QwtPlot& plot, const QString& name, const QVector<QPointF>& samples,
              const QPen& pen) {
  auto* curve = new QwtPlotCurve(name);
  curve->setSamples(samples);
  curve->setPen(pen);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->setLegendAttribute(QwtPlotCurve::LegendShowLine);
  curve->setLegendIconSize(QSize(24, 8));
  if (pen.style() == Qt::SolidLine) {
    curve->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, pen.color(), Qt::NoPen, QSize(6, 6)));
  }
  curve->setItemAttribute(QwtPlotItem::Legend, !name.isEmpty());
  curve->attach(&plot);
}

QVector<QPointF> samplesOf(const std::vector<BenchPoint>& points, double BenchPoint::*time) {
  QVector<QPointF> samples;
  for (const BenchPoint& point : points) {
    samples.push_back({static_cast<double>(point.people), point.*time});
  }
  return samples;
}

/// Measured values as a solid line, extrapolated ones dashed.
void addPlain(QwtPlot& plot, const std::vector<BenchPoint>& points, const QColor& color) {
  QVector<QPointF> measured;
  QVector<QPointF> scaled;
  for (const BenchPoint& point : points) {
    const QPointF sample(point.people, point.plain);
    if (!point.isScaled) {
      measured.push_back(sample);
      scaled.clear();
    }
    scaled.push_back(sample);
  }
  addCurve(plot, QStringLiteral("forces, naive sum over all pairs"), measured, QPen(color, 2.0));
  addCurve(plot, {}, scaled, QPen(color, 2.0, Qt::DashLine));
}

void addRealTime(QwtPlot& plot, const editor::Theme& theme) {
  auto* line = new QwtPlotMarker;
  line->setLineStyle(QwtPlotMarker::HLine);
  line->setLinePen(theme.color(Role::TextSecondary), 1.0, Qt::DotLine);
  line->setYValue(kTickMs);
  line->setLabel(
      titled(QStringLiteral("real time"), theme.font(8.5), theme.color(Role::TextSecondary)));
  line->setLabelAlignment(Qt::AlignLeft | Qt::AlignTop);
  line->attach(&plot);
}

}  // namespace

bool drawBench(const std::vector<BenchPoint>& points, const QString& machine, const QString& file) {
  const editor::Theme theme = editor::Theme::light();
  QwtPlot plot(titled(machine, theme.font(10.0, QFont::DemiBold), theme.color(Role::Text)));
  plot.setCanvasBackground(theme.color(Role::Panel));
  QPalette colors = plot.palette();
  colors.setColor(QPalette::Window, theme.color(Role::Panel));
  colors.setColor(QPalette::Text, theme.color(Role::TextSecondary));
  colors.setColor(QPalette::WindowText, theme.color(Role::FieldEdge));
  plot.setPalette(colors);
  plot.setFont(theme.font(9.0));
  static_cast<QwtPlotCanvas*>(plot.canvas())->setFrameStyle(QFrame::NoFrame);
  setAxes(plot, theme);
  auto* grid = new QwtPlotGrid;
  grid->setPen(theme.color(Role::Line), 1.0);
  grid->attach(&plot);
  addPlain(plot, points, theme.color(Role::TextSecondary));
  addCurve(plot, QStringLiteral("full step with trees, bodies and lidar"),
           samplesOf(points, &BenchPoint::whole), QPen(theme.color(Role::Text), 2.0));
  addCurve(plot, QStringLiteral("forces only"), samplesOf(points, &BenchPoint::forces),
           QPen(theme.color(Role::Accent), 2.4));
  addRealTime(plot, theme);
  auto* legend = new QwtLegend;
  legend->setFont(theme.font(9.0));
  plot.insertLegend(legend, QwtPlot::BottomLegend);
  plot.setContentsMargins(12, 10, 16, 10);
  plot.resize(720, 405);
  plot.replot();
  QwtPlotRenderer renderer;
  renderer.setDiscardFlag(QwtPlotRenderer::DiscardCanvasFrame);
  renderer.renderDocument(&plot, file, kMillimetres, kDotsPerInch);
  return QFileInfo(file).size() > 0;
}

}  // namespace app
