#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

namespace report {

constexpr int kOptionColors = 7;  // Okabe & Ito; with each its own mark

/// One drawing as SVG, in pixels from the upper left. Colours are names that the page's style sheet
/// knows in light and dark, and that become plain colours in a file.
class Figure {
 public:
  Figure(std::string name, double width, double height)
      : name_(std::move(name)), width_(width), height_(height) {}

  const std::string& name() const { return name_; }
  bool isEmpty() const { return content_.empty(); }
  std::string caption;  // plain text

  enum class Anchor { Start, Middle, End };
  void text(double x, double y, const std::string& words, const char* role = "ink",
            Anchor anchor = Anchor::Start, double size = 11.0);
  void line(double x1, double y1, double x2, double y2, const std::string& role,
            double width = 1.0);
  void rect(double x, double y, double width, double height, const std::string& role,
            double opacity = 1.0);
  void disc(double x, double y, double radius, const std::string& role, double opacity = 1.0);
  /// `path`: as SVG wants it.
  void path(const std::string& path, const std::string& role, double width = 1.0,
            double opacity = 1.0);
  /// Lines through points.
  void polyline(const std::vector<base::Vec2>& points, const std::string& role, double width,
                double opacity = 1.0);
  /// The mark of an option: its shape and colour.
  void mark(double x, double y, std::size_t option, double size = 4.5);
  /// Drawn once, shown wherever use() says.
  void define(const std::string& id, const std::string& path, const std::string& role);
  void use(const std::string& id, double x, double y);
  /// Everything until end() shows in this rectangle only.
  void beginClip(double x, double y, double width, double height);
  void endClip() { content_ += "</g>\n"; }

  std::string markup() const;      // an svg element for the page
  std::string standalone() const;  // an SVG file, light

 private:
  std::string whole(const std::string& attributes) const;

  std::string name_;
  double width_, height_;
  std::string definitions_, content_;
  int clips_ = 0;
};

std::string strokeOf(std::size_t option);  // role of its lines
std::string fillOf(std::size_t option);    // role of its areas
std::string pixel(double value);           // with one decimal at most

/// Numbers to pixels.
struct Scale {
  double low = 0.0, high = 1.0;   // of numbers
  double from = 0.0, to = 100.0;  // of pixels
  double at(double value) const { return from + (value - low) / (high - low) * (to - from); }
};
/// Round numbers within [low, high], about so many; never more than 12.
std::vector<double> ticks(double low, double high, int count);
/// [low, high] with some room, never empty.
Scale roomyScale(double low, double high, double from, double to);
/// Ticks of a horizontal axis, as many as there is room for, and two at least.
std::vector<double> axisTicks(const Scale& scale);
/// A thin axis below a panel with its numbers.
void horizontalAxis(Figure& figure, const Scale& scale, double y, bool asPercent = false);

/// At most so many characters; what is left out is shown as "…".
std::string shortened(const std::string& text, std::size_t most);
/// In lines of at most so many characters, 1 at least: broken after a blank or one of "_-,/." where
/// there is one in the last two thirds of a line, else where the line is full. One line at least.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
std::size_t characterCount(const std::string& text);  // of UTF-8

constexpr double kLetter = 6.7;  // px of a character of 11 px, of the widest font that there may be

/// Panels side by side: `draw(index, left, top)` for each.
struct PanelGrid {
  std::size_t count = 0;
  int columns = 2;
  double panelHeight = 100.0;
  double width = 720.0, gap = 32.0;
  std::vector<double> rowHeights{};  // where rows differ; empty: panelHeight
  /// Each row as tall as the tallest of its panels.
  void fitRows(const std::vector<double>& panelHeights);
  std::size_t rows() const;
  double topOf(std::size_t row) const;
  double height() const { return topOf(rows()) - gap; }
  double panelWidth() const { return (width - gap * (columns - 1)) / columns; }
  void forEach(const std::function<void(std::size_t, double, double)>& draw) const;
};

}  // namespace report
