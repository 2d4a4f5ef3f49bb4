#include "editor/look/Theme.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/trace/Trace.h"

namespace editor {

namespace {

struct RoleColors {
  Role role;
  QRgb light, dark;
};

constexpr std::array<RoleColors, static_cast<std::size_t>(Role::Count)> kRoles = {{
    {Role::Window, 0xFFF5F6F7, 0xFF1E2124},        {Role::Panel, 0xFFFFFFFF, 0xFF26292D},
    {Role::Text, 0xFF1B1F23, 0xFFE6E8EA},          {Role::TextSecondary, 0xFF5F6B76, 0xFF9BA5AF},
    {Role::Line, 0xFFD8DCE0, 0xFF3A3F45},          {Role::Accent, 0xFF2F6FDE, 0xFF6EA0FF},
    {Role::AccentText, 0xFF1F58C0, 0xFF6EA0FF},    {Role::MapFree, 0xFFFFFFFF, 0xFF2A2E33},
    {Role::MapOccupied, 0xFF2B2F33, 0xFF858E97},   {Role::MapUnknown, 0xFFC9CED3, 0xFF3C4248},
    {Role::CanvasOutside, 0xFFECEEF0, 0xFF202326}, {Role::ObstacleFill, 0xFFE6E9EC, 0xFF383E44},
    {Role::ObstacleEdge, 0xFF838E98, 0xFF7C8790},  {Role::RowSelected, 0xFFE4EDFB, 0xFF2C3A55},
    {Role::RowHover, 0xFFEEF1F4, 0xFF2F3338},      {Role::Field, 0xFFFFFFFF, 0xFF1F2225},
    {Role::FieldEdge, 0xFFC4CAD0, 0xFF4A5158},     {Role::Ok, 0xFF2E8540, 0xFF58B36B},
    {Role::Warning, 0xFF9C5C00, 0xFFE0A030},       {Role::WarningMark, 0xFFC77700, 0xFFE0A030},
    {Role::Error, 0xFFC0392B, 0xFFF06A5A},         {Role::ErrorSoft, 0xFFD3746B, 0xFFD3746B},
    {Role::RobotBody, 0xFF222222, 0xFFF0F0F0},     {Role::RobotFront, 0xFFF0E442, 0xFFC79200},
    {Role::RobotLine, 0xFF4A5056, 0xFFD6DADE},     {Role::GoalPin, 0xFFFFFFFF, 0xFF2A2E33},
    {Role::Past, 0xFF2F6FDE, 0xFF6EA0FF},          {Role::ForceGoal, 0xFF2E8540, 0xFF58B36B},
    {Role::ForceSocial, 0xFFB35C8D, 0xFFDB96BC},   {Role::ForceObstacle, 0xFFB57A00, 0xFFE69F00},
    {Role::ForceGroup, 0xFF2389C4, 0xFF7CCBF5},    {Role::ForceTotal, 0xFF1B1F23, 0xFFFFFFFF},
    {Role::Lidar, 0xFF8F7A00, 0xFFF0E442},         {Role::Guide, 0xFFC2185B, 0xFFFF7EB0},
}};

constexpr bool isInOrder() {
  std::size_t place = 0;
  for (const RoleColors& entry : kRoles) {
    if (static_cast<std::size_t>(entry.role) != place++) {
      return false;
    }
  }
  return true;
}
static_assert(isInOrder(), "the colour of a role is found by its number");

constexpr std::array<QRgb, kLookCount> kFills = {0xFF0072B2, 0xFF7F7F7F, 0xFFE69F00, 0xFFCC79A7,
                                                 0xFF56B4E9, 0xFFD55E00, 0xFF009E73};
constexpr std::array<QRgb, kLookCount> kLightLines = {
    0xFF0072B2, 0xFF6B6B6B, 0xFFB57A00, 0xFFB35C8D, 0xFF2389C4, 0xFFC65600, 0xFF008A64};
constexpr std::array<QRgb, kLookCount> kDarkLines = {0xFF3C93D6, 0xFFA3A3A3, 0xFFE69F00, 0xFFDB96BC,
                                                     0xFF7CCBF5, 0xFFEE7A26, 0xFF1DB98B};

double linear(double channel) {
  return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color) {
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

std::size_t index(Look look) {
  return static_cast<std::size_t>(look);
}

}  // namespace

Look lookOf(sim2d::BehaviorType type) {
  const int number = static_cast<int>(type);  // Starts at 1, in the same order.
  return number >= 1 && number < kLookCount ? static_cast<Look>(number - 1) : Look::Regular;
}

Look lookOf(const sim2d::TraceHuman& recorded) {
  return recorded.customTree ? Look::CustomTree
                             : lookOf(static_cast<sim2d::BehaviorType>(recorded.behavior));
}

QString lookName(Look look) {
  static constexpr const char* kNames[] = {
      QT_TRANSLATE_NOOP("Behaviour", "Regular"),    QT_TRANSLATE_NOOP("Behaviour", "Impassive"),
      QT_TRANSLATE_NOOP("Behaviour", "Surprised"),  QT_TRANSLATE_NOOP("Behaviour", "Scared"),
      QT_TRANSLATE_NOOP("Behaviour", "Curious"),    QT_TRANSLATE_NOOP("Behaviour", "Threatening"),
      QT_TRANSLATE_NOOP("Behaviour", "Custom tree")};
  return QCoreApplication::translate("Behaviour", kNames[index(look)]);
}

Mark markOf(Look look) {
  static constexpr std::array<Mark, kLookCount> kMarks = {
      Mark::Disc, Mark::Square,     Mark::Diamond, Mark::TriangleDown,
      Mark::Ring, Mark::TriangleUp, Mark::Hexagon};
  return kMarks[index(look)];
}

Theme Theme::fromSystem(const QPalette& system) {
  return Theme(luminance(system.color(QPalette::Window)) < 0.2);
}

QColor Theme::color(Role role) const {
  const RoleColors& colors = kRoles[static_cast<std::size_t>(role)];
  return isDark_ ? colors.dark : colors.light;
}

QColor Theme::fill(Look look) const {
  return kFills[index(look)];
}

QColor Theme::line(Look look) const {
  return (isDark_ ? kDarkLines : kLightLines)[index(look)];
}

QColor Theme::outline(Look look) const {
  return isDark() ? mixed(fill(look), QColor(Qt::white), 0.55)
                  : mixed(fill(look), QColor(Qt::black), 0.5);
}

QPalette Theme::palette() const {
  static constexpr std::pair<QPalette::ColorRole, Role> kColors[] = {
      {QPalette::Window, Role::Window},
      {QPalette::WindowText, Role::Text},
      {QPalette::Base, Role::Field},
      {QPalette::AlternateBase, Role::RowHover},
      {QPalette::Text, Role::Text},
      {QPalette::Button, Role::Window},
      {QPalette::ButtonText, Role::Text},
      {QPalette::BrightText, Role::Error},
      {QPalette::ToolTipBase, Role::Panel},
      {QPalette::ToolTipText, Role::Text},
      {QPalette::PlaceholderText, Role::TextSecondary},
      {QPalette::Highlight, Role::RowSelected},
      {QPalette::HighlightedText, Role::Text},
      {QPalette::Link, Role::AccentText},
      {QPalette::Light, Role::Panel},
      {QPalette::Midlight, Role::RowHover},
      {QPalette::Mid, Role::FieldEdge},
      {QPalette::Dark, Role::Line},
      {QPalette::Shadow, Role::Line}};
  QPalette result;
  for (const auto& [target, role] : kColors) {
    result.setColor(target, color(role));
  }
  for (const QPalette::ColorRole role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::HighlightedText}) {
    result.setColor(QPalette::Disabled, role, mixed(color(Role::Text), color(Role::Window), 0.55));
  }
  return result;
}

QPalette Theme::textPalette() const {
  constexpr double kLight = 0.3;
  constexpr double kDark = 0.45;
  QPalette result = palette();
  result.setColor(QPalette::Highlight,
                  mixed(color(Role::Field), color(Role::Accent), isDark_ ? kDark : kLight));
  return result;
}

QFont Theme::font(double points, QFont::Weight weight) const {
  QFont result = QGuiApplication::font();  // The cached system font; querying the system is slow.
  result.setPointSizeF(points);
  result.setWeight(weight);
  return result;
}

QFont Theme::figureFont(double points) const {
  // The digits of common system fonts already have equal widths; other fonts are left unchanged.
  QFont result = font(points);
  result.setStyleStrategy(QFont::PreferQuality);
  return result;
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [share](double from, double to) { return from + share * (to - from); };
  return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()),
                          part(a.blueF(), b.blueF()), part(a.alphaF(), b.alphaF()));
}

double contrastRatio(const QColor& a, const QColor& b) {
  const double first = luminance(a);
  const double second = luminance(b);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

}  // namespace editor
