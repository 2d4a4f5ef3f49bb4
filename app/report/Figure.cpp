#include "app/report/Figure.h"

#include <algorithm>
#include <cmath>

#include "app/report/Markup.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

struct RoleColors {
  const char* role;
  const char* attributes;  // in a standalone file
};
constexpr RoleColors kRoles[] = {
    {"ink", "fill=\"#1B1F23\""},
    {"dim", "fill=\"#5F6B76\""},
    {"axis", "stroke=\"#8A949E\" fill=\"none\""},
    {"grid", "stroke=\"#E3E7EA\" fill=\"none\""},
    {"zero", "stroke=\"#5F6B76\" stroke-dasharray=\"3 3\" fill=\"none\""},
    {"line", "stroke=\"#1B1F23\" fill=\"none\""},
    {"accent", "stroke=\"#2F6FDE\" fill=\"none\""},
    {"heat", "fill=\"#2F6FDE\""},
    {"hot", "fill=\"#C65600\""},
    {"ground", "fill=\"#FFFFFF\" stroke=\"#D8DCE0\""},
    {"wall", "fill=\"#2B2F33\" fill-rule=\"evenodd\""},
    {"solid", "fill=\"#D3D8DC\" stroke=\"#838E98\" stroke-width=\"0.6\" fill-rule=\"evenodd\""},
    {"s0", "stroke=\"#0072B2\" fill=\"none\""},
    {"s1", "stroke=\"#C65600\" fill=\"none\""},
    {"s2", "stroke=\"#008A64\" fill=\"none\""},
    {"s3", "stroke=\"#B35C8D\" fill=\"none\""},
    {"s4", "stroke=\"#B57A00\" fill=\"none\""},
    {"s5", "stroke=\"#2389C4\" fill=\"none\""},
    {"s6", "stroke=\"#6B6B6B\" fill=\"none\""},
    {"f0", "fill=\"#0072B2\""},
    {"f1", "fill=\"#C65600\""},
    {"f2", "fill=\"#008A64\""},
    {"f3", "fill=\"#B35C8D\""},
    {"f4", "fill=\"#B57A00\""},
    {"f5", "fill=\"#2389C4\""},
    {"f6", "fill=\"#6B6B6B\""},
};

std::string classOf(const std::string& role) {
  return " class=\"" + role + "\"";
}

std::string opacityOf(double opacity) {
  return opacity < 1.0 ? " opacity=\"" + plainNumber(opacity, 2) + "\"" : std::string();
}

std::string polygonPath(double x, double y, const std::vector<base::Vec2>& corners, double size) {
  std::string path;
  for (const base::Vec2& corner : corners) {
    path += (path.empty() ? "M" : "L") + pixel(x + corner.x() * size) + " " +
            pixel(y + corner.y() * size);
  }
  return path + "Z";
}

}  // namespace

std::string strokeOf(std::size_t option) {
  return "s" + std::to_string(option % kOptionColors);
}

std::string fillOf(std::size_t option) {
  return "f" + std::to_string(option % kOptionColors);
}

std::string pixel(double value) {
  std::string text = plainNumber(value, 1);
  if (text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0) {
    text.resize(text.size() - 2);
  }
  return text == "-0" ? "0" : text;
}

void Figure::text(double x, double y, const std::string& words, const char* role, Anchor anchor,
                  double size) {
  const char* anchors[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
  content_ += "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" font-size=\"" + pixel(size) +
              "\"" + anchors[static_cast<int>(anchor)] + classOf(role) + ">" + escaped(words) +
              "</text>\n";
}

void Figure::line(double x1, double y1, double x2, double y2, const std::string& role,
                  double width) {
  content_ += "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) +
              "\" y2=\"" + pixel(y2) + "\" stroke-width=\"" + pixel(width) + "\"" + classOf(role) +
              "/>\n";
}

void Figure::rect(double x, double y, double width, double height, const std::string& role,
                  double opacity) {
  content_ += "<rect x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" width=\"" + pixel(width) +
              "\" height=\"" + pixel(height) + "\"" + opacityOf(opacity) + classOf(role) + "/>\n";
}

void Figure::disc(double x, double y, double radius, const std::string& role, double opacity) {
  content_ += "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"" + pixel(radius) +
              "\"" + opacityOf(opacity) + classOf(role) + "/>\n";
}

void Figure::path(const std::string& path, const std::string& role, double width, double opacity) {
  content_ += "<path d=\"" + path + "\" stroke-width=\"" + pixel(width) + "\"" +
              opacityOf(opacity) + classOf(role) + "/>\n";
}

void Figure::polyline(const std::vector<base::Vec2>& points, const std::string& role, double width,
                      double opacity) {
  std::string lines;
  for (const base::Vec2& point : points) {
    lines += (lines.empty() ? "M" : "L") + pixel(point.x()) + " " + pixel(point.y());
  }
  if (points.size() > 1) {
    path(lines, role, width, opacity);
  }
}

void Figure::mark(double x, double y, std::size_t option, double size) {
  const std::string role = fillOf(option);
  switch (option % kOptionColors) {
    case 0:
      disc(x, y, size, role);
      break;
    case 1:
      path(polygonPath(x, y, {{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}}, size), role, 0.0);
      break;
    case 2:
      path(polygonPath(x, y, {{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}}, size), role, 0.0);
      break;
    case 3:
      path(polygonPath(x, y, {{0, -1.2}, {1.1, .8}, {-1.1, .8}}, size), role, 0.0);
      break;
    case 4:
      path(polygonPath(x, y, {{0, 1.2}, {1.1, -.8}, {-1.1, -.8}}, size), role, 0.0);
      break;
    case 5:
      path(polygonPath(x, y, {{-.5, -1}, {.5, -1}, {1.1, 0}, {.5, 1}, {-.5, 1}, {-1.1, 0}}, size),
           role, 0.0);
      break;
    default:
      path(polygonPath(x, y,
                       {{-.4, -1.2},
                        {.4, -1.2},
                        {.4, -.4},
                        {1.2, -.4},
                        {1.2, .4},
                        {.4, .4},
                        {.4, 1.2},
                        {-.4, 1.2},
                        {-.4, .4},
                        {-1.2, .4},
                        {-1.2, -.4},
                        {-.4, -.4}},
                       size),
           role, 0.0);
  }
}

void Figure::define(const std::string& id, const std::string& path, const std::string& role) {
  definitions_ +=
      "<path id=\"" + name_ + "-" + escaped(id) + "\" d=\"" + path + "\"" + classOf(role) + "/>\n";
}

void Figure::use(const std::string& id, double x, double y) {
  content_ += "<use xlink:href=\"#" + name_ + "-" + escaped(id) + "\" x=\"" + pixel(x) + "\" y=\"" +
              pixel(y) + "\"/>\n";
}

void Figure::beginClip(double x, double y, double width, double height) {
  const std::string id = name_ + "-clip" + std::to_string(clips_++);
  definitions_ += "<clipPath id=\"" + id + "\"><rect x=\"" + pixel(x) + "\" y=\"" + pixel(y) +
                  "\" width=\"" + pixel(width) + "\" height=\"" + pixel(height) +
                  "\"/></clipPath>\n";
  content_ += "<g clip-path=\"url(#" + id + ")\">\n";
}

std::string Figure::whole(const std::string& attributes) const {
  const std::string size = pixel(width_) + " " + pixel(height_);
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 " +
      size + "\" width=\"" + pixel(width_) + "\" height=\"" + pixel(height_) + "\"" + attributes +
      ">\n";
  if (!definitions_.empty()) {
    text += "<defs>\n" + definitions_ + "</defs>\n";
  }
  return text + content_ + "</svg>\n";
}

std::string Figure::markup() const {
  return whole(" role=\"img\" aria-label=\"" + escaped(caption) + "\"");
}

std::string Figure::standalone() const {
  std::string text = whole(" font-family=\"'DejaVu Sans', Helvetica, Arial, sans-serif\"");
  for (const RoleColors& role : kRoles) {
    const std::string from = classOf(role.role);
    const std::string to = std::string(" ") + role.attributes;
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
      text.replace(at, from.size(), to);
    }
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text;
}

std::vector<double> ticks(double low, double high, int count) {
  const double rough = (high - low) / std::max(1, count);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double nice : {5.0, 2.0, 1.0}) {
    step = nice * power >= rough * 0.999 ? nice * power : step;
  }
  std::vector<double> found;
  constexpr int kMostTicks = 12;
  const double first = std::ceil(low / step - 1e-9);
  for (int k = 0; k < kMostTicks; ++k) {
    const double tick = (first + k) * step;
    if (tick > high + 1e-9 * step) {
      break;
    }
    found.push_back(tick == 0.0 ? 0.0 : tick);  // avoids -0
  }
  return found;
}

Scale paddedScale(double low, double high, double from, double to) {
  constexpr double kWidest = 1e300;
  if (!(low <= high) || high - low > kWidest) {
    return {0.0, 1.0, from, to};
  }
  const double size = std::max(std::abs(low), std::abs(high));
  double room = 0.05 * (high - low);
  room = room > 1e-9 * size ? room : size > 1e-12 ? 0.1 * size : 1.0;
  return {low - room, high + room, from, to};
}

std::vector<double> axisTicks(const Scale& scale) {
  constexpr double kRoom = 60.0;  // [px], space for a number
  const int most = std::max(2, static_cast<int>((scale.to - scale.from) / kRoom));
  std::vector<double> at = ticks(scale.low, scale.high, most);
  for (int count = 2 * most; at.size() < 2 && count <= 4 * most; count *= 2) {
    at = ticks(scale.low, scale.high, count);  // a single tick defines no scale
  }
  if (at.size() > static_cast<std::size_t>(most) + 1) {  // every second tick
    for (std::size_t k = 0; 2 * k < at.size(); ++k) {
      at[k] = at[2 * k];
    }
    at.resize((at.size() + 1) / 2);
  }
  return at;
}

void horizontalAxis(Figure& figure, const Scale& scale, double y, bool asPercent) {
  figure.line(scale.from, y, scale.to, y, "axis");
  const std::vector<double> at = axisTicks(scale);
  const double step = at.size() > 1 ? at[1] - at[0] : 1.0;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  for (const double tick : at) {
    const double x = scale.at(tick);
    figure.line(x, y, x, y + 4.0, "axis");
    figure.text(x, y + 15.0,
                asPercent ? numberText(100.0 * tick, 0) + " %" : numberText(tick, decimals), "dim",
                Figure::Anchor::Middle, 10.0);
  }
}

namespace {

/// Whether this is the first byte of a UTF-8 character.
bool isCharacterStart(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

}  // namespace

std::string shortened(const std::string& text, std::size_t most) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (isCharacterStart(text[at]) && ++characters > most) {
      std::size_t cut = at;  // one more character is removed for the ellipsis
      do {
        --cut;
      } while (cut > 0 && !isCharacterStart(text[cut]));
      return text.substr(0, cut) + "…";
    }
  }
  return text;
}

std::size_t characterCount(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isCharacterStart));
}

std::vector<std::string> wrapped(const std::string& text, std::size_t most) {
  const std::string breaks = " _-,/.";
  std::vector<std::string> lines(1);
  std::size_t characters = 0;  // in the current line
  std::size_t goodEnd = 0;     // in bytes: after the last break position
  for (const char c : text) {
    if (isCharacterStart(c) && characters == most) {
      std::string& full = lines.back();
      const std::size_t end = 3 * goodEnd >= full.size() && goodEnd > 0 ? goodEnd : full.size();
      std::string rest = full.substr(end);
      full.resize(end);
      characters = characterCount(rest);
      lines.push_back(std::move(rest));
      goodEnd = 0;
    }
    lines.back() += c;
    characters += isCharacterStart(c) ? 1 : 0;
    goodEnd = breaks.find(c) != std::string::npos ? lines.back().size() : goodEnd;
  }
  return lines;
}

std::size_t PanelGrid::rows() const {
  const auto inRow = static_cast<std::size_t>(columns);
  return (count + inRow - 1) / inRow;
}

double PanelGrid::topOf(std::size_t row) const {
  double top = 0.0;
  for (std::size_t k = 0; k < row; ++k) {
    top += (k < rowHeights.size() ? rowHeights[k] : panelHeight) + gap;
  }
  return top;
}

void PanelGrid::fitRows(const std::vector<double>& panelHeights) {
  rowHeights.assign(rows(), 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    double& height = rowHeights[k / static_cast<std::size_t>(columns)];
    height = std::max(height, panelHeights[k]);
  }
}

void PanelGrid::forEach(const std::function<void(std::size_t, double, double)>& draw) const {
  const auto inRow = static_cast<std::size_t>(columns);
  for (std::size_t k = 0; k < count; ++k) {
    draw(k, static_cast<double>(k % inRow) * (panelWidth() + gap), topOf(k / inRow));
  }
}

}  // namespace report
