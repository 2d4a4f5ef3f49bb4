#include "app/report/Figure.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

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
};
constexpr const char* kOptionShades[kOptionColors] = {"#0072B2", "#C65600", "#008A64", "#B35C8D",
                                                      "#B57A00", "#2389C4", "#6B6B6B"};

std::string classOf(const std::string& role) {
  return " class=\"" + role + "\"";
}

std::string opacityOf(double opacity) {
  return opacity < 1.0 ? " opacity=\"" + plainNumber(opacity, 2) + "\"" : std::string();
}

/// ` name="value"` for each of the names.
std::string pixels(std::initializer_list<std::pair<const char*, double>> values) {
  std::string attributes;
  for (const auto& [name, value] : values) {
    attributes += std::string(" ") + name + "=\"" + pixel(value) + "\"";
  }
  return attributes;
}

using Corners = std::vector<base::Vec2>;

/// The corners of the mark of an option, in units of its size; none: a disc.
const Corners& markCorners(std::size_t option) {
  static const Corners kMarks[kOptionColors] = {
      {},
      {{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}},
      {{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}},
      {{0, -1.2}, {1.1, .8}, {-1.1, .8}},
      {{0, 1.2}, {1.1, -.8}, {-1.1, -.8}},
      {{-.5, -1}, {.5, -1}, {1.1, 0}, {.5, 1}, {-.5, 1}, {-1.1, 0}},
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
       {-.4, -.4}}};
  return kMarks[option % kOptionColors];
}

/// The data of a path through the points.
std::string pathThrough(const std::vector<base::Vec2>& points) {
  std::string path;
  for (const base::Vec2& point : points) {
    path += (path.empty() ? "M" : "L") + pixel(point.x()) + " " + pixel(point.y());
  }
  return path;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
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
  content_ += "<text" + pixels({{"x", x}, {"y", y}, {"font-size", size}}) +
              anchors[static_cast<int>(anchor)] + classOf(role) + ">" + escaped(words) +
              "</text>\n";
}

void Figure::line(double x1, double y1, double x2, double y2, const std::string& role,
                  double width) {
  content_ += "<line" +
              pixels({{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}, {"stroke-width", width}}) +
              classOf(role) + "/>\n";
}

void Figure::rect(double x, double y, double width, double height, const std::string& role,
                  double opacity) {
  content_ += "<rect" + pixels({{"x", x}, {"y", y}, {"width", width}, {"height", height}}) +
              opacityOf(opacity) + classOf(role) + "/>\n";
}

void Figure::disc(double x, double y, double radius, const std::string& role, double opacity) {
  content_ += "<circle" + pixels({{"cx", x}, {"cy", y}, {"r", radius}}) + opacityOf(opacity) +
              classOf(role) + "/>\n";
}

void Figure::path(const std::string& path, const std::string& role, double width, double opacity) {
  content_ += "<path d=\"" + path + "\"" + pixels({{"stroke-width", width}}) + opacityOf(opacity) +
              classOf(role) + "/>\n";
}

void Figure::polyline(const std::vector<base::Vec2>& points, const std::string& role, double width,
                      double opacity) {
  if (points.size() > 1) {
    path(pathThrough(points), role, width, opacity);
  }
}

void Figure::mark(double x, double y, std::size_t option, double size) {
  Corners corners = markCorners(option);
  if (corners.empty()) {
    disc(x, y, size, fillOf(option));
    return;
  }
  for (base::Vec2& corner : corners) {
    corner = base::Vec2(x + corner.x() * size, y + corner.y() * size);
  }
  path(pathThrough(corners) + "Z", fillOf(option), 0.0);
}

void Figure::define(const std::string& id, const std::string& path, const std::string& role) {
  definitions_ +=
      "<path id=\"" + name_ + "-" + escaped(id) + "\" d=\"" + path + "\"" + classOf(role) + "/>\n";
}

void Figure::use(const std::string& id, double x, double y) {
  content_ += "<use xlink:href=\"#" + name_ + "-" + escaped(id) + "\"" +
              pixels({{"x", x}, {"y", y}}) + "/>\n";
}

void Figure::beginClip(double x, double y, double width, double height) {
  const std::string id = name_ + "-clip" + std::to_string(clips_++);
  definitions_ += "<clipPath id=\"" + id + "\"><rect" +
                  pixels({{"x", x}, {"y", y}, {"width", width}, {"height", height}}) +
                  "/></clipPath>\n";
  content_ += "<g clip-path=\"url(#" + id + ")\">\n";
}

std::string Figure::whole(const std::string& attributes) const {
  const std::string size = pixel(width_) + " " + pixel(height_);
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 " +
      size + "\"" + pixels({{"width", width_}, {"height", height_}}) + attributes + ">\n";
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
    replaceAll(text, classOf(role.role), std::string(" ") + role.attributes);
  }
  for (std::size_t option = 0; option < kOptionColors; ++option) {
    const std::string shade = std::string("=\"") + kOptionShades[option] + "\"";
    replaceAll(text, classOf(strokeOf(option)), " stroke" + shade + " fill=\"none\"");
    replaceAll(text, classOf(fillOf(option)), " fill" + shade);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + text;
}

double tickStep(double length, int most) {
  const double least = length / std::max(1, most);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double nice : {1.0, 2.0, 5.0}) {
    if (nice * power >= least * 0.999) {
      return nice * power;
    }
  }
  return 10.0 * power;
}

std::vector<double> ticks(double low, double high, int count) {
  const double step = tickStep(high - low, count);
  std::vector<double> found;
  const int most = std::max(12, count + 1);
  const double first = std::ceil(low / step - 1e-9);
  for (int k = 0; k < most; ++k) {
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

namespace {

std::vector<double> powersOfTen(double low, double high) {
  std::vector<double> powers;
  double power = std::pow(10.0, std::ceil(std::log10(low) - 1e-9));
  while (power <= high * (1.0 + 1e-9)) {
    powers.push_back(power);
    power *= 10.0;
  }
  return powers;
}

}  // namespace

std::vector<double> axisTicks(const Scale& scale) {
  if (scale.isLogarithmic) {
    return powersOfTen(scale.low, scale.high);
  }
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

std::vector<std::string> tickTexts(const Scale& scale, const std::vector<double>& at) {
  std::vector<std::string> texts;
  texts.reserve(at.size());
  for (const double tick : at) {
    const double step = scale.isLogarithmic ? tick : at.size() > 1 ? at[1] - at[0] : 1.0;
    const double decimals = std::ceil(-std::log10(step) - 1e-9);
    texts.push_back(numberText(tick, std::clamp(static_cast<int>(decimals), 0, 6)));
  }
  return texts;
}

void horizontalAxis(Figure& figure, const Scale& scale, double y, bool asPercent) {
  figure.line(scale.from, y, scale.to, y, "axis");
  const std::vector<double> at = axisTicks(scale);
  const std::vector<std::string> texts = tickTexts(scale, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double x = scale.at(at[k]);
    figure.line(x, y, x, y + 4.0, "axis");
    figure.text(x, y + 15.0, asPercent ? percentText(at[k]) : texts[k], "dim",
                Figure::Anchor::Middle, 10.0);
  }
}

void verticalAxis(Figure& figure, const Scale& scale, const std::vector<double>& at, double left,
                  double right) {
  const std::vector<std::string> texts = tickTexts(scale, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double y = scale.at(at[k]);
    figure.line(left, y, right, y, "grid");
    figure.text(left - 8.0, y + 4.0, texts[k], "dim", Figure::Anchor::End, 10.0);
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
