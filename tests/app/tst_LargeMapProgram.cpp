#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <fstream>
#include <spawn.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <vector>

#include <QTemporaryDir>
#include <QtTest>

#include "tests/support/Sanitizers.h"

extern char** environ;

namespace {

constexpr int kSmall = 400;            // cells along the side of a map
constexpr double kMostPerCell = 10.0;  // [B]

int largeSide() {
  return qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 10000 : 3600;
}

/// Of a hall with two walls, each with a way round it, and some ground that nobody knows; from the
/// upper left, one byte per pixel.
std::vector<char> pixelRow(int row, int side) {
  constexpr char kWall = 0, kUnknown = static_cast<char>(205), kFree = static_cast<char>(254);
  std::vector<char> pixels(static_cast<std::size_t>(side), kFree);
  const bool isEdge = row < 4 || row >= side - 4;
  for (int column = 0; column < side; ++column) {
    const bool isLow = row / 4 == side / 12 && column < side * 3 / 4;
    const bool isHigh = row / 4 == side / 6 && column > side / 4;
    if (isEdge || column < 4 || column >= side - 4 || isLow || isHigh) {
      pixels[static_cast<std::size_t>(column)] = kWall;
    } else if (row > side * 9 / 10 && column > side * 9 / 10) {
      pixels[static_cast<std::size_t>(column)] = kUnknown;
    }
  }
  return pixels;
}

void put(std::ofstream& file, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) {
    file.put(static_cast<char>((value >> static_cast<unsigned>(8 * i)) & 0xFFU));
  }
}

void writePgm(const std::string& path, int side) {
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << side << " " << side << "\n255\n";
  for (int row = 0; row < side; ++row) {
    const std::vector<char> pixels = pixelRow(row, side);
    file.write(pixels.data(), side);
  }
}

/// In colours, 24 bit; the side is a multiple of four. Row by row: what this test takes itself
/// counts as the memory of what it starts.
void writeBmp(const std::string& path, int side) {
  constexpr std::uint32_t kHead = 54;
  const auto size = static_cast<std::uint32_t>(side);
  std::ofstream file(path, std::ios::binary);
  file << "BM";
  for (const std::uint32_t value : {kHead + 3 * size * size, 0U, kHead, 40U, size, size}) {
    put(file, value, 4);
  }
  put(file, 1, 2);
  put(file, 24, 2);
  for (const std::uint32_t value : {0U, 3 * size * size, 2835U, 2835U, 0U, 0U}) {
    put(file, value, 4);
  }
  for (int row = side - 1; row >= 0; --row) {
    for (const char pixel : pixelRow(row, side)) {
      file.put(pixel).put(pixel).put(pixel);
    }
  }
}

/// Two people and a robot; the robot has to go round both walls.
std::string scenarioText(double metres) {
  std::string text =
      "hunav_loader:\n  ros__parameters:\n    map: hall\n    global_goals:\n"
      "      1:\n        x: " +
      std::to_string(0.9 * metres) + "\n        y: " + std::to_string(0.5 * metres) +
      "\n    agents:\n      - anna\n      - ben\n";
  int id = 0;
  for (const char* const name : {"anna", "ben"}) {
    ++id;
    text += std::string("    ") + name + ":\n      id: " + std::to_string(id) +
            "\n      init_pose:\n        x: " + std::to_string(0.4 * metres + id) +
            "\n        y: " + std::to_string(0.5 * metres) + "\n      goals:\n        - 1\n";
  }
  return text +
         "hunavsim_desktop:\n  ros__parameters:\n    format: 1\n    duration: 1.0\n    robots:\n"
         "      - robot1\n    robot1:\n      start:\n        x: " +
         std::to_string(0.1 * metres) + "\n        y: " + std::to_string(0.1 * metres) +
         "\n        h: 0.0\n      goal:\n        x: " + std::to_string(0.1 * metres) +
         "\n        y: " + std::to_string(0.9 * metres) + "\n";
}

struct Ended {
  int exitCode = -1;
  double bytes = 0.0;  // the most that it took
};

Ended runToEnd(const std::vector<std::string>& words) {
  std::vector<std::string> all{HUNAVSIM_PROGRAM};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& word : all) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  ::pid_t child = 0;
  const int error =
      ::posix_spawn(&child, HUNAVSIM_PROGRAM, &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    return {};
  }
  int status = 0;
  rusage used{};
  while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          1024.0 * static_cast<double>(used.ru_maxrss)};
}

}  // namespace

/// What commands take at the most with a large map, above what they take with a small one; with
/// HUNAV_ALL_TESTS a map of the most cells that are read.
class LargeMapProgramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void command_largeMap_takesTenBytesPerCell_data();
  void command_largeMap_takesTenBytesPerCell();

 private:
  std::string at(const char* map, const char* name) const {
    return folder_.filePath(QString::fromUtf8(map) + QLatin1Char('/') + QString::fromUtf8(name))
        .toStdString();
  }
  std::vector<std::string> wordsFor(const char* map, const QStringList& words) const;

  const QTemporaryDir folder_;
};

void LargeMapProgramTest::initTestCase() {
  if (kIsSanitized) {
    QSKIP("sanitizers take memory of their own");
  }
  for (const char* const map : {"small", "large"}) {
    const int side = qstrcmp(map, "small") == 0 ? kSmall : largeSide();
    QVERIFY(QDir(folder_.path()).mkdir(QString::fromUtf8(map)));
    writePgm(at(map, "hall.pgm"), side);
    writeBmp(at(map, "colours.bmp"), side);
    for (const char* const image : {"hall.pgm", "colours.bmp"}) {
      const std::string yaml = qstrcmp(image, "hall.pgm") == 0 ? "hall.yaml" : "colours.yaml";
      std::ofstream(at(map, yaml.c_str()))
          << "image: " << image << "\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\n"
          << "occupied_thresh: 0.65\nfree_thresh: 0.196\n";
    }
    std::ofstream(at(map, "hall_agents.yaml")) << scenarioText(0.05 * side);
  }
}

void LargeMapProgramTest::command_largeMap_takesTenBytesPerCell_data() {
  QTest::addColumn<QStringList>("words");
  const auto row = [](const char* name, const char* words) {
    QTest::newRow(name) << QString::fromUtf8(words).split(QLatin1Char(' '));
  };
  row("check", "check @hall_agents.yaml");
  row("an image in colours", "check @hall_agents.yaml --map @colours.yaml");
  row("run", "run @hall_agents.yaml -o @run");
  row("evaluate", "evaluate @run -o @evaluated");
  row("render", "render @run -o @run.png");
  row("convert", "convert @hall_agents.yaml -o @ws --target webots");
  row("window", "@hall_agents.yaml --screenshot @window.png");
}

/// With files of the folder of a map where an @ stands.
std::vector<std::string> LargeMapProgramTest::wordsFor(const char* map,
                                                       const QStringList& words) const {
  std::vector<std::string> result;
  result.reserve(static_cast<std::size_t>(words.size()));
  for (const QString& word : words) {
    result.push_back(word.startsWith(QLatin1Char('@')) ? at(map, word.mid(1).toUtf8().constData())
                                                       : word.toStdString());
  }
  return result;
}

void LargeMapProgramTest::command_largeMap_takesTenBytesPerCell() {
  QFETCH(const QStringList, words);
  const Ended small = runToEnd(wordsFor("small", words));
  const Ended large = runToEnd(wordsFor("large", words));
  QCOMPARE(small.exitCode, 0);
  QCOMPARE(large.exitCode, 0);
  const double perCell = (large.bytes - small.bytes) / (double(largeSide()) * largeSide());
  qInfo("%.2f bytes per cell above %.0f MB", perCell, small.bytes / 0x1p20);
  QVERIFY(perCell > 0.5);  // the cells themselves: it was read
  QVERIFY2(perCell <= kMostPerCell, qPrintable(QString::number(perCell)));
}

QTEST_GUILESS_MAIN(LargeMapProgramTest)
#include "tst_LargeMapProgram.moc"
