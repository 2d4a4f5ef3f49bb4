#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "app/report/MapPanels.h"

namespace report {

namespace {

using Squares = std::map<std::pair<int, int>, int>;  // contacts in each

constexpr double kSquare = 0.5;  // [m]

Squares squaresOf(const std::vector<base::Vec2>& contacts) {
  Squares counts;
  for (const base::Vec2& place : contacts) {
    ++counts[{static_cast<int>(std::floor(place.x() / kSquare)),
              static_cast<int>(std::floor(place.y() / kSquare))}];
  }
  return counts;
}

/// The more contacts the stronger, the same in all panels.
double strengthOf(int count, int most) {
  return 0.25 + 0.65 * count / most;
}

void heatSquares(Figure& figure, const MapPanel& panel, const Squares& squares, int most) {
  for (const auto& [square, count] : squares) {
    const base::Vec2 corner = panel.at({square.first * kSquare, (square.second + 1) * kSquare});
    figure.rect(corner.x(), corner.y(), kSquare * panel.scale, kSquare * panel.scale, "hot",
                strengthOf(count, most));
  }
}

constexpr double kKeyHeight = 30.0;  // [px]

/// What the squares stand for: the fewest, the most, and one between.
void heatKey(Figure& figure, double top, int most) {
  constexpr double kSide = 12.0;
  const std::string words = "Contacts in a square:";
  figure.text(0.0, top + 10.0, words, "dim");
  double left = 6.4 * static_cast<double>(words.size());
  for (const int count : std::set<int>{1, (1 + most) / 2, most}) {
    figure.rect(left, top, kSide, kSide, "ground");
    figure.rect(left, top, kSide, kSide, "hot", strengthOf(count, most));
    const std::string number = std::to_string(count);
    figure.text(left + kSide + 6.0, top + 10.0, number);
    left += kSide + 24.0 + 6.4 * static_cast<double>(number.size());
  }
}

std::string withNumber(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

/// Contacts of all runs in one scenario.
struct ContactMap {
  std::string scenario;
  std::size_t count = 0;
  Squares squares;
  int most() const {
    int found = 0;
    for (const auto& [square, contacts] : squares) {
      found = std::max(found, contacts);
    }
    return found;
  }
};

/// Of scenarios that have contacts, by name.
std::vector<ContactMap> contactMaps(const Study& study, const RunPictures& pictures) {
  std::map<std::string, std::vector<base::Vec2>> places;
  for (const RunPicture& picture : pictures.runs) {
    for (const metrics::RobotContact& contact : picture.contacts) {
      places[study.results.runs[picture.run].scenario].push_back(contact.place);
    }
  }
  std::vector<ContactMap> maps;
  maps.reserve(places.size());
  for (const auto& [scenario, contacts] : places) {
    maps.push_back({scenario, contacts.size(), squaresOf(contacts)});
  }
  return maps;
}

std::string contactsCaption(const RunPictures& pictures, std::size_t shown, std::size_t all) {
  const std::size_t others = pictures.grounds.size() - all;
  return "Where the robot was when contacts began, with people (a gap below the metrics' "
         "contact_distance) or obstacles, in " +
         withNumber(pictures.runs.size(), "recorded run") +
         ": the stronger the colour of a square of 0.5 m the more contacts, on one scale for all "
         "maps" +
         cutText(shown, all, "scenarios with contacts") + "." +
         (others == 0 ? "" : " None in " + withNumber(others, "other scenario") + ".");
}

constexpr double kMapHeight = 420.0;  // of a map [px]

PanelGrid gridOf(const std::vector<ContactMap>& maps, const RunPictures& pictures) {
  PanelGrid grid;
  grid.count = maps.size();
  grid.columns = maps.size() > 1 ? 2 : 1;
  grid.gap = 20.0;
  std::vector<double> heights;
  heights.reserve(maps.size());
  for (const ContactMap& map : maps) {
    heights.push_back(
        panelHeightOf(pictures.grounds.at(map.scenario), grid.panelWidth(), kMapHeight));
  }
  grid.fitRows(heights);
  return grid;
}

}  // namespace

std::optional<Figure> contactsFigure(const Study& study, const RunPictures& pictures) {
  std::vector<ContactMap> maps = contactMaps(study, pictures);
  const std::size_t all = maps.size();
  if (maps.empty()) {
    return std::nullopt;
  }
  maps.resize(std::min(kMostPanels, all));
  const PanelGrid grid = gridOf(maps, pictures);
  int most = 1;
  for (const ContactMap& map : maps) {
    most = std::max(most, map.most());
  }
  Figure figure("contacts", grid.width, grid.height() + kKeyHeight);
  Grounds grounds(figure, grid.panelWidth(), kMapHeight);
  grid.forEach([&](std::size_t index, double left, double top) {
    const ContactMap& map = maps[index];
    const std::string name = shortened(map.scenario.substr(study.sharedFolder), 60);
    figure.text(left, top + 12.0, name + ": " + withNumber(map.count, "contact"));
    const Ground& ground = pictures.grounds.at(map.scenario);
    heatSquares(figure, grounds.draw(map.scenario, ground, left, top + kPanelHead), map.squares,
                most);
  });
  heatKey(figure, grid.height() + kKeyHeight - 16.0, most);
  figure.caption = contactsCaption(pictures, maps.size(), all);
  return figure;
}

}  // namespace report
