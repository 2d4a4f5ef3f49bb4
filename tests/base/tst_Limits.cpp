#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "tests/support/Columns.h"

namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Without the blanks and quotes that group digits.
std::string digitsOf(std::string text) {
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\''; }),
             text.end());
  return text;
}

/// Of `100 000`, `10 m`, `8 GB`.
std::optional<double> figureOf(const std::string& cell) {
  std::smatch found;
  if (!std::regex_match(cell, found, std::regex("([0-9][0-9 ]*?) ?(|m|MB|GB)"))) {
    return std::nullopt;
  }
  const double factor = found[2] == "MB" ? 0x1p20 : (found[2] == "GB" ? 0x1p30 : 1.0);
  return factor * std::stod(digitsOf(found[1]));
}

/// What stands behind `NAME =`: a number, or one that is shifted.
std::optional<double> constantOf(const std::string& file, const std::string& name) {
  const std::string text = contentOf(SOURCE_DIR "/" + file);
  std::smatch found;
  if (!std::regex_search(text, found, std::regex("\\b" + name + " = ([^;,]+)[;,]"))) {
    return std::nullopt;
  }
  const std::string value = digitsOf(found[1]);
  if (std::regex_match(value, found, std::regex("std::size_t\\{(\\d+)\\}<<(\\d+)U"))) {
    return std::ldexp(std::stod(found[1]), std::stoi(found[2]));
  }
  if (value == "5*kMaxPeople/2") {
    return 2.5 * static_cast<double>(base::kMaxPeople);
  }
  return base::parseDouble(value);
}

/// The cells of a row of a table, without the blanks around them.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells = base::split(line, '|');
  std::transform(cells.begin(), cells.end(), cells.begin(),
                 [](const std::string& cell) { return base::trimmed(cell); });
  return cells;
}

std::string allOf(const base::Diagnostics& problems) {
  std::string text;
  for (const base::Diagnostic& problem : problems) {
    text += problem.message + "\n";
  }
  return text;
}

/// What is told of a text of YAML.
std::string problemsOf(const std::string& yaml) {
  base::Diagnostics problems;
  base::parseYaml(yaml, "f.yaml", problems);
  return allOf(problems);
}

}  // namespace

/// LIMITS.md and the code say the same.
class LimitsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void page_figures_areThoseOfTheCode_data() {
    addColumns<QString, QString, QString>({"figure", "name", "file"});
    std::istringstream page(contentOf(SOURCE_DIR "/sim2d/scenario/LIMITS.md"));
    int rows = 0;
    for (std::string line; std::getline(page, line);) {
      const std::vector<std::string> cells = cellsOf(line);
      std::smatch place;
      if (cells.size() > 3 && std::regex_match(cells[3], place, std::regex("`(k\\w+)`, (\\S+)"))) {
        QTest::addRow("%d %s", ++rows, cells[1].c_str())
            << QString::fromStdString(cells[2]) << QString::fromStdString(place[1])
            << QString::fromStdString(place[2]);
      }
    }
    QVERIFY2(rows >= 36, "rows of the table are no longer found");
  }

  void page_figures_areThoseOfTheCode() {
    QFETCH(const QString, figure);
    QFETCH(const QString, name);
    QFETCH(const QString, file);
    const std::optional<double> onPage = figureOf(figure.toStdString());
    const std::optional<double> inCode = constantOf(file.toStdString(), name.toStdString());
    QVERIFY2(onPage, qPrintable(figure));
    QVERIFY2(inCode, qPrintable(file + QStringLiteral(" has no ") + name));
    QCOMPARE(*onPage, *inCode);
  }

  void people_oneMore_isRefused() {
    std::string list = "agents:\n";
    for (int i = 0; i < 100000; ++i) {
      list += "  - p\n";
    }
    QCOMPARE(problemsOf(list), std::string());
    const std::string told = problemsOf(list + "  - p\n");
    QVERIFY2(told.find("more than 100000 people") != std::string::npos, told.c_str());
  }

  void keys_oneMore_isRefused() {
    std::string map;
    for (int i = 0; i < 250000; ++i) {
      map += "k" + std::to_string(i) + ": 1\n";
    }
    QCOMPARE(problemsOf(map), std::string());
    const std::string told = problemsOf(map + "more: 1\n");
    QVERIFY2(told.find("more than 250000 keys") != std::string::npos, told.c_str());
  }
};

QTEST_APPLESS_MAIN(LimitsTest)
#include "tst_Limits.moc"
