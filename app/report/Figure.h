#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Types.h"

namespace report {

constexpr int kOptionColors = 7;  // Okabe & Ito; each has its own mark shape

/// An SVG drawing in pixels, origin at the upper left. Colours are given as roles, which the page's
/// style sheet defines for light and dark mode and a standalone file replaces by fixed colours.
class Figure {
 public:
  Figure(std::string name, double width, double height)
      : name_(std::move(name)), width_(width), height_(height) {}

  const std::string& name() const { return name_; }
  std::string caption;  // plain text

  enum class Anchor { Start, Middle, End };
  void text(double x, double y, const std::string& words, const char* role = "ink",
            Anchor anchor = Anchor::Start, double size = 11.0);
  void line(double x1, double y1, double x2, double y2, const std::string& role,
            double width = 1.0);
  void rect(double x, double y, double width, double height, const std::string& role,
            double opacity = 1.0);
  void disc(double x, double y, double radius, const std::string& role, double opacity = 1.0);
  /// `path`: SVG path data.
  void path(const std::string& path, const std::string& role, double width = 1.0,
            double opacity = 1.0);
  /// A polyline through the points.
  void polyline(const std::vector<base::Vec2>& points, const std::string& role, double width,
                double opacity = 1.0);
  /// The mark of an option, with its shape and colour.
  void mark(double x, double y, std::size_t option, double size = 4.5);
  /// Defines a path that use() can draw repeatedly.
  void define(const std::string& id, const std::string& path, const std::string& role);
  void use(const std::string& id, double x, double y);
  /// Clips everything until endClip() to this rectangle.
  void beginClip(double x, double y, double width, double height);
  void endClip() { content_ += "</g>\n"; }

  std::string markup() const;      // an <svg> element for the page
  std::string standalone() const;  // an SVG file with light colours

 private:
  std::string whole(const std::string& attributes) const;

  std::string name_;
  double width_, height_;
  std::string definitions_, content_;
  int clips_ = 0;
};

std::string strokeOf(std::size_t option);  // role of the option's lines
std::string fillOf(std::size_t option);    // role of the option's areas
std::string pixel(double value);           // at most one decimal

/// A scale from numbers to pixels.
struct Scale {
  double low = 0.0, high = 1.0;   // range of numbers; logarithmic: both above 0
  double from = 0.0, to = 100.0;  // range of pixels
  bool isLogarithmic = false;
  double at(double value) const {
    const double share =
        isLogarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + share * (to - from);
  }
};
/// The smallest 1, 2 or 5 times a power of ten of which at most `most` fit into `length`.
double tickStep(double length, int most);
/// About `count` round numbers within [low, high], at most 12.
std::vector<double> ticks(double low, double high, int count);
/// A scale for [low, high] with a margin; never empty.
Scale paddedScale(double low, double high, double from, double to);
/// The ticks of a horizontal axis: as many as fit, at least two. Of a logarithmic axis: the powers
/// of ten.
std::vector<double> axisTicks(const Scale& scale);
/// The numbers at ticks, with the decimals that their distance requires.
std::vector<std::string> tickTexts(const Scale& scale, const std::vector<double>& at);
/// Draws an axis with numbers below a panel.
void horizontalAxis(Figure& figure, const Scale& scale, double y, bool asPercent = false);
/// Draws a line across a panel at each tick, with its number on the left.
void verticalAxis(Figure& figure, const Scale& scale, const std::vector<double>& at, double left,
                  double right);

/// Shortens the text to at most `most` characters; an ellipsis marks the cut.
std::string shortened(const std::string& text, std::size_t most);
/// Splits the text into lines of at most `most` characters (at least 1): after a space or one of
/// "_-,/." in the last two thirds of a line, otherwise at the limit. Returns at least one line.
std::vector<std::string> wrapped(const std::string& text, std::size_t most);
std::size_t characterCount(const std::string& text);  // UTF-8 characters

constexpr double kLetter = 6.7;  // [px], character width at 11 px in the widest font

/// A grid of panels; forEach() calls `draw(index, left, top)` for each.
struct PanelGrid {
  std::size_t count = 0;
  int columns = 2;
  double panelHeight = 100.0;
  double width = 720.0, gap = 32.0;
  std::vector<double> rowHeights{};  // if rows differ; empty: panelHeight
  /// Sets the height of each row to its tallest panel.
  void fitRows(const std::vector<double>& panelHeights);
  std::size_t rows() const;
  double topOf(std::size_t row) const;
  double height() const { return topOf(rows()) - gap; }
  double panelWidth() const { return (width - gap * (columns - 1)) / columns; }
  void forEach(const std::function<void(std::size_t, double, double)>& draw) const;
};

}  // namespace report
