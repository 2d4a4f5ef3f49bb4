#include "editor/panels/ListText.h"

#include <algorithm>

#include <QStringList>

#include "sim2d/base/Text.h"

namespace editor {

QString listText(const std::vector<double>& values) {
  QStringList words;
  for (const double value : values) {
    words.push_back(QString::fromStdString(base::formatDouble(value)));
  }
  return words.join(QStringLiteral(", "));
}

std::optional<std::vector<double>> listFromText(const QString& text) {
  std::vector<double> values;
  for (const QString& word : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const std::optional<double> value = base::parseDouble(word.trimmed().toStdString());
    if (!value) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

QString pairsText(const std::vector<std::pair<std::string, std::string>>& pairs) {
  QStringList words;
  for (const auto& [name, value] : pairs) {
    words << QString::fromStdString(name + "=" + value);
  }
  return words.join(QStringLiteral(", "));
}

std::optional<std::vector<std::pair<std::string, std::string>>> pairsFromText(const QString& text) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    const int sign = part.indexOf(QLatin1Char('='));
    const QString name = part.left(std::max(sign, 0)).trimmed();
    const QString value = part.mid(sign + 1).trimmed();
    if (sign < 0 || name.isEmpty() || value.isEmpty()) {
      return std::nullopt;
    }
    pairs.emplace_back(name.toStdString(), value.toStdString());
  }
  return pairs;
}

QString pointsText(const std::vector<Vec2>& points) {
  QStringList words;
  for (const Vec2& point : points) {
    words << QString::fromStdString(base::formatDouble(point.x()) + " " +
                                    base::formatDouble(point.y()));
  }
  return words.join(QStringLiteral("; "));
}

std::optional<std::vector<Vec2>> pointsFromText(const QString& text) {
  std::vector<Vec2> points;
  for (const QString& part : text.split(QLatin1Char(';'), Qt::SkipEmptyParts)) {
    const QStringList words = part.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (words.size() != 2) {
      return std::nullopt;
    }
    const std::optional<double> x = base::parseDouble(words[0].toStdString());
    const std::optional<double> y = base::parseDouble(words[1].toStdString());
    if (!x || !y) {
      return std::nullopt;
    }
    points.emplace_back(*x, *y);
  }
  return points;
}

}  // namespace editor
